// The common case of a mesh, held as compactly as it is drawn: triangles whose corners have one index for all attributes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lustro/mesh.hpp"

namespace lustro {

/// A SourceMesh of which only this is needed: half the memory of the general form, and nothing to be copied on the way to a Mesh.
struct PlainMesh {
  std::vector<Vec3f> positions;                         ///< V x 3
  std::vector<Vec3f> normals;                           ///< V x 3 or empty
  std::vector<Vec2f> uvs;                               ///< V x 2 or empty
  std::vector<Vec3f> colors;                            ///< V x 3 or empty
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< F, inside positions
  std::vector<std::uint32_t> materials_of;              ///< F or empty; an index into materials, or SourceMesh::kNone
  std::vector<Material> materials;
  std::string format;
  Notes notes;

  /// Stated where the vertices stand in the order of their first use: how many are used. The others are the last ones.
  std::optional<std::size_t> used;
};

/// Brings the vertices into the order of their first use.
void sort_by_first_use(PlainMesh& plain, int threads);

/// The same mesh in the general form.
[[nodiscard]] SourceMesh to_source(PlainMesh plain);

/// The same mesh in the plain form, where it has one and build_plain() makes of it what the general way makes. What is taken over is moved from.
/// source  its indices are inside their arrays
[[nodiscard]] std::optional<PlainMesh> to_plain(SourceMesh& source, const NormalOptions& options, int threads);

/// True where build_plain() can do what is asked for.
[[nodiscard]] inline bool makes_plain_normals(const NormalOptions& options) {
  return options.crease_deg == 180;
}

/// build_mesh() of the mesh in the general form, bit by bit, for makes_plain_normals(options).
[[nodiscard]] BuiltMesh build_plain(PlainMesh mesh, const NormalOptions& options, int threads);

}  // namespace lustro
