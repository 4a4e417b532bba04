// Random numbers by (pixel, sample, dimension): no state, so that neither threads nor tiles nor passes change what is drawn. Pairs of the Sobol
// sequence's first two dimensions, each pair shuffled and Owen-scrambled by hashes of its own: the samples of a pixel are stratified in every
// pair.
//
// source  Burley 2020, Practical hash-based Owen scrambling (JCGT 9, 4); the hash is Vegdahl's of 2021 (Building a better LK hash), after Laine
//         and Karras 2011
#pragma once

#include <cstdint>

#include "lustro/vec.hpp"

namespace lustro {

/// The bits in the opposite order.
[[nodiscard]] constexpr std::uint32_t reversed_bits(std::uint32_t x) {
  x = ((x >> 1U) & 0x55555555U) | ((x & 0x55555555U) << 1U);
  x = ((x >> 2U) & 0x33333333U) | ((x & 0x33333333U) << 2U);
  x = ((x >> 4U) & 0x0F0F0F0FU) | ((x & 0x0F0F0F0FU) << 4U);
  x = ((x >> 8U) & 0x00FF00FFU) | ((x & 0x00FF00FFU) << 8U);
  return (x >> 16U) | (x << 16U);
}

/// Every bit depends on every bit: murmur3's finalizer with better constants (Wellons 2018, lowbias32).
[[nodiscard]] constexpr std::uint32_t mixed(std::uint32_t x) {
  x ^= x >> 16U;
  x *= 0x7FEB352DU;
  x ^= x >> 15U;
  x *= 0x846CA68BU;
  x ^= x >> 16U;
  return x;
}

/// Each bit is flipped by a hash of those below it: an Owen scramble of the bits in opposite order.
[[nodiscard]] constexpr std::uint32_t owen_hash(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3D20ADEAU;
  x += seed;
  x *= (seed >> 16U) | 1U;
  x ^= x * 0x05526C56U;
  x ^= x * 0x53A22864U;
  return x;
}

/// The Sobol sequence's second dimension, bits in opposite order: index(1 + x) as polynomials over the bits, since its matrix is Pascal's
/// triangle.
[[nodiscard]] constexpr std::uint32_t sobol_second_reversed(std::uint32_t index) {
  index ^= (index & 0xAAAAAAAAU) >> 1U;
  index ^= (index & 0xCCCCCCCCU) >> 2U;
  index ^= (index & 0xF0F0F0F0U) >> 4U;
  index ^= (index & 0xFF00FF00U) >> 8U;
  index ^= index >> 16U;
  return index;
}

/// The upper 24 bits as a number 0..1, the 1 excluded.
[[nodiscard]] constexpr float unit_float(std::uint32_t bits) {
  return static_cast<float>(bits >> 8U) * 0x1p-24F;
}

/// The numbers of one path.
class PathRandom {
 public:
  PathRandom(std::uint32_t pixel, std::uint32_t sample, std::uint32_t seed)
      : seed_(mixed(pixel ^ mixed(seed ^ 0x9E3779B9U))), reversed_sample_(reversed_bits(sample)) {}

  /// Two numbers 0..1, the 1 excluded, of the pair of dimensions `pair`.
  [[nodiscard]] Vec2f pair(std::uint32_t pair) const {
    const std::uint32_t seed = mixed(seed_ + pair * 0x9E3779B9U);
    const std::uint32_t index = reversed_bits(owen_hash(reversed_sample_, seed));
    return {first_of(index, seed), unit_float(reversed_bits(owen_hash(sobol_second_reversed(index), mixed(seed ^ 0x02E5BE93U))))};
  }
  /// The first of them alone.
  [[nodiscard]] float one(std::uint32_t pair) const {
    const std::uint32_t seed = mixed(seed_ + pair * 0x9E3779B9U);
    return first_of(reversed_bits(owen_hash(reversed_sample_, seed)), seed);
  }

 private:
  [[nodiscard]] static float first_of(std::uint32_t index, std::uint32_t seed) {
    return unit_float(reversed_bits(owen_hash(index, mixed(seed ^ 0x68BC21EBU))));
  }

  std::uint32_t seed_;
  std::uint32_t reversed_sample_;
};

}  // namespace lustro
