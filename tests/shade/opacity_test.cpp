// MTL's halo by its formula: 1 - |N.V| (1 - opacity).
#include "shade/opacity.hpp"

#include <gtest/gtest.h>

namespace lustro {
namespace {

TEST(Opacity, AHaloIsTheStatedOpacitySeenFromTheFrontAndOneFromTheSide) {
  EXPECT_EQ(halo(0.25F, 1.0F), 0.25F);
  EXPECT_EQ(halo(0.25F, -1.0F), 0.25F);  // from behind as from the front
  EXPECT_EQ(halo(0.25F, 0.0F), 1.0F);
  EXPECT_EQ(halo(0.5F, 0.5F), 0.75F);
}

TEST(Opacity, IsTheSameEverywhereUnlessSomethingVariesIt) {
  ShadingOpacity opacity;
  EXPECT_TRUE(opacity.is_uniform());
  opacity.has_halo = true;
  EXPECT_FALSE(opacity.is_uniform());
  opacity = {};
  opacity.has_vertex_alphas = true;
  EXPECT_FALSE(opacity.is_uniform());
  opacity = {};
  opacity.has_map = true;
  EXPECT_FALSE(opacity.is_uniform());
}

}  // namespace
}  // namespace lustro
