#include <cmath>
#include <limits>

#include "image/heat.hpp"
#include "image/srgb.hpp"
#include "image/support.hpp"

namespace lustro {
namespace {

Image filled(int width, int height, const std::vector<float>& pixel) {
  Image image(width, height, static_cast<int>(pixel.size()));
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = pixel[i % pixel.size()];
  }
  return image;
}

Comparison compared(const Image& a, const Image& b, double tolerance = 2.0 / 255, Transfer transfer = Transfer::none) {
  auto result = compare_images(a, b, tolerance, transfer);
  EXPECT_TRUE(result) << (result ? "" : result.error().text());
  return result ? *result : Comparison();
}

TEST(Compare, EqualPicturesDifferInNothing) {
  const Image image = random_image(30, 20, 4, 1);
  const Comparison c = compared(image, image);
  EXPECT_EQ(c.max, 0);
  EXPECT_EQ(c.mean, 0);
  EXPECT_EQ(c.rmse, 0);
  EXPECT_EQ(c.psnr, std::numeric_limits<double>::infinity());
  EXPECT_EQ(c.share_over, 0);
  EXPECT_EQ(c.flip, 0);
  EXPECT_EQ(largest_difference(c.heatmap, Image(30, 20, 3)), 0);
}

TEST(Compare, NumbersOnPaper) {
  // 4 pixels of 3 channels; one channel differs by 0.5 and one by 0.25
  Image a = filled(2, 2, {0.25F, 0.25F, 0.25F});
  Image b = a;
  b.at(0, 0)[1] = 0.75F;
  b.at(1, 1)[2] = 0.0F;
  const Comparison c = compared(a, b, 0.3);
  EXPECT_DOUBLE_EQ(c.max, 0.5);
  EXPECT_DOUBLE_EQ(c.mean, 0.75 / 12);
  EXPECT_DOUBLE_EQ(c.rmse, std::sqrt((0.25 + 0.0625) / 12));
  EXPECT_DOUBLE_EQ(c.psnr, 10 * std::log10(12 / 0.3125));
  EXPECT_DOUBLE_EQ(c.share_over, 0.25);
  EXPECT_DOUBLE_EQ(compared(a, b, 0.2).share_over, 0.5);
}

TEST(Compare, ADifferenceOfExactlyTheToleranceIsNotOver) {
  for (const Transfer transfer : {Transfer::none, Transfer::srgb}) {
    for (int v = 0; v + 2 < 256; ++v) {
      const auto linear = [&](int byte) {
        const float u = static_cast<float>(byte) / 255.0F;
        return transfer == Transfer::srgb ? srgb_decode(u) : u;
      };
      const Image a = filled(1, 1, {linear(v)});
      ASSERT_EQ(compared(a, filled(1, 1, {linear(v + 2)}), 2.0 / 255, transfer).share_over, 0) << v;
      if (v + 3 < 256) {
        ASSERT_EQ(compared(a, filled(1, 1, {linear(v + 3)}), 2.0 / 255, transfer).share_over, 1) << v;
      }
    }
  }
}

TEST(Compare, PicturesAreComparedAsTheyWouldBeStored) {
  const Comparison encoded = compared(filled(1, 1, {0.0F}), filled(1, 1, {0.5F}), 0, Transfer::srgb);
  EXPECT_NEAR(encoded.max, 0.735357, 1e-6);
  EXPECT_NEAR(compared(filled(1, 1, {0.0F}), filled(1, 1, {0.5F})).max, 0.5, 1e-7);
  // beyond 1 everything is white, below 0 and no number black
  EXPECT_EQ(compared(filled(1, 1, {7.0F}), filled(1, 1, {1.0F})).max, 0);
  EXPECT_EQ(compared(filled(1, 1, {-7.0F}), filled(1, 1, {std::numeric_limits<float>::quiet_NaN()})).max, 0);
}

TEST(Compare, GrayAndColourAndOpaqueAlphaMayMeet) {
  const Image gray = random_image(9, 7, 1, 2);
  Image rgb(9, 7, 3);
  Image rgba(9, 7, 4);
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 9; ++x) {
      for (std::size_t c = 0; c < 4; ++c) {
        rgba.at(x, y)[c] = c == 3 ? 1.0F : gray.at(x, y)[0];
        if (c < 3) {
          rgb.at(x, y)[c] = gray.at(x, y)[0];
        }
      }
    }
  }
  EXPECT_EQ(compared(gray, rgb).max, 0);
  EXPECT_EQ(compared(rgb, rgba).max, 0);
  EXPECT_EQ(compared(rgba, gray).flip, 0);
}

TEST(Compare, AlphaCountsWhereItIsNotOneEverywhere) {
  const Image clear = filled(2, 1, {0, 0, 0, 0});
  const Image black = filled(2, 1, {0, 0, 0, 1});
  const Comparison c = compared(clear, black);
  EXPECT_EQ(c.max, 1);
  EXPECT_DOUBLE_EQ(c.mean, 0.25);
  EXPECT_EQ(c.share_over, 1);
  EXPECT_EQ(c.flip, 0);  // over black nobody sees a difference
}

TEST(Compare, DifferentSizesAreRefused) {
  const auto result = compare_images(Image(4, 3, 3), Image(3, 4, 3));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::usage);
  EXPECT_EQ(result.error().text(), "the pictures have different sizes: 4 x 3 and 3 x 4");
  EXPECT_FALSE(compare_images(Image(), Image()));
}

TEST(Compare, IsTheSameEveryTime) {
  const Image a = random_image(150, 170, 3, 3);
  const Image b = random_image(150, 170, 3, 4);
  const Comparison first = compared(a, b, 0.1, Transfer::srgb);
  EXPECT_GT(first.flip, 0.1);
  for (int i = 0; i < 5; ++i) {
    const Comparison again = compared(a, b, 0.1, Transfer::srgb);
    EXPECT_EQ(again.mean, first.mean);
    EXPECT_EQ(again.rmse, first.rmse);
    EXPECT_EQ(again.flip, first.flip);
    EXPECT_EQ(again.heatmap.pixels, first.heatmap.pixels);
  }
}

TEST(Compare, TheHeatMapIsBrightWhereThePicturesDiffer) {
  const Image a = filled(64, 64, {0.2F, 0.2F, 0.2F});
  Image b = a;
  for (int y = 20; y < 30; ++y) {
    for (int x = 40; x < 50; ++x) {
      b.at(x, y)[0] = 0.9F;
    }
  }
  const Comparison c = compared(a, b);
  EXPECT_EQ(c.heatmap.width, 64);
  EXPECT_EQ(c.heatmap.channels, 3);
  EXPECT_EQ(c.heatmap.at(2, 60)[0], 0);
  EXPECT_GT(c.heatmap.at(45, 25)[0], 0.3F);
}

TEST(HeatColor, RisesInLightnessFromBlackToNearWhite) {
  float before = -1;
  for (int i = 0; i <= 1000; ++i) {
    const Vec3f c = heat_color(static_cast<float>(i) / 1000);
    const float luminance = 0.2126F * c.x + 0.7152F * c.y + 0.0722F * c.z;
    ASSERT_GT(luminance, before) << i;
    before = luminance;
  }
  EXPECT_EQ(heat_color(0), (Vec3f{0, 0, 0}));
  EXPECT_GT(before, 0.85F);
  EXPECT_EQ(heat_color(std::numeric_limits<float>::quiet_NaN()), heat_color(0));
  EXPECT_EQ(heat_color(5), heat_color(1));
}

}  // namespace
}  // namespace lustro
