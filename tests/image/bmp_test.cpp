#include "image/bmp.hpp"

#include "image/small_files.hpp"
#include "image/support.hpp"

namespace lustro {
namespace {

using Bytes = std::vector<int>;

struct Header {
  int width = 2, height = 2;
  int bits = 24;
  std::uint32_t compression = 0;
  int size = 40;  // of the header itself
  std::vector<std::uint32_t> masks{};
  Bytes palette{};  // blue, green, red, 0 each; without the 0 in the header of 12 bytes
  int stated_colors = 0;
};

std::vector<std::byte> bmp(const Header& h, const Bytes& pixels) {
  Bytes all;
  const auto put = [&](std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) {
      all.push_back(static_cast<int>((value >> (8 * i)) & 255));
    }
  };
  const bool are_masks_outside = h.size == 40;
  const auto begin = static_cast<std::uint32_t>(14 + h.size + (are_masks_outside ? 4 * static_cast<int>(h.masks.size()) : 0) +
                                                static_cast<int>(h.palette.size()));
  put('B' + 256 * 'M', 2);
  put(begin + static_cast<std::uint32_t>(pixels.size()), 4);
  put(0, 4);
  put(begin, 4);
  put(static_cast<std::uint32_t>(h.size), 4);
  const int word = h.size == 12 ? 2 : 4;
  put(static_cast<std::uint32_t>(h.width), word);
  put(static_cast<std::uint32_t>(h.height), word);
  put(1, 2);
  put(static_cast<std::uint32_t>(h.bits), 2);
  if (h.size > 12) {
    put(h.compression, 4);
    put(0, 12);
    put(static_cast<std::uint32_t>(h.stated_colors), 4);
    put(0, 4);
    for (const std::uint32_t mask : h.masks) {
      put(mask, 4);
    }
    while (static_cast<int>(all.size()) < 14 + h.size) {
      all.push_back(0);
    }
  }
  all.insert(all.end(), h.palette.begin(), h.palette.end());
  all.insert(all.end(), pixels.begin(), pixels.end());
  std::vector<std::byte> bytes;
  for (const int value : all) {
    bytes.push_back(static_cast<std::byte>(value));
  }
  return bytes;
}

ByteImage read(const std::vector<std::byte>& bytes) {
  const auto image = decode_bmp(bytes, "a.bmp");
  EXPECT_TRUE(image) << image.error().text();
  return image.value_or(ByteImage());
}

constexpr auto is = [](auto... values) { return testing::ElementsAre(values...); };

/// Gray i of 16 for index i, so that pixels name their index.
Bytes numbered_palette(int count, int entry = 4) {
  Bytes palette;
  for (int i = 0; i < count; ++i) {
    for (int c = 0; c < entry; ++c) {
      palette.push_back(c < 3 ? i : 0);
    }
  }
  return palette;
}

Bytes indices(const ByteImage& image) {
  Bytes reds;
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    reds.push_back(image.pixels[i]);
  }
  return reds;
}

TEST(Bmp, RowsOf24BitsComeFromTheBottomAndEndOnFourBytes) {
  const Bytes data{1, 2, 3, 4, 5, 6, 0, 0, 7, 8, 9, 10, 11, 12, 0, 0};
  EXPECT_THAT(read(bmp({}, data)).pixels, is(9, 8, 7, 12, 11, 10, 3, 2, 1, 6, 5, 4));
  EXPECT_THAT(read(bmp({.height = -2}, data)).pixels, is(3, 2, 1, 6, 5, 4, 9, 8, 7, 12, 11, 10));
}

TEST(Bmp, IndicesOfOneToEightBitsLookIntoThePalette) {
  const Bytes two{0, 0, 255, 0, 255, 0, 0, 0};  // red, blue
  EXPECT_THAT(read(bmp({.width = 3, .height = 1, .bits = 1, .palette = two}, {0b01000000, 0, 0, 0})).pixels,
              is(255, 0, 0, 0, 0, 255, 255, 0, 0));
  EXPECT_EQ(indices(read(bmp({.width = 5, .height = 1, .bits = 2, .palette = numbered_palette(4)}, {0b00011011, 0b10000000, 0, 0}))),
            (Bytes{0, 1, 2, 3, 2}));
  EXPECT_EQ(indices(read(bmp({.width = 3, .height = 1, .bits = 4, .palette = numbered_palette(16)}, {0x1F, 0x30, 0, 0}))), (Bytes{1, 15, 3}));
  EXPECT_EQ(indices(read(bmp({.width = 3, .height = 1, .bits = 8, .palette = numbered_palette(9), .stated_colors = 9}, {8, 0, 3, 0}))),
            (Bytes{8, 0, 3}));
  EXPECT_EQ(indices(read(bmp({.width = 3, .height = 1, .bits = 8, .size = 12, .palette = numbered_palette(256, 3)}, {255, 0, 3, 0}))),
            (Bytes{255, 0, 3}));
  const auto outside =
      decode_bmp(bmp({.width = 1, .height = 1, .bits = 8, .palette = numbered_palette(2), .stated_colors = 2}, {2, 0, 0, 0}), "a");
  ASSERT_FALSE(outside);
  EXPECT_EQ(outside.error().text(), "a: a pixel of the bitmap has colour 2 of 2");
}

TEST(Bmp, SixteenBitsHaveFiveBitsAColourOrWhatTheMasksSay) {
  EXPECT_THAT(read(bmp({.height = 1, .bits = 16}, {0x00, 0x7C, 0xF0, 0x03})).pixels, is(255, 0, 0, 0, 255, 132));
  EXPECT_THAT(read(bmp({.height = 1, .bits = 16, .compression = 3, .masks = {0xF800, 0x7E0, 0x1F}}, {0x00, 0xF8, 0xE0, 0x07})).pixels,
              is(255, 0, 0, 0, 255, 0));
  EXPECT_THAT(
      read(bmp({.height = 1, .bits = 16, .compression = 3, .size = 56, .masks = {0xF00, 0xF0, 0xF, 0xF000}}, {0x48, 0x1F, 0x48, 0x2F})).pixels,
      is(255, 68, 136, 17, 255, 68, 136, 34));
}

TEST(Bmp, ThirtyTwoBitsHaveAnAlphaWhereAMaskStatesOne) {
  const Bytes data{1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_THAT(read(bmp({.height = 1, .bits = 32}, data)).pixels, is(3, 2, 1, 7, 6, 5));  // the fourth byte means nothing
  const std::vector<std::uint32_t> bgra{0xFF0000, 0xFF00, 0xFF, 0xFF000000};
  EXPECT_THAT(read(bmp({.height = 1, .bits = 32, .compression = 3, .size = 124, .masks = bgra}, data)).pixels, is(3, 2, 1, 4, 7, 6, 5, 8));
  EXPECT_THAT(read(bmp({.height = 1, .bits = 32, .compression = 3, .size = 108, .masks = bgra}, {1, 2, 3, 0, 5, 6, 7, 0})).pixels,
              is(3, 2, 1, 7, 6, 5));  // 0 everywhere
  EXPECT_THAT(read(bmp({.height = 1, .bits = 32, .compression = 6, .masks = {0xFF, 0xFF00, 0xFF0000, 0xFF000000}}, data)).pixels,
              is(1, 2, 3, 4, 5, 6, 7, 8));
  EXPECT_THAT(
      read(bmp({.width = 1, .height = 1, .bits = 32, .compression = 3, .masks = {0x3FF00000, 0xFFC00, 0x3FF}}, {0xFF, 0x07, 0xF0, 0x3F})).pixels,
      is(255, 0, 255));  // ten bits a colour: 1023, 1, 1023
}

TEST(Bmp, PackedIndicesOfEightBits) {
  // 3 x 1: twice 5, end of row; 1, 2, 3 as a stretch of odd length; one row left out; end
  const Bytes data{2, 5, 1, 6, 0, 0, 0, 3, 1, 2, 3, 0, 0, 0, 0, 2, 1, 0, 1, 7, 0, 1};
  const ByteImage image =
      read(bmp({.width = 3, .height = 3, .bits = 8, .compression = 1, .palette = numbered_palette(8), .stated_colors = 8}, data));
  EXPECT_EQ(indices(image), (Bytes{0, 7, 0, 1, 2, 3, 5, 5, 6}));
}

TEST(Bmp, PackedIndicesOfFourBits) {
  // 5 x 2: five of 1 and 2 in turn; a stretch 3 4 5 of odd length in two bytes, then 6 twice
  const Bytes data{5, 0x12, 0, 0, 0, 3, 0x34, 0x50, 2, 0x66, 0, 1};
  const ByteImage image = read(bmp({.width = 5, .height = 2, .bits = 4, .compression = 2, .palette = numbered_palette(16)}, data));
  EXPECT_EQ(indices(image), (Bytes{3, 4, 5, 6, 6, 1, 2, 1, 2, 1}));
}

TEST(Bmp, PackedPixelsOutsideOfThePictureAreErrors) {
  const auto text = [](const Bytes& data) {
    return decode_bmp(bmp({.bits = 8, .compression = 1, .palette = numbered_palette(2), .stated_colors = 2}, data), "a").error().text();
  };
  EXPECT_EQ(text({3, 1, 0, 1}), "a: byte 62: 3 pixels at (0, 0) lie outside of the bitmap's 2 x 2");
  EXPECT_EQ(text({0, 0, 0, 0, 1, 1, 0, 1}), "a: byte 66: 1 pixels at (0, 2) lie outside of the bitmap's 2 x 2");
  EXPECT_EQ(text({0, 2, 3, 0, 0, 1}), "a: byte 62: a move leads out of the bitmap's picture");
  EXPECT_EQ(text({2, 1, 0, 0}), "a: byte 66: the bitmap ends here, without the mark for the end of its packed pixels");
}

TEST(Bmp, EveryPrefixIsAnError) {
  for (const auto& bytes :
       {bmp({}, Bytes(16, 9)),
        bmp({.bits = 8, .compression = 1, .palette = numbered_palette(2), .stated_colors = 2}, {2, 1, 0, 3, 1, 1, 1, 0, 0, 1}),
        bmp({.height = 1, .bits = 16, .compression = 3, .masks = {0xF800, 0x7E0, 0x1F}}, {0, 0, 0, 0}),
        bmp({.width = 1, .height = 1, .bits = 8, .size = 12, .palette = numbered_palette(256, 3)}, {1, 0, 0, 0})}) {
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      EXPECT_FALSE(decode_bmp(std::span(bytes).first(length), "a")) << length;
    }
  }
}

TEST(Bmp, HeadersThatCannotBeAreRefusedBeforeMemoryIsTaken) {
  const auto kind = [](const Header& header) { return decode_bmp(bmp(header, Bytes(64, 0)), "a").error().kind; };
  EXPECT_EQ(kind({.width = 0}), ErrorKind::malformed);
  EXPECT_EQ(kind({.width = -2}), ErrorKind::malformed);
  EXPECT_EQ(kind({.height = -2147483647 - 1}), ErrorKind::limit);
  EXPECT_EQ(kind({.width = 16385}), ErrorKind::limit);
  EXPECT_EQ(kind({.width = 16384, .height = 16384}), ErrorKind::malformed);
  EXPECT_EQ(kind({.width = 16384, .height = 16384, .bits = 8, .compression = 1, .palette = numbered_palette(256)}), ErrorKind::malformed);
  EXPECT_EQ(kind({.bits = 3}), ErrorKind::malformed);
  EXPECT_EQ(kind({.bits = 24, .compression = 1}), ErrorKind::malformed);
  EXPECT_EQ(kind({.bits = 24, .compression = 3}), ErrorKind::malformed);
  EXPECT_EQ(kind({.compression = 4}), ErrorKind::unsupported);  // JPEG inside
  EXPECT_EQ(kind({.compression = 99}), ErrorKind::unsupported);
  EXPECT_EQ(kind({.bits = 1, .compression = 3, .size = 64}), ErrorKind::unsupported);  // OS/2's fax code
  EXPECT_EQ(kind({.size = 41}), ErrorKind::unsupported);
  EXPECT_EQ(kind({.bits = 16, .compression = 3, .masks = {0xF0F0, 0x0F00, 0x1F}}), ErrorKind::malformed);
  EXPECT_EQ(kind({.bits = 16, .compression = 3, .masks = {0xF800, 0xF000, 0x1F}}), ErrorKind::malformed);
  auto bytes = bmp({}, Bytes(16, 9));
  bytes[10] = std::byte{53};  // the pixels begin inside the header
  EXPECT_EQ(decode_bmp(bytes, "a").error().kind, ErrorKind::malformed);
}

}  // namespace
}  // namespace lustro
