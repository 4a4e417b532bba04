// The promise of equal bits: the reference, every row of kernels and every number of threads draw the same floats, in colour and in all layers.
#include "raster/parity.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <string>

#include "lustro/lustro.hpp"
#include "shared_dir.hpp"
#include "truth/scene_tree.hpp"

namespace lustro {
namespace {

TEST(Parity, EverySceneOfTheTree) {
  for (const truth::TreeScene* entry : truth::chosen_scenes()) {
    expect_parity(entry->scene, entry->name);
    if (HasFailure()) {
      return;
    }
  }
}

// Larger pictures than the tree's, of several tiles, with triangles from a fraction of a pixel to more than the picture.
Scene big_scene(const std::string& mesh, Interpolation interpolation, int samples, int width, int height) {
  Scene scene;
  scene.shading.interpolation = interpolation;
  scene.image.samples = samples;
  scene.image.width = width;
  scene.image.height = height;
  scene.objects.push_back({.source = mesh, .mesh = truth::tree_mesh(mesh, scene.shading)});
  return scene;
}

TEST(Parity, PicturesOfManyTiles) {
  for (const char* mesh : {"primitive:sphere:300", "primitive:teapot", "primitive:cube", "primitive:plane:40"}) {
    for (const int samples : {1, 2, 4, 8, 16}) {
      expect_parity(big_scene(mesh, Interpolation::phong, samples, 301, 203), std::string(mesh) + " samples " + std::to_string(samples));
    }
  }
}

TEST(Parity, InterpolationsInPicturesOfManyTiles) {
  for (const Interpolation interpolation : {Interpolation::flat, Interpolation::gouraud}) {
    expect_parity(big_scene("primitive:torus:60", interpolation, 4, 200, 150), "torus");
  }
}

// The camera inside the mesh: triangles cross the near plane and reach far out of the guard band.
TEST(Parity, CamerasInsideMeshes) {
  std::mt19937 random(7);
  const auto number = [&random] { return static_cast<double>(random()) / 4294967296.0 * 2 - 1; };
  for (int i = 0; i < 30; ++i) {
    Scene scene = big_scene(i % 3 == 0 ? "primitive:cube" : (i % 3 == 1 ? "primitive:sphere:24" : "primitive:teapot"), Interpolation::phong,
                            i % 2 == 0 ? 1 : 4, 190, 170);
    scene.camera.eye = Vec3d{number(), number(), number()};
    scene.camera.target = Vec3d{number() * 3, number() * 3, number() * 3};
    scene.camera.fov = 20 + 65 * (number() + 1);
    scene.camera.near = i % 4 == 0 ? 1e-4 : 0.05;
    scene.camera.far = 100;
    scene.shading.two_sided = i % 2 == 0;
    expect_parity(scene, "inside " + std::to_string(i));
  }
}

// Large coordinates, tiny and huge triangles, slivers, duplicates: whatever a file may hold.
TEST(Parity, RandomTriangles) {
  std::mt19937 random(11);
  const auto number = [&random] { return static_cast<float>(random()) / 4294967296.0F * 2 - 1; };
  for (int i = 0; i < 40; ++i) {
    auto mesh = std::make_shared<Mesh>();
    const float scale = i % 4 == 0 ? 0.02F : (i % 4 == 1 ? 0.3F : (i % 4 == 2 ? 2.0F : 50.0F));
    const float place = i % 5 == 0 ? 1e5F : 1.0F;
    for (int t = 0; t < 500; ++t) {
      const Vec3f center{number() * place, number() * place, number() * place};
      for (int k = 0; k < 3; ++k) {
        mesh->positions.push_back({center.x + number() * scale * place, center.y + number() * scale * place,
                                   center.z + number() * scale * place * (t % 7 == 0 ? 1e-3F : 1.0F)});
      }
      const auto first = static_cast<std::uint32_t>(3 * t);
      mesh->triangles.push_back({first, first + 1, first + 2});
      if (t % 11 == 0) {
        mesh->triangles.push_back({first, first + 1, first + 2});  // exactly as near: the first one is seen
        mesh->triangles.push_back({first + 2, first + 1, first});
      }
    }
    Scene scene;
    scene.image.width = 257;
    scene.image.height = 131;
    scene.image.samples = i % 2 == 0 ? 1 : 4;
    scene.camera.projection = i % 3 == 0 ? Projection::orthographic : Projection::perspective;
    scene.shading.two_sided = true;
    scene.objects.push_back({.mesh = mesh});
    expect_parity(scene, "random " + std::to_string(i));
  }
}

// Many materials and instances in one tile.
TEST(Parity, ManyMaterials) {
  std::mt19937 random(13);
  const auto number = [&random] { return static_cast<double>(random()) / 4294967296.0 * 2 - 1; };
  Scene scene;
  scene.image = {.width = 180, .height = 140, .samples = 4};
  for (int i = 0; i < 60; ++i) {
    Object object;
    object.mesh = truth::tree_mesh(i % 2 == 0 ? "primitive:sphere:12" : "primitive:cube");
    const double size = 0.1 + 0.2 * (number() + 1);
    const double turn = number();
    object.matrix.m = {
        size, turn * size, 0, 3 * number(), -turn * size, size, 0, 3 * number(), 0, 0, i % 3 == 0 ? -size : 2 * size, 3 * number(), 0, 0, 0, 1};
    object.material = Material{.diffuse = {{static_cast<float>(number() + 1) / 2, 0.5F, 0.2F}},
                               .specular = {{0.5F, 0.5F, 0.5F}},
                               .shininess = static_cast<float>(1 + i),
                               .lighting = i % 5 == 0 ? std::optional(Lighting::blinn_phong) : std::nullopt};
    scene.objects.push_back(object);
  }
  for (const NormalInterpolation normals : {NormalInterpolation::lerp, NormalInterpolation::slerp}) {
    scene.shading.normals = normals;
    expect_parity(scene, "materials");
  }
}

TEST(Parity, ARendererThatIsUsedAgainGivesTheSameBits) {
  Renderer renderer;
  Rendering used;
  std::size_t i = 0;
  for (const truth::TreeScene* entry : truth::chosen_scenes()) {
    if (++i % 23 != 0) {
      continue;
    }
    RenderOptions options;
    options.aovs = all_aovs();
    const Result<void> again = renderer.render(entry->scene, options, used);
    const Result<Rendering> once = render(entry->scene, options);
    ASSERT_EQ(again.has_value(), once.has_value());
    if (once) {
      const auto found = difference(once->color, used.color, entry->name);
      EXPECT_FALSE(found) << *found;
    }
  }
}

// A renderer that is used again leaves out whole clusters that look away, and not one triangle that the image's grid turns round.
TEST(Parity, CulledClusters) {
  std::mt19937 random(17);
  const auto number = [&random] { return static_cast<double>(random()) / 4294967296.0 * 2 - 1; };
  for (int i = 0; i < 48; ++i) {
    constexpr std::array kMeshes{"primitive:sphere:24", "primitive:sphere:200", "primitive:sphere:500", "primitive:teapot",
                                 "primitive:torus:160"};
    Scene scene = big_scene(kMeshes[static_cast<std::size_t>(i) % kMeshes.size()], Interpolation::flat, i % 3 == 0 ? 4 : 1, 160, 120);
    scene.shading.cull = i % 2 == 0 ? Culling::back : Culling::front;
    scene.shading.two_sided = i % 4 < 2;
    scene.camera.projection = i % 5 == 0 ? Projection::orthographic : Projection::perspective;
    scene.camera.eye = Vec3d{2.5 * number(), 2.5 * number(), 2.5 * number()};
    scene.camera.target = Vec3d{number(), number(), number()};
    scene.camera.fov = 20 + 60 * (number() + 1);
    scene.camera.near = 0.01;
    scene.camera.far = 100;
    const double size = i % 7 == 0 ? 0.05 : 1;  // the finer meshes then have triangles far below the grid
    scene.objects[0].matrix.m = {size, 0, 0, 1e3 * (i % 11 == 0), 0, i % 3 == 0 ? -size : size, 0, 0, 0, 0, i % 13 == 0 ? 2 * size : size, 0, 0,
                                 0,    0, 1};
    if (i % 11 == 0) {  // far from the origin
      scene.camera.eye->x += 1e3;
      scene.camera.target->x += 1e3;
    }
    RenderOptions options{.aovs = all_aovs(), .store_bytes = true};
    options.engine = Engine::reference;
    const Result<Rendering> reference = render(scene, options);
    options.engine = Engine::raster;
    Result<Rendering> used = Rendering{};
    Renderer renderer;
    ASSERT_TRUE(renderer.render(scene, options, *used));
    const auto found = difference(reference, used);
    EXPECT_FALSE(found) << i << ": " << *found;
  }
}

// Triangles in a plane, thinner than a step of the image's grid: seen from behind, the grid turns some of them round, and those are drawn.
TEST(Parity, SliversThatTheGridTurnsRound) {
  std::mt19937 random(19);
  const auto number = [&random] { return static_cast<float>(random()) / 4294967296.0F - 0.5F; };
  auto mesh = std::make_shared<Mesh>();
  for (std::uint32_t i = 0; i < 3 * 100'000; i += 3) {
    const Vec3f center{number(), number(), 0};
    const Vec3f along = normalize(Vec3f{number(), number(), 0}) * 0.03F;
    constexpr float kThin = 1e-3F;
    mesh->positions.insert(mesh->positions.end(), {center - along, center + along, center + Vec3f{-along.y, along.x, 0} * kThin});
    mesh->triangles.push_back({i, i + 1, i + 2});
  }
  Scene scene;
  scene.image = {.width = 70, .height = 60, .samples = 1};
  scene.camera.target = Vec3d{0, 0, 0};
  scene.shading.cull = Culling::back;
  scene.objects.push_back({.mesh = mesh});
  for (const double side : {1.0, -1.0}) {
    scene.camera.eye = Vec3d{0.1, 0.05, 2 * side};
    const Result<Rendering> reference = render(scene, {.engine = Engine::reference});
    Renderer renderer;
    Rendering used;
    ASSERT_TRUE(renderer.render(scene, {}, used));
    EXPECT_GT(reference->stats.pixels_covered, 10U);
    const auto found = difference(reference->color, used.color, side < 0 ? "back" : "front");
    EXPECT_FALSE(found) << *found;
  }
}

// Small enough for the thread sanitizer.
TEST(Parity, SeveralThreadsShareNothingButTheScene) {
  Scene scene = big_scene("primitive:sphere:40", Interpolation::phong, 4, 200, 150);
  Renderer renderer;
  Rendering result;
  const Result<Rendering> one = drawn(scene, {.threads = 1}, false);
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(renderer.render(scene, {.threads = 4, .store_bytes = true}, result));
    EXPECT_EQ(result.bytes.pixels, one->bytes.pixels);
    EXPECT_EQ(result.color.pixels, one->color.pixels);
  }
}

TEST(Target, NamesAreReadBack) {
  for (const Target target : available_targets()) {
    const auto parsed = parse_target(target_name(target));
    ASSERT_TRUE(parsed);
    EXPECT_EQ(*parsed, target);
  }
  EXPECT_EQ(*parse_target("auto"), Target::automatic);
  EXPECT_EQ(parse_target("sse9").error().kind, ErrorKind::usage);
  EXPECT_EQ(available_targets().back(), Target::scalar);
}

TEST(Target, WhatTheMachineLacksIsAnError) {
  for (const char* name : {"avx512", "neon", "wasm"}) {
    const auto parsed = parse_target(name);
    if (!parsed) {
      EXPECT_EQ(parsed.error().kind, ErrorKind::unsupported);
      EXPECT_NE(parsed.error().message.find("scalar"), std::string::npos);
      return;
    }
  }
  FAIL() << "no machine has all three";
}

}  // namespace
}  // namespace lustro
