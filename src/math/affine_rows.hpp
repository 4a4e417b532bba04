// An affine transform as floats that every lane type sums alike.
#pragma once

#include <array>
#include <cstddef>

#include "lustro/vec.hpp"

namespace lustro {

/// Three rows of four: a point's affine transform in float, summed in the order ((x + y) + z) + translation.
struct AffineRows {
  std::array<float, 12> m{};
  template <class F>
  [[nodiscard]] Vec3<F> operator()(const Vec3<F>& p) const {
    const auto row = [&](std::size_t i) { return ((F(m[i]) * p.x + F(m[i + 1]) * p.y) + F(m[i + 2]) * p.z) + F(m[i + 3]); };
    return {row(0), row(4), row(8)};
  }
  /// Of a direction: without the translation.
  template <class F>
  [[nodiscard]] Vec3<F> turned(const Vec3<F>& d) const {
    const auto row = [&](std::size_t i) { return (F(m[i]) * d.x + F(m[i + 1]) * d.y) + F(m[i + 2]) * d.z; };
    return {row(0), row(4), row(8)};
  }
};

/// Rows and a translation in double, each number rounded once.
[[nodiscard]] inline AffineRows to_rows(const std::array<Vec3d, 3>& rows, const Vec3d& translation) {
  AffineRows result;
  const std::array<double, 3> t{translation.x, translation.y, translation.z};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<double, 4> row{rows[i].x, rows[i].y, rows[i].z, t[i]};
    for (std::size_t j = 0; j < 4; ++j) {
      result.m[4 * i + j] = static_cast<float>(row[j]);
    }
  }
  return result;
}

}  // namespace lustro
