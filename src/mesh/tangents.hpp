// Tangents for normal maps by MikkTSpace, the convention that baking tools and renderers share.
#pragma once

#include <array>
#include <cstdint>

#include "lustro/mesh.hpp"

namespace lustro {

/// How a normal map's picture lies on the mesh: the tangent points to the picture's right, the bitangent to its top.
struct TangentOptions {
  std::uint8_t uv_set = 0;                     ///< 0: Mesh::uvs, 1: Mesh::uvs1
  std::array<float, 4> uv_matrix{1, 0, 0, 1};  ///< of (u, v), as TextureUse::uv_matrix without its shift; the picture's v goes down
  friend bool operator==(const TangentOptions&, const TangentOptions&) = default;
};

/// The mesh with tangents, in glTF's form: xyz unit, w the sign in bitangent = w cross(normal, tangent). Where the corners of a vertex need
/// different ones (at a seam of mirrored coordinates, say) the vertex is there twice; triangles keep their order and their corners.
///
/// The result does not depend on the order of triangles, but for those without an area in texture coordinates and for edges that more than two
/// triangles share. A corner whose triangles all lack such an area gets (1, 0, 0, 1).
///
/// mesh    with normals and that set of texture coordinates, else it comes back as it is; indices inside their arrays
/// source  Mikkelsen 2008, Simulation of wrinkled surfaces revisited, and the published description of MikkTSpace; its default angle of 180
///         degrees. Sums are taken in double and in an order that is their own, so its last digits differ.
[[nodiscard]] Mesh with_tangents(const Mesh& mesh, const TangentOptions& options = {});

}  // namespace lustro
