#include "image/webp.hpp"

#include "image/decode_texture.hpp"
#include "image/small_files.hpp"
#include "image/support.hpp"

namespace lustro {
namespace {

#ifdef LUSTRO_HAS_WEBP

TEST(Webp, LosslessFilesHaveEveryByte) {
  const auto image = decode_webp(from_hex(kWebpLossless), "a.webp");
  ASSERT_TRUE(image) << image.error().text();
  std::vector<std::uint8_t> expected;
  constexpr int kAlpha[] = {255, 128, 0, 1};
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) {
      for (const int value : {80 * x, 120 * y, 255 - 60 * x, kAlpha[x]}) {
        expected.push_back(static_cast<std::uint8_t>(value));
      }
    }
  }
  EXPECT_EQ(image->width, 4);
  EXPECT_EQ(image->height, 3);
  EXPECT_EQ(image->channels, 4);
  EXPECT_EQ(image->pixels, expected);
}

TEST(Webp, LossyFilesAreNearTheirPicture) {
  const auto image = decode_webp(from_hex(kWebpLossy), "a.webp");
  ASSERT_TRUE(image) << image.error().text();
  ASSERT_EQ(image->channels, 3);
  const auto expect_near = [&](std::size_t x, std::size_t y, std::vector<int> rgb) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(image->pixels[(y * 16 + x) * 3 + c], rgb[c], 12) << x << " " << y << " " << c;
    }
  };
  expect_near(2, 2, {255, 0, 0});
  expect_near(13, 2, {0, 128, 0});
  expect_near(2, 13, {0, 0, 255});
  expect_near(13, 13, {200, 200, 40});
}

TEST(Webp, LossyColoursMayHaveAnExactAlpha) {
  const auto image = decode_webp(from_hex(kWebpLossyAlpha), "a.webp");
  ASSERT_TRUE(image) << image.error().text();
  ASSERT_EQ(image->channels, 4);
  for (std::size_t i = 0; i < 256; ++i) {
    EXPECT_EQ(image->pixels[4 * i + 3], i % 16 < 8 ? 255 : 64);
    EXPECT_NEAR(image->pixels[4 * i], 255, 6);
  }
}

TEST(Webp, AnimationsAreNotRead) {
  const auto image = decode_webp(from_hex(kWebpAnimation), "a.webp");
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().kind, ErrorKind::unsupported);
  EXPECT_EQ(image.error().text(), "a.webp: is an animated WebP file, and a single picture was expected");
}

TEST(Webp, EveryPrefixIsAnError) {
  for (const std::string_view hex : {kWebpLossless, kWebpLossy, kWebpLossyAlpha}) {
    const auto bytes = from_hex(hex);
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      const auto image = decode_webp(std::span(bytes).first(length), "a.webp");
      ASSERT_FALSE(image) << length;
      EXPECT_EQ(image.error().kind, ErrorKind::malformed);
    }
  }
}

TEST(Webp, EveryBrokenByteGivesAPictureOrAnError) {
  auto bytes = from_hex(kWebpLossyAlpha);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::byte sound = bytes[i];
    for (const unsigned flip : {0x01U, 0x80U, 0xFFU}) {
      bytes[i] = sound ^ static_cast<std::byte>(flip);
      const auto image = decode_webp(bytes, "a.webp", {.pixels = 1 << 16});
      EXPECT_TRUE(image || !image.error().message.empty());
    }
    bytes[i] = sound;
  }
}

TEST(Webp, SizesAreCheckedBeforeMemoryIsTaken) {
  EXPECT_EQ(decode_webp(from_hex(kWebpLossy), "a.webp", {.side = 15}).error().kind, ErrorKind::limit);
  EXPECT_EQ(decode_webp(from_hex(kWebpLossy), "a.webp", {.pixels = 255}).error().kind, ErrorKind::limit);
}

#else

TEST(Webp, ABuildWithoutTheLibraryNamesWhatToInstall) {
  const auto image = decode_webp(from_hex(kWebpLossy), "a.webp");
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().kind, ErrorKind::unsupported);
  EXPECT_THAT(image.error().message, testing::HasSubstr("libwebp-dev"));
}

#endif

}  // namespace
}  // namespace lustro
