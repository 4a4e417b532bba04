// Vertex normals of plain triangles, in parallel: make_normals() for meshes without polygons, creases and smoothing groups.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lustro/options.hpp"
#include "lustro/vec.hpp"

namespace lustro {

/// What normals of triangles are made from.
struct TriangleCorners {
  std::span<const Vec3f> positions;
  std::span<const std::array<std::uint32_t, 3>> triangles;  ///< inside positions; those are finite
  std::span<const std::array<std::uint32_t, 3>> groups;     ///< of the same corners: which of them share a normal
  std::size_t group_count = 0;
};

struct TriangleNormals {
  std::vector<Vec3f> normals;  ///< one a group, unit; 0 where no corner is in the group or its triangles cancel
  bool has_zero = false;       ///< some are 0
  bool has_flat = false;       ///< some triangles have no area at all
  bool has_thin = false;       ///< some have two corners at one place: they are no part of any normal, and not counted as flat
};

/// The normals that make_normals() gives of the faces that validate() leaves, bit by bit, whatever the number of threads.
///
/// Each thread sums up ranges of the groups and looks at all triangles that touch them, in their order; so nothing is shared, and
/// no sum depends on how many threads there are. A triangle on the border of ranges is measured more than once.
///
[[nodiscard]] TriangleNormals make_triangle_normals(const TriangleCorners& corners, VertexNormals weights, int threads);

/// The normal that a corner gets where those of its vertex cancel: its triangle's own, or (0, 0, 1) for one without area.
[[nodiscard]] Vec3f own_normal(std::span<const Vec3f> positions, const std::array<std::uint32_t, 3>& triangle);

}  // namespace lustro
