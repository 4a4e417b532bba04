// The fast deflate encoder: see deflate.hpp. Three passes over a piece: runs (runs.hpp), counts, bits.
#include "image/deflate.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "image/huffman.hpp"
#include "image/runs.hpp"

namespace lustro {
namespace {

// --- how often each symbol occurs ----------------------------------------------------------------------------------------

constexpr std::size_t kEndOfBlock = 256;
constexpr std::size_t kLiteralSymbols = 286;  // literals, the end, and 29 for lengths
constexpr std::uint32_t kShortestLength = 3;
constexpr std::uint32_t kLongestLength = 258;

/// RFC 1951, 3.2.5: lengths 3..258 as a symbol and extra bits.
struct LengthCode {
  std::uint16_t symbol = 0;
  std::uint8_t extra_bits = 0;
  std::uint8_t extra = 0;
};

constexpr std::array<LengthCode, kLongestLength + 1> make_length_codes() {
  std::array<LengthCode, kLongestLength + 1> codes{};
  std::uint32_t length = kShortestLength;
  for (std::uint32_t symbol = 257; symbol < 285; ++symbol) {
    const std::uint32_t extra_bits = symbol < 265 ? 0 : (symbol - 261) / 4;
    for (std::uint32_t extra = 0; extra < 1U << extra_bits; ++extra, ++length) {
      codes[length] = {static_cast<std::uint16_t>(symbol), static_cast<std::uint8_t>(extra_bits), static_cast<std::uint8_t>(extra)};
    }
  }
  codes[kLongestLength] = {285, 0, 0};
  return codes;
}
constexpr auto kLengthCodes = make_length_codes();

/// The next length of a run of which `repeats` are left: none of the lengths is below the shortest.
std::uint32_t next_length(std::uint32_t repeats) {
  if (repeats <= kLongestLength) {
    return repeats;
  }
  return repeats < kLongestLength + kShortestLength ? kLongestLength - kShortestLength : kLongestLength;
}

std::array<std::uint32_t, kLiteralSymbols> count_symbols(std::span<const std::uint8_t> data, std::span<const Stretch> stretches) {
  // Four tables, so that a byte need not wait for the same byte before it.
  std::array<std::array<std::uint32_t, 256>, 4> tables{};
  std::array<std::uint32_t, kLiteralSymbols> counts{};
  const std::uint8_t* at = data.data();
  for (const Stretch& stretch : stretches) {
    const std::uint8_t* const end = at + stretch.literals;
    for (; end - at >= 8; at += 8) {
      const std::uint64_t v = load_little_endian(at);
      for (std::size_t k = 0; k < 8; ++k) {
        ++tables[k % 4][(v >> (8 * k)) & 0xFF];
      }
    }
    for (; at < end; ++at) {
      ++tables[0][*at];
    }
    at += stretch.repeats;
    for (std::uint32_t left = stretch.repeats; left > 0;) {
      const std::uint32_t length = next_length(left);
      ++counts[kLengthCodes[length].symbol];
      left -= length;
    }
  }
  for (std::size_t v = 0; v < 256; ++v) {
    counts[v] = tables[0][v] + tables[1][v] + tables[2][v] + tables[3][v];
  }
  counts[kEndOfBlock] = 1;
  return counts;
}

// --- bits ----------------------------------------------------------------------------------------------------------------

/// Puts bits behind one another, the lowest first. The memory must reach 8 bytes beyond what is put.
class BitWriter {
 public:
  explicit BitWriter(std::byte* to) : to_(to) {}

  /// After a flush there is room for 56 bits.
  void put(std::uint64_t bits, std::uint32_t count) {
    bits_ |= bits << count_;
    count_ += count;
  }

  void flush() {
    if constexpr (std::endian::native == std::endian::little) {
      std::memcpy(to_, &bits_, sizeof bits_);
    } else {
      const std::uint64_t swapped = __builtin_bswap64(bits_);
      std::memcpy(to_, &swapped, sizeof swapped);
    }
    to_ += count_ / 8;
    bits_ >>= count_ & ~7U;
    count_ %= 8;
  }

  /// Zeros up to the next whole byte; where that is.
  std::byte* finish() {
    flush();
    count_ = (count_ + 7) & ~7U;
    flush();
    return to_;
  }

 private:
  std::byte* to_;
  std::uint64_t bits_ = 0;
  std::uint32_t count_ = 0;
};

/// Bits and how many, in one word to load: a code of at most 24 bits.
struct Code {
  std::uint32_t packed = 0;
  Code() = default;
  Code(std::uint32_t bits, std::uint32_t count) : packed(bits | (count << 24)) {}
  [[nodiscard]] std::uint64_t bits() const { return packed & 0xFFFFFF; }
  [[nodiscard]] std::uint32_t count() const { return packed >> 24; }
};

/// Of a literal or length: four of these and the rest of a byte fit into 64 bits. 12 would cost one part in a hundred, 11 three, and save no
/// time.
constexpr int kLongestCode = 14;

struct BlockCode {
  std::array<std::uint8_t, kLiteralSymbols> lengths{};
  std::array<Code, kLiteralSymbols> symbols;
  std::array<Code, kLongestLength + 1> repeats;  ///< length, extra bits and distance 1 together
  std::size_t bits = 0;                          ///< of the coded data, with the end of the block
};

BlockCode make_block_code(const std::array<std::uint32_t, kLiteralSymbols>& counts) {
  BlockCode code;
  std::array<std::uint16_t, kLiteralSymbols> bits{};
  huffman_lengths(counts, kLongestCode, code.lengths);
  huffman_codes(code.lengths, bits);
  for (std::size_t s = 0; s < kLiteralSymbols; ++s) {
    code.symbols[s] = Code(bits[s], code.lengths[s]);
    code.bits += std::size_t{counts[s]} * code.lengths[s];
  }
  for (std::uint32_t length = kShortestLength; length <= kLongestLength; ++length) {
    const LengthCode& c = kLengthCodes[length];
    const std::uint32_t symbol_bits = code.lengths[c.symbol];
    // Distance 1 is the first of two codes of one bit: a zero.
    code.repeats[length] = Code(bits[c.symbol] | (std::uint32_t{c.extra} << symbol_bits), symbol_bits + c.extra_bits + 1);
  }
  for (std::uint32_t length = kShortestLength; length <= kLongestLength; ++length) {  // each length symbol once
    const LengthCode& c = kLengthCodes[length];
    if (c.extra == 0) {
      code.bits += std::size_t{counts[c.symbol]} * (c.extra_bits + 1U);
    }
  }
  return code;
}

/// The lengths of both codes, in the code that deflate has for lengths (RFC 1951, 3.2.7).
struct BlockHeader {
  struct Item {
    std::uint8_t symbol = 0;
    std::uint8_t extra_bits = 0;
    std::uint8_t extra = 0;
  };
  std::vector<Item> items;
  std::array<std::uint8_t, 19> lengths{};
  std::size_t literal_count = 0;  ///< how many lengths of literals and lengths are sent
  std::size_t length_count = 0;   ///< how many lengths of lengths are sent
  std::size_t bits = 0;
};

constexpr std::array<std::uint8_t, 19> kLengthOrder{16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
constexpr std::size_t kDistanceCount = 2;  // two, though the second is never used: some decoders want a complete code

BlockHeader make_header(const BlockCode& code) {
  BlockHeader header;
  header.literal_count = kLiteralSymbols;
  while (header.literal_count > 257 && code.lengths[header.literal_count - 1] == 0) {
    --header.literal_count;
  }
  std::vector<std::uint8_t> sent(code.lengths.begin(), code.lengths.begin() + static_cast<std::ptrdiff_t>(header.literal_count));
  sent.insert(sent.end(), kDistanceCount, 1);
  const auto add = [&](std::size_t symbol, std::size_t extra_bits, std::size_t extra) {
    header.items.push_back({static_cast<std::uint8_t>(symbol), static_cast<std::uint8_t>(extra_bits), static_cast<std::uint8_t>(extra)});
  };
  for (std::size_t i = 0; i < sent.size();) {
    std::size_t same = 1;
    while (i + same < sent.size() && sent[i + same] == sent[i]) {
      ++same;
    }
    if (sent[i] == 0 && same >= 3) {
      same = std::min<std::size_t>(same, 138);
      same <= 10 ? add(17, 3, same - 3) : add(18, 7, same - 11);
    } else if (sent[i] != 0 && same >= 4) {  // the first as it is, then 3 to 6 more of it
      same = std::min<std::size_t>(same, 7);
      add(sent[i], 0, 0);
      add(16, 2, same - 4);
    } else {
      same = 1;
      add(sent[i], 0, 0);
    }
    i += same;
  }
  std::array<std::uint32_t, 19> counts{};
  for (const BlockHeader::Item& item : header.items) {
    ++counts[item.symbol];
  }
  huffman_lengths(counts, 7, header.lengths);
  header.length_count = kLengthOrder.size();
  while (header.length_count > 4 && header.lengths[kLengthOrder[header.length_count - 1]] == 0) {
    --header.length_count;
  }
  header.bits = 3 + 5 + 5 + 4 + 3 * header.length_count;
  for (const BlockHeader::Item& item : header.items) {
    header.bits += std::size_t{header.lengths[item.symbol]} + item.extra_bits;
  }
  return header;
}

void put_header(BitWriter& writer, const BlockHeader& header, bool is_last) {
  constexpr std::uint32_t kDynamic = 2;
  writer.put((is_last ? 1U : 0U) | (kDynamic << 1), 3);
  writer.put(header.literal_count - 257, 5);
  writer.put(kDistanceCount - 1, 5);
  writer.put(header.length_count - 4, 4);
  for (std::size_t i = 0; i < header.length_count; ++i) {
    writer.put(header.lengths[kLengthOrder[i]], 3);
    writer.flush();
  }
  std::array<std::uint16_t, 19> codes{};
  huffman_codes(header.lengths, codes);
  for (const BlockHeader::Item& item : header.items) {
    writer.put(codes[item.symbol], header.lengths[item.symbol]);
    writer.put(item.extra, item.extra_bits);
    writer.flush();
  }
}

/// By value: a writer that lives in registers need not be stored whenever a byte is.
BitWriter put_data(BitWriter writer, std::span<const std::uint8_t> data, std::span<const Stretch> stretches, const BlockCode& code) {
  static_assert(4 * kLongestCode + 7 <= 64);
  const std::uint8_t* at = data.data();
  const auto put = [&writer](Code c) { writer.put(c.bits(), c.count()); };
  for (const Stretch& stretch : stretches) {
    const std::uint8_t* const end = at + stretch.literals;
    for (; end - at >= 4; at += 4) {
      put(code.symbols[at[0]]);
      put(code.symbols[at[1]]);
      put(code.symbols[at[2]]);
      put(code.symbols[at[3]]);
      writer.flush();
    }
    for (; at < end; ++at) {
      put(code.symbols[*at]);
    }
    writer.flush();
    at += stretch.repeats;
    for (std::uint32_t left = stretch.repeats; left > 0;) {
      const std::uint32_t length = next_length(left);
      put(code.repeats[length]);
      writer.flush();
      left -= length;
    }
  }
  put(code.symbols[kEndOfBlock]);
  writer.flush();
  return writer;
}

// --- stored blocks -----------------------------------------------------------------------------------------------------------------

constexpr std::size_t kLongestStored = 65535;

std::byte* put_stored(std::byte* to, std::span<const std::uint8_t> data, bool is_last) {
  do {
    const std::size_t length = std::min(data.size(), kLongestStored);
    *to++ = static_cast<std::byte>(is_last && length == data.size() ? 1 : 0);
    for (const std::size_t v : {length, ~length}) {
      *to++ = static_cast<std::byte>(v & 0xFF);
      *to++ = static_cast<std::byte>((v >> 8) & 0xFF);
    }
    if (length > 0) {
      std::memcpy(to, data.data(), length);
      to += length;
    }
    data = data.subspan(length);
  } while (!data.empty());
  return to;
}

}  // namespace

void append_deflate(std::span<const std::uint8_t> data, bool is_last, std::vector<std::byte>& out) {
  const std::vector<Stretch> stretches = find_stretches(data);
  const BlockCode code = make_block_code(count_symbols(data, stretches));
  const BlockHeader header = make_header(code);
  const std::size_t stored_bytes = data.size() + 5 * ((data.size() + kLongestStored - 1) / kLongestStored);
  constexpr std::size_t kJoint = 5;  // an empty stored block, from which on the next piece begins at a whole byte
  const std::size_t coded_bytes = (header.bits + code.bits + 7) / 8 + (is_last ? 0 : kJoint);
  const std::size_t begin = out.size();
  out.resize(begin + std::min(coded_bytes, stored_bytes) + sizeof(std::uint64_t));
  std::byte* end = out.data() + begin;
  if (coded_bytes < stored_bytes) {
    BitWriter writer(end);
    put_header(writer, header, is_last);
    writer = put_data(writer, data, stretches, code);
    if (is_last) {
      end = writer.finish();
    } else {
      writer.put(0, 3);  // the header of a stored block, which goes on at the next whole byte: 0 bytes follow
      end = writer.finish();
      for (const int b : {0, 0, 0xFF, 0xFF}) {
        *end++ = static_cast<std::byte>(b);
      }
    }
  } else {
    end = put_stored(end, data, is_last);
  }
  out.resize(static_cast<std::size_t>(end - out.data()));
}

}  // namespace lustro
