// Prefix codes: see huffman.hpp.
#include "image/huffman.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace lustro {
namespace {

constexpr std::size_t kMostSymbols = 512;
constexpr std::size_t kLongest = 15;

/// Turns ascending weights into the depths of the leaves of a tree of least weight, deepest first, in place (Moffat and Katajainen 1995).
void weights_to_depths(std::span<std::uint32_t> a) {
  const std::size_t n = a.size();
  // 1. Join the two lightest again and again: a[next] becomes the weight of an inner node, later the index of its parent.
  std::size_t root = 0;
  std::size_t leaf = 0;
  for (std::size_t next = 0; next + 1 < n; ++next) {
    std::uint32_t sum = 0;
    for (int child = 0; child < 2; ++child) {
      if (leaf >= n || (root < next && a[root] < a[leaf])) {
        sum += a[root];
        a[root++] = static_cast<std::uint32_t>(next);
      } else {
        sum += a[leaf++];
      }
    }
    a[next] = sum;
  }
  // 2. Parents become depths, from the root down.
  a[n - 2] = 0;
  for (std::size_t next = n - 2; next-- > 0;) {
    a[next] = a[a[next]] + 1;
  }
  // 3. Every place that inner nodes leave free at a depth is a leaf.
  std::size_t inner = n - 1;  // inner nodes not yet met, from the back
  std::size_t free_places = 1;
  std::size_t to = n;
  for (std::uint32_t depth = 0; free_places > 0; ++depth) {
    std::size_t used = 0;
    while (inner > 0 && a[inner - 1] == depth) {
      ++used;
      --inner;
    }
    for (; free_places > used; --free_places) {
      a[--to] = depth;
    }
    free_places = 2 * used;
  }
}

}  // namespace

void huffman_lengths(std::span<const std::uint32_t> counts, int limit, std::span<std::uint8_t> lengths) {
  std::array<std::uint64_t, kMostSymbols> order{};  // count and symbol
  std::size_t n = 0;
  for (std::size_t symbol = 0; symbol < counts.size(); ++symbol) {
    lengths[symbol] = 0;
    if (counts[symbol] != 0) {
      order[n++] = (std::uint64_t{counts[symbol]} << 32) | symbol;
    }
  }
  std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(n));
  std::array<std::uint32_t, kMostSymbols> depths{};
  for (std::size_t i = 0; i < n; ++i) {
    depths[i] = static_cast<std::uint32_t>(order[i] >> 32);
  }
  weights_to_depths(std::span(depths).first(n));

  // Leaves deeper than the limit are lifted to it; then places are made until all fit: a leaf above the limit moves down one step, and takes one
  // of those at the limit as its sibling.
  const auto longest = static_cast<std::size_t>(limit);
  std::array<std::uint32_t, kLongest + 1> leaves{};  // at every depth
  std::uint64_t kraft = 0;                           // in units of 2^-limit
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t depth = std::min<std::size_t>(depths[i], longest);
    ++leaves[depth];
    kraft += std::uint64_t{1} << (longest - depth);
  }
  for (; kraft > std::uint64_t{1} << longest; --kraft) {
    std::size_t depth = longest - 1;
    while (leaves[depth] == 0) {
      --depth;
    }
    --leaves[depth];
    leaves[depth + 1] += 2;
    --leaves[longest];
  }
  std::size_t i = 0;
  for (std::size_t depth = longest; depth > 0; --depth) {
    for (std::uint32_t k = 0; k < leaves[depth]; ++k) {
      lengths[order[i++] & 0xFFFFFFFF] = static_cast<std::uint8_t>(depth);
    }
  }
}

void huffman_codes(std::span<const std::uint8_t> lengths, std::span<std::uint16_t> codes) {
  std::array<std::uint32_t, kLongest + 2> next{};  // first the number of codes one bit shorter
  for (const std::uint8_t length : lengths) {
    ++next[length + std::size_t{1}];
  }
  next[1] = 0;                                                    // symbols without a code
  for (std::size_t length = 1; length < next.size(); ++length) {  // then the first code
    next[length] = (next[length] + next[length - 1]) << 1;
  }
  for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
    std::uint32_t code = lengths[symbol] == 0 ? 0 : next[lengths[symbol]]++;
    std::uint32_t reversed = 0;
    for (int bit = 0; bit < lengths[symbol]; ++bit) {
      reversed = (reversed << 1) | (code & 1);
      code >>= 1;
    }
    codes[symbol] = static_cast<std::uint16_t>(reversed);
  }
}

}  // namespace lustro
