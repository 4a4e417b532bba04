// What an arithmetic lane must offer beside + - * / and comparisons, and the lane of one float. A SIMD lane type offers the same names, so
// that the lighting equation is written once. Every operation here is exact or correctly rounded by IEEE 754: equal bits on every machine.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

/// What the shading of a pixel is made of: a kernel's vectors would go through memory at every call.
#define LUSTRO_INLINE [[gnu::always_inline]] inline

namespace lustro {

// clang-format off
/// select(mask, a, b): a where the mask holds, else b. Both sides are evaluated.
inline float select(bool mask, float a, float b) { return mask ? a : b; }
inline double select(bool mask, double a, double b) { return mask ? a : b; }
inline std::int32_t select(bool mask, std::int32_t a, std::int32_t b) { return mask ? a : b; }

/// Whether a mask holds in any lane.
inline bool any_of(bool mask) { return mask; }

/// max(a, b) = a > b ? a : b: b where either is NaN, the same on every instruction set.
template <class F> F lane_max(const F& a, const F& b) { return select(a > b, a, b); }
template <class F> F lane_min(const F& a, const F& b) { return select(a < b, a, b); }
template <class F> F clamp01(const F& a) { return lane_min(lane_max(a, F(0)), F(1)); }
template <class F> F lane_abs(const F& a) { return select(a < F(0), -a, a); }

inline float square_root(float a) { return std::sqrt(a); }
inline double square_root(double a) { return std::sqrt(a); }

/// The bits of a float and back, for exponents and mantissas.
template <class F> struct LaneInt;
template <> struct LaneInt<float> { using type = std::int32_t; };
template <class F> using IntOf = typename LaneInt<F>::type;
inline std::int32_t bits_of(float a) { return std::bit_cast<std::int32_t>(a); }
inline float from_bits(std::int32_t bits) { return std::bit_cast<float>(bits); }
/// Exact for |i| < 2^24.
inline float to_float(std::int32_t i) { return static_cast<float>(i); }
/// Towards zero; the argument must fit an int32.
inline std::int32_t truncate(float a) { return static_cast<std::int32_t>(a); }
/// p[index] of every lane.
inline float gather(const float* p, std::int32_t index) { return p[index]; }
inline std::int32_t gather(const std::int32_t* p, std::int32_t index) { return p[index]; }
/// Two numbers beside each other at each of two places.
template <class F> struct TwoPairs { F first_left, first_right, second_left, second_right; };
inline TwoPairs<float> gather_pairs(const float* p, std::int32_t first, std::int32_t second) { return {p[first], p[first + 1], p[second], p[second + 1]}; }
/// The largest whole number that is not above; of any float, NaN and infinities stay.
inline float floor_of(float a) {
  if (!(std::abs(a) < 8388608.0F)) {
    return a;  // whole already
  }
  const float t = to_float(truncate(a));
  return t > a ? t - 1.0F : t;
}
// clang-format on

}  // namespace lustro
