// A mesh that never was a file: a height field made here, handed to the renderer as arrays, once with facets and once smooth, side by side.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <lustro/lustro.hpp>
#include <memory>

namespace {

// A ripple on an n x n grid, as quads. A SourceMesh is what importers make; build_mesh() validates it, cuts it into triangles and makes normals.
lustro::SourceMesh ripple(std::uint32_t n) {
  lustro::SourceMesh mesh;
  for (std::uint32_t j = 0; j <= n; ++j) {
    for (std::uint32_t i = 0; i <= n; ++i) {
      const float x = 2 * static_cast<float>(i) / static_cast<float>(n) - 1;
      const float z = 2 * static_cast<float>(j) / static_cast<float>(n) - 1;
      const float r = std::sqrt(x * x + z * z);
      mesh.positions.push_back({x, 0.3F * std::cos(9 * r) / (1 + 4 * r * r), z});
    }
  }
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t corner = j * (n + 1) + i;
      mesh.corner_position.insert(mesh.corner_position.end(), {corner, corner + n + 1, corner + n + 2, corner + 1});
      mesh.face_begin.push_back(static_cast<std::uint32_t>(mesh.corner_position.size()));
    }
  }
  return mesh;
}

lustro::Object placed(const lustro::Mesh& mesh, double x) {
  lustro::Object object;
  object.mesh = std::make_shared<const lustro::Mesh>(mesh);
  object.material = lustro::library_material("polished_copper");
  object.matrix(0, 3) = x;
  return object;
}

}  // namespace

int main() {
  lustro::NormalOptions creased;
  creased.crease_deg = 0;  // faces at any angle to each other keep their own normals
  const auto smooth = lustro::build_mesh(ripple(24));
  const auto faceted = lustro::build_mesh(ripple(24), creased);
  if (!smooth || !faceted) {
    std::fprintf(stderr, "%s\n", (smooth ? faceted : smooth).error().text().c_str());
    return 1;
  }

  lustro::Scene scene;
  scene.image.width = 900;
  scene.image.height = 450;
  scene.objects = {placed(faceted->mesh, -1.15), placed(smooth->mesh, 1.15)};
  scene.camera.eye = {0, 2.3, 3};
  scene.camera.target = {0, -0.05, 0.1};

  const auto rendering = lustro::render(scene);
  if (!rendering) {
    std::fprintf(stderr, "%s\n", rendering.error().text().c_str());
    return 1;
  }
  const auto written = lustro::write_image("mesh_in_memory.png", rendering->color);
  if (!written) {
    std::fprintf(stderr, "%s\n", written.error().text().c_str());
  }
  return written ? 0 : 1;
}
