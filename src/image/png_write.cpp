// The PNG writer: a signature, a few chunks, and the filtered rows packed between them. Two ways to pack: strips of 8-bit rows go through our
// own encoder on all threads (deflate.hpp), because a picture is drawn in less time than a general compressor takes to pack it; where a level is
// asked for, and for 16 bits, libdeflate takes the picture whole.
#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>

#include "image/adler.hpp"
#include "image/deflate.hpp"
#include "image/png.hpp"
#include "image/png_filter.hpp"
#include "image/store.hpp"
#include "parallel/parallel_for.hpp"

namespace lustro {
namespace {

// --- the samples ---------------------------------------------------------------------------------------------------------------

/// The stored samples as PNG orders them (16 bits big endian), before alpha is looked at.
struct Samples {
  std::size_t width = 0;
  std::size_t height = 0;
  std::size_t channels = 0;
  std::size_t depth = 1;  ///< bytes a sample
  std::span<const std::uint8_t> bytes;

  [[nodiscard]] std::size_t step() const { return channels * depth; }
  [[nodiscard]] std::span<const std::uint8_t> row(std::size_t y) const { return bytes.subspan(y * width * step(), width * step()); }
};

/// For loops whose bytes do not depend on it.
constexpr std::size_t kRowsARange = 128;

/// Calls body(begin, end) for a few ranges that make up 0..rows-1.
template <class Body>
void for_ranges(std::size_t rows, std::size_t rows_a_range, int threads, Body body) {
  parallel_for((rows + rows_a_range - 1) / rows_a_range, threads,
               [&](std::size_t i) { body(i * rows_a_range, std::min(rows, (i + 1) * rows_a_range)); });
}

/// Whether the last sample of every pixel is as large as it can be. A pixel with alpha takes 2, 4 or 8 bytes, so it lies the same way in every
/// word.
bool is_opaque(std::span<const std::uint8_t> row, std::size_t step, std::size_t depth) {
  constexpr std::size_t kWord = sizeof(std::uint64_t);
  std::uint64_t all = ~std::uint64_t{0};
  std::size_t i = 0;
  for (; i + kWord <= row.size(); i += kWord) {
    std::uint64_t word = 0;
    std::memcpy(&word, &row[i], kWord);
    all &= word;
  }
  std::array<std::uint8_t, kWord> least{};
  std::memcpy(least.data(), &all, kWord);
  for (std::size_t k = 0; i < row.size(); ++i, ++k) {
    least[k] &= row[i];
  }
  for (std::size_t k = 0; k < kWord; ++k) {
    if (k % step >= step - depth && least[k] != 0xFF) {
      return false;
    }
  }
  return true;
}

/// Whether there is an alpha channel, and nothing in it but full coverage.
bool has_idle_alpha(const Samples& samples, int threads) {
  if (samples.channels != 2 && samples.channels != 4) {
    return false;
  }
  std::atomic<bool> is_idle = true;
  for_ranges(samples.height, kRowsARange, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end && is_idle.load(std::memory_order_relaxed); ++y) {
      if (!is_opaque(samples.row(y), samples.step(), samples.depth)) {
        is_idle.store(false, std::memory_order_relaxed);
      }
    }
  });
  return is_idle;
}

/// `row` without the last channel. Writes up to 8 bytes more than it keeps: `to` has room for them.
void drop_alpha(std::span<const std::uint8_t> row, std::size_t step, std::size_t depth, std::uint8_t* to) {
  std::size_t i = 0;
  if (std::endian::native == std::endian::little && step == 4 && depth == 1) {  // what most pictures are: two pixels, a word, at once
    for (; i + 8 <= row.size(); i += 8, to += 6) {
      std::uint64_t word = 0;
      std::memcpy(&word, &row[i], sizeof word);
      word = (word & 0xFFFFFF) | ((word >> 8) & 0xFFFFFF000000);
      std::memcpy(to, &word, sizeof word);
    }
  }
  for (; i < row.size(); i += step, to += step - depth) {
    std::memcpy(to, &row[i], step - depth);
  }
}

/// The rows as they are filtered: with or without alpha. One a thread, for it holds the rows that it gave last.
class RowSource {
 public:
  RowSource(const Samples& samples, bool without_alpha) : samples_(samples), without_alpha_(without_alpha), rows_(2 * room()) {}

  /// Row y, zeros for y = -1. Stays until the second call after this one.
  std::span<const std::uint8_t> row(std::ptrdiff_t y) {
    if (y >= 0 && !without_alpha_) {
      return samples_.row(static_cast<std::size_t>(y));
    }
    std::uint8_t* to = &rows_[is_second_ ? room() : 0];
    is_second_ = !is_second_;
    if (y < 0) {
      std::fill_n(to, length(), std::uint8_t{0});
    } else {
      drop_alpha(samples_.row(static_cast<std::size_t>(y)), samples_.step(), samples_.depth, to);
    }
    return {to, length()};
  }

  [[nodiscard]] std::size_t step() const { return without_alpha_ ? samples_.step() - samples_.depth : samples_.step(); }
  [[nodiscard]] std::size_t length() const { return samples_.width * step(); }

 private:
  [[nodiscard]] std::size_t room() const { return length() + 8; }

  const Samples& samples_;
  bool without_alpha_;
  bool is_second_ = false;
  std::vector<std::uint8_t> rows_;
};

// --- chunks ----------------------------------------------------------------------------------------------------------------------

void append_u32(std::vector<std::byte>& out, std::uint32_t v) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    out.push_back(static_cast<std::byte>(v >> shift));
  }
}

void append_bytes(std::vector<std::byte>& out, std::span<const std::byte> bytes) {
  out.insert(out.end(), bytes.begin(), bytes.end());
}

using ChunkType = std::array<char, 4>;
constexpr ChunkType kData{'I', 'D', 'A', 'T'};

std::uint32_t crc_of(const ChunkType& type, std::span<const std::byte> data) {
  const std::uint32_t crc = libdeflate_crc32(0, type.data(), type.size());
  return data.empty() ? crc : libdeflate_crc32(crc, data.data(), data.size());  // it takes no memory at all for a new beginning
}

/// Length, type, data, CRC of type and data.
void append_chunk(std::vector<std::byte>& out, const ChunkType& type, std::span<const std::byte> data, std::uint32_t crc) {
  append_u32(out, static_cast<std::uint32_t>(data.size()));
  append_bytes(out, std::as_bytes(std::span(type)));
  append_bytes(out, data);
  append_u32(out, crc);
}

void append_chunk(std::vector<std::byte>& out, const ChunkType& type, std::span<const std::byte> data) {
  append_chunk(out, type, data, crc_of(type, data));
}

void append_head(std::vector<std::byte>& out, const Samples& samples, std::size_t channels, Transfer transfer) {
  for (const int b : {0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A}) {
    out.push_back(static_cast<std::byte>(b));
  }
  std::vector<std::byte> header;
  append_u32(header, static_cast<std::uint32_t>(samples.width));
  append_u32(header, static_cast<std::uint32_t>(samples.height));
  constexpr std::array<std::size_t, 5> kColorTypes{0, 0, 4, 2, 6};  // by channels: gray, gray and alpha, RGB, RGBA
  for (const std::size_t b : {8 * samples.depth, kColorTypes[channels], std::size_t{0}, std::size_t{0}, std::size_t{0}}) {
    header.push_back(static_cast<std::byte>(b));
  }
  append_chunk(out, {'I', 'H', 'D', 'R'}, header);
  if (transfer == Transfer::srgb) {
    constexpr std::byte kPerceptual{0};
    append_chunk(out, {'s', 'R', 'G', 'B'}, std::span(&kPerceptual, 1));
  }
  constexpr std::array<char, 15> kSoftware{'S', 'o', 'f', 't', 'w', 'a', 'r', 'e', 0, 'L', 'u', 's', 't', 'r', 'o'};  // no version: equal bytes
  append_chunk(out, {'t', 'E', 'X', 't'}, std::as_bytes(std::span(kSoftware)));
}

// --- packing ---------------------------------------------------------------------------------------------------------------------

bool equal_rows(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
  return std::memcmp(a.data(), b.data(), a.size()) == 0;
}

/// Rows that are packed together and become a chunk.
struct Strip {
  std::vector<std::byte> packed;
  std::size_t filtered_bytes = 0;
  std::uint32_t adler = kAdlerOfNothing;
  std::uint32_t crc = 0;  ///< of the chunk, type and all
};

/// About how many filtered bytes a strip holds: enough that its code (some 80 bytes) and its chunk weigh nothing, few enough that a
/// small picture gives work to several threads and a strip stays in the second cache. A constant, so that the bytes do not depend on threads.
constexpr std::size_t kStripBytes = std::size_t{128} << 10;

/// Every strip a chunk: its own filters, its own code, its own checksums. The stream's frame (RFC 1950) is around the first and the last.
void append_fast_data(std::vector<std::byte>& out, const Samples& samples, bool without_alpha, int threads) {
  const std::size_t filtered_row = RowSource(samples, without_alpha).length() + 1;
  const std::size_t rows_a_strip = std::max<std::size_t>(1, kStripBytes / filtered_row);
  std::vector<Strip> strips((samples.height + rows_a_strip - 1) / rows_a_strip);
  for_ranges(samples.height, rows_a_strip, threads, [&](std::size_t begin, std::size_t end) {
    RowSource source(samples, without_alpha);
    std::vector<std::uint8_t> filtered((end - begin) * filtered_row);
    std::span<const std::uint8_t> up = source.row(static_cast<std::ptrdiff_t>(begin) - 1);
    for (std::size_t y = begin; y < end; ++y) {
      const std::span<std::uint8_t> to = std::span(filtered).subspan((y - begin) * filtered_row, filtered_row);
      if (y > 0 && equal_rows(samples.row(y), samples.row(y - 1))) {
        to[0] = static_cast<std::uint8_t>(RowFilter::up);  // the rest is 0 already
        continue;
      }
      const std::span<const std::uint8_t> row = source.row(static_cast<std::ptrdiff_t>(y));
      filter_row_well(row, up, source.step(), to);
      up = row;
    }
    Strip& strip = strips[begin / rows_a_strip];
    if (begin == 0) {
      strip.packed = {std::byte{0x78}, std::byte{0x01}};  // deflate, a window of 32 KiB, the fastest of four levels
    }
    append_deflate(filtered, end == samples.height, strip.packed);
    strip.filtered_bytes = filtered.size();
    strip.adler = libdeflate_adler32(kAdlerOfNothing, filtered.data(), filtered.size());
    strip.crc = crc_of(kData, strip.packed);
  });
  std::uint32_t adler = kAdlerOfNothing;
  std::size_t bytes = 0;
  for (const Strip& strip : strips) {
    adler = joined_adler(adler, strip.adler, strip.filtered_bytes);
    bytes += strip.packed.size() + 12;
  }
  std::vector<std::byte> trailer;
  append_u32(trailer, adler);
  strips.back().crc = libdeflate_crc32(strips.back().crc, trailer.data(), trailer.size());
  append_bytes(strips.back().packed, trailer);
  out.reserve(out.size() + bytes + 16);
  for (const Strip& strip : strips) {
    append_chunk(out, kData, strip.packed, strip.crc);
  }
}

struct FreeCompressor {
  void operator()(libdeflate_compressor* c) const { libdeflate_free_compressor(c); }
};

constexpr int kUsualLevel = 6;  // of libdeflate, where nobody asked

/// The whole picture by libdeflate. Every row has the filter Sub: the long searches of the high levels find more behind it than behind a choice
/// of filters, which breaks up what repeats from row to row.
Result<void> append_small_data(std::vector<std::byte>& out, const Samples& samples, bool without_alpha, int level, int threads) {
  const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(libdeflate_alloc_compressor(level));
  if (!compressor) {
    return fail(ErrorKind::usage, "", "the compression level of a PNG lies in 0..12, and " + std::to_string(level) + " was asked for");
  }
  const std::size_t filtered_row = RowSource(samples, without_alpha).length() + 1;
  std::vector<std::uint8_t> filtered(samples.height * filtered_row);
  for_ranges(samples.height, kRowsARange, threads, [&](std::size_t begin, std::size_t end) {
    RowSource source(samples, without_alpha);
    for (std::size_t y = begin; y < end; ++y) {
      filter_row(RowFilter::sub, source.row(static_cast<std::ptrdiff_t>(y)), {}, source.step(),
                 std::span(filtered).subspan(y * filtered_row, filtered_row));
    }
  });
  std::vector<std::byte> packed(libdeflate_zlib_compress_bound(compressor.get(), filtered.size()));
  packed.resize(libdeflate_zlib_compress(compressor.get(), filtered.data(), filtered.size(), packed.data(), packed.size()));
  constexpr std::size_t kLongestChunk = std::size_t{1} << 30;
  out.reserve(out.size() + packed.size() + 64);
  for (std::size_t begin = 0; begin < packed.size(); begin += kLongestChunk) {
    append_chunk(out, kData, std::span(packed).subspan(begin, std::min(kLongestChunk, packed.size() - begin)));
  }
  return {};
}

Result<std::vector<std::byte>> encode(const Samples& samples, const WriteOptions& options, bool keep_alpha = false) {
  const bool without_alpha = !keep_alpha && has_idle_alpha(samples, options.threads);
  std::vector<std::byte> out;
  append_head(out, samples, samples.channels - (without_alpha ? 1 : 0), options.transfer);
  if (!options.png_level && samples.depth == 1) {
    append_fast_data(out, samples, without_alpha, options.threads);
  } else {
    // Between the halves of 16 bits there are few runs: what finds nothing else makes files half as large again.
    const int level = options.png_level.value_or(kUsualLevel);
    if (auto done = append_small_data(out, samples, without_alpha, level, options.threads); !done) {
      return tl::unexpected(std::move(done).error());
    }
  }
  append_chunk(out, {'I', 'E', 'N', 'D'}, {});
  return out;
}

template <class AnyImage>
Samples samples_of(const AnyImage& image, std::span<const std::uint8_t> bytes, std::size_t depth) {
  return {.width = static_cast<std::size_t>(image.width),
          .height = static_cast<std::size_t>(image.height),
          .channels = static_cast<std::size_t>(image.channels),
          .depth = depth,
          .bytes = bytes};
}

}  // namespace

Result<std::vector<std::byte>> encode_png(const ByteImage& image, const WriteOptions& options, bool keep_alpha) {
  if (options.bits != 8) {
    return fail(ErrorKind::usage, "", "a picture of bytes becomes a PNG of 8 bits a channel, not of " + std::to_string(options.bits));
  }
  return encode(samples_of(image, image.pixels, 1), options, keep_alpha);
}

Result<std::vector<std::byte>> encode_png(const Image& image, const WriteOptions& options) {
  if (options.bits == 8) {
    return encode(samples_of(image, stored8(image, options.transfer, options.tone, options.threads), 1), options);
  }
  if (options.bits != 16) {
    return fail(ErrorKind::usage, "", "a PNG has 8 or 16 bits a channel, not " + std::to_string(options.bits));
  }
  const std::vector<std::uint16_t> words = stored16(image, options.transfer, options.tone, options.threads);
  std::vector<std::uint8_t> bytes(words.size() * 2);
  for (std::size_t i = 0; i < words.size(); ++i) {
    bytes[2 * i] = static_cast<std::uint8_t>(words[i] >> 8);
    bytes[2 * i + 1] = static_cast<std::uint8_t>(words[i] & 0xFF);
  }
  return encode(samples_of(image, bytes, 2), options);
}

}  // namespace lustro
