// Occlusion, and floors that show nothing but shadows, have the same bits by the reference, by every row of kernels and on every number of
// threads.
#include <gtest/gtest.h>

#include <random>

#include "raster/parity.hpp"
#include "truth/scene_tree.hpp"

namespace lustro {
namespace {

Scene random_scene(unsigned seed) {
  std::mt19937 random(seed + 400);
  const auto number = [&random] { return static_cast<double>(random()) / 4294967296.0 * 2 - 1; };
  constexpr std::array kMeshes{"primitive:sphere:24", "primitive:cube", "primitive:torus:30", "primitive:teapot", "primitive:plane:3"};
  Scene scene;
  scene.image = {.width = 120, .height = 90, .samples = seed % 2 == 0 ? 1 : 4, .transparent = seed % 3 == 1};
  scene.shading.interpolation = static_cast<Interpolation>(seed % 3);
  scene.shading.lighting = static_cast<Lighting>(1 + seed % 4);
  scene.shading.two_sided = seed % 5 < 3;
  scene.camera.projection = seed % 7 == 0 ? Projection::orthographic : Projection::perspective;
  for (int i = 0; i < 6; ++i) {
    Object object;
    object.mesh = truth::tree_mesh(kMeshes[random() % kMeshes.size()]);
    const double size = 0.3 + 0.3 * (number() + 1);
    object.matrix.m = {size, 0.3 * number(), 0, 1.5 * number(), 0, size, 0.2 * number(), number(), 0, 0, size, 1.5 * number(), 0, 0, 0, 1};
    object.material = Material{.specular = {{0.4F, 0.4F, 0.4F}}, .shininess = 20, .opacity = random() % 3 == 0 ? 0.4F : 1.0F};
    if (random() % 5 == 0) {
      object.material->illumination = 10;
    }
    scene.objects.push_back(object);
  }
  if (seed % 3 == 0) {
    scene.lights = {Light{.direction = {number(), -1, number()}, .ambient = {{0.1F, 0.2F, 0}}},
                    Light{.type = LightType::point, .position = {2 * number(), 2, 2 * number()}, .shadow = false}};
  }
  scene.occlusion = OcclusionSettings{.directions = 4 + static_cast<int>(random() % 20), .size = 16 << random() % 4};
  if (seed % 2 == 0) {
    scene.occlusion->radius = 0.1 + number() + 1;
  }
  if (seed % 4 == 3) {
    scene.occlusion.reset();
  }
  if (seed % 4 != 1) {
    scene.ground.emplace();
    scene.shadow = seed == 0 ? ShadowSettings{} : ShadowSettings{.size = 256};  // what the floor shows; one map of the default size
  }
  if (seed % 5 == 0) {
    scene.environment = Environment{.color = {{0.3F, 0.5F, 0.4F}}, .visible = seed % 2 == 0};
  }
  if (seed % 6 == 0) {
    scene.fog = Fog{.density = 0.1, .color = {{0.3F, 0.3F, 0.4F}}};
  }
  return scene;
}

TEST(Parity, OcclusionAndGround) {
  for (unsigned seed = 0; seed < 24; ++seed) {
    expect_parity(random_scene(seed), "occlusion " + std::to_string(seed));
    if (HasFailure()) {
      return;
    }
  }
}

TEST(Parity, OcclusionOfARendererThatIsUsedAgain) {
  expect_parity_when_used_again(12, random_scene);
}

}  // namespace
}  // namespace lustro
