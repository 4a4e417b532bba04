// Lights with a size as samplers: directions by their densities, and one density whichever way it is asked for.
#include "path/emitters.hpp"

#include <algorithm>

#include "chi_square.hpp"
#include "path_testing.hpp"

namespace lustro {
namespace {

PreparedScene prepared(Scene scene) {
  if (scene.objects.empty()) {
    scene.objects.push_back(object(square(0.01F), lambert(0)));
  }
  return prepare(scene).value();
}

Light area(LightType type) {
  Light light;
  light.type = type;
  light.position = {0.3, 0.2, 1};
  light.direction = {-0.2, 0.1, -1};
  light.size = {1.5F, 1};
  light.radius = 0.6;
  return light;
}

TEST(Emitters, DirectionsToLightsFallAsTheirDensitySays) {
  for (const LightType type : {LightType::rectangle, LightType::disk, LightType::sphere}) {
    Scene scene = look({0, 0, 5}, 1);
    scene.lights->push_back(area(type));
    const PreparedScene ready = prepared(scene);
    const Emitters emitters(ready);
    const Vec3f position{0.1F, -0.1F, -5};  // relative to the eye
    constexpr float kFar = 1e30F;
    expect_distribution(
        [&](const Vec2f& u) {
          const EmitterSample sample = emitters.sample(position, u);
          EXPECT_GT(sample.density, 0);
          const auto met = emitters.meets_area(0, position, sample.to_light, kFar);
          if (met) {  // but at the very edge
            EXPECT_NEAR(met->density, sample.density, 1e-3F * sample.density);
          }
          return sample.to_light;
        },
        [&](const Vec3f& d) {
          const auto met = emitters.meets_area(0, position, d, kFar);
          return met ? static_cast<double>(met->density) : 0.0;
        },
        "light " + std::to_string(static_cast<int>(type)));
  }
}

// In the cone's own coordinates, so that the cells are as fine for a lamp that is nearly all around as for one that is a point.
TEST(Emitters, DirectionsFillTheConeOfASphereEvenly) {
  constexpr int kRows = 16;
  constexpr int kColumns = 16;
  constexpr int kSamples = 400000;
  for (const double radius : {0.98, 0.6, 0.05, 0.003}) {
    Scene scene = look({0, 0, 5}, 1);
    Light lamp = area(LightType::sphere);
    lamp.position = {0.36, -0.48, 0.8};
    lamp.radius = radius;
    scene.lights->push_back(lamp);
    const PreparedScene ready = prepared(scene);
    const Emitters emitters(ready);
    const Vec3f position{0, 0, -5};  // relative to the eye: one away from the lamp's centre
    const Vec3d axis{0.36, -0.48, 0.8};
    const Vec3d x{0.8, 0.6, 0};
    const Vec3d y = cross(axis, x);
    const double cosine = std::sqrt(1 - radius * radius);
    const double cap = radius * radius / (1 + cosine);  // 1 - cos
    std::vector<double> found(kRows * kColumns);
    Uniform uniform(7);
    for (int i = 0; i < kSamples; ++i) {
      const EmitterSample sample = emitters.sample(position, uniform.two());
      EXPECT_NEAR(static_cast<double>(sample.density) * (2 * kPi * cap), 1, 2e-4) << radius;
      const Vec3d d = vec_cast<double>(sample.to_light);
      const double along_x = dot(d, x);
      const double along_y = dot(d, y);
      const double sine2 = along_x * along_x + along_y * along_y;
      const double z = dot(d, axis) > 0 ? std::sqrt(1 - std::min(sine2, 1.0)) : 0;
      const double row = sine2 / (1 + z) / cap * kRows;  // (1 - cos) / cap is even in 0..1
      const double column = (std::atan2(along_y, along_x) / (2 * kPi) + 0.5) * kColumns;
      EXPECT_LT(row, kRows * (1 + 1e-3)) << radius;
      const int r = std::clamp(static_cast<int>(row), 0, kRows - 1);
      const int c = std::clamp(static_cast<int>(column), 0, kColumns - 1);
      found[static_cast<std::size_t>(r * kColumns + c)] += 1;
      // The way ends on the sphere's near side.
      const Vec3d at = d * static_cast<double>(sample.distance) - axis;
      EXPECT_NEAR(std::sqrt(dot(at, at)), radius, 2e-3 * radius + 1e-5) << radius;
      EXPECT_LE(static_cast<double>(sample.distance), 1) << radius;
    }
    expect_counts(found, std::vector<double>(kRows * kColumns, static_cast<double>(kSamples) / (kRows * kColumns)),
                  "radius " + std::to_string(radius));
  }
}

TEST(Emitters, EmittingTrianglesAreFoundByTheirPower) {
  Scene scene = look({0, 0, 5}, 1);
  Material dim = lambert(0);
  dim.emission = gray(1);
  Material bright = lambert(0);
  bright.emission = gray(5);
  scene.objects.push_back(object(square(0.5F), dim, moved(-1, 0, 1)));
  scene.objects.push_back(object(square(0.4F), bright, moved(1, 0.3, 1)));
  scene.objects.push_back(object(square(0.4F), lambert(1), moved(0, 0, -1)));
  const PreparedScene ready = prepared(scene);
  const Emitters emitters(ready);
  auto rays = RayScene::make(ready);
  if (!rays) {
    GTEST_SKIP() << rays.error().text();
  }
  const Vec3f position{0, 0, -5};
  expect_distribution([&](const Vec2f& u) { return emitters.sample(position, u).to_light; },
                      [&](const Vec3f& d) {
                        RayHit hit;
                        if (!rays->closest({position, d, 0.01F}, hit) || hit.instance == 2) {
                          return 0.0;
                        }
                        return static_cast<double>(
                            emitters.density_of(place_of(ready, hit, placed_triangle(ready, hit.instance, hit.triangle), d, true), position));
                      },
                      "triangles", 50000);
  EXPECT_FALSE(emitters.is_empty());
  EXPECT_EQ(emitters.sky(), nullptr);
}

TEST(Emitters, WhatHasNoLightIsEmpty) {
  const PreparedScene ready = prepared(look({0, 0, 5}, 1));
  EXPECT_TRUE(Emitters(ready).is_empty());
  Scene scene = look({0, 0, 5}, 1);
  scene.environment = white_sky(0);
  const PreparedScene dark = prepared(scene);
  EXPECT_TRUE(Emitters(dark).is_empty());
}

TEST(Emitters, ALightIsMetFromItsFrontBeforeWhatStandsBehindIt) {
  Scene scene = look({0, 0, 5}, 1);
  scene.lights->push_back(area(LightType::disk));
  const PreparedScene ready = prepared(scene);
  const Emitters emitters(ready);
  const Vec3f center = ready.area_lights[0].center;
  const Vec3f before = center + ready.area_lights[0].normal * 2.0F;
  const Vec3f behind = center - ready.area_lights[0].normal * 2.0F;
  EXPECT_TRUE(emitters.meets_area(0, before, -ready.area_lights[0].normal, 2.1F));
  EXPECT_FALSE(emitters.meets_area(0, before, -ready.area_lights[0].normal, 1.9F)) << "something stands before it";
  EXPECT_FALSE(emitters.meets_area(0, behind, ready.area_lights[0].normal, 9));
  EXPECT_FALSE(emitters.meets_area(0, before, ready.area_lights[0].normal, 9));
}

}  // namespace
}  // namespace lustro
