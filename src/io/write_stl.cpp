// STL (3D Systems 1989): facets, each with the normal that its corners give.
#include <fmt/format.h>

#include <algorithm>

#include "io/mesh_writers.hpp"
#include "io/write_bytes.hpp"
#include "io/write_text.hpp"

namespace lustro {
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kFacetBytes = 50;

Vec3f facet_normal(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
  const Vec3d origin = vec_cast<double>(a);
  const Vec3d normal = cross(vec_cast<double>(b) - origin, vec_cast<double>(c) - origin);
  const double size = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  if (!(size > 0)) {
    return {0, 0, 0};
  }
  return vec_cast<float>(normalize(normal * (1 / size)));
}

/// `, ` between what is left out.
std::string left_out(const Mesh& mesh) {
  std::string names;
  const auto add = [&names](bool is_there, const char* name) { names += is_there ? (names.empty() ? "" : ", ") + std::string(name) : ""; };
  add(!mesh.uvs.empty() || !mesh.uvs1.empty(), "texture coordinates");
  add(!mesh.colors.empty(), "colours");
  add(!mesh.alphas.empty(), "opacities");
  add(has_materials(mesh), "materials");
  return names;
}

}  // namespace

Result<MeshBytes> stl_bytes(const Mesh& mesh, bool ascii) {
  const std::size_t count = mesh.triangles.size();
  if (count > 0xFFFFFFFFU) {
    return fail(ErrorKind::limit, "", fmt::format("{} triangles, and STL counts to {}", count, 0xFFFFFFFFU));
  }
  MeshBytes stl;
  if (!ascii) {
    stl.bytes = "binary STL written by Lustro";  // never `solid` first
    stl.bytes.reserve(kHeaderBytes + 4 + kFacetBytes * count);
    stl.bytes.resize(kHeaderBytes, ' ');
    append_u32(stl.bytes, static_cast<std::uint32_t>(count));
  } else {
    stl.bytes = "solid\n";
  }
  for (const auto& triangle : mesh.triangles) {
    const Vec3f& a = mesh.positions[triangle[0]];
    const Vec3f& b = mesh.positions[triangle[1]];
    const Vec3f& c = mesh.positions[triangle[2]];
    const Vec3f normal = facet_normal(a, b, c);
    if (!ascii) {
      for (const Vec3f& vector : {normal, a, b, c}) {
        append_f32(stl.bytes, vector);
      }
      stl.bytes.append(2, '\0');
      continue;
    }
    stl.bytes += "facet normal";
    append_vector(stl.bytes, normal);
    stl.bytes += "\nouter loop";
    for (const Vec3f& corner : {a, b, c}) {
      stl.bytes += "\nvertex";
      append_vector(stl.bytes, corner);
    }
    stl.bytes += "\nendloop\nendfacet\n";
  }
  stl.bytes += ascii ? "endsolid\n" : "";
  if (const std::string names = left_out(mesh); !names.empty()) {
    stl.notes.push_back({"", fmt::format("STL holds triangles alone: {} are left out", names)});
  }
  return stl;
}

}  // namespace lustro
