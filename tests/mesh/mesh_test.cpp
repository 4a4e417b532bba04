// What a mesh says about itself: bounds and counts.
#include "lustro/mesh.hpp"

#include <gtest/gtest.h>

namespace lustro {
namespace {

TEST(Bounds, AreEmptyUntilAPointIsIncluded) {
  Bounds box;
  EXPECT_TRUE(box.is_empty());
  box.include({1, 2, 3});
  EXPECT_FALSE(box.is_empty());
  EXPECT_EQ(box.lower, (Vec3d{1, 2, 3}));
  EXPECT_EQ(box.upper, (Vec3d{1, 2, 3}));
  box.include({-1, 5, 2});
  EXPECT_EQ(box.lower, (Vec3d{-1, 2, 2}));
  EXPECT_EQ(box.upper, (Vec3d{1, 5, 3}));
  EXPECT_EQ(box.center(), (Vec3d{0, 3.5, 2.5}));
}

TEST(Mesh, BoundsCountOnlyPositionsThatTrianglesUse) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, -3}, {100, 100, 100}};
  EXPECT_TRUE(mesh.bounds().is_empty());
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(mesh.bounds().lower, (Vec3d{0, 0, -3}));
  EXPECT_EQ(mesh.bounds().upper, (Vec3d{1, 2, 0}));
}

TEST(SourceMesh, APolygonOfNCornersStatesNMinus2Triangles) {
  SourceMesh source;
  EXPECT_EQ(source.face_count(), 0U);
  EXPECT_EQ(source.stated_triangle_count(), 0U);
  source.face_begin = {0, 3, 7, 9, 9, 17};  // a triangle, a quad, two and no corners, an octagon
  EXPECT_EQ(source.face_count(), 5U);
  EXPECT_EQ(source.stated_triangle_count(), 1U + 2U + 6U);
}

}  // namespace
}  // namespace lustro
