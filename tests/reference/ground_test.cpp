// The floor that shows nothing but the shadows on it: its opacity from paper, where it lies, and what it leaves alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/prepare.hpp"
#include "scenes.hpp"

namespace lustro {
namespace {

// A thin plate one unit above the lowest point, which a pin below it marks; light from straight above. Seen from high above at an angle.
Scene plate() {
  Scene scene = plain_scene(primitive("cube"));
  scene.image.background = {{0.5F, 0.25F, 1}};
  scene.image.width = 120;
  scene.image.height = 90;
  scene.objects[0].matrix.m = {1, 0, 0, 0, 0, 0.01, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1};
  scene.objects.push_back({.source = "pin", .mesh = primitive("cube")});
  scene.objects[1].matrix.m = {0.01, 0, 0, 0, 0, 0.5, 0, 0.5, 0, 0, 0.01, 0, 0, 0, 0, 1};
  scene.camera.eye = Vec3d{0, 3, 8};
  scene.camera.target = Vec3d{0, 0, 0};
  scene.camera.far.reset();
  scene.ambient = {{0.25F, 0.25F, 0.25F}};
  scene.lights = {Light{.direction = {0, -1, 0}, .ambient = {{0, 0, 0}}, .diffuse = {{0.75F, 0.75F, 0.75F}}}};
  scene.ground.emplace();
  return scene;
}

Rendering pictured(const Scene& scene, const char* aovs = "depth,object,position") {
  auto rendering = render(scene, {.aovs = parse_aovs(aovs).value(), .engine = Engine::reference});
  EXPECT_TRUE(rendering) << (rendering ? "" : rendering.error().text());
  return rendering ? *std::move(rendering) : Rendering{};
}

// Where a point of the world is seen.
std::array<int, 2> pixel_of(const Scene& scene, const Vec3d& place) {
  const PreparedScene prepared = prepare(scene).value();
  const View& view = prepared.view;
  const Vec3d p = place - view.eye;
  const double scale = view.pixels_per_unit / dot(p, view.forward);
  return {static_cast<int>(view.width * 0.5 + dot(p, view.right) * scale), static_cast<int>(view.height * 0.5 - dot(p, view.up) * scale)};
}

// In the shadow a quarter of the light is left: a I_a of I_a + l_d = 0.25 / 1. The background is seen by a quarter.
TEST(Ground, IsAsOpaqueAsItsShadowIsDark) {
  Scene scene = plate();
  const auto [x, y] = pixel_of(scene, {0.5, 0, 0.7});
  const Rendering picture = pictured(scene);
  EXPECT_NEAR(picture.color.at(x, y)[0], 0.125F, 1e-6F);
  EXPECT_NEAR(picture.color.at(x, y)[1], 0.0625F, 1e-6F);
  EXPECT_NEAR(picture.color.at(x, y)[2], 0.25F, 1e-6F);
  EXPECT_EQ(picture.color.at(x, y)[3], 1);
  const auto [free_x, free_y] = pixel_of(scene, {1.5, 0, 1.3});
  EXPECT_EQ(picture.color.at(free_x, free_y)[0], 0.5F);
  scene.image.transparent = true;
  const Rendering seen_through = pictured(scene);
  EXPECT_EQ(seen_through.color.at(x, y)[0], 0);
  EXPECT_NEAR(seen_through.color.at(x, y)[3], 0.75F, 1e-6F);
  EXPECT_EQ(seen_through.color.at(free_x, free_y)[3], 0);
  scene.ground->strength = 0.5F;
  EXPECT_NEAR(pictured(scene).color.at(x, y)[3], 0.375F, 1e-6F);
}

TEST(Ground, LiesBelowEverythingOrWhereItIsStated) {
  Scene scene = plate();
  const auto [x, y] = pixel_of(scene, {0.5, 0, 0.7});
  const Rendering picture = pictured(scene);
  EXPECT_EQ(picture.layers[1].image.at(x, y)[0], 2);  // an object of its own, after the scene's
  EXPECT_NEAR(picture.layers[2].image.at(x, y)[1], 0, 1e-3F);
  scene.ground->height = -2;
  const auto [lower_x, lower_y] = pixel_of(scene, {0.5, -2, 0.7});
  EXPECT_NEAR(pictured(scene).layers[2].image.at(lower_x, lower_y)[1], -2, 1e-3F);
  EXPECT_NEAR(pictured(scene).color.at(lower_x, lower_y)[0], 0.125F, 1e-6F);
}

// It changes neither what the camera frames nor any pixel of the objects; from below it is not there.
TEST(Ground, LeavesEverythingElseAlone) {
  Scene scene = plate();
  scene.camera = {};
  scene.shadow.emplace();
  Scene without = scene;
  without.ground.reset();
  const Rendering with_ground = pictured(scene);
  const Rendering bare = pictured(without);
  int same = 0;
  for (int y = 0; y < scene.image.height; ++y) {
    for (int x = 0; x < scene.image.width; ++x) {
      if (bare.layers[1].image.at(x, y)[0] >= 0) {
        for (std::size_t c = 0; c < 4; ++c) {
          ASSERT_EQ(with_ground.color.at(x, y)[c], bare.color.at(x, y)[c]) << x << ", " << y;
        }
        ++same;
      }
    }
  }
  EXPECT_GT(same, 100);
  scene.camera.eye = Vec3d{0, -3, 8};
  scene.camera.target = Vec3d{0, 0, 0};
  without.camera = scene.camera;
  EXPECT_EQ(pictured(scene).color.pixels, pictured(without).color.pixels);
}

// A shadow that reaches towards the eye, before everything that the scene's box holds, is whole.
TEST(Ground, IsNotCutByPlanesThatNobodyStates) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Scene scene = plate();
    scene.lights = {Light{.direction = {0.1, -0.2, 1}}};
    scene.camera.projection = projection;
    scene.camera.near.reset();
    const Rendering chosen = pictured(scene);
    scene.camera.near = 0.01;
    scene.camera.far = 200;
    const Rendering stated = pictured(scene);
    int dark = 0;
    for (int y = 0; y < scene.image.height; ++y) {
      for (int x = 0; x < scene.image.width; ++x) {
        EXPECT_NEAR(chosen.color.at(x, y)[0], stated.color.at(x, y)[0], 2e-3F) << x << ", " << y;
        dark += stated.color.at(x, y)[0] < 0.4F ? 1 : 0;
      }
    }
    EXPECT_GT(dark, 100);
  }
}

TEST(Ground, IsNotThereWhereNothingIs) {
  Scene scene = plate();
  scene.objects.resize(1);
  auto empty = std::make_shared<Mesh>();
  empty->positions = {{0, 0, 0}};
  scene.objects[0].mesh = empty;
  const auto made = render(scene);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().kind, ErrorKind::empty) << made.error().text();
}

// Ambient light alone has no shadow, but occlusion.
TEST(Ground, ShowsOcclusionToo) {
  Scene scene = plate();
  scene.lights->clear();
  const auto [x, y] = pixel_of(scene, {0.1, 0, 0.9});
  EXPECT_EQ(pictured(scene).color.at(x, y)[0], 0.5F);
  scene.occlusion = OcclusionSettings{.radius = 10};
  const float below = pictured(scene).color.at(x, y)[0];
  EXPECT_LT(below, 0.4F);
  EXPECT_GT(below, 0.02F);
}

TEST(Ground, ThrowsNoShadowAndHidesNothing) {
  Scene scene = plate();
  scene.lights = {Light{.direction = {0, 1, 0}}};  // from below
  scene.camera.eye = Vec3d{0, -3, 8};
  scene.occlusion.emplace();
  Scene without = scene;
  without.ground.reset();
  without.shadow.emplace();
  EXPECT_EQ(pictured(scene).color.pixels, pictured(without).color.pixels);
}

TEST(Ground, ItsMaterialMayBeAnySurfaces) {
  Scene scene = plate();
  scene.ground.reset();
  scene.shadow.emplace();
  Object wall{.source = "wall", .mesh = primitive("plane")};
  wall.matrix.m = {3, 0, 0, 0, 0, 1, 0, 0, 0, 0, 3, 0, 0, 0, 0, 1};
  wall.material = Material{.name = "matte", .illumination = 10};
  scene.objects.push_back(wall);
  const auto [x, y] = pixel_of(scene, {0.5, 0, 0.7});
  EXPECT_NEAR(pictured(scene).color.at(x, y)[0], 0.125F, 1e-6F);
  scene.shadow.reset();
  const Rendering idle = pictured(scene);
  EXPECT_EQ(idle.color.at(x, y)[0], 0.5F);
  ASSERT_EQ(idle.notes.size(), 1U);
  EXPECT_EQ(idle.notes[0].message, "\"matte\" shows nothing but the shadows on it, and the scene has none: `shadow` switches them on");
}

}  // namespace
}  // namespace lustro
