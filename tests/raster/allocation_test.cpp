// The third picture and all that follow take no memory: every allocation of this program is counted. oneTBB keeps its tasks in memory of its
// own.
#include <gtest/gtest.h>

#include <string>

#include "allocation_hooks.hpp"
#include "lustro/render.hpp"

#ifndef LUSTRO_HOOKS_ARE_TAKEN

namespace lustro {
namespace {

Object object(const std::string& source, double x, const std::string& name) {
  Object result;
  result.source = source;
  result.name = name;
  result.matrix(0, 3) = x;
  return result;
}

/// Small and large triangles, clipped ones, long names, materials, lights and fog.
Scene scene() {
  Scene scene;
  scene.objects = {object("primitive:sphere", 0, "the name of this one is long"), object("primitive:teapot", 3, "teapot"),
                   object("primitive:cube", -3, "another long name for an object")};
  scene.objects[1].material.emplace();
  scene.objects[1].material->name = "a material whose name is long";
  scene.camera.eye = {0.5, 0.3, 2};  // the cube and the teapot reach behind it
  scene.camera.target = {0, 0, 0};
  scene.camera.near = 0.1;
  scene.fog.emplace();
  scene.image.width = 200;
  scene.image.height = 130;
  scene.image.samples = 4;
  EXPECT_TRUE(load_meshes(scene, {}, {}));
  return scene;
}

std::size_t allocations_of(Renderer& renderer, const Scene& scene, const RenderOptions& options, Rendering& result) {
  const std::size_t before = allocations;
  const bool is_drawn = renderer.render(scene, options, result).has_value();
  const std::size_t taken = allocations - before;
  EXPECT_TRUE(is_drawn);
  EXPECT_GT(result.stats.pixels_covered, 1000U);
  return taken;
}

TEST(Allocation, AnotherPictureOfTheSameMeshesTakesNone) {
  const Scene stated = scene();
  for (const int threads : {1, 2}) {
    Renderer renderer;
    Rendering result;
    const RenderOptions options{.threads = threads, .store_bytes = true};
    EXPECT_GT(allocations_of(renderer, stated, options, result), 0U);  // the hooks work
    for (int warm = 0; warm < 8; ++warm) {                             // until each thread has had the largest tile
      (void)allocations_of(renderer, stated, options, result);
    }
    std::size_t least = allocations_of(renderer, stated, options, result);
    for (int frame = 0; frame < 4; ++frame) {
      least = std::min(least, allocations_of(renderer, stated, options, result));
    }
    EXPECT_EQ(least, 0U) << threads;
  }
}

TEST(Allocation, PicturesThatHaveBeenThereBeforeTakeNone) {
  Scene turned = scene();
  Renderer renderer;
  Rendering result;
  const RenderOptions options{.threads = 1, .store_bytes = true};
  for (int round = 0; round < 3; ++round) {
    for (const double x : {-0.5, 0.5, 1.5}) {
      turned.camera.eye->x = x;
      turned.image.height = x < 0 ? 100 : 130;
      const std::size_t taken = allocations_of(renderer, turned, options, result);
      EXPECT_TRUE(round == 0 || taken == 0) << taken << " in round " << round << " at " << x;
    }
  }
}

}  // namespace
}  // namespace lustro

#endif
