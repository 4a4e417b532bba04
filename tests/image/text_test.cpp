#include "image/text.hpp"

#include <array>
#include <string>

#include "image/support.hpp"
#include "image/utf8.hpp"

namespace lustro {
namespace {

int width_of(std::string_view text, int size = 32) {
  const auto extent = measure_text(text, size);
  EXPECT_TRUE(extent) << (extent ? "" : extent.error().text());
  return extent ? extent->width : -1;
}

/// Coverage of white text on a black, clear picture, as its alpha.
Image drawn(std::string_view text, int x, int y, int size, int width = 200, int height = 60) {
  Image image(width, height, 4);
  EXPECT_TRUE(draw_text(image, text, x, y, size, {1, 1, 1}));
  return image;
}

double ink(const Image& image) {
  double sum = 0;
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
    sum += static_cast<double>(image.pixels[i]);
  }
  return sum;
}

/// x0, y0, x1, y1 of what is covered at all; the end is exclusive.
std::array<int, 4> bounds(const Image& image) {
  std::array<int, 4> box{image.width, image.height, 0, 0};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (image.at(x, y)[3] > 0) {
        box = {std::min(box[0], x), std::min(box[1], y), std::max(box[2], x + 1), std::max(box[3], y + 1)};
      }
    }
  }
  return box;
}

TEST(Text, TheWidthIsTheSumOfTheFontsAdvances) {
  // DejaVu Sans: em 2048; M 1767, i 569, space 651 units
  EXPECT_EQ(width_of("M", 2048 / 4), (1767 + 3) / 4);
  EXPECT_EQ(width_of("i", 512), (569 + 3) / 4);
  EXPECT_EQ(width_of("MiM", 512), (1767 + 569 + 1767 + 3) / 4);
  EXPECT_EQ(width_of(" ", 512), (651 + 3) / 4);
  EXPECT_EQ(width_of(""), 0);
}

TEST(Text, TheWidthGrowsWithTheTextAndTheSize) {
  int before = 0;
  for (const char* text : {"p", "po", "pol", "poli", "polis", "polished", "polished gold"}) {
    EXPECT_GT(width_of(text), before);
    before = width_of(text);
  }
  EXPECT_NEAR(width_of("polished gold", 64), 2 * width_of("polished gold", 32), 2);
}

TEST(Text, PairsAreKerned) {
  EXPECT_LT(width_of("AV", 100), width_of("A", 100) + width_of("V", 100) - 2);
  EXPECT_NEAR(width_of("HH", 100), 2 * width_of("H", 100), 1);
}

TEST(Text, ALetterStandsOnItsBaseline) {
  // H of DejaVu Sans is 1493 units high and stands from 201 to 1339
  const Image image = drawn("H", 20, 50, 40);
  const auto [x0, y0, x1, y1] = bounds(image);
  EXPECT_EQ(y1, 50);
  EXPECT_NEAR(y0, 50 - 1493 * 40 / 2048.0, 1);
  EXPECT_NEAR(x0, 20 + 201 * 40 / 2048.0, 1);
  EXPECT_NEAR(x1, 20 + 1339 * 40 / 2048.0, 1);
  EXPECT_GT(bounds(drawn("g", 20, 40, 40))[3], 45);  // below the baseline
}

TEST(Text, StaysWithinItsExtent) {
  const auto extent = *measure_text("Angular qfjy", 24);
  const auto [x0, y0, x1, y1] = bounds(drawn("Angular qfjy", 10, 35, 24));
  EXPECT_GE(x0, 9);
  EXPECT_LE(x1, 10 + extent.width + 1);
  EXPECT_GE(y0, 35 - extent.ascent);
  EXPECT_LE(y1, 35 + extent.descent);
}

TEST(Text, TheInkOfALetterDoesNotDependOnWhereItStands) {
  const double one = ink(drawn("e", 10, 40, 30));
  EXPECT_GT(one, 50);
  EXPECT_NEAR(ink(drawn("e", 90, 33, 30)), one, 1e-6);
  EXPECT_NEAR(ink(drawn("eee", 10, 40, 30)), 3 * one, 3);  // also between pixels
}

TEST(Text, IsBlendedOverWhatIsThere) {
  Image opaque(40, 40, 3);
  std::ranges::fill(opaque.pixels, 1.0F);
  ASSERT_TRUE(draw_text(opaque, "\xE2\x96\x88", 0, 30, 32, {0.5F, 0.25F, 0}));  // a full block
  EXPECT_NEAR(opaque.at(10, 20)[0], 0.5F, 1e-6);
  EXPECT_NEAR(opaque.at(10, 20)[1], 0.25F, 1e-6);
  EXPECT_NEAR(opaque.at(10, 20)[2], 0.0F, 1e-6);
  EXPECT_EQ(opaque.at(39, 39)[1], 1.0F);
  Image half(40, 40, 4);
  std::ranges::fill(half.pixels, 0.5F);  // half-covered white
  ASSERT_TRUE(draw_text(half, "H", 5, 30, 32, {0, 0, 0}));
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      const auto p = half.at(x, y);
      ASSERT_NEAR(p[0] + (p[3] - 0.5F) * 2 * 0.5F, 0.5F, 1e-5F);  // c: 0.5 (1 - k), alpha: 0.5 + 0.5 k
    }
  }
}

TEST(Text, WhatLiesOutsideIsCutOff) {
  for (const auto& [x, y] : {std::pair{-20, 20}, std::pair{190, 20}, std::pair{50, -1000}, std::pair{50, 5}, std::pair{2000000000, 20},
                             std::pair{-2000000000, -2000000000}}) {
    drawn("cut off everywhere", x, y, 40);
  }
  EXPECT_EQ(ink(drawn("far", 500, 20, 30)), 0);
  EXPECT_LT(ink(drawn("H", -10, 40, 40)), ink(drawn("H", 10, 40, 40)));
}

TEST(Text, EveryStringIsDrawn) {
  EXPECT_GT(width_of("gr\xC3\xBC\xC3\x9F"
                     "e"),
            width_of("grue"));
  EXPECT_GT(ink(drawn("\xC3\x84\xC3\x96\xC3\x9C", 10, 40, 30)), ink(drawn("AOU", 10, 40, 30)));  // dots cost ink
  EXPECT_GT(ink(drawn("\xF3\xB0\x80\x80", 10, 40, 30)), 0);                                      // a private code point: the empty box
  EXPECT_GT(ink(drawn("\xFF\xFE", 10, 40, 30)), 0);                                              // no UTF-8: the replacement sign
  EXPECT_EQ(ink(drawn("\t\n\r\x01", 10, 40, 30)), 0);
  EXPECT_EQ(width_of("\n"), width_of(" "));
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    std::string text(random() % 20, ' ');
    std::ranges::generate(text, [&] { return static_cast<char>(random() & 0xFF); });
    EXPECT_GE(width_of(text, 12), 0);
    drawn(text, 5, 30, 12);
  }
}

TEST(Text, SizesAndImagesOutOfRangeAreRefused) {
  Image gray(4, 4, 1);
  Image rgb(4, 4, 3);
  EXPECT_EQ(measure_text("a", 0).error().kind, ErrorKind::usage);
  EXPECT_EQ(measure_text("a", 1001).error().text(), "a text size of 1001 pixels is outside 1..1000");
  EXPECT_EQ(draw_text(rgb, "a", 0, 0, -1, {}).error().kind, ErrorKind::usage);
  EXPECT_EQ(draw_text(gray, "a", 0, 0, 12, {}).error().text(), "text is drawn on 3 or 4 channels, not on 1");
}

std::u32string decoded(std::string_view text) {
  std::u32string codes;
  while (!text.empty()) {
    codes += next_code_point(text);
  }
  return codes;
}

TEST(Utf8, WellFormedTextIsItsCodePoints) {
  EXPECT_EQ(decoded("a\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80z"), U"a\u00e9\u20ac\U0001F600z");
  EXPECT_EQ(decoded(std::string_view("\0\x7F", 2)), std::u32string(U"\0\x7F", 2));
  EXPECT_EQ(decoded("\xC2\x80\xDF\xBF\xE0\xA0\x80\xEF\xBF\xBF\xF0\x90\x80\x80\xF4\x8F\xBF\xBF"),
            U"\u0080\u07FF\u0800\uFFFF\U00010000\U0010FFFF");
}

TEST(Utf8, EveryOtherByteIsReplaced) {
  EXPECT_EQ(decoded("\x80"), U"\uFFFD");
  EXPECT_EQ(decoded("\xC3"), U"\uFFFD");
  EXPECT_EQ(decoded("\xC3x"), U"\uFFFDx");
  EXPECT_EQ(decoded("\xC0\xAF"), U"\uFFFD\uFFFD");            // overlong
  EXPECT_EQ(decoded("\xE0\x9F\xBF"), U"\uFFFD\uFFFD\uFFFD");  // overlong
  EXPECT_EQ(decoded("\xED\xA0\x80"), U"\uFFFD\uFFFD\uFFFD");  // a surrogate
  EXPECT_EQ(decoded("\xF4\x90\x80\x80").size(), 4U);          // above U+10FFFF
  EXPECT_EQ(decoded("\xF8\x88\x80\x80\x80").size(), 5U);
  EXPECT_EQ(decoded("\xFF"), U"\uFFFD");
}

}  // namespace
}  // namespace lustro
