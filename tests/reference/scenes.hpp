// Small scenes for the renderer's tests, built in memory.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "lustro/lustro.hpp"

namespace lustro {

inline std::shared_ptr<const Mesh> built(const SourceMesh& source, const NormalOptions& options = {}) {
  auto mesh = build_mesh(source, options);
  EXPECT_TRUE(mesh) << (mesh ? "" : mesh.error().text());
  return std::make_shared<const Mesh>(mesh ? mesh->mesh : Mesh{});
}
inline std::shared_ptr<const Mesh> primitive(std::string_view name) {
  const auto source = make_primitive(name);
  EXPECT_TRUE(source) << (source ? "" : source.error().text());
  return built(source ? *source : SourceMesh{});
}

/// One triangle with unit normals towards +z.
inline std::shared_ptr<Mesh> triangle_mesh(Vec3f a, Vec3f b, Vec3f c, Vec3f normal = {0, 0, 1}) {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {a, b, c};
  mesh->normals = {normal, normal, normal};
  mesh->triangles = {{0, 1, 2}};
  return mesh;
}

/// A camera at (0, 0, 4) looking along -z, 64 x 48 pixels, one sample, colours as they stand, black background, no light, no ambient.
inline Scene plain_scene(std::shared_ptr<const Mesh> mesh) {
  Scene scene;
  scene.image = {.width = 64, .height = 48, .samples = 1, .transfer = Transfer::none, .background = {{0, 0, 0}}};
  scene.camera.eye = Vec3d{0, 0, 4};
  scene.camera.target = Vec3d{0, 0, 0};
  scene.camera.near = 0.1;
  scene.camera.far = 100;
  scene.ambient = {{0, 0, 0}};
  scene.lights = std::vector<Light>{};
  scene.objects.push_back({.source = "test", .mesh = std::move(mesh)});
  return scene;
}

/// A scene that has everything: three lights, ambient, emission, fog, two objects, a coloured background.
inline Scene rich_scene() {
  Scene scene = plain_scene(primitive("sphere:24"));
  scene.image = {
      .width = 97, .height = 61, .samples = 4, .transfer = Transfer::srgb, .background = {{0.1F, 0.2F, 0.3F}}, .background_alpha = 0.5F};
  scene.camera.eye = Vec3d{1, 1.2, 3.5};
  scene.ambient = {{0.2F, 0.15F, 0.1F}};
  scene.objects[0].material = Material{.ambient = {{0.3F, 0.2F, 0.1F}},
                                       .diffuse = {{0.6F, 0.3F, 0.4F}},
                                       .specular = {{0.5F, 0.6F, 0.7F}},
                                       .emission = {{0.02F, 0.03F, 0}},
                                       .shininess = 20};
  Object floor{.source = "floor", .mesh = primitive("plane:4")};
  floor.matrix = {{3, 0, 0, 0, 0, 3, 0, -1.01, 0, 0, 3, 0, 0, 0, 0, 1}};
  floor.material = *library_material("jade");
  scene.objects.push_back(floor);
  Light sun{.type = LightType::directional, .direction = {-1, -1, -0.5}};
  Light bulb{.type = LightType::point, .position = {2, 2, 1}, .ambient = {{0.1F, 0, 0}}, .diffuse = {{1, 0.8F, 0.6F}}};
  bulb.attenuation = {.constant = 1, .linear = 0.1, .quadratic = 0.05};
  Light spot{.type = LightType::spot, .position = {-2, 3, 2}, .direction = {2, -3, -2}, .diffuse = {{0.3F, 1, 0.5F}}};
  spot.cutoff = 25;
  spot.beam = 15.0;
  spot.exponent = 8;
  scene.lights = std::vector<Light>{sun, bulb, spot};
  scene.fog = Fog{.mode = FogMode::exp2, .density = 0.15, .color = {{0.5F, 0.5F, 0.6F}}};
  return scene;
}

inline Rendering drawn(const Scene& scene, RenderOptions options = {}) {
  options.engine = Engine::reference;
  auto result = render(scene, options);
  EXPECT_TRUE(result) << (result ? "" : result.error().text());
  return result ? *std::move(result) : Rendering{};
}

}  // namespace lustro
