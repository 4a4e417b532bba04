// Trigonometry without libm, so that cameras, primitives and normals have the same bits on every system. Double precision for geometry;
// two lane functions for the spherical interpolation of normals.
#pragma once

#include "lustro/vec.hpp"
#include "math/lane.hpp"

namespace lustro {

inline constexpr double kPi = 3.14159265358979323846;

[[nodiscard]] constexpr double radians(double degrees) {
  return degrees * (kPi / 180);
}
[[nodiscard]] constexpr double degrees(double radians) {
  return radians * (180 / kPi);
}

/// Error below 1e-15 for |x| <= 1000.
[[nodiscard]] double sine(double x);
[[nodiscard]] double cosine(double x);
[[nodiscard]] double tangent(double x);
/// Of an angle in degrees: exact at multiples of 90.
[[nodiscard]] double sine_deg(double x);
[[nodiscard]] double cosine_deg(double x);
/// The angle of (x, y) in -pi..pi; 0 for (0, 0). Error below 1e-15.
[[nodiscard]] double arctangent2(double y, double x);
/// In 0..pi; the argument is clamped to -1..1.
[[nodiscard]] double arccosine(double x);
/// The angle between two vectors, 0..pi, accurate for small and large angles; 0 where one is zero.
[[nodiscard]] double angle_between(const Vec3d& a, const Vec3d& b);

/// sin(u) / u and cos(u) for 0 <= u <= pi; absolute error below 8e-7.
template <class F>
struct SineOverX {
  F sine_over_x, cosine;
};
template <class F>
SineOverX<F> sine_over_x(const F& u) {
  const F h = u * F(0.5F);  // sin u = 2 sin h cos h, cos u = 1 - 2 sin^2 h; Taylor to h^13 suffices up to pi/2
  const F x = h * h;
  const F sin_h_over_h =
      F(1) + x * (F(-1.0F / 6) + x * (F(1.0F / 120) + x * (F(-1.0F / 5040) + x * (F(1.0F / 362880) + x * F(-1.0F / 39916800)))));
  const F cos_h =
      F(1) +
      x * (F(-0.5F) + x * (F(1.0F / 24) + x * (F(-1.0F / 720) + x * (F(1.0F / 40320) + x * (F(-1.0F / 3628800) + x * F(1.0F / 479001600))))));
  const F sin_h = h * sin_h_over_h;
  return {sin_h_over_h * cos_h, F(1) - F(2) * (sin_h * sin_h)};
}

/// The angle in 0..pi whose sine is `s` >= 0 and whose cosine is `c`; absolute error below 2e-6.
template <class F>
F angle_of(const F& s, const F& c) {
  const auto obtuse =
      c < F(0);  // tan(a/2) = s / (1 + c) = (1 - c) / s, by whichever does not cancel; both parts below 2e15, whose square is finite
  const F tan_half = select(obtuse, F(1) - c, s) / lane_max(select(obtuse, s, F(1) + c), F(1e-15F));
  const F quarter = tan_half / (F(1) + square_root(F(1) + tan_half * tan_half));  // tan(a/4)
  const F t = quarter / (F(1) + square_root(F(1) + quarter * quarter));           // tan(a/8) <= tan(pi/8) = 0.4142
  const F x = t * t;
  const F arctan_over_t =
      F(1) + x * (F(-1.0F / 3) +
                  x * (F(1.0F / 5) + x * (F(-1.0F / 7) + x * (F(1.0F / 9) + x * (F(-1.0F / 11) + x * (F(1.0F / 13) + x * F(-1.0F / 15)))))));
  return F(8) * (t * arctan_over_t);
}

}  // namespace lustro
