// What must hold for any mesh that a parser gives, and for what build_mesh() makes of it.
#pragma once

#include <cstdio>
#include <cstdlib>

#include "lustro/mesh.hpp"

namespace lustro {

/// Ends the program with a report where a promise is broken: libFuzzer keeps the input.
inline void require(bool is_kept, const char* promise) {
  if (!is_kept) {
    std::fprintf(stderr, "broken promise: %s\n", promise);
    std::abort();
  }
}

inline void check_source(const SourceMesh& mesh) {
  const std::size_t faces = mesh.face_count();
  const std::size_t corners = mesh.corner_position.size();
  require(mesh.face_begin.front() == 0 && mesh.face_begin.back() == corners, "face_begin spans the corners");
  for (std::size_t f = 0; f < faces; ++f) {
    require(mesh.face_begin[f + 1] >= mesh.face_begin[f] + 3, "a face has three corners or more");
  }
  const auto is_inside = [](const std::vector<std::uint32_t>& indices, std::size_t count, bool may_be_none) {
    for (const std::uint32_t index : indices) {
      if (index >= count && !(may_be_none && index == SourceMesh::kNone)) {
        return false;
      }
    }
    return true;
  };
  require(is_inside(mesh.corner_position, mesh.positions.size(), false), "positions' indices are inside");
  require(is_inside(mesh.corner_normal, mesh.normals.size(), true), "normals' indices are inside");
  require(is_inside(mesh.corner_uv, mesh.uvs.size(), true), "uvs' indices are inside");
  require(is_inside(mesh.face_material, mesh.materials.size(), true), "materials' indices are inside");
  require(is_inside(mesh.face_object, mesh.objects.size(), false), "objects' indices are inside");
  for (const auto* per_corner : {&mesh.corner_normal, &mesh.corner_uv}) {
    require(per_corner->empty() || per_corner->size() == corners, "one entry a corner, or none");
  }
  for (const auto* per_face : {&mesh.face_smoothing, &mesh.face_material, &mesh.face_object}) {
    require(per_face->empty() || per_face->size() == faces, "one entry a face, or none");
  }
  require(mesh.colors.empty() || mesh.colors.size() == mesh.positions.size(), "one colour a position, or none");
  require(mesh.face_colors.empty() || mesh.face_colors.size() == faces, "one colour a face, or none");
  for (const auto* colors : {&mesh.colors, &mesh.face_colors}) {
    for (const Vec3f& c : *colors) {
      require(c.x >= 0 && c.x <= 1 && c.y >= 0 && c.y <= 1 && c.z >= 0 && c.z <= 1, "colours are in 0..1");
    }
  }
}

/// A parsed mesh and the mesh that would be drawn.
inline void check_mesh(const Result<SourceMesh>& parsed) {
  if (!parsed) {
    require(!parsed.error().where.empty() && !parsed.error().message.empty(), "an error says where and what");
    return;
  }
  check_source(*parsed);
  const Result<BuiltMesh> built = build_mesh(*parsed);
  require(built.has_value(), "what a parser gives can be built");
  const Mesh& mesh = built->mesh;
  for (const Vec3f& p : mesh.positions) {
    require(is_finite(p), "built positions are finite");
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t index : triangle) {
      require(index < mesh.positions.size(), "built indices are inside");
    }
  }
}

}  // namespace lustro
