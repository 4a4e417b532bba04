#include <cmath>
#include <limits>

#include "image/id_color.hpp"
#include "image/support.hpp"

namespace lustro {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

Layer layer(const char* name, int channels, std::vector<float> pixels) {
  Layer l;
  l.name = name;
  l.image = Image(static_cast<int>(pixels.size()) / channels, 1, channels);
  l.image.pixels = std::move(pixels);
  return l;
}

TEST(LayerPreview, DepthIsWhiteWhereNearAndDarkWhereFarAndBlackWhereThereIsNothing) {
  const Image p = layer_preview(layer("depth", 1, {2, 4, 3, kInfinity, std::numeric_limits<float>::quiet_NaN()}));
  EXPECT_EQ(p.at(0, 0)[0], 1.0F);
  EXPECT_FLOAT_EQ(p.at(1, 0)[0], 0.1F);
  EXPECT_FLOAT_EQ(p.at(2, 0)[0], 0.55F);
  EXPECT_EQ(p.at(3, 0)[0], 0.0F);
  EXPECT_EQ(p.at(4, 0)[0], 0.0F);
}

TEST(LayerPreview, AFlatDepthIsWhiteAndAnEmptyOneBlack) {
  EXPECT_EQ(layer_preview(layer("depth", 1, {3, 3, kInfinity})).pixels, (std::vector<float>{1, 1, 0}));
  EXPECT_EQ(layer_preview(layer("depth", 1, {kInfinity, kInfinity})).pixels, (std::vector<float>{0, 0}));
}

TEST(LayerPreview, NormalsAreHalvedAndMovedAndTheBackgroundStaysBlack) {
  EXPECT_EQ(layer_preview(layer("normal", 3, {0, 0, 1, -1, 0.5F, 0, 0, 0, 0})).pixels,
            (std::vector<float>{0.5F, 0.5F, 1, 0, 0.75F, 0.5F, 0, 0, 0}));
}

TEST(LayerPreview, PositionsFillTheirBounds) {
  const Image p = layer_preview(layer("position", 3, {-1, 5, 2, 3, 5, 4, 1, 5, 3, 0, 0, 0}));
  EXPECT_EQ(p.pixels, (std::vector<float>{0, 0.5F, 0, 1, 0.5F, 1, 0.5F, 0.5F, 0.5F, 0, 0, 0}));
}

TEST(LayerPreview, IdsBecomeColoursAndTheBackgroundBlack) {
  for (const char* name : {"object", "material", "triangle"}) {
    const Image p = layer_preview(layer(name, 1, {-1, 0, 1, 0}));
    ASSERT_EQ(p.channels, 3);
    EXPECT_EQ(p.at(0, 0)[0] + p.at(0, 0)[1] + p.at(0, 0)[2], 0.0F);
    EXPECT_TRUE(std::ranges::equal(p.at(1, 0), p.at(3, 0)));
    EXPECT_FALSE(std::ranges::equal(p.at(1, 0), p.at(2, 0)));
  }
}

TEST(LayerPreview, LightIsLeftAsItIs) {
  for (const char* name : {"ambient", "diffuse", "specular", "emission", "fog", "background", "light:0", "scene", "albedo"}) {
    const Layer l = layer(name, 3, {0.25F, 3, -1});
    EXPECT_FALSE(is_data_layer(l)) << name;
    EXPECT_EQ(layer_preview(l).pixels, l.image.pixels) << name;
  }
}

TEST(LayerPreview, NumbersAreToldFromLight) {
  for (const char* name : {"depth", "normal", "position", "object", "material", "triangle", "barycentrics", "mask"}) {
    EXPECT_TRUE(is_data_layer(layer(name, 3, {0, 0, 0}))) << name;
  }
}

TEST(IdColor, NeighboursAndTheFirstTwoDozenAreFarApart) {
  const auto distance = [](const Vec3f& a, const Vec3f& b) { return length(a - b); };
  for (int i = 0; i < 24; ++i) {
    for (int j = 0; j < i; ++j) {
      EXPECT_GT(distance(id_color(static_cast<float>(i)), id_color(static_cast<float>(j))), 0.1F) << i << " " << j;
    }
  }
  for (int i = 0; i < 100000; ++i) {
    ASSERT_GT(distance(id_color(static_cast<float>(i)), id_color(static_cast<float>(i + 1))), 0.25F) << i;
  }
}

TEST(IdColor, IsNeverTakenForTheBackground) {
  for (int i = 0; i < 10000; ++i) {
    const Vec3f c = id_color(static_cast<float>(i));
    ASSERT_GT(std::max({c.x, c.y, c.z}), 0.6F);
    ASSERT_LE(std::max({c.x, c.y, c.z}), 1.0F);
    ASSERT_GE(std::min({c.x, c.y, c.z}), 0.0F);
  }
  for (const float none : {-1.0F, -0.5F, std::numeric_limits<float>::quiet_NaN(), kInfinity}) {
    EXPECT_EQ(id_color(none), (Vec3f{0, 0, 0}));
  }
}

}  // namespace
}  // namespace lustro
