// Scenes of a few triangles, and pictures of them by paths, with their mean over pixels and how sure it is.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>

#include "lustro/render.hpp"

#ifdef LUSTRO_HAS_EMBREE
#define LUSTRO_REQUIRE_PATHS() static_cast<void>(0)
#else
#define LUSTRO_REQUIRE_PATHS() GTEST_SKIP() << "this build follows no paths"
#endif

namespace lustro {

inline Color gray(float value) {
  return {{value, value, value}, ColorSpace::linear};
}

/// A square of these half edges about the origin in the plane z = 0, facing +z.
inline std::shared_ptr<const Mesh> square(float half) {
  Mesh mesh;
  mesh.positions = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return std::make_shared<const Mesh>(std::move(mesh));
}

/// A built-in mesh with its file's normals.
inline std::shared_ptr<const Mesh> primitive(const char* name) {
  return std::make_shared<const Mesh>(build_mesh(make_primitive(name).value()).value().mesh);
}

inline Material lambert(float albedo) {
  Material material;
  material.ambient = gray(0);
  material.diffuse = gray(albedo);
  material.lighting = Lighting::lambert;
  return material;
}

inline Material highlight(Lighting lighting, float k_s, float shininess) {
  Material material;
  material.ambient = gray(0);
  material.diffuse = gray(0);
  material.specular = gray(k_s);
  material.shininess = shininess;
  material.lighting = lighting;
  return material;
}

inline Object object(std::shared_ptr<const Mesh> mesh, const Material& material, const Mat4& matrix = {}) {
  return {.name = "", .source = "", .mesh = std::move(mesh), .material = material, .matrix = matrix};
}

inline Mat4 moved(double x, double y, double z) {
  Mat4 m;
  m(0, 3) = x;
  m(1, 3) = y;
  m(2, 3) = z;
  return m;
}

/// No light, no ambient light; an orthographic look at the origin from that way, `height` high.
inline Scene look(const Vec3d& from, double height, int pixels = 16) {
  Scene scene;
  scene.image = {.width = pixels, .height = pixels, .samples = 1, .transfer = Transfer::none};
  scene.image.background = gray(0);
  scene.camera.projection = Projection::orthographic;
  scene.camera.eye = from;
  scene.camera.target = Vec3d{0, 0, 0};
  scene.camera.up = std::abs(from.y) > 0.9 * length(from) ? Vec3d{0, 0, 1} : Vec3d{0, 1, 0};
  scene.camera.height = height;
  scene.camera.near = 0.001;
  scene.camera.far = 1000;
  scene.ambient = gray(0);
  scene.lights.emplace();
  scene.shading.normalized = true;
  return scene;
}

inline Environment white_sky(float radiance = 1) {
  Environment sky;
  sky.color = gray(radiance);
  return sky;
}

inline Rendering draw_paths(const Scene& scene, int samples, int bounces = 16, std::uint32_t seed = 0, int threads = 0) {
  RenderOptions options;
  options.engine = Engine::path;
  options.threads = threads;
  options.path = {.samples = samples, .bounces = bounces, .seed = seed};
  auto drawn = render(scene, options);
  EXPECT_TRUE(drawn) << (drawn ? "" : drawn.error().text());
  if (!drawn) {
    Rendering nothing;
    nothing.color = Image(scene.image.width, scene.image.height, 4);
    return nothing;
  }
  return *std::move(drawn);
}

/// A mean and its standard error, from how pixels differ: each has random numbers of its own.
struct Estimate {
  double mean = 0, error = 0;
};
inline Estimate estimate(const Image& image, int channel = 0) {
  double sum = 0;
  double squares = 0;
  const auto count = static_cast<double>(image.width) * image.height;
  for (std::size_t i = static_cast<std::size_t>(channel); i < image.pixels.size(); i += static_cast<std::size_t>(image.channels)) {
    sum += static_cast<double>(image.pixels[i]);
    squares += static_cast<double>(image.pixels[i]) * static_cast<double>(image.pixels[i]);
  }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(squares / count - mean * mean, 0.0) / (count - 1))};
}

/// Within three standard errors, which are small enough to mean something: at most 1 % of it.
inline void expect_estimate(const Estimate& found, double expected, const std::string& what) {
  EXPECT_NEAR(found.mean, expected, 3 * found.error + 2e-6 * std::abs(expected)) << what << ", standard error " << found.error;
  EXPECT_LT(found.error, 0.01 * std::abs(expected)) << what;
}

}  // namespace lustro
