// Values as a command line writes them.
#include "scene/text_values.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <random>

namespace lustro {
namespace {

TEST(TextValues, NumbersAreWholeFiniteAndExact) {
  EXPECT_EQ(parse_number("0.1").value(), 0.1);
  EXPECT_EQ(parse_number("-1e-3").value(), -0.001);
  for (const char* bad : {"", " 1", "1 ", "1x", "0x10", "nan", "inf", "1e999", "1,2", "--1"}) {
    EXPECT_FALSE(parse_number(bad)) << bad;
  }
  EXPECT_EQ(parse_number("abc").error().message, "found \"abc\", expected a finite number");
}

TEST(TextValues, IntegersAreWhole) {
  EXPECT_EQ(parse_int("16").value(), 16);
  EXPECT_EQ(parse_int("4.5").error().message, "found \"4.5\", expected a whole number");
  EXPECT_EQ(parse_int("99999999999").error().message, "\"99999999999\" is too large");
  EXPECT_FALSE(parse_int(""));
}

TEST(TextValues, SwitchesWithoutTextAreOn) {
  EXPECT_TRUE(parse_bool("").value());
  EXPECT_TRUE(parse_bool("on").value());
  EXPECT_FALSE(parse_bool("false").value());
  EXPECT_EQ(parse_bool("maybe").error().message, "found \"maybe\", expected true or false");
}

TEST(TextValues, VectorsHaveThreeNumbers) {
  EXPECT_EQ(parse_vector("1,-2,3.5").value(), (Vec3d{1, -2, 3.5}));
  EXPECT_EQ(parse_vector("1, 2, 3").value(), (Vec3d{1, 2, 3}));
  for (const char* bad : {"1,2", "1,2,3,4", "1,2,", ",,", "", "a,b,c"}) {
    EXPECT_FALSE(parse_vector(bad)) << bad;
  }
}

TEST(TextValues, MatricesAreRowMajor) {
  const Mat4 m = parse_matrix("1,0,0,5, 0,1,0,6, 0,0,1,7, 0,0,0,1").value();
  EXPECT_EQ(m(0, 3), 5);
  EXPECT_EQ(m(2, 3), 7);
  EXPECT_FALSE(parse_matrix("1,2,3"));
}

TEST(TextValues, HashColoursAreEncodedAndNumbersLinear) {
  EXPECT_EQ(parse_color("#ff8000").value(), (Color{{1, 128.0F / 255, 0}, ColorSpace::encoded}));
  EXPECT_EQ(parse_color("#F80").value(), parse_color("#ff8800").value());
  EXPECT_EQ(parse_color("0.5,2,0").value(), (Color{{0.5F, 2, 0}, ColorSpace::linear}));
  EXPECT_EQ(parse_color("color(srgb 0.54 0.89 0.63)").value(), (Color{{0.54F, 0.89F, 0.63F}, ColorSpace::encoded}));
  for (const char* bad : {"", "#", "#ff", "#ff00", "#ff80000", "#ggg", "red", "1,2", "1,2,3,4", "-1,0,0", "1e39,0,0", "color(srgb 1 1)",
                          "color(srgb 1 1 1", "color(srgb 1 1 1 / 1)", "color(srgb 1 1 1 1)", "color(rgb 1 1 1)", "#ff8000ff", "#+1-1 1"}) {
    EXPECT_FALSE(parse_color(bad)) << bad;
  }
  EXPECT_EQ(parse_color("red").error().message, "found \"red\", expected a colour: #rgb, #rrggbb or three numbers r,g,b");
  EXPECT_EQ(parse_color("0,-0.5,0").error().message, "-0.5 is less than 0");
}

TEST(TextValues, AFourthNumberIsAlphaWhereOneIsMeant) {
  EXPECT_EQ(parse_color_alpha("#ff800080", true)->alpha, 128.0F / 255);
  EXPECT_EQ(parse_color_alpha("#f808", true)->alpha, 136.0F / 255);
  EXPECT_EQ(parse_color_alpha("1,1,1,0.25", true)->alpha, 0.25F);
  EXPECT_EQ(parse_color_alpha("color(srgb 0.1 0.2 0.3 / 0.4)", true)->alpha, 0.4F);
  EXPECT_EQ(parse_color_alpha("#fff", true)->alpha, std::nullopt);
  EXPECT_EQ(parse_color_alpha("1,1,1,1.5", true).error().message, "1.5 is outside 0..1");
}

TEST(TextValues, TermsAreAListOfWords) {
  EXPECT_EQ(parse_terms("ambient,specular").value(), (TermSet{true, false, true, false}));
  EXPECT_EQ(parse_terms("none").value(), (TermSet{false, false, false, false}));
  EXPECT_EQ(parse_terms("difuse").error().message,
            "unknown word \"difuse\", did you mean \"diffuse\"? (known: ambient, diffuse, specular, emission)");
}

TEST(TextValues, EveryFloatReadsBackBitEqual) {
  std::mt19937 random(1);
  for (int i = 0; i < 200000; ++i) {
    const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (!std::isfinite(value)) {
      continue;
    }
    const auto back = static_cast<float>(parse_number(number_text(value)).value());
    ASSERT_EQ(std::bit_cast<std::uint32_t>(back), std::bit_cast<std::uint32_t>(value)) << number_text(value);
  }
  EXPECT_EQ(number_text(0.1F), "0.1");
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(-0.0F), "-0.0");
  EXPECT_EQ(number_text(3.0), "3");
}

TEST(TextValues, ColoursReadBackEqual) {
  std::mt19937 random(2);
  const auto unit = [&] { return static_cast<float>(random() >> 8U) / 16777216.0F; };
  for (int i = 0; i < 2000; ++i) {
    const Color linear{{unit(), unit() * 4, unit()}, ColorSpace::linear};
    const Color encoded{{unit(), unit(), unit()}, ColorSpace::encoded};
    const Color bytes{{static_cast<float>(random() % 256) / 255, static_cast<float>(random() % 256) / 255, 1}, ColorSpace::encoded};
    EXPECT_EQ(parse_color(color_text(linear)).value(), linear);
    EXPECT_EQ(parse_color(color_text(encoded)).value(), encoded);
    EXPECT_EQ(parse_color(color_text(bytes)).value(), bytes);
    EXPECT_EQ(color_text(bytes).size(), 7U);  // #rrggbb
    const float alpha = unit();
    const auto back = parse_color_alpha(color_text(encoded, alpha), true).value();
    EXPECT_EQ(back.color, encoded);
    EXPECT_EQ(back.alpha, alpha);
  }
}

}  // namespace
}  // namespace lustro
