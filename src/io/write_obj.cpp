// Wavefront OBJ: one position, uv and normal a vertex under one index, colours behind the positions, `usemtl` where the material changes.
#include <fmt/format.h>

#include "io/mesh_writers.hpp"
#include "io/write_text.hpp"

namespace lustro {
namespace {

void append_corner(std::string& text, std::uint32_t corner, bool has_uv, bool has_normal) {
  const std::uint64_t index = std::uint64_t{corner} + 1;
  const auto out = std::back_inserter(text);
  if (has_uv && has_normal) {
    fmt::format_to(out, " {0}/{0}/{0}", index);
  } else if (has_uv) {
    fmt::format_to(out, " {0}/{0}", index);
  } else if (has_normal) {
    fmt::format_to(out, " {0}//{0}", index);
  } else {
    fmt::format_to(out, " {0}", index);
  }
}

}  // namespace

MeshBytes obj_bytes(const Mesh& mesh, const std::string& library) {
  MeshBytes obj;
  std::string& text = obj.bytes;
  text = "# written by Lustro\n";
  const bool with_materials = has_materials(mesh);
  if (with_materials) {
    text += fmt::format("mtllib {}\n", library);
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    text += 'v';
    append_vector(text, mesh.positions[v]);
    if (!mesh.colors.empty()) {
      append_vector(text, mesh.colors[v]);
    }
    text += '\n';
  }
  for (const Vec2f& uv : mesh.uvs) {
    text += "vt";
    append_vector(text, uv);
    text += '\n';
  }
  for (const Vec3f& normal : mesh.normals) {
    text += "vn";
    append_vector(text, normal);
    text += '\n';
  }
  const std::vector<std::string> names = with_materials ? material_names(mesh.materials) : std::vector<std::string>{};
  std::uint32_t current = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t material = mesh.triangle_material.empty() ? 0 : mesh.triangle_material[t];
    if (with_materials && (t == 0 || material != current)) {
      text += fmt::format("usemtl {}\n", names[material]);
      current = material;
    }
    text += 'f';
    for (const std::uint32_t corner : mesh.triangles[t]) {
      append_corner(text, corner, !mesh.uvs.empty(), !mesh.normals.empty());
    }
    text += '\n';
  }
  if (!mesh.alphas.empty()) {
    obj.notes.push_back({"", "OBJ holds no opacities of vertices: they are left out"});
  }
  if (!mesh.uvs1.empty()) {
    obj.notes.push_back({"", "OBJ holds one set of texture coordinates: the second is left out"});
  }
  return obj;
}

}  // namespace lustro
