// An environment has the same bits by the reference, by every row of kernels and on every number of threads; and lights as paths say.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "raster/parity.hpp"
#include "truth/scene_tree.hpp"

namespace lustro {
namespace {

std::shared_ptr<const Image> random_picture(std::mt19937& random, int width) {
  auto picture = std::make_shared<Image>(width, width / 2, 3);
  for (float& value : picture->pixels) {
    value = static_cast<float>(random() % 1000) / 500;
  }
  return picture;
}

Scene random_scene(unsigned seed) {
  std::mt19937 random(seed);
  const auto number = [&random] { return static_cast<double>(random()) / 4294967296.0 * 2 - 1; };
  constexpr std::array kMeshes{"primitive:sphere:24", "primitive:cube", "primitive:torus:30", "primitive:teapot", "primitive:plane:3"};
  Scene scene;
  scene.image = {.width = 150, .height = 110, .samples = seed % 2 == 0 ? 1 : 4, .transparent = seed % 11 == 10};
  scene.image.tone = {.curve = static_cast<ToneOperator>(seed % 4)};
  scene.shading.interpolation = static_cast<Interpolation>(seed % 3);
  scene.shading.lighting = static_cast<Lighting>(seed % 5);
  scene.shading.two_sided = seed % 5 < 3;
  scene.shading.normalized = seed % 2 == 1;
  scene.camera.projection = seed % 7 == 0 ? Projection::orthographic : Projection::perspective;
  scene.environment.emplace();
  Environment& environment = *scene.environment;
  if (seed % 4 != 3) {
    environment.picture = random_picture(random, 16 << random() % 3);
  }
  environment.color = {{0.3F, 0.5F, 0.7F}};
  environment.gain = {0.8F, 1.0F, 0.5F};
  environment.rotation = 180 * number();
  environment.visible = seed % 5 != 4;
  for (int i = 0; i < 5; ++i) {
    Object object;
    object.mesh = truth::tree_mesh(kMeshes[random() % kMeshes.size()]);
    const double size = 0.3 + 0.3 * (number() + 1);
    object.matrix.m = {size, 0.3 * number(), 0, 1.5 * number(), 0, size, 0.2 * number(), number(), 0, 0, size, 1.5 * number(), 0, 0, 0, 1};
    object.material =
        Material{.specular = {{0.4F, 0.4F, 0.4F}}, .shininess = static_cast<float>(random() % 100), .opacity = random() % 3 == 0 ? 0.5F : 1.0F};
    if (random() % 3 == 0) {
      object.material->illumination = 3;
    }
    if (random() % 4 == 0) {
      object.material->specular = {{0, 0, 0}};
    }
    scene.objects.push_back(object);
  }
  if (seed % 3 == 0) {
    scene.lights.emplace();
  }
  if (seed % 6 == 0) {
    scene.fog = Fog{.density = 0.1, .color = {{0.3F, 0.3F, 0.4F}}};
  }
  return scene;
}

TEST(Parity, Environments) {
  for (unsigned seed = 0; seed < 24; ++seed) {
    expect_parity(random_scene(seed), "environment " + std::to_string(seed));
    if (HasFailure()) {
      return;
    }
  }
}

TEST(Parity, EnvironmentsOfARendererThatIsUsedAgain) {
  expect_parity_when_used_again(8, random_scene);
}

/// A ball in the middle of nothing.
Scene ball_in(const Environment& environment, const Material& material) {
  Scene scene;
  scene.image = {.width = 48, .height = 48, .samples = 4};
  scene.camera.eye = Vec3d{0, 0, 5};
  scene.camera.target = Vec3d{0, 0, 0};
  scene.camera.fov = 40;
  scene.ambient = {{0, 0, 0}};
  scene.lights.emplace();
  scene.environment = environment;
  Object object;
  object.mesh = truth::tree_mesh("primitive:sphere:96");
  object.material = material;
  scene.objects = {object};
  return scene;
}

// The furnace: a ball that reflects everything cannot be seen in a white sky.
TEST(EnvironmentTruth, AWhiteBallVanishesInAWhiteSky) {
  const Scene scene = ball_in({}, Material{.ambient = {{0, 0, 0}}, .diffuse = {{1, 1, 1}}});
  const Result<Rendering> picture = render(scene);
  ASSERT_TRUE(picture);
  for (std::size_t i = 0; i < picture->color.pixels.size(); ++i) {
    ASSERT_NEAR(picture->color.pixels[i], 1, 1e-5);
  }
}

// Right of the picture's middle is seen to the right of -z; the eye looks along -z.
TEST(EnvironmentTruth, TheSkyStandsWhereThePictureSays) {
  auto picture = std::make_shared<Image>(64, 32, 3);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      const auto to = picture->at(x, y);
      to[0] = x >= 32 ? 1.0F : 0.0F;
      to[1] = y < 16 ? 1.0F : 0.0F;
    }
  }
  Scene scene = ball_in({.picture = picture}, Material{.opacity = 1});
  scene.objects[0].matrix.m[0] = scene.objects[0].matrix.m[5] = scene.objects[0].matrix.m[10] = 0.05;
  const Result<Rendering> seen = render(scene);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->color.at(44, 4)[0], 1, 0.01);
  EXPECT_NEAR(seen->color.at(44, 4)[1], 1, 0.01);
  EXPECT_NEAR(seen->color.at(4, 44)[0], 0, 0.01);
  EXPECT_NEAR(seen->color.at(4, 44)[1], 0, 0.01);
  scene.environment->rotation = 180;
  EXPECT_NEAR(render(scene)->color.at(44, 4)[0], 0, 0.01);
}

// Diffuse and blurred light beside paths of one bounce, on a ball, which shadows nothing of what it can see.
TEST(EnvironmentTruth, ABallIsLitAsPathsOfOneBounceSay) {
  auto picture = std::make_shared<Image>(64, 32, 3);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      const auto to = picture->at(x, y);
      to[0] = 0.4F + 0.3F * std::sin(0.098F * static_cast<float>(x));
      to[1] = y < 16 ? 1.0F : 0.3F;
      to[2] = x > 40 && x < 56 && y > 8 && y < 20 ? 3.0F : 0.2F;
    }
  }
  for (const float specular : {0.0F, 0.5F}) {
    Scene scene = ball_in(
        {.rotation = 70, .picture = picture},
        Material{.ambient = {{0, 0, 0}}, .diffuse = {{0.7F, 0.7F, 0.7F}}, .specular = {{specular, specular, specular}}, .shininess = 20});
    scene.shading.lighting = Lighting::phong;
    const Result<Rendering> local = render(scene);
    const Result<Rendering> paths = render(scene, {.engine = Engine::path, .path = {.samples = 256, .bounces = 1}});
    if (!paths && paths.error().kind == ErrorKind::unsupported) {
      GTEST_SKIP() << "this build has no path tracer (Embree is absent)";
    }
    ASSERT_TRUE(local && paths);
    double sum = 0, squares = 0;
    int count = 0;
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 48; ++x) {
        if ((x - 24) * (x - 24) + (y - 24) * (y - 24) > 100) {
          continue;  // towards the edge the lobe dips below the horizon
        }
        for (std::size_t c = 0; c < 3; ++c) {
          const double d = static_cast<double>(local->color.at(x, y)[c]) - static_cast<double>(paths->color.at(x, y)[c]);
          sum += d;
          squares += d * d;
          ++count;
        }
      }
    }
    EXPECT_LT(std::abs(sum / count), 0.01) << specular;
    EXPECT_LT(std::sqrt(squares / count), 0.03) << specular;
  }
}

}  // namespace
}  // namespace lustro
