// The three fog equations of OpenGL 2.1 (3.31 to 3.33), their ends and their clamping.
#include "shade/fog.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lustro {
namespace {

/// Linear fog from `start` to `end`, as the docstring of ShadingFog wants it.
ShadingFog linear_fog(float start, float end) {
  return {.mode = FogMode::linear, .end = end, .range_scale = 1 / (end - start)};
}
ShadingFog dense(FogMode mode, float density) {
  return {.mode = mode, .density = density};
}

TEST(Fog, LinearFallsFromStartToEnd) {
  const ShadingFog fog = linear_fog(2, 10);
  EXPECT_EQ(fog_factor(fog, 2.0F), 1.0F);
  EXPECT_EQ(fog_factor(fog, 4.0F), 0.75F);
  EXPECT_EQ(fog_factor(fog, 9.0F), 0.125F);
  EXPECT_EQ(fog_factor(fog, 10.0F), 0.0F);
}

TEST(Fog, LinearIsClampedBeforeTheStartAndBehindTheEnd) {
  EXPECT_EQ(fog_factor(linear_fog(2, 10), 0.0F), 1.0F);
  EXPECT_EQ(fog_factor(linear_fog(2, 10), 1e9F), 0.0F);
}

TEST(Fog, LinearMayRunBackwards) {  // OpenGL allows an end before the start: clear far away
  EXPECT_EQ(fog_factor(linear_fog(10, 2), 4.0F), 0.25F);
  EXPECT_EQ(fog_factor(linear_fog(10, 2), 0.0F), 0.0F);
  EXPECT_EQ(fog_factor(linear_fog(10, 2), 20.0F), 1.0F);
}

TEST(Fog, ExpIsEToTheMinusDepth) {
  for (double density : {0.01, 0.3, 2.0}) {
    for (double distance : {0.5, 1.0, 7.0, 30.0}) {
      const double expected = std::exp(-density * distance);
      const float f = fog_factor(dense(FogMode::exp, static_cast<float>(density)), static_cast<float>(distance));
      EXPECT_NEAR(f, expected, expected * 3e-7 * (2 + density * distance)) << density << ' ' << distance;
    }
  }
}

TEST(Fog, Exp2IsEToTheMinusDepthSquared) {
  for (double density : {0.01, 0.1, 0.5}) {
    for (double distance : {0.5, 1.0, 7.0, 12.0}) {
      const double depth = density * distance;
      const float f = fog_factor(dense(FogMode::exp2, static_cast<float>(density)), static_cast<float>(distance));
      EXPECT_NEAR(f, std::exp(-depth * depth), std::exp(-depth * depth) * 3e-7 * (2 + depth * depth)) << density << ' ' << distance;
    }
  }
}

TEST(Fog, AtTheEyeAllIsClearAndFarAwayAllIsFog) {
  for (FogMode mode : {FogMode::exp, FogMode::exp2}) {
    EXPECT_EQ(fog_factor(dense(mode, 1), 0.0F), 1.0F);
    EXPECT_EQ(fog_factor(dense(mode, 0), 1e9F), 1.0F);
    EXPECT_EQ(fog_factor(dense(mode, 1), 1e4F), 0.0F);
    EXPECT_EQ(fog_factor(dense(mode, 1), 3e38F), 0.0F);  // the square overflows, the factor does not
  }
}

TEST(Fog, NeverLeavesZeroToOneAndNeverRisesWithDistance) {
  for (const ShadingFog& fog : {linear_fog(1, 5), dense(FogMode::exp, 0.7F), dense(FogMode::exp2, 0.7F)}) {
    float last = 1;
    for (float distance = 0; distance < 20; distance += 0.125F) {
      const float f = fog_factor(fog, distance);
      EXPECT_GE(f, 0.0F);
      EXPECT_LE(f, last);
      last = f;
    }
    EXPECT_LT(last, 0.01F);
  }
}

}  // namespace
}  // namespace lustro
