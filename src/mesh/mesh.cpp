// The small questions that meshes answer about themselves.
#include "lustro/mesh.hpp"

#include <algorithm>

namespace lustro {

void Bounds::include(const Vec3d& p) {
  lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
  upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
}

std::size_t SourceMesh::stated_triangle_count() const {
  std::size_t count = 0;
  for (std::size_t f = 0; f + 1 < face_begin.size(); ++f) {
    const std::uint32_t begin = face_begin[f];
    const std::uint32_t end = face_begin[f + 1];
    count += end > begin && end - begin > 2 ? end - begin - 2 : 0;
  }
  return count;
}

Bounds Mesh::bounds() const {
  Bounds box;
  for (const auto& triangle : triangles) {
    for (const std::uint32_t v : triangle) {
      box.include(vec_cast<double>(positions[v]));
    }
  }
  return box;
}

}  // namespace lustro
