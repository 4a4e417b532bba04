// Look-ups in maps whose values stand on paper.
#include "shade/depth_map.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace lustro {
namespace {

// 16 x 16 texels of size 1, seen from z = 10 along -z; depth 5 is a plate over the left half, x < 0; elsewhere there is nothing.
struct Plate {
  std::vector<float> keys;
  DepthMap map;

  explicit Plate(int softness) : keys(256, 0.0F) {
    map.shape = DepthShape::parallel;
    map.size = 16;
    map.softness = softness;
    map.key_scale = 0.05F;
    map.farthest = 20;
    map.place.m = {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 10};
    for (std::size_t i = 0; i < keys.size(); ++i) {
      keys[i] = i % 16 < 8 ? (20 - 5) * 0.05F : 0.0F;
    }
    map.keys = keys.data();
  }
  [[nodiscard]] float at(const Vec3f& p, const Vec3f& normal = {0, 0, 1}) const { return visibility_in(map, p, normal); }
};

TEST(DepthMap, BlendsTheTwoTexelsAroundAPlace) {
  const Plate plate(0);
  EXPECT_EQ(plate.at({-0.75F, 0, 0}), 0);
  EXPECT_EQ(plate.at({-0.5F, 0, 0}), 0);
  EXPECT_EQ(plate.at({-0.25F, 0, 0}), 0.25F);
  EXPECT_EQ(plate.at({0, 0, 0}), 0.5F);
  EXPECT_EQ(plate.at({0.25F, 3.3F, 0}), 0.75F);
  EXPECT_EQ(plate.at({0.5F, 0, 0}), 1);
}

TEST(DepthMap, BlursByItsSoftness) {
  const Plate plate(2);  // five texels
  EXPECT_EQ(plate.at({-2.5F, 0, 0}), 0);
  EXPECT_FLOAT_EQ(plate.at({-1.5F, 0, 0}), 0.2F);
  EXPECT_EQ(plate.at({0, 0, 0}), 0.5F);
  EXPECT_FLOAT_EQ(plate.at({1, 0, 0}), 0.7F);
  EXPECT_EQ(plate.at({2.5F, 0, 0}), 1);
}

// The plate itself, at z = 5, and what lies just below it: the plane is lifted by half a texel.
TEST(DepthMap, WhatIsSeenByTheLightIsNotInItsOwnShadow) {
  const Plate plate(0);
  EXPECT_EQ(plate.at({-3, 0, 5}), 1);
  EXPECT_EQ(plate.at({-3, 0, 4.6F}), 1);
  EXPECT_EQ(plate.at({-3, 0, 4.4F}), 0);
  EXPECT_EQ(plate.at({-3, 0, 9}), 1);
}

// A slope whose depth changes by 8 units a texel: the map holds its depths at the texels' centres, and every place on it is lit.
TEST(DepthMap, ASteepReceiverIsComparedWithItsOwnPlane) {
  Plate plate(1);
  const float slope = 8;
  plate.map.farthest = 200;
  plate.map.key_scale = 1;
  plate.map.place.m[11] = 100;
  for (std::size_t i = 0; i < 256; ++i) {
    plate.keys[i] = 100 + slope * (static_cast<float>(i % 16) + 0.5F - 8);
  }
  const Vec3f normal = normalize(Vec3f{-slope, 0, 1});
  for (float x = -6; x < 6; x += 0.0625F) {
    EXPECT_EQ(plate.at({x, 0.3F, slope * x}, normal), 1) << x;
    EXPECT_EQ(plate.at({x, 0.3F, slope * x}, -normal), 1) << x;
    EXPECT_EQ(plate.at({x, 0.3F, slope * x - 2 * slope}, normal), 0) << x;
  }
}

TEST(DepthMap, PlacesBesideTheMapAndNoNumbersReadItsEdge) {
  const Plate plate(2);
  EXPECT_EQ(plate.at({1e30F, 0, 0}), 1);
  EXPECT_EQ(plate.at({-1e30F, -1e30F, 0}), 0);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float anything = plate.at({nan, nan, nan});
  EXPECT_TRUE(anything >= 0 && anything <= 1);
}

// A plate before each face of a cube around the light, at the distance 2: what lies behind it is dark, what lies before it is lit.
TEST(DepthMap, ACubeLooksAllAround) {
  const std::vector<float> keys(6 * 64, 0.5F);
  DepthMap map;
  map.shape = DepthShape::cube;
  map.size = 8;
  map.texels = 4;
  map.nearest = 0.01F;
  map.keys = keys.data();
  map.place.m = {1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 1, 3};
  const Vec3f light{-1, -2, -3};
  for (const Vec3f& way :
       {Vec3f{1, 0.2F, 0.3F}, Vec3f{-1, 0.5F, 0.1F}, Vec3f{0.1F, 1, 0.6F}, Vec3f{0.7F, -1, 0}, Vec3f{0.3F, 0.4F, 1}, Vec3f{-0.2F, 0.1F, -1}}) {
    const Vec3f axis{way.x * way.x == 1 ? way.x : 0, way.y * way.y == 1 ? way.y : 0, way.z * way.z == 1 ? way.z : 0};
    EXPECT_EQ(visibility_in(map, light + way * 1.5F, axis), 1);
    EXPECT_EQ(visibility_in(map, light + way * 3.0F, axis), 0);
  }
}

}  // namespace
}  // namespace lustro
