// See faceted.hpp.
#include "approximation/faceted.hpp"

#include <limits>
#include <vector>

namespace lustro {
namespace {

template <class T>
void take(const std::vector<T>& from, std::uint32_t vertex, std::vector<T>& to) {
  if (!from.empty()) {
    to.push_back(from[vertex]);
  }
}

}  // namespace

Result<Mesh> faceted(const Mesh& mesh) {
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max() / 3) {
    return fail(ErrorKind::limit, "", "too many triangles to give each its own vertices");
  }
  Mesh result;
  result.triangle_material = mesh.triangle_material;
  result.materials = mesh.materials;
  result.triangles.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3d p = vec_cast<double>(mesh.positions[a]);
    const Vec3d normal = cross(vec_cast<double>(mesh.positions[b]) - p, vec_cast<double>(mesh.positions[c]) - p);
    const double size = length(normal);
    for (const std::uint32_t vertex : {a, b, c}) {
      take(mesh.positions, vertex, result.positions);
      take(mesh.uvs, vertex, result.uvs);
      take(mesh.uvs1, vertex, result.uvs1);
      take(mesh.tangents, vertex, result.tangents);
      take(mesh.colors, vertex, result.colors);
      take(mesh.alphas, vertex, result.alphas);
      const Vec3f kept = mesh.normals.empty() ? Vec3f{0, 1, 0} : mesh.normals[vertex];
      result.normals.push_back(size > 0 ? vec_cast<float>(normal * (1 / size)) : kept);
    }
    const auto first = static_cast<std::uint32_t>(result.positions.size() - 3);
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

}  // namespace lustro
