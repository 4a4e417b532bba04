// Displacement: a mesh is subdivided until a height map has vertices to move, and these are moved along their normals.
//
// Based on Cook 1984 (Shade trees), where displacement maps come from.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "lustro/mesh.hpp"

namespace lustro {

/// A material's height map as a mesh needs it.
struct DisplacementMap {
  std::uint8_t uv_set = 0;                          ///< 0: Mesh::uvs, 1: Mesh::uvs1
  std::array<float, 4> texels_from_uv{1, 0, 0, 1};  ///< texels that a step in (u, v) goes across and down
  /// The height at texture coordinates, in units of the mesh; `spacing`: the texels between the mesh's vertices. Empty: the material has no map.
  /// Called from several threads at once.
  std::function<float(const Vec2f& uv, float spacing)> height{};
};

struct DisplacementOptions {
  bool encoded_colors = true;  ///< vertex colours are blended in linear light
  float texels_an_edge = 2;    ///< edges in maps are not longer
  std::size_t most_triangles = std::size_t{1} << 21U;
  int threads = 0;  ///< 0: one a core; the result is the same for any number
};

/// A displaced mesh, and what did not go as asked: empty, or a sentence.
struct DisplacedMesh {
  Mesh mesh;
  std::string note;
};

/// The mesh, subdivided and displaced.
///
/// Edges of a triangle with a map are halved, the longest ones first, until none spans more than two texels, or until the next step would take
/// more than `most_triangles` (or the mesh alone has as many), which is noted; heights are then looked up in smaller copies of the picture. An
/// edge is halved for all triangles that share its two points, whatever their vertices, so no crack opens. New vertices are the middle of the
/// two old ones, in all that vertices hold. Children stand where their triangle stood, in their order.
///
/// Each vertex goes height times its unit normal. Vertices that were at one position move together, by the mean of what those with a map ask
/// for: so a seam of texture coordinates, a crease or the border to a material without a map stays closed.
///
/// Normals turn as the surface turns: by the smallest rotation from the mesh's own normal (of the triangles around, by area) before to that
/// after. Vertices of one position that shared a normal share it still. So heights that are equal everywhere change no normal of a plane, and a
/// smooth surface stays smooth.
///
/// mesh  with unit normals; indices inside their arrays; maps name sets of coordinates that it has
/// maps  one a material (Mesh::triangle_material; a single one where that is empty)
[[nodiscard]] DisplacedMesh displaced(const Mesh& mesh, std::span<const DisplacementMap> maps, const DisplacementOptions& options = {});

}  // namespace lustro
