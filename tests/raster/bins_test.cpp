#include "raster/bins.hpp"

#include <gtest/gtest.h>

#include "truth/scene_tree.hpp"

namespace lustro {
namespace {

std::size_t clusters_that_may_be_seen(Culling cull) {
  Scene scene;
  scene.image = {.width = 320, .height = 240, .samples = 1};
  scene.shading.cull = cull;
  scene.objects.push_back({.mesh = truth::tree_mesh("primitive:sphere:300")});
  MeshCache cache(ClusterUse::often);
  PreparedScene prepared;
  EXPECT_TRUE(prepare(scene, cache, 1, prepared));
  Frame frame;
  frame.scene = &prepared;
  frame.tiles_x = 5;
  frame.tiles_y = 4;
  BinWork work;
  sort_into_tiles(frame, work, 1);
  return frame.clusters.size();
}

// parity_test.cpp sees to it that they are not too many.
TEST(Bins, ClustersThatLookAwayAreLeftOut) {
  const std::size_t all = clusters_that_may_be_seen(Culling::none);
  const std::size_t front = clusters_that_may_be_seen(Culling::back);
  const std::size_t back = clusters_that_may_be_seen(Culling::front);
  EXPECT_GT(all, 300U);
  EXPECT_LT(front, all * 3 / 4);
  EXPECT_LT(back, all * 9 / 10);
  EXPECT_GE(front + back, all);
}

}  // namespace
}  // namespace lustro
