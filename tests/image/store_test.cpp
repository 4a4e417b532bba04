#include "image/store.hpp"

#include <limits>

#include "image/support.hpp"

namespace lustro {
namespace {

Image pixel(std::vector<float> values) {
  Image image(1, 1, static_cast<int>(values.size()));
  image.pixels = std::move(values);
  return image;
}

TEST(Store, ColoursAreEncodedAndAlphaIsNot) {
  EXPECT_EQ(to_bytes(pixel({0.5F, 0.18F, 1.0F, 1.0F}), Transfer::srgb).pixels, (std::vector<std::uint8_t>{188, 118, 255, 255}));
  EXPECT_EQ(to_bytes(pixel({0.5F, 0.18F, 1.0F, 1.0F}), Transfer::none).pixels, (std::vector<std::uint8_t>{128, 46, 255, 255}));
}

TEST(Store, PremultipliedColoursAreDividedByAlphaBeforeTheyAreEncoded) {
  // half-covered white and half-covered mid grey
  EXPECT_EQ(to_bytes(pixel({0.5F, 0.25F, 0.0F, 0.5F}), Transfer::srgb).pixels, (std::vector<std::uint8_t>{255, 188, 0, 128}));
  EXPECT_EQ(to_bytes(pixel({0.25F, 0.5F}), Transfer::none).pixels, (std::vector<std::uint8_t>{128, 128}));
  EXPECT_EQ(to_bytes(pixel({0.25F}), Transfer::none).pixels, (std::vector<std::uint8_t>{64}));
}

TEST(Store, WhereNothingIsCoveredTheColourIsBlack) {
  EXPECT_EQ(to_bytes(pixel({0.7F, 0.7F, 0.7F, 0.0F}), Transfer::srgb).pixels, (std::vector<std::uint8_t>{0, 0, 0, 0}));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(to_bytes(pixel({0.7F, 0.7F, 0.7F, nan}), Transfer::srgb).pixels, (std::vector<std::uint8_t>{0, 0, 0, 0}));
}

TEST(Store, WhatIsNoNumberIsBlackAndWhatIsTooBrightIsWhite) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const Transfer transfer : {Transfer::srgb, Transfer::none}) {
    EXPECT_EQ(to_bytes(pixel({nan, infinity, -infinity, 1.0F}), transfer).pixels, (std::vector<std::uint8_t>{0, 255, 0, 255}));
    EXPECT_EQ(to_bytes(pixel({17.0F, -2.0F, 1e30F, 3.0F}), transfer).pixels, (std::vector<std::uint8_t>{255, 0, 255, 255}));
  }
}

TEST(Store, SixteenBitsFollowTheSameRules) {
  EXPECT_EQ(stored16(pixel({0.25F, 0.5F, 0.0F, 0.5F}), Transfer::none), (std::vector<std::uint16_t>{32768, 65535, 0, 32768}));
  EXPECT_EQ(stored16(pixel({0.5F}), Transfer::srgb), (std::vector<std::uint16_t>{48192}));  // 65535 * 0.7353569
}

TEST(Store, EightBitColoursSurviveEveryAlphaButZero) {
  // what a PNG with alpha holds comes back from premultiplied floats
  for (int alpha = 1; alpha < 256; ++alpha) {
    Image image(256, 1, 4);
    for (int v = 0; v < 256; ++v) {
      const float a = static_cast<float>(alpha) / 255.0F;
      const auto p = image.at(v, 0);
      p[0] = p[1] = p[2] = static_cast<float>(v) / 255.0F * a;
      p[3] = a;
    }
    const ByteImage bytes = to_bytes(image, Transfer::none);
    for (std::size_t v = 0; v < 256; ++v) {
      ASSERT_EQ(bytes.pixels[4 * v], v);
      ASSERT_EQ(bytes.pixels[4 * v + 3], alpha);
    }
  }
}

}  // namespace
}  // namespace lustro
