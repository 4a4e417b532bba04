// Which material a triangle has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "lustro/mesh.hpp"

namespace lustro {

/// Materials go over as they are; triangles without one get the default material, appended once. All of the first: none stated.
/// material_of  of triangle t: an index into materials, or SourceMesh::kNone
template <class MaterialOf>
void assign_materials(std::vector<Material> materials, std::size_t triangles, const MaterialOf& material_of, Mesh& mesh) {
  mesh.materials = std::move(materials);
  const auto none = static_cast<std::uint32_t>(mesh.materials.size());
  bool all_first = true;
  mesh.triangle_material.resize(triangles);
  for (std::size_t t = 0; t < triangles; ++t) {
    const std::uint32_t stated = material_of(t);
    const std::uint32_t material = stated == SourceMesh::kNone ? none : stated;
    if (material == none && mesh.materials.size() == none) {
      mesh.materials.emplace_back().name = "default";
    }
    all_first = all_first && material == 0;
    mesh.triangle_material[t] = material;
  }
  if (all_first) {
    mesh.triangle_material = {};
  }
}

}  // namespace lustro
