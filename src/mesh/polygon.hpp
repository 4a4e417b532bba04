// What a polygon in space is: its plane, its size, its corners' angles. Sums in double, so that float positions cost no precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "lustro/vec.hpp"

namespace lustro {

/// A polygon's plane and size.
struct PolygonPlane {
  Vec3d normal;           ///< unit, towards the side from which the corners run counter-clockwise; 0 where all corners lie on a line
  double area = 0;        ///< half the length of the vector area; that of a triangle or of a planar polygon
  double rounding = 0;    ///< a distance below which the corners' float coordinates say nothing
  bool is_sliver = true;  ///< not wider than that rounding, so that the normal is noise (or 0)
};

/// Source  Newell's method (Sutherland, Sproull, Schumacker 1974): the sum of the edges' areas projected on the three planes. We sum around
///         the first corner. A polygon that crosses itself so that its areas cancel has the normal of its first three corners that make one.
/// size      at least 3
/// position  of corner i, as a Vec3f
template <class Position>
[[nodiscard]] PolygonPlane plane_of(std::size_t size, const Position& position) {
  const Vec3d origin = vec_cast<double>(position(0));
  Vec3d sum{};
  double largest = std::max({std::abs(origin.x), std::abs(origin.y), std::abs(origin.z)});
  double longest_squared = 0;
  Vec3d a{};
  for (std::size_t i = 1; i <= size; ++i) {
    const Vec3d point = i < size ? vec_cast<double>(position(i)) : origin;
    const Vec3d b = point - origin;
    const Vec3d edge = b - a;
    sum += cross(a, b);
    largest = std::max({largest, std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    longest_squared = std::max(longest_squared, dot(edge, edge));
    a = b;
  }
  PolygonPlane plane;
  double doubled = length(sum);
  plane.area = doubled / 2;
  plane.rounding = largest * 0x1p-23;
  if (size > 3 && doubled <= plane.rounding * std::sqrt(longest_squared)) {
    for (std::size_t i = 1; i + 1 < size; ++i) {
      const Vec3d corner = cross(vec_cast<double>(position(i)) - origin, vec_cast<double>(position(i + 1)) - origin);
      if (const double size_of_corner = length(corner); size_of_corner > plane.rounding * std::sqrt(longest_squared)) {
        sum = corner;
        doubled = size_of_corner;
        break;
      }
    }
  }
  if (doubled > 0) {
    plane.normal = {sum.x / doubled, sum.y / doubled, sum.z / doubled};
    plane.is_sliver = doubled <= plane.rounding * std::sqrt(longest_squared);
  }
  return plane;
}

}  // namespace lustro
