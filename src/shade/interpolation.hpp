// Interpolating normals over a triangle: the weighted sum (Phong 1975), and the spherical weighted average of Buss and Fillmore, "Spherical
// averages and applications to spherical splines and interpolation", ACM TOG 2001, algorithm A1. On an edge the latter is the classic
// slerp n(t) = (sin((1-t)a) n0 + sin(ta) n1) / sin a, whatever the third corner, so neighbours agree along their edge.
#pragma once

#include <array>

#include "lustro/options.hpp"
#include "lustro/vec.hpp"
#include "math/lane.hpp"
#include "math/trig.hpp"

namespace lustro {

/// Perspective-correct weights of a triangle's three vertices; they sum to 1.
template <class F>
using Weights = std::array<F, 3>;

template <class F>
LUSTRO_INLINE Vec3<F> weighted_sum(const std::array<Vec3<F>, 3>& values, const Weights<F>& w) {
  return (values[0] * w[0] + values[1] * w[1]) + values[2] * w[2];
}

/// The weighted sum, normalised; `fallback` where the normals cancel.
template <class F>
LUSTRO_INLINE Vec3<F> lerp_normal(const std::array<Vec3<F>, 3>& normals, const Weights<F>& w, const Vec3<F>& fallback) {
  const Vec3<F> sum = weighted_sum(normals, w);
  const F length2 = dot(sum, sum);
  const auto cancels = length2 < F(1e-12F);
  const F scale = F(1) / square_root(select(cancels, F(1), length2));
  return {select(cancels, fallback.x, sum.x * scale), select(cancels, fallback.y, sum.y * scale), select(cancels, fallback.z, sum.z * scale)};
}

/// The unit vector q that minimises sum_i w_i angle(q, n_i)^2. The normals are unit; `fallback` where they cancel.
template <class F>
Vec3<F> slerp_normal(const std::array<Vec3<F>, 3>& normals, const Weights<F>& w, const Vec3<F>& fallback) {
  constexpr int kMaxSteps = 32;        // two or three are usual; normals that lie 120 degrees apart may need all
  constexpr float kConverged = 3e-7F;  // radians; a smaller step is rounding
  Vec3<F> q = lerp_normal(normals, w, fallback);
  for (int step = 0; step < kMaxSteps; ++step) {
    Vec3<F> tangent{};  // the weighted mean of the normals, unrolled into the tangent plane at q
    for (std::size_t i = 0; i < 3; ++i) {
      const F cosine = dot(normals[i], q);
      const Vec3<F> across = normals[i] - q * cosine;
      const F sine = length(across);
      const auto close = sine < F(1e-6F);
      const F unroll = select(close, F(1), angle_of(sine, cosine) / select(close, F(1), sine));
      tangent += across * (w[i] * unroll);
    }
    const F angle = length(tangent);
    const auto [sine_over_angle, cosine] = sine_over_x(lane_min(angle, F(3.14159265F)));
    const Vec3<F> moved = normalize(q * cosine + tangent * sine_over_angle);
    const auto moves = angle > F(kConverged);
    q = {select(moves, moved.x, q.x), select(moves, moved.y, q.y), select(moves, moved.z, q.z)};
    if (!any_of(moves)) {
      break;
    }
  }
  return q;
}

template <class F>
LUSTRO_INLINE Vec3<F> interpolate_normal(NormalInterpolation mode, const std::array<Vec3<F>, 3>& normals, const Weights<F>& w,
                                         const Vec3<F>& fallback) {
  return mode == NormalInterpolation::lerp ? lerp_normal(normals, w, fallback) : slerp_normal(normals, w, fallback);
}

}  // namespace lustro
