// Runs of bytes: see runs.hpp.
#include "image/runs.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace lustro {
namespace {

/// Bit i of word w: whether byte 64 w + i equals the byte before it.
std::vector<std::uint64_t> find_repeats(std::span<const std::uint8_t> data) {
  constexpr std::uint64_t kLow7 = 0x7F7F7F7F7F7F7F7F;
  std::vector<std::uint64_t> words(data.size() / 64 + 2);  // one more of zeros, so that a word can look at the next
  std::uint64_t before = static_cast<std::uint8_t>(~data[0]);
  const auto word_of = [&before](const std::uint8_t* at) {
    std::array<std::uint64_t, 8> different{};  // bytes that are 0 where a byte equals the one before it
    std::uint64_t any = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      const std::uint64_t v = load_little_endian(at + 8 * k);
      different[k] = v ^ ((v << 8) | before);
      before = v >> 56;
      any |= different[k];
    }
    if (any == 0) {
      return ~std::uint64_t{0};
    }
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      const std::uint64_t top_bits = (((different[k] & kLow7) + kLow7) | different[k]) & ~kLow7;  // set where a byte is not 0
      word |= ((top_bits * 0x0002040810204081) >> 56) << (8 * k);                                 // the eight of them side by side
    }
    return ~word;
  };
  const std::size_t whole = data.size() / 64;
  for (std::size_t w = 0; w < whole; ++w) {
    words[w] = word_of(&data[64 * w]);
  }
  if (const std::size_t rest = data.size() % 64; rest > 0) {
    std::array<std::uint8_t, 64> last{};
    std::copy_n(&data[64 * whole], rest, last.begin());
    words[whole] = word_of(last.data()) & ((std::uint64_t{1} << rest) - 1);
  }
  return words;
}

/// The first place from `at` on whose bit is not set. The bits end with a word of zeros.
std::size_t first_clear(std::span<const std::uint64_t> words, std::size_t at) {
  std::size_t w = at / 64;
  std::uint64_t clear = ~words[w] & (~std::uint64_t{0} << (at % 64));
  while (clear == 0) {
    clear = ~words[++w];
  }
  return 64 * w + static_cast<std::size_t>(std::countr_zero(clear));
}

/// The places of word w where eight set bits in a row begin, found in three doublings.
std::uint64_t run_starts(std::span<const std::uint64_t> words, std::size_t w) {
  static_assert(kShortestRun == 8);
  const std::uint64_t next = words[w + 1];
  const std::uint64_t two = words[w] & ((words[w] >> 1) | (next << 63));
  const std::uint64_t next_two = next & (next >> 1);
  const std::uint64_t four = two & ((two >> 2) | (next_two << 62));
  const std::uint64_t next_four = next_two & (next_two >> 2);
  return four & ((four >> 4) | (next_four << 60));
}

}  // namespace

std::vector<Stretch> find_stretches(std::span<const std::uint8_t> data) {
  const std::vector<std::uint64_t> words = find_repeats(data);
  std::vector<Stretch> stretches;
  stretches.reserve(data.size() / (kShortestRun + 1) + 2);
  std::size_t done = 0;
  while (true) {
    std::size_t w = done / 64;
    std::uint64_t starts = run_starts(words, w) & (~std::uint64_t{0} << (done % 64));
    while (starts == 0 && w + 2 < words.size()) {
      starts = run_starts(words, ++w);
    }
    if (starts == 0) {
      stretches.push_back({static_cast<std::uint32_t>(data.size() - done), 0});
      return stretches;
    }
    const std::size_t begin = 64 * w + static_cast<std::size_t>(std::countr_zero(starts));
    const std::size_t end = first_clear(words, begin);
    stretches.push_back({static_cast<std::uint32_t>(begin - done), static_cast<std::uint32_t>(end - begin)});
    done = end;
  }
}

}  // namespace lustro
