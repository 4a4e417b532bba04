#include "image/hdr.hpp"

#include "image/small_files.hpp"
#include "image/support.hpp"
#include "shared_dir.hpp"

namespace lustro {
namespace {

std::vector<std::byte> hdr(const std::string& size, const std::vector<int>& data, const std::string& head = "FORMAT=32-bit_rle_rgbe\n") {
  std::vector<std::byte> bytes = bytes_of_text("#?RADIANCE\n# made by hand\n" + head + "\n" + size + "\n");
  for (const int value : data) {
    bytes.push_back(static_cast<std::byte>(value));
  }
  return bytes;
}

Image read(const std::string& size, const std::vector<int>& data) {
  const auto image = decode_hdr(hdr(size, data), "a.hdr");
  EXPECT_TRUE(image) << image.error().text();
  return image.value_or(Image());
}

TEST(Hdr, AValueIsItsMantissaTimesAPowerOfTwo) {
  const Image image = read("-Y 1 +X 4", {128, 64, 0, 129, 255, 1, 2, 128, 9, 9, 9, 0, 200, 100, 50, 148});
  EXPECT_THAT(image.pixels, testing::ElementsAre(1.0F, 0.5F, 0.0F,                              // 128 * 2^(129 - 136)
                                                 255 / 256.0F, 1 / 256.0F, 2 / 256.0F,          //
                                                 0.0F, 0.0F, 0.0F,                              // exponent 0 is black
                                                 200 * 4096.0F, 100 * 4096.0F, 50 * 4096.0F));  // 2^(148 - 136)
}

TEST(Hdr, TheSmallestAndTheLargestExponentsAreFinite) {
  const Image image = read("-Y 1 +X 2", {255, 1, 0, 1, 255, 128, 0, 255});
  EXPECT_EQ(image.pixels[0], 255 * 0x1p-135F);
  EXPECT_EQ(image.pixels[1], 0x1p-135F);
  EXPECT_EQ(image.pixels[3], 255 * 0x1p119F);
}

TEST(Hdr, NewRunsPackEachComponentByItself) {
  const Image image = read("-Y 1 +X 8", {2,   2,   0, 8,                   // eight pixels
                                         136, 128,                         // red: eight times 128
                                         4,   1,   2, 3, 4, 132, 5,        // green: 1 2 3 4, four times 5
                                         8,   8,   7, 6, 5, 4,   3, 2, 1,  // blue: as they are
                                         136, 136});
  ASSERT_EQ(image.width, 8);
  EXPECT_EQ(image.at(0, 0)[0], 128);
  EXPECT_EQ(image.at(7, 0)[0], 128);
  EXPECT_EQ(image.at(2, 0)[1], 3);
  EXPECT_EQ(image.at(7, 0)[1], 5);
  EXPECT_EQ(image.at(0, 0)[2], 8);
  EXPECT_EQ(image.at(7, 0)[2], 1);
}

TEST(Hdr, OldRunsRepeatTheLastPixel) {
  const Image image = read("-Y 2 +X 300", {10, 20, 30, 136, 1, 1, 1, 43, 1, 1, 1, 1,  // 1 + 43 + 256
                                           40, 50, 60, 136, 1, 1, 1, 44, 1, 1, 1, 0, 7, 7, 7, 136, 1, 1, 1, 254});
  EXPECT_EQ(image.at(299, 0)[1], 20);
  EXPECT_EQ(image.at(44, 1)[0], 40);
  EXPECT_EQ(image.at(45, 1)[0], 7);
  EXPECT_EQ(image.at(299, 1)[2], 7);
}

TEST(Hdr, AnyOrderOfTheAxesGivesThePictureItsPlace) {
  // the picture  1 2 3
  //              4 5 6  as its scan lines come
  const std::vector<std::pair<std::string, std::vector<int>>> orders{{"-Y 2 +X 3", {1, 2, 3, 4, 5, 6}}, {"-Y 2 -X 3", {3, 2, 1, 6, 5, 4}},
                                                                     {"+Y 2 +X 3", {4, 5, 6, 1, 2, 3}}, {"+Y 2 -X 3", {6, 5, 4, 3, 2, 1}},
                                                                     {"+X 3 -Y 2", {1, 4, 2, 5, 3, 6}}, {"+X 3 +Y 2", {4, 1, 5, 2, 6, 3}},
                                                                     {"-X 3 -Y 2", {3, 6, 2, 5, 1, 4}}, {"-X 3 +Y 2", {6, 3, 5, 2, 4, 1}}};
  for (const auto& [size, values] : orders) {
    std::vector<int> data;
    for (const int value : values) {
      data.insert(data.end(), {value, 0, 0, 136});
    }
    const Image image = read(size, data);
    ASSERT_EQ(image.width, 3) << size;
    ASSERT_EQ(image.height, 2) << size;
    for (int i = 0; i < 6; ++i) {
      EXPECT_EQ(image.at(i % 3, i / 3)[0], static_cast<float>(i + 1)) << size;
    }
  }
}

TEST(Hdr, ErrorsNameThePlaceAndWhatWasExpected) {
  const auto error = [](const std::vector<std::byte>& bytes) { return decode_hdr(bytes, "a.hdr").error(); };
  EXPECT_EQ(error(bytes_of_text("P6")).text(), "a.hdr: byte 0: is no Radiance picture: it does not begin with a line `#?RADIANCE`");
  EXPECT_EQ(error(bytes_of_text("#?RGBE\nGAMMA=1\n")).text(),
            "a.hdr: byte 15: an empty line was expected at the end of the Radiance picture's header");
  const auto xyz = error(hdr("-Y 1 +X 1", {1, 2, 3, 4}, "FORMAT=32-bit_rle_xyze\n"));
  EXPECT_EQ(xyz.kind, ErrorKind::unsupported);
  EXPECT_THAT(xyz.text(), testing::StartsWith("a.hdr: byte 26: the colours of the Radiance picture are XYZ"));
  EXPECT_THAT(error(hdr("-Y 1 +Y 1", {1, 2, 3, 4})).text(), testing::EndsWith("a size like `-Y 480 +X 640` was expected"));
  EXPECT_THAT(error(hdr("-Y 1 +X one", {1, 2, 3, 4})).text(), testing::EndsWith("a size like `-Y 480 +X 640` was expected"));
  EXPECT_EQ(error(hdr("-Y 0 +X 1", {})).kind, ErrorKind::malformed);
  EXPECT_EQ(error(hdr("-Y 16385 +X 1", {})).kind, ErrorKind::limit);
  EXPECT_THAT(error(hdr("-Y 16384 +X 16384", {1, 2, 3, 4})).text(), testing::HasSubstr("16384 scan lines take 4 bytes each or more"));
  EXPECT_THAT(error(hdr("-Y 1 +X 4", {1, 1, 1, 2, 5, 5, 5, 5})).text(),
              testing::EndsWith("scan line 0 of the Radiance picture is broken or cut"));
  EXPECT_FALSE(decode_hdr(hdr("-Y 1 +X 8", {2, 2, 0, 9, 136, 1, 136, 1, 136, 1, 136, 1}), "a"));  // a line of 9 in a picture of 8
  EXPECT_FALSE(decode_hdr(hdr("-Y 1 +X 8", {2, 2, 0, 8, 137, 1, 136, 1, 136, 1, 136, 1}), "a"));  // a run of 9
  EXPECT_FALSE(decode_hdr(hdr("-Y 1 +X 8", {2, 2, 0, 8, 0, 1, 136, 1, 136, 1, 136, 1}), "a"));    // a stretch of none
  EXPECT_FALSE(decode_hdr(hdr("-Y 1 +X 2", {5, 5, 5, 5, 1, 1, 1, 2}), "a"));                      // an old run of 2 where 1 is left
}

TEST(Hdr, EveryPrefixIsAnError) {
  for (const auto& bytes : {hdr("-Y 1 +X 8", {2, 2, 0, 8, 136, 1, 136, 1, 136, 1, 136, 1}), hdr("-Y 1 +X 4", {5, 5, 5, 5, 1, 1, 1, 3})}) {
    ASSERT_TRUE(decode_hdr(bytes, "a"));
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      EXPECT_FALSE(decode_hdr(std::span(bytes).first(length), "a")) << length;
    }
  }
}

}  // namespace
}  // namespace lustro
