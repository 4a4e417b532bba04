// Vertex normals from the faces around a vertex.
#pragma once

#include <cstdint>
#include <vector>

#include "lustro/mesh.hpp"
#include "mesh/smoothing.hpp"

namespace lustro {

/// A sum shorter than this share of its summands has cancelled: what is left is rounding.
inline constexpr double kCancelled = 1e-6;

/// Normals by index. No normal is shared by corners at different positions.
struct CornerNormals {
  std::vector<Vec3f> normals;                ///< N x 3, unit
  std::vector<std::uint32_t> corner_normal;  ///< C, into normals
};

/// Normals for every corner of every face.
///
/// A group's normal (smoothing.hpp) is the normalised sum of the unit normals of its faces, whole polygons and not their triangles, each
/// weighted by 1 (`uniform`; a face counts once), by its area, or by the angle at the corner. Sums are made in double, in the order of the
/// faces. Slivers do not count unless there is nothing else; where the sum cancels to zero, each face keeps its own normal. Faces are taken
/// with the winding that they have: neighbours wound against each other cancel.
/// source  Gouraud 1971 (uniform); Thuermer, Wuethrich 1998, Computing vertex normals from polygonal facets (angle); Max 1999 compares
/// threads  0: one a core; the normals are the same for any number
[[nodiscard]] CornerNormals make_normals(const Faces& faces, const NormalOptions& options, int threads = 0);

/// The mesh with a unit normal at every vertex; as it is, where it has them and options.recompute does not ask for others.
///
/// Vertices keep their index; where faces do not share a normal, copies are added behind them. Two vertices at one position are two vertices:
/// nothing is welded, no triangle dropped. A vertex that no triangle uses gets (0, 0, 1).
/// mesh  indices inside their arrays, positions finite
[[nodiscard]] Mesh with_vertex_normals(const Mesh& mesh, const NormalOptions& options);

}  // namespace lustro
