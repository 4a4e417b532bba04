// The checksum of a zlib stream (RFC 1950, 9), where its parts were summed apart.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lustro {

constexpr std::uint32_t kAdlerOfNothing = 1;

/// Adler-32 of a, then b, from those of a and of b and the length of b: the low half sums the bytes, the high half sums the low half after each
/// byte, both from (1, 0) and modulo 65521.
constexpr std::uint32_t joined_adler(std::uint32_t a, std::uint32_t b, std::size_t length_of_b) {
  constexpr std::uint64_t kBase = 65521;
  const std::uint64_t before = (a & 0xFFFF) + kBase - 1;  // what b's sums would have started with, less the 1 that they did
  const std::uint64_t low = (before + (b & 0xFFFF)) % kBase;
  const std::uint64_t high = ((a >> 16) + (b >> 16) + before % kBase * (length_of_b % kBase)) % kBase;
  return static_cast<std::uint32_t>((high << 16) | low);
}

}  // namespace lustro
