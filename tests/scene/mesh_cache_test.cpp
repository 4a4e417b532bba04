// What is made of a mesh is kept while pictures ask for it, and made anew where they ask for something else.
#include "scene/mesh_cache.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lustro {
namespace {

std::shared_ptr<Mesh> triangle() {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh->triangles = {{0, 1, 2}};
  return mesh;
}

TEST(MeshCache, KeepsWhatIsAskedForAgain) {
  MeshCache cache(ClusterUse::often);
  const auto mesh = triangle();
  const auto first = cache.get(mesh, {}, 1, "mesh");
  ASSERT_TRUE(first);
  cache.forget_unused();
  EXPECT_EQ(*cache.get(mesh, {}, 1, "mesh"), *first);
  cache.forget_unused();
  cache.forget_unused();  // nobody asked
  EXPECT_NE(*cache.get(mesh, {}, 1, "mesh"), *first);
}

TEST(MeshCache, OtherDemandsAreOtherEntries) {
  MeshCache cache(ClusterUse::often);
  const auto mesh = triangle();
  const auto lit = cache.get(mesh, {}, 1, "mesh");
  const auto flat = cache.get(mesh, {.wants_normals = false}, 1, "mesh");
  ASSERT_TRUE(lit && flat);
  EXPECT_EQ((*lit)->mesh->normals.size(), 3U);
  EXPECT_TRUE((*flat)->mesh->normals.empty());
  EXPECT_EQ((*flat)->mesh, mesh) << "nothing was to be changed, so nothing was copied";
}

TEST(MeshCache, NormalsOfAnyLengthBecomeUnit) {
  MeshCache cache(ClusterUse::once);
  const auto mesh = triangle();
  mesh->normals = {{0, 0, 5}, {0, 1e-30F, 0}, {0, 0, 1}};
  const auto drawable = cache.get(mesh, {}, 1, "mesh");
  ASSERT_TRUE(drawable);
  EXPECT_EQ((*drawable)->mesh->normals, (std::vector<Vec3f>{{0, 0, 1}, {0, 1, 0}, {0, 0, 1}}));
}

TEST(MeshCache, WhatDoesNotFitTogetherIsAnError) {
  MeshCache cache(ClusterUse::once);
  const auto outside = triangle();
  outside->triangles = {{0, 1, 3}};
  EXPECT_EQ(cache.get(outside, {}, 1, "here").error().text(), "here: a triangle names vertex 3, but there are 3");
  const auto infinite = triangle();
  infinite->positions[1].x = std::numeric_limits<float>::infinity();
  EXPECT_EQ(cache.get(infinite, {}, 2, "here").error().text(), "here: has a position that is not finite");
  const auto uneven = triangle();
  uneven->colors.resize(2);
  EXPECT_FALSE(cache.get(uneven, {}, 1, "here"));
  const auto material = triangle();
  material->triangle_material = {1};
  EXPECT_EQ(cache.get(material, {}, 1, "here").error().text(), "here: a triangle names material 1, but there are 1");
}

}  // namespace
}  // namespace lustro
