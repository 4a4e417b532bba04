#include "image/jpeg.hpp"

#include "image/decode_texture.hpp"
#include "image/small_files.hpp"
#include "image/support.hpp"

namespace lustro {
namespace {

#ifdef LUSTRO_HAS_JPEG

using Bytes = std::vector<int>;

Bytes pixel(const ByteImage& image, int x, int y) {
  const auto step = static_cast<std::size_t>(image.channels);
  const std::size_t at = (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) * step;
  return {image.pixels.begin() + static_cast<std::ptrdiff_t>(at), image.pixels.begin() + static_cast<std::ptrdiff_t>(at + step)};
}

void expect_near(const ByteImage& image, int x, int y, const Bytes& expected, int tolerance) {
  const Bytes found = pixel(image, x, y);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t c = 0; c < found.size(); ++c) {
    EXPECT_NEAR(found[c], expected[c], tolerance) << "(" << x << ", " << y << ")[" << c << "]";
  }
}

ByteImage read(std::string_view hex) {
  const auto image = decode_jpeg(from_hex(hex), "a.jpg");
  EXPECT_TRUE(image) << image.error().text();
  return image.value_or(ByteImage());
}

/// The length of a segment's data is stated behind its marker, FF `marker`.
std::size_t find_marker(const std::vector<std::byte>& bytes, unsigned marker) {
  for (std::size_t i = 0; i + 1 < bytes.size(); ++i) {
    if (bytes[i] == std::byte{0xFF} && bytes[i + 1] == static_cast<std::byte>(marker)) {
      return i;
    }
  }
  return bytes.size();
}

TEST(Jpeg, QuartersOfOneColourEachComeBackWithinTheQuantization) {
  const ByteImage image = read(kJpegBaseline);
  ASSERT_EQ(image.width, 16);
  ASSERT_EQ(image.height, 16);
  ASSERT_EQ(image.channels, 3);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      expect_near(image, x, y, {255, 0, 0}, 3);
      expect_near(image, x + 8, y, {0, 128, 0}, 3);
      expect_near(image, x, y + 8, {0, 0, 255}, 3);
      expect_near(image, x + 8, y + 8, {200, 200, 40}, 3);
    }
  }
}

TEST(Jpeg, ProgressiveFilesHoldTheSamePicture) {  // the same coefficients in another order
  EXPECT_EQ(read(kJpegProgressive).pixels, read(kJpegBaseline).pixels);
}

TEST(Jpeg, ColoursOfHalfTheResolutionAreInterpolated) {
  const ByteImage image = read(kJpegHalfColor);
  ASSERT_EQ(image.width, 32);
  expect_near(image, 4, 4, {255, 0, 0}, 4);
  expect_near(image, 27, 4, {0, 128, 0}, 4);
  expect_near(image, 4, 27, {0, 0, 255}, 4);
  expect_near(image, 27, 27, {200, 200, 40}, 4);
}

TEST(Jpeg, GrayHasOneChannel) {
  const ByteImage image = read(kJpegGray);
  ASSERT_EQ(image.channels, 1);
  expect_near(image, 3, 3, {40}, 1);
  expect_near(image, 12, 3, {220}, 1);
}

TEST(Jpeg, TheOrientationOfCamerasIsNotApplied) {
  const ByteImage turned = read(kJpegTurned);
  EXPECT_EQ(turned.width, 16);
  EXPECT_EQ(turned.height, 8);
  EXPECT_EQ(turned.pixels, read(kJpegGray).pixels);
}

TEST(Jpeg, InksBecomeTheLightThatTheyLetThrough) {
  const ByteImage image = read(kJpegInks);
  ASSERT_EQ(image.channels, 3);
  expect_near(image, 3, 3, {255, 0, 0}, 3);
  expect_near(image, 12, 3, {0, 153, 153}, 3);  // 255 - 102 of the black ink
  auto bytes = from_hex(kJpegInks);             // without Adobe's marker the numbers are inks and not their complements
  const std::size_t marker = find_marker(bytes, 0xEE);
  ASSERT_LT(marker, bytes.size());
  bytes[marker + 1] = std::byte{0xED};
  const auto plain = decode_jpeg(bytes, "a.jpg");
  ASSERT_TRUE(plain);
  expect_near(*plain, 3, 3, {0, 0, 0}, 3);
  expect_near(*plain, 12, 3, {102, 0, 0}, 3);  // magenta, yellow, and 153 of black
}

TEST(Jpeg, EveryPrefixIsAnError) {
  for (const std::string_view hex : {kJpegBaseline, kJpegProgressive, kJpegGray, kJpegInks}) {
    const auto bytes = from_hex(hex);
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      const auto image = decode_jpeg(std::span(bytes).first(length), "a.jpg");
      ASSERT_FALSE(image) << length;
      EXPECT_EQ(image.error().kind, ErrorKind::malformed) << image.error().text();
      EXPECT_EQ(image.error().where, "a.jpg");
    }
  }
}

TEST(Jpeg, EveryBrokenByteGivesAPictureOrAnError) {
  for (const std::string_view hex : {kJpegProgressive, kJpegInks}) {
    auto bytes = from_hex(hex);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      const std::byte sound = bytes[i];
      for (const unsigned flip : {0x01U, 0x80U, 0xFFU}) {
        bytes[i] = sound ^ static_cast<std::byte>(flip);
        const auto image = decode_jpeg(bytes, "a.jpg", {.pixels = 1 << 16});
        EXPECT_TRUE(image || !image.error().message.empty());
      }
      bytes[i] = sound;
    }
  }
}

TEST(Jpeg, SizesAreCheckedBeforeMemoryIsTaken) {
  auto bytes = from_hex(kJpegBaseline);
  const std::size_t frame = find_marker(bytes, 0xC0);
  ASSERT_LT(frame, bytes.size());
  for (std::size_t i = 5; i < 9; ++i) {  // height and width
    bytes[frame + i] = std::byte{0xFF};
  }
  EXPECT_EQ(decode_jpeg(bytes, "a.jpg").error().kind, ErrorKind::limit);  // libjpeg's own
  bytes[frame + 5] = bytes[frame + 7] = std::byte{0x40};
  const auto huge = decode_jpeg(bytes, "a.jpg");
  ASSERT_FALSE(huge);
  EXPECT_EQ(huge.error().kind, ErrorKind::limit);
  EXPECT_EQ(huge.error().text(), "a.jpg: states a size of 16639 x 16639 pixels; at most 16384 x 16384 are read");
  bytes[frame + 5] = bytes[frame + 7] = std::byte{0x3F};  // 16383 x 16383
  const auto hollow = decode_jpeg(bytes, "a.jpg");
  ASSERT_FALSE(hollow);
  EXPECT_EQ(hollow.error().kind, ErrorKind::malformed);
  EXPECT_THAT(hollow.error().message, testing::HasSubstr("16383 x 16383 pixels, which a file of"));
  EXPECT_EQ(decode_jpeg(from_hex(kJpegBaseline), "a.jpg", {.side = 15}).error().kind, ErrorKind::limit);
}

TEST(Jpeg, SamplesOfTwelveBitsAreNotRead) {
  auto bytes = from_hex(kJpegBaseline);
  bytes[find_marker(bytes, 0xC0) + 4] = std::byte{12};
  EXPECT_EQ(decode_jpeg(bytes, "a.jpg").error().kind, ErrorKind::unsupported);
}

TEST(Jpeg, BytesBetweenSegmentsAreSteppedOver) {  // as some cameras write them
  auto bytes = from_hex(kJpegBaseline);
  const ByteImage sound = read(kJpegBaseline);
  bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(find_marker(bytes, 0xC0)), {std::byte{0}, std::byte{7}});
  const auto image = decode_jpeg(bytes, "a.jpg");
  ASSERT_TRUE(image) << image.error().text();
  EXPECT_EQ(image->pixels, sound.pixels);
}

#else

TEST(Jpeg, ABuildWithoutTheLibraryNamesWhatToInstall) {
  const auto image = decode_jpeg(from_hex(kJpegGray), "a.jpg");
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().kind, ErrorKind::unsupported);
  EXPECT_THAT(image.error().message, testing::HasSubstr("libjpeg62-turbo-dev"));
}

#endif

}  // namespace
}  // namespace lustro
