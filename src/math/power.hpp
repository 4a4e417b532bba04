// log2, exp2 and x^n from additions, multiplications and the bits of a float: libm differs between systems, this does not. The polynomials
// are minimax fits of our own (Remez, relative error); evaluation is Estrin's scheme, whose order is part of the promised bits.
// Errors are measured over the whole range by tests/math/power_test.cpp.
#pragma once

#include <limits>

#include "math/lane.hpp"

namespace lustro {

/// log2(x). x: positive, normal. Relative error below 4e-7 (of the result, also near x = 1).
template <class F>
LUSTRO_INLINE F log2_of(const F& x) {
  using I = IntOf<F>;
  constexpr std::int32_t kSqrtHalf = 0x3F3504F3;  // the bits of sqrt(1/2): the mantissa is taken from sqrt(1/2)..sqrt(2)
  const I shifted = bits_of(x) - I(kSqrtHalf);
  const F exponent = to_float(shifted >> 23);
  const F f = from_bits((shifted & I(0x007FFFFF)) + I(kSqrtHalf)) - F(1);
  const F f2 = f * f;
  const F f4 = f2 * f2;
  const F low = (F(1.442694902F) + F(-0.7213528156F) * f) + (F(0.4809232354F) + F(-0.3602396250F) * f) * f2;
  const F high = (F(0.2870987058F) + F(-0.2488768697F) * f) + (F(0.2340423763F) + F(-0.1458116919F) * f) * f2;
  return exponent + f * (low + high * f4);
}

/// 2^y. y <= -100 gives 0, so that no intermediate is ever a denormal; y >= 127 gives 2^127. Relative error below 3e-7. Exactly 1 at y = 0.
template <class F>
LUSTRO_INLINE F exp2_of(const F& y) {
  using I = IntOf<F>;
  const F clamped = lane_min(lane_max(y, F(-100)), F(127));
  const I whole = truncate(clamped + F(128.5F)) - I(128);  // nearest whole number, for the argument is above -128.5
  const F r = clamped - to_float(whole);
  const F r2 = r * r;
  const F low = (F(1) + F(0.6931471825F) * r) + (F(0.2402264625F) + F(0.05550328642F) * r) * r2;
  const F high = (F(0.009618489072F) + F(0.001339993090F) * r) + F(0.0001534581243F) * r2;
  const F mantissa = low + high * (r2 * r2);
  return select(y <= F(-100), F(0), mantissa * from_bits((whole + I(127)) << 23));
}

/// An exponent n and what of it is found once, rather than at every point.
struct Exponent {
  static constexpr float kMostSquared = 256;

  float n = 0;
  int whole = 0;  ///< n where repeated squaring raises to it: a whole number of 0..256; else -1
  /// 2^(-99/n) where it does: a base below gives 0, so that no intermediate is ever a denormal. With n = 0 there is none.
  float smallest = -std::numeric_limits<float>::infinity();

  Exponent() = default;
  Exponent(float n_) : n(n_), whole(-1) {  // NOLINT(google-explicit-constructor): a number is an exponent
    if (n >= 0 && n <= kMostSquared && to_float(truncate(n)) == n) {
      whole = truncate(n);
      smallest = whole == 0 ? smallest : exp2_of(-99.0F / n);
    }
  }
};

/// x^n with the conventions of lighting: x^0 = 1 for every x, 0 to a positive power is 0, negative x counts as 0. Below 2^-100, for a whole n
/// below 2^-99, the result is 0, above 2^127 it is 2^127; for a whole n of 1..256, where x is a cosine and at most 1.4, that upper bound is not
/// looked after. Exactly 1 at x = 1. Relative error below n 6e-8 for a whole n of 1..256, else below 1e-6 (1 + |n log2 x|).
template <class F>
LUSTRO_INLINE F power(const F& x, const Exponent& exponent) {
  if (exponent.whole >= 0) {  // the same in all lanes
    F square = lane_max(x, F(exponent.smallest));
    F result = exponent.whole % 2 == 1 ? square : F(1);
    for (int left = exponent.whole / 2; left != 0; left /= 2) {
      square = square * square;
      result = left % 2 == 1 ? result * square : result;
    }
    return select(x < F(exponent.smallest), F(0), result);
  }
  constexpr float kSmallestNormal = 1.17549435e-38F;
  const F base = lane_max(x, F(kSmallestNormal));
  const F result = exp2_of(F(exponent.n) * log2_of(base));
  return select(x < F(kSmallestNormal), F(exponent.n < 0 ? 1.7014118e38F : 0.0F), result);
}

/// An exponent that differs from lane to lane: 0..10000.
template <class F>
struct LaneExponent {
  F n;
};

/// The same by exp2(n log2 x), whether n is whole or not.
template <class F>
LUSTRO_INLINE F power(const F& x, const LaneExponent<F>& exponent) {
  constexpr float kSmallestNormal = 1.17549435e-38F;
  const F base = lane_max(x, F(kSmallestNormal));
  const F result = exp2_of(exponent.n * log2_of(base));
  return select(x < F(kSmallestNormal), select(exponent.n > F(0), F(0), F(1)), result);
}

}  // namespace lustro
