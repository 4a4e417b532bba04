// The generator of meshes and the scene: see subjects.hpp. Its sines come from the C library: nothing here has to have the same bits everywhere.
#include "common/subjects.hpp"

#include <cmath>
#include <functional>

namespace lustro::bench {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr std::size_t kSheetCells = 32;

Vec3f narrowed(const Vec3d& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// The unit normal of a surface p(u, v) by differences: p_v x p_u.
Vec3f normal_of(const std::function<Vec3d(double, double)>& p, double u, double v) {
  constexpr double kStep = 1e-5;
  const Vec3d n = cross(p(u, v + kStep) - p(u, v - kStep), p(u + kStep, v) - p(u - kStep, v));
  return narrowed(n * (1 / std::sqrt(dot(n, n))));
}

Light shining(LightType type, const Vec3d& from, const std::array<float, 3>& color) {
  Light light;
  light.type = type;
  light.position = from;
  light.direction = from * -1.0;
  light.diffuse = {{color[0], color[1], color[2]}};
  light.specular = {{color[0], color[1], color[2]}};
  return light;
}

}  // namespace

Mesh bumpy_torus(std::size_t triangles, int variation) {
  const auto rings = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(triangles))));
  const std::size_t sides = std::max<std::size_t>(3, triangles / 2 / rings);
  const double shift = 0.7 * variation;
  const std::function<Vec3d(double, double)> place = [shift](double u, double v) {  // u along the ring, v around the tube
    const double tube = 0.28 * (1 + 0.1 * std::sin(5 * u + shift) * std::cos(3 * v + 2 * shift));
    const double out = 0.7 + tube * std::cos(v);
    return Vec3d{out * std::cos(u), tube * std::sin(v), out * std::sin(u)};
  };
  Mesh mesh;
  mesh.positions.reserve(rings * sides);
  mesh.normals.reserve(rings * sides);
  mesh.triangles.reserve(2 * rings * sides);
  for (std::size_t i = 0; i < rings; ++i) {
    for (std::size_t j = 0; j < sides; ++j) {
      const double u = 2 * kPi * static_cast<double>(i) / static_cast<double>(rings);
      const double v = 2 * kPi * static_cast<double>(j) / static_cast<double>(sides);
      mesh.positions.push_back(narrowed(place(u, v)));
      mesh.normals.push_back(normal_of(place, u, v));
      const auto at = [&](std::size_t ring, std::size_t side) { return static_cast<std::uint32_t>(ring % rings * sides + side % sides); };
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
      mesh.triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
    }
  }
  return mesh;
}

Mesh wavy_sheet() {
  const std::function<Vec3d(double, double)> place = [](double v, double u) { return Vec3d{u, v, 0.05 * std::sin(4 * u) * std::cos(5 * v)}; };
  Mesh mesh;
  const auto at = [](std::size_t x, std::size_t y) { return static_cast<std::uint32_t>(y * (kSheetCells + 1) + x); };
  for (std::size_t y = 0; y <= kSheetCells; ++y) {
    for (std::size_t x = 0; x <= kSheetCells; ++x) {
      const double u = 2 * static_cast<double>(x) / kSheetCells - 1;
      const double v = 2 * static_cast<double>(y) / kSheetCells - 1;
      mesh.positions.push_back(narrowed(place(v, u)));
      mesh.normals.push_back(normal_of(place, v, u));
      if (x < kSheetCells && y < kSheetCells) {
        mesh.triangles.push_back({at(x, y), at(x + 1, y), at(x, y + 1)});
        mesh.triangles.push_back({at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
      }
    }
  }
  return mesh;
}

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all{{"2k", 2 * kSheetCells * kSheetCells, true},
                                        {"5k", 5'000, false},
                                        {"50k", 50'000, false},
                                        {"70k", 70'000, false},
                                        {"1m", 1'000'000, false},
                                        {"10m", 10'000'000, false}};
  return all;
}

const Subject* find_subject(std::string_view name) {
  for (const Subject& subject : subjects()) {
    if (subject.name == name) {
      return &subject;
    }
  }
  return nullptr;
}

Scene common_scene(const Subject& subject, int samples) {
  Scene scene;
  scene.image.width = 1920;
  scene.image.height = 1080;
  scene.image.samples = samples;
  scene.image.transfer = Transfer::none;
  scene.image.background = {{0.1F, 0.1F, 0.12F}};
  scene.shading.two_sided = true;
  scene.ambient = {{0.2F, 0.2F, 0.2F}};
  scene.lights = {shining(LightType::directional, {0.4, 0.8, 1}, {0.5F, 0.5F, 0.5F}),
                  shining(LightType::directional, {-1, 0.3, 0.2}, {0.2F, 0.25F, 0.35F}),
                  shining(LightType::point, {1.5, 2, 1.5}, {0.4F, 0.35F, 0.3F})};
  Object object;
  object.mesh = std::make_shared<Mesh>(subject.fills_the_picture ? wavy_sheet() : bumpy_torus(subject.triangles));
  Material material;
  material.ambient = {{0.3F, 0.3F, 0.3F}};
  material.diffuse = {{0.7F, 0.6F, 0.5F}};
  material.specular = {{0.4F, 0.4F, 0.4F}};
  material.shininess = 24;
  object.material = material;
  scene.objects = {object};
  Camera& camera = scene.camera;
  camera.target = Vec3d{0, 0, 0};
  camera.up = Vec3d{0, 1, 0};
  camera.fov = 42;
  if (subject.fills_the_picture) {  // 42 degrees see 0.27 up and 0.48 aside at this distance: the sheet may turn
    camera.eye = Vec3d{0, 0, 0.7};
    camera.near = 0.1;
    camera.far = 10;
  } else {
    camera.eye = Vec3d{0, 2.16, 1.75};
    camera.near = 0.5;
    camera.far = 10;
  }
  return scene;
}

Mat4 turned(const Subject& subject, int i) {
  const double angle = 0.01 * i;
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  Mat4 m;
  if (subject.fills_the_picture) {
    m(0, 0) = c, m(0, 1) = -s, m(1, 0) = s, m(1, 1) = c;
  } else {
    m(0, 0) = c, m(0, 2) = s, m(2, 0) = -s, m(2, 2) = c;
  }
  return m;
}

}  // namespace lustro::bench
