// Shadows have the same bits by the reference, by every row of kernels and on every number of threads.
#include <gtest/gtest.h>

#include <random>

#include "raster/parity.hpp"
#include "truth/scene_tree.hpp"

namespace lustro {
namespace {

// Objects, lights and a camera at random; what may see through, may be cut out, is mirrored, comes from a coloured mesh.
Scene random_scene(unsigned seed) {
  std::mt19937 random(seed);
  const auto number = [&random] { return static_cast<double>(random()) / 4294967296.0 * 2 - 1; };
  constexpr std::array kMeshes{"primitive:sphere:24", "primitive:cube", "primitive:torus:30", "primitive:teapot", "primitive:plane:3"};
  Scene scene;
  scene.image = {.width = 150, .height = 110, .samples = seed % 2 == 0 ? 1 : 4, .tone = {.curve = static_cast<ToneOperator>(seed % 4)}};
  scene.image.tone.exposure = seed % 3 == 0 ? 0.5F : 0;
  scene.shading.interpolation = static_cast<Interpolation>(seed % 3);
  scene.shading.lighting = static_cast<Lighting>(1 + seed % 4);
  scene.shading.two_sided = seed % 5 < 3;
  scene.camera.projection = seed % 7 == 0 ? Projection::orthographic : Projection::perspective;
  if (seed % 4 == 1) {  // inside
    scene.camera.eye = Vec3d{number(), number(), number()};
    scene.camera.target = Vec3d{3 * number(), number(), 3 * number()};
    scene.camera.near = 0.01;
    scene.camera.far = 50;
  }
  for (int i = 0; i < 8; ++i) {
    Object object;
    object.mesh = truth::tree_mesh(kMeshes[random() % kMeshes.size()]);
    const double size = i == 0 ? 3 : 0.2 + 0.3 * (number() + 1);
    object.matrix.m = {
        size, 0.3 * number(), 0, 2 * number(), 0, random() % 4 == 0 ? -size : size, 0.2 * number(), number(), 0, 0, size, 2 * number(), 0, 0, 0,
        1};
    object.material = Material{
        .specular = {{0.4F, 0.4F, 0.4F}}, .shininess = 20, .opacity = random() % 3 == 0 ? 0.3F + 0.1F * static_cast<float>(i % 5) : 1.0F};
    object.material->alpha_mode = static_cast<AlphaMode>(random() % 3);
    scene.objects.push_back(object);
  }
  scene.lights.emplace();
  for (unsigned i = 0; i < 1 + seed % 3; ++i) {
    Light light{.type = static_cast<LightType>(random() % 3),
                .position = {4 * number(), 3 * number(), 4 * number()},
                .direction = {number(), number() - 1, number()},
                .ambient = {{0.1F, 0.05F, 0}}};
    light.cutoff = 20 + 35 * (number() + 1);
    light.shadow = random() % 5 != 0;
    scene.lights->push_back(light);
  }
  scene.shadow = ShadowSettings{.size = 16 << random() % 6, .softness = static_cast<int>(random() % 4)};
  if (seed % 6 == 0) {
    scene.fog = Fog{.density = 0.1, .color = {{0.3F, 0.3F, 0.4F}}};
  }
  return scene;
}

TEST(Parity, Shadows) {
  for (unsigned seed = 0; seed < 36; ++seed) {
    expect_parity(random_scene(seed), "shadows " + std::to_string(seed));
    if (HasFailure()) {
      return;
    }
  }
}

TEST(Parity, ShadowsOfARendererThatIsUsedAgain) {
  expect_parity_when_used_again(12, random_scene);
}

// Shadows are there at all, and change a part of the picture.
TEST(Parity, ShadowsAreSeen) {
  int changed = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    Scene scene = random_scene(seed);
    const Result<Rendering> with = render(scene);
    scene.shadow.reset();
    const Result<Rendering> without = render(scene);
    ASSERT_TRUE(with && without);
    changed += with->color.pixels != without->color.pixels ? 1 : 0;
  }
  EXPECT_GT(changed, 5);
}

}  // namespace
}  // namespace lustro
