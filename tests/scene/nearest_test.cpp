// Suggestions, and text from outside in messages.
#include "scene/nearest.hpp"

#include <gtest/gtest.h>

#include <array>

namespace lustro {
namespace {

constexpr std::array<std::string_view, 5> kKnown{"cutoff", "beam", "exponent", "type", "attenuation"};

TEST(Nearest, FindsOneSlipOfTheFinger) {
  EXPECT_EQ(nearest_name("cutof", kKnown), "cutoff");
  EXPECT_EQ(nearest_name("cuttoff", kKnown), "cutoff");
  EXPECT_EQ(nearest_name("cutfof", kKnown), "cutoff");  // two letters swapped are one slip
  EXPECT_EQ(nearest_name("Cutoff", kKnown), "cutoff");
  EXPECT_EQ(nearest_name("baem", kKnown), "beam");
  EXPECT_EQ(nearest_name("atenuatoin", kKnown), "attenuation");
}

TEST(Nearest, SaysNothingWhereNothingIsNear) {
  EXPECT_EQ(nearest_name("colour", kKnown), std::nullopt);
  EXPECT_EQ(nearest_name("", kKnown), std::nullopt);
  EXPECT_EQ(nearest_name(std::string(100000, 'c'), kKnown), std::nullopt);
  constexpr std::array<std::string_view, 1> kShort{"x"};
  EXPECT_EQ(nearest_name("y", kShort), std::nullopt);
  EXPECT_EQ(nearest_name("beam", {}), std::nullopt);
}

TEST(Nearest, QuotesTextFromOutsideSafely) {
  EXPECT_EQ(quote("jade"), "\"jade\"");
  EXPECT_EQ(quote("a\"b\\c"), "\"a\\\"b\\\\c\"");
  EXPECT_EQ(quote("\x1b[31m\n"), "\"\\x1b[31m\\x0a\"");                       // no escape codes on a terminal
  EXPECT_EQ(quote("gr\xc3\xbcn"), "\"gr\xc3\xbcn\"");                         // UTF-8 stays
  EXPECT_EQ(quote("\xff\xc3"), "\"\\xff\\xc3\"");                             // broken UTF-8 does not
  EXPECT_EQ(quote("\xc0\xaf\xed\xa0\x80"), "\"\\xc0\\xaf\\xed\\xa0\\x80\"");  // overlong, surrogate
  EXPECT_EQ(quote(std::string(1000, 'a')), "\"" + std::string(60, 'a') + "...\"");
}

}  // namespace
}  // namespace lustro
