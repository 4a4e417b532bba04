#include "image/tga.hpp"

#include "image/small_files.hpp"
#include "image/support.hpp"

namespace lustro {
namespace {

using Bytes = std::vector<int>;

struct Header {
  int type = 2;
  int width = 2, height = 2;
  int bits = 24;
  int descriptor = 0x20;  // from the top left, no alpha
  int palette_first = 0, palette_length = 0, palette_bits = 0;
  int id = 0;
};

std::vector<std::byte> tga(const Header& h, const Bytes& data) {
  Bytes all{h.id,
            h.palette_length > 0 ? 1 : 0,
            h.type,
            h.palette_first & 255,
            h.palette_first >> 8,
            h.palette_length & 255,
            h.palette_length >> 8,
            h.palette_bits,
            0,
            0,
            0,
            0,
            h.width & 255,
            h.width >> 8,
            h.height & 255,
            h.height >> 8,
            h.bits,
            h.descriptor};
  all.insert(all.end(), data.begin(), data.end());
  std::vector<std::byte> bytes;
  for (const int value : all) {
    bytes.push_back(static_cast<std::byte>(value));
  }
  return bytes;
}

/// With TGA 2.0's extension area, which holds the attributes type, and its footer.
std::vector<std::byte> with_attributes(std::vector<std::byte> bytes, int type) {
  const std::size_t area = bytes.size();
  bytes.resize(area + 495);
  bytes[area + 494] = static_cast<std::byte>(type);
  for (std::size_t i = 0; i < 4; ++i) {
    bytes.push_back(static_cast<std::byte>((area >> (8 * i)) & 255));
  }
  bytes.resize(bytes.size() + 4);
  const auto signature = bytes_of_text(std::string("TRUEVISION-XFILE.\0", 18));
  bytes.insert(bytes.end(), signature.begin(), signature.end());
  return bytes;
}

ByteImage read(const std::vector<std::byte>& bytes) {
  const auto image = decode_tga(bytes, "a.tga");
  EXPECT_TRUE(image) << image.error().text();
  return image.value_or(ByteImage());
}

constexpr auto is = [](auto... values) { return testing::ElementsAre(values...); };

TEST(Tga, ColoursOf24BitsAreBlueGreenRed) {
  const ByteImage image = read(tga({}, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(image.channels, 3);
  EXPECT_THAT(image.pixels, is(3, 2, 1, 6, 5, 4, 9, 8, 7, 12, 11, 10));
}

TEST(Tga, ThePictureMayBeginInAnyCorner) {
  const Bytes data{1, 2, 3, 4, 5, 6};  // gray, 3 x 2
  EXPECT_THAT(read(tga({.type = 3, .width = 3, .bits = 8, .descriptor = 0x20}, data)).pixels, is(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(read(tga({.type = 3, .width = 3, .bits = 8, .descriptor = 0x00}, data)).pixels, is(4, 5, 6, 1, 2, 3));
  EXPECT_THAT(read(tga({.type = 3, .width = 3, .bits = 8, .descriptor = 0x30}, data)).pixels, is(3, 2, 1, 6, 5, 4));
  EXPECT_THAT(read(tga({.type = 3, .width = 3, .bits = 8, .descriptor = 0x10}, data)).pixels, is(6, 5, 4, 3, 2, 1));
}

TEST(Tga, FifteenAndSixteenBitsHaveFiveBitsAColour) {
  // 0xFC00: alpha, red 31; 0x03E0: green 31; 0x0010: blue 16, which is 131.6 of 255; 0x8421: ones
  const Bytes data{0x00, 0xFC, 0xE0, 0x03, 0x10, 0x00, 0x21, 0x84};
  EXPECT_THAT(read(tga({.bits = 15}, data)).pixels, is(255, 0, 0, 0, 255, 0, 0, 0, 132, 8, 8, 8));
  EXPECT_THAT(read(tga({.bits = 16}, data)).pixels, is(255, 0, 0, 0, 255, 0, 0, 0, 132, 8, 8, 8));
  const ByteImage alpha = read(tga({.bits = 16, .descriptor = 0x21}, data));
  EXPECT_EQ(alpha.channels, 4);
  EXPECT_THAT(alpha.pixels, is(255, 0, 0, 255, 0, 255, 0, 0, 0, 0, 132, 0, 8, 8, 8, 255));
}

TEST(Tga, AlphaOf32BitsStands) {
  const ByteImage image = read(tga({.height = 1, .bits = 32, .descriptor = 0x28}, {1, 2, 3, 4, 5, 6, 7, 0}));
  EXPECT_THAT(image.pixels, is(3, 2, 1, 4, 7, 6, 5, 0));
  EXPECT_EQ(read(tga({.height = 1, .bits = 32, .descriptor = 0x20}, {1, 2, 3, 4, 5, 6, 7, 0})).pixels, image.pixels);
}

TEST(Tga, AlphaThatIsZeroEverywhereIsNone) {
  const ByteImage image = read(tga({.height = 1, .bits = 32}, {1, 2, 3, 0, 5, 6, 7, 0}));
  EXPECT_EQ(image.channels, 3);
  EXPECT_THAT(image.pixels, is(3, 2, 1, 7, 6, 5));
}

TEST(Tga, TheExtensionAreaSaysWhatAlphaMeans) {
  const auto bytes = tga({.height = 1, .bits = 32}, {100, 50, 0, 100, 255, 128, 0, 255});
  for (const int undefined : {0, 1, 2}) {
    EXPECT_THAT(read(with_attributes(bytes, undefined)).pixels, is(0, 50, 100, 0, 128, 255)) << undefined;
  }
  EXPECT_THAT(read(with_attributes(bytes, 3)).pixels, is(0, 50, 100, 100, 0, 128, 255, 255));
  EXPECT_THAT(read(with_attributes(bytes, 4)).pixels, is(0, 128, 255, 100, 0, 128, 255, 255));  // 50 and 100 over an alpha of 100
}

TEST(Tga, PalettesBecomeColours) {
  const Bytes palette{10, 20, 30, 40, 50, 60, 70, 80, 90};
  Bytes data = palette;
  data.insert(data.end(), {2, 0, 1, 1});
  EXPECT_THAT(read(tga({.type = 1, .bits = 8, .palette_length = 3, .palette_bits = 24}, data)).pixels,
              is(90, 80, 70, 30, 20, 10, 60, 50, 40, 60, 50, 40));
  Bytes wide = palette;
  wide.insert(wide.end(), {7, 0, 5, 0, 6, 0, 6, 0});  // indices of 16 bits into a map whose first entry is 5
  EXPECT_THAT(read(tga({.type = 1, .bits = 16, .palette_first = 5, .palette_length = 3, .palette_bits = 24}, wide)).pixels,
              is(90, 80, 70, 30, 20, 10, 60, 50, 40, 60, 50, 40));
  EXPECT_THAT(read(tga({.type = 1, .height = 1, .bits = 8, .palette_length = 2, .palette_bits = 16}, {0x00, 0x7C, 0x1F, 0, 1, 0})).pixels,
              is(0, 0, 255, 255, 0, 0));
  EXPECT_THAT(read(tga({.type = 1, .height = 1, .bits = 8, .palette_length = 2, .palette_bits = 32}, {1, 2, 3, 4, 5, 6, 7, 8, 1, 0})).pixels,
              is(7, 6, 5, 8, 3, 2, 1, 4));
  const auto outside = decode_tga(tga({.type = 1, .bits = 8, .palette_length = 1, .palette_bits = 24}, {1, 2, 3, 0, 0, 0, 1}), "a.tga");
  ASSERT_FALSE(outside);
  EXPECT_EQ(outside.error().text(), "a.tga: pixel 3 of the TGA file has colour 1 of a map with 1 from 0 on");
}

TEST(Tga, GrayMayHaveAlpha) {
  const ByteImage image = read(tga({.type = 3, .height = 1, .bits = 16, .descriptor = 0x28}, {9, 255, 8, 0}));
  EXPECT_EQ(image.channels, 2);
  EXPECT_THAT(image.pixels, is(9, 255, 8, 0));
}

TEST(Tga, TheNameOfThePictureIsSteppedOver) {
  EXPECT_THAT(read(tga({.type = 3, .height = 1, .bits = 8, .id = 3}, {'a', 'b', 'c', 4, 5})).pixels, is(4, 5));
  EXPECT_THAT(read(tga({.type = 3, .height = 1, .bits = 8, .palette_length = 1, .palette_bits = 24, .id = 1}, {'a', 1, 2, 3, 4, 5})).pixels,
              is(4, 5));  // and a map that is not used
}

TEST(Tga, PacketsAreRunsAndStretchesAndMayCrossRows) {
  // a run of 3, then 1, 2, 3
  EXPECT_THAT(read(tga({.type = 11, .width = 2, .height = 3, .bits = 8}, {0x82, 7, 0x02, 1, 2, 3})).pixels, is(7, 7, 7, 1, 2, 3));
  EXPECT_THAT(read(tga({.type = 10, .height = 1}, {0x81, 1, 2, 3})).pixels, is(3, 2, 1, 3, 2, 1));
  EXPECT_THAT(read(tga({.type = 9, .height = 1, .bits = 8, .palette_length = 2, .palette_bits = 24}, {1, 2, 3, 4, 5, 6, 0x01, 1, 0})).pixels,
              is(6, 5, 4, 3, 2, 1));
  const auto long_run = decode_tga(tga({.type = 11, .bits = 8}, {0x84, 7}), "a.tga");
  ASSERT_FALSE(long_run);
  EXPECT_EQ(long_run.error().text(), "a.tga: byte 18: a packet of 5 pixels, where the TGA file's picture has 4 left");
}

TEST(Tga, EveryPrefixIsAnError) {
  for (const auto& bytes : {tga({}, Bytes(12, 9)), tga({.type = 11, .bits = 8}, {0x81, 7, 0x01, 1, 2}),
                            tga({.type = 1, .bits = 8, .palette_length = 3, .palette_bits = 24, .id = 2}, Bytes(15, 0))}) {
    ASSERT_TRUE(decode_tga(bytes, "a.tga"));
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      const auto image = decode_tga(std::span(bytes).first(length), "a.tga");
      ASSERT_FALSE(image) << length;
      EXPECT_EQ(image.error().where, "a.tga: byte " + std::to_string(length));
    }
  }
}

TEST(Tga, HeadersThatCannotBeAreRefusedBeforeMemoryIsTaken) {
  const auto kind = [](const Header& header) { return decode_tga(tga(header, Bytes(64, 0)), "a.tga").error().kind; };
  EXPECT_EQ(kind({.type = 0}), ErrorKind::malformed);
  EXPECT_EQ(kind({.type = 8}), ErrorKind::malformed);
  EXPECT_EQ(kind({.type = 12}), ErrorKind::malformed);
  EXPECT_EQ(kind({.type = 32}), ErrorKind::malformed);
  EXPECT_EQ(kind({.type = 1, .bits = 8}), ErrorKind::malformed);  // no palette
  EXPECT_EQ(kind({.bits = 8}), ErrorKind::malformed);
  EXPECT_EQ(kind({.bits = 40}), ErrorKind::malformed);
  EXPECT_EQ(kind({.width = 0}), ErrorKind::malformed);
  EXPECT_EQ(kind({.width = 65535}), ErrorKind::limit);
  EXPECT_EQ(kind({.descriptor = 0x60}), ErrorKind::unsupported);
  EXPECT_EQ(kind({.width = 16384, .height = 16384}), ErrorKind::malformed);
  EXPECT_EQ(kind({.type = 10, .width = 16384, .height = 16384}), ErrorKind::malformed);
  EXPECT_EQ(decode_tga(tga({.type = 10, .width = 16384, .height = 16384}, {}), "a.tga").error().text(),
            "a.tga: byte 18: the TGA file ends here, and its pixels take 8388608 bytes or more");
}

}  // namespace
}  // namespace lustro
