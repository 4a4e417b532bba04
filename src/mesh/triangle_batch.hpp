// Planes and corner angles of triangles, many at a time: what vertex normals are summed from.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace lustro {

/// Triangles as one array a number. The corners of triangle i are (x[k][i], y[k][i], z[k][i]), k = 0, 1, 2.
struct TriangleBatch {
  static constexpr std::size_t kSize = 64;
  using Column = std::array<double, kSize>;

  alignas(64) std::array<Column, 3> x, y, z;
  alignas(64) Column normal_x, normal_y, normal_z;         ///< unit; 0 where the triangle has no area
  alignas(64) Column area;                                 ///< twice it is exactly 0 where the triangle has none
  alignas(64) std::array<std::uint64_t, kSize> is_sliver;  ///< 0 or 1, as PolygonPlane means it
  alignas(64) std::array<Column, 3> angle;                 ///< at the corners, 0..pi
};

/// The planes of all triangles of the batch, and the angles where they are wanted: the same bits as plane_of() and arctangent2() give for one
/// triangle, on every machine.
void measure(TriangleBatch& batch, bool with_angles);

}  // namespace lustro
