// From uniform numbers to directions and points, each with its density. Densities of directions are by solid angle.
//
// source  Pharr, Jakob and Humphreys, Physically Based Rendering, 4th edition, A.5; Lafortune and Willems 1994 (TR CW197) for the Phong lobe
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "lustro/vec.hpp"
#include "math/power.hpp"
#include "math/trig.hpp"

namespace lustro {

inline constexpr float kPiF = 3.14159265F;
inline constexpr float kInversePiF = 0.318309886F;

/// Two directions at right angles to n and to each other; all unit, right-handed with n last.
/// source  Duff et al. 2017, Building an orthonormal basis, revisited
struct Frame3 {
  Vec3f x, y, z;
  explicit Frame3(const Vec3f& n) : z(n) {
    const float sign = std::copysign(1.0F, n.z);
    const float a = -1.0F / (sign + n.z);
    const float b = n.x * n.y * a;
    x = {1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x};
    y = {b, sign + n.y * n.y * a, -n.y};
  }
  [[nodiscard]] Vec3f world(const Vec3f& v) const { return (x * v.x + y * v.y) + z * v.z; }
};

/// (cos, sin) of 2 pi u.
[[nodiscard]] inline Vec2f on_circle(float u) {
  const float angle = (u - 0.5F) * (2 * kPiF);  // -pi..pi, turned by half a turn
  const auto [sine_over_angle, cosine] = sine_over_x(std::abs(angle));
  return {-cosine, -(sine_over_angle * angle)};
}

/// sqrt(max(x, 0))
[[nodiscard]] inline float safe_root(float x) {
  return x > 0 ? std::sqrt(x) : 0.0F;
}

/// The direction at this cosine from z.
[[nodiscard]] inline Vec3f at_cosine(float cosine, float turn) {
  const float sine = safe_root(1.0F - cosine * cosine);
  const Vec2f around = on_circle(turn);
  return {sine * around.x, sine * around.y, cosine};
}

/// Uniform in the unit disk, by concentric squares (Shirley and Chiu 1997): neighbours stay neighbours. Density 1 / pi.
[[nodiscard]] Vec2f sample_disk(const Vec2f& u);

/// About z with density cos / pi.
[[nodiscard]] inline Vec3f sample_cosine(const Vec2f& u) {
  const Vec2f d = sample_disk(u);
  return {d.x, d.y, safe_root(1.0F - (d.x * d.x + d.y * d.y))};
}

/// About z with density (n + 1) / 2 pi cos^n, cos > 0.
[[nodiscard]] inline Vec3f sample_power_cosine(float n, const Vec2f& u) {
  return at_cosine(power(1.0F - u.x, LaneExponent<float>{1.0F / (n + 1.0F)}), u.y);
}
[[nodiscard]] inline float power_cosine_density(float n, float cosine) {
  return cosine > 0 ? (n + 1.0F) * (0.5F * kInversePiF) * power(cosine, LaneExponent<float>{n}) : 0.0F;
}

/// A normal about z with density D cos of Trowbridge and Reitz, a = alpha^2.
[[nodiscard]] inline Vec3f sample_ggx_normal(float a, const Vec2f& u) {
  return at_cosine(std::sqrt((1.0F - u.x) / (1.0F + (a - 1.0F) * u.x)), u.y);
}
[[nodiscard]] inline float ggx_normal_density(float a, float cosine) {
  const float d = cosine * cosine * (a - 1.0F) + 1.0F;
  return cosine > 0 ? a * cosine * kInversePiF / (d * d) : 0.0F;
}

/// Uniform in the cone about z with these 1 - cos of its half angle. Density 1 / (2 pi one_minus_cosine).
[[nodiscard]] inline Vec3f sample_cone(float one_minus_cosine, const Vec2f& u) {
  const float drop = u.x * one_minus_cosine;  // 1 - cos, exact for narrow cones
  const float sine = safe_root(drop * (2.0F - drop));
  const Vec2f around = on_circle(u.y);
  return {sine * around.x, sine * around.y, 1.0F - drop};
}

/// Uniform over the sphere. Density 1 / 4 pi.
[[nodiscard]] inline Vec3f sample_sphere(const Vec2f& u) {
  return at_cosine(1.0F - 2.0F * u.x, u.y);
}

/// Weights of a triangle's vertices, uniform over its area (Heitz 2019, without a root).
[[nodiscard]] inline Vec3f sample_triangle(const Vec2f& u) {
  const float half = 0.5F * std::min(u.x, u.y);  // the two halves of the square without a branch, which nobody could predict
  const float b0 = u.x - half;
  const float b1 = u.y - half;
  return {b0, b1, (1.0F - b0) - b1};
}

/// The share of a strategy with density `a` beside one with `b`.
/// source  Veach 1997, 9.2.4: the power heuristic with exponent 2
[[nodiscard]] inline float power_heuristic(float a, float b) {
  if (!(a > 0)) {
    return 0;
  }
  const float ratio = b / a;
  return 1.0F / (1.0F + ratio * ratio);
}

/// Indices chosen with a probability in proportion to their weight, in a time that does not grow with their number: a table says where to look
/// (Chen and Asau 1974, the method of guide tables).
class Choice {
 public:
  Choice() = default;
  /// Weights are >= 0 and finite. Where all are 0 nothing can be chosen.
  explicit Choice(std::span<const float> weights);

  [[nodiscard]] bool is_empty() const { return !(total_ > 0); }
  [[nodiscard]] double total() const { return total_; }

  /// What was chosen with u, how probable it was, and a number 0..1 that is left for the next choice.
  struct Chosen {
    std::uint32_t index = 0;
    float probability = 0;
    float rest = 0;
  };
  [[nodiscard]] Chosen choose(float u) const;
  [[nodiscard]] float probability(std::uint32_t index) const { return static_cast<float>(sums_[index + 1] - sums_[index]); }

 private:
  std::vector<double> sums_;          // 0 .. 1, of the probabilities before
  std::vector<std::uint32_t> guide_;  // the first index that is chosen by u >= i / size
  std::uint32_t last_ = 0;            // the last with a weight
  double total_ = 0;
};

}  // namespace lustro
