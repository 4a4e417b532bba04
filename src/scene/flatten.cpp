// All objects of a scene as one mesh.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "lustro/mesh_file.hpp"

namespace lustro {
namespace {

/// What the vertices of the whole mesh have.
struct Attributes {
  bool normals = true, tangents = true, uvs = false, uvs1 = false, colors = false, alphas = false, materials = false;
};

Attributes attributes_of(const Scene& scene) {
  Attributes all;
  for (const Object& object : scene.objects) {
    const Mesh& mesh = *object.mesh;
    if (mesh.positions.empty()) {
      continue;
    }
    all.normals = all.normals && !mesh.normals.empty();
    all.tangents = all.tangents && !mesh.tangents.empty();
    all.uvs |= !mesh.uvs.empty();
    all.uvs1 |= !mesh.uvs1.empty();
    all.colors |= !mesh.colors.empty();
    all.alphas |= !mesh.alphas.empty();
    all.materials |= object.material.has_value() || !mesh.materials.empty();
  }
  return all;
}

/// The linear part of a matrix, for directions.
struct Rows {
  std::array<Vec3d, 3> row{};
  [[nodiscard]] Vec3d times(const Vec3d& v) const { return {dot(row[0], v), dot(row[1], v), dot(row[2], v)}; }
};

/// A direction moved and made a unit again; as it was where that has no length.
Vec3f moved_direction(const Rows& rows, const Vec3f& direction) {
  const Vec3d moved = rows.times(vec_cast<double>(direction));
  const double size = length(moved);
  return size > 0 && std::isfinite(size) ? vec_cast<float>(moved * (1 / size)) : direction;
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from, std::size_t count, const T& otherwise) {
  if (from.empty()) {
    to.resize(to.size() + count, otherwise);
  } else {
    to.insert(to.end(), from.begin(), from.end());
  }
}

void append_vertices(Mesh& all, const Mesh& mesh, const Attributes& has) {
  const std::size_t count = mesh.positions.size();
  all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
  // clang-format off
  if (has.normals)  { all.normals.insert(all.normals.end(), mesh.normals.begin(), mesh.normals.end()); }
  if (has.tangents) { all.tangents.insert(all.tangents.end(), mesh.tangents.begin(), mesh.tangents.end()); }
  if (has.uvs)      { append(all.uvs, mesh.uvs, count, Vec2f{}); }
  if (has.uvs1)     { append(all.uvs1, mesh.uvs1, count, Vec2f{}); }
  if (has.colors)   { append(all.colors, mesh.colors, count, Vec3f{1, 1, 1}); }
  if (has.alphas)   { append(all.alphas, mesh.alphas, count, 1.0F); }
  // clang-format on
}

/// Moves the vertices from `first` on. Returns whether the matrix mirrors.
Result<bool> move_vertices(Mesh& all, std::size_t first, const Mat4& m, std::size_t object) {
  const Rows linear{{Vec3d{m(0, 0), m(0, 1), m(0, 2)}, Vec3d{m(1, 0), m(1, 1), m(1, 2)}, Vec3d{m(2, 0), m(2, 1), m(2, 2)}}};
  const auto& [x, y, z] = linear.row;
  Rows cofactors{{cross(y, z), cross(z, x), cross(x, y)}};  // the inverse transpose times the determinant
  const double determinant = dot(x, cofactors.row[0]);
  if (!(std::abs(determinant) > 0)) {
    return fail(ErrorKind::usage, fmt::format("objects[{}].matrix", object), "is singular: it flattens the object");
  }
  if (determinant < 0) {
    for (Vec3d& row : cofactors.row) {
      row = -row;
    }
  }
  for (std::size_t v = first; v < all.positions.size(); ++v) {
    all.positions[v] = vec_cast<float>(transform_point(m, vec_cast<double>(all.positions[v])));
    if (!all.normals.empty()) {
      all.normals[v] = moved_direction(cofactors, all.normals[v]);
    }
    if (!all.tangents.empty()) {
      auto& t = all.tangents[v];
      const Vec3f moved = moved_direction(linear, {t[0], t[1], t[2]});
      t = {moved.x, moved.y, moved.z, determinant < 0 ? -t[3] : t[3]};
    }
  }
  return determinant < 0;
}

void append_triangles(Mesh& all, const Object& object, std::size_t first_vertex, bool is_mirrored, bool has_materials) {
  const Mesh& mesh = *object.mesh;
  const auto offset = static_cast<std::uint32_t>(first_vertex);
  for (const auto& t : mesh.triangles) {
    all.triangles.push_back({t[0] + offset, t[is_mirrored ? 2 : 1] + offset, t[is_mirrored ? 1 : 2] + offset});
  }
  if (!has_materials) {
    return;
  }
  const auto first_material = static_cast<std::uint32_t>(all.materials.size());
  if (object.material || mesh.materials.empty()) {
    all.materials.push_back(object.material.value_or(Material{}));
    all.triangle_material.resize(all.triangles.size(), first_material);
    return;
  }
  all.materials.insert(all.materials.end(), mesh.materials.begin(), mesh.materials.end());
  for (const std::uint32_t material : mesh.triangle_material) {
    all.triangle_material.push_back(material + first_material);
  }
  all.triangle_material.resize(all.triangles.size(), first_material);
}

}  // namespace

Result<Mesh> flatten_scene(const Scene& scene) {
  std::size_t vertices = 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (scene.objects[i].mesh == nullptr) {
      return fail(ErrorKind::usage, fmt::format("objects[{}]", i), "has no mesh");
    }
    vertices += scene.objects[i].mesh->positions.size();
  }
  if (vertices >= SourceMesh::kNone) {
    return fail(ErrorKind::limit, "objects", fmt::format("have {} vertices, and at most {} are held", vertices, SourceMesh::kNone - 1));
  }
  if (scene.objects.size() == 1 && scene.objects[0].matrix == Mat4{} && !scene.objects[0].material) {
    return *scene.objects[0].mesh;
  }
  const Attributes has = attributes_of(scene);
  Mesh all;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    const std::size_t first = all.positions.size();
    append_vertices(all, *object.mesh, has);
    bool is_mirrored = false;
    if (object.matrix != Mat4{}) {
      const Result<bool> moved = move_vertices(all, first, object.matrix, i);
      if (!moved) {
        return tl::unexpected(moved.error());
      }
      is_mirrored = *moved;
    }
    append_triangles(all, object, first, is_mirrored, has.materials);
  }
  return all;
}

}  // namespace lustro
