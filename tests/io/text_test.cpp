// The text cursor: lines, words, numbers, names.
#include "io/text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace lustro {
namespace {

TextCursor cursor(std::string_view text) {
  return TextCursor(text, {.hash_comments = true, .joined_lines = true});
}

std::vector<std::string> words_of_lines(std::string_view text) {  // a | between lines
  TextCursor at = cursor(text);
  std::vector<std::string> words;
  for (; !at.at_end(); at.next_line()) {
    while (!at.at_line_end()) {
      words.emplace_back(at.word());
    }
    words.emplace_back("|");
  }
  return words;
}

using Words = std::vector<std::string>;

TEST(Text, LinesEndWithLfCrlfOrCr) {
  for (const char* text : {"a b\nc\n", "a b\r\nc\r\n", "a b\rc\r", "a b\nc", "a b\r\nc", "a b\rc"}) {
    EXPECT_EQ(words_of_lines(text), (Words{"a", "b", "|", "c", "|"})) << text;
  }
}

TEST(Text, CountsLinesOfEveryKind) {
  TextCursor at = cursor("1\n2\r\n3\r4\\\n5\n6");
  std::vector<std::size_t> lines;
  for (; !at.at_end(); at.next_line()) {
    lines.push_back(at.line());
  }
  EXPECT_EQ(lines, (std::vector<std::size_t>{1, 2, 3, 4, 6}));
}

TEST(Text, ABackslashBeforeTheLinesEndJoinsTheNextLine) {
  EXPECT_EQ(words_of_lines("a \\\nb\\\r\nc\\\rd\ne"), (Words{"a", "b", "c", "d", "|", "e", "|"}));
  EXPECT_EQ(words_of_lines("a\\b \\ c\\"), (Words{"a\\b", "\\", "c\\", "|"}));  // elsewhere it is a letter
}

TEST(Text, CommentsEndWithTheLineAndJoinNothing) {
  EXPECT_EQ(words_of_lines("# x\na # y \\\nb\n #z\nc#d"), (Words{"|", "a", "|", "b", "|", "|", "c#d", "|"}));
}

TEST(Text, SkipsAByteOrderMarkAtTheStartOnly) {
  EXPECT_EQ(words_of_lines("\xEF\xBB\xBFv\n\xEF\xBB\xBFv"), (Words{"v", "|", "\xEF\xBB\xBFv", "|"}));
}

TEST(Text, ReadsNumbersCorrectlyRounded) {
  TextCursor at = cursor("1 -2.5 +3 .5 5. 1e3 -1E-2 0.1 16777217 1e-46 1e39 -0");
  const std::vector<float> expected{1, -2.5F, 3, 0.5F, 5, 1000, -0.01F, 0.1F, 16777216, 0, std::numeric_limits<float>::infinity(), 0};
  for (const float value : expected) {
    float found = -99;
    ASSERT_TRUE(at.number(found)) << value;
    EXPECT_EQ(found, value);
  }
  EXPECT_TRUE(at.at_end());
}

TEST(Text, ReadsWhatSystemsPrintForNoNumber) {
  TextCursor at = cursor("nan -nan NaN nan(ind) -nan(ind) 1.#QNAN -1.#IND 1.#QNAN0 1.#IND00 inf -inf infinity 1.#INF -1.#INF00");
  for (int i = 0; i < 9; ++i) {
    float found = 0;
    ASSERT_TRUE(at.number(found)) << i;
    EXPECT_TRUE(std::isnan(found)) << i;
  }
  for (const int sign : {1, -1, 1, 1, -1}) {
    float found = 0;
    ASSERT_TRUE(at.number(found));
    EXPECT_TRUE(std::isinf(found));
    EXPECT_EQ(std::signbit(found), sign < 0);
  }
  EXPECT_TRUE(at.at_line_end());
}

TEST(Text, WhatIsNoNumberStaysWhereItIs) {
  for (const char* text : {"x", "1x", "1,5", "--1", "+-1", "++1", "-", "+", ".", "e5", "1e", "0x10", "1.5.2", "", "\n1", "1/2"}) {
    TextCursor at = cursor(text);
    float found = 0;
    EXPECT_FALSE(at.number(found)) << text;
    EXPECT_EQ(at.remaining(), std::string_view(text).size()) << text;
  }
}

TEST(Text, ANumberMayTouchAComment) {
  TextCursor at = cursor("1 2#INFO 3\n4");
  float found = 0;
  ASSERT_TRUE(at.number(found));
  ASSERT_TRUE(at.number(found));
  EXPECT_EQ(found, 2);
  EXPECT_TRUE(at.at_line_end());
}

TEST(Text, ReadsWholeNumbersAndStaysAtOthers) {
  TextCursor at = cursor("12 -7 +3 99999999999999999999999 4/5");
  std::int64_t found = 0;
  for (const std::int64_t value : {std::int64_t{12}, std::int64_t{-7}, std::int64_t{3}, std::int64_t{100'000'000'000'000'000}}) {
    ASSERT_TRUE(at.integer(found));
    EXPECT_EQ(found, value);
  }
  EXPECT_FALSE(at.integer(found));
  ASSERT_TRUE(at.integer(found, '/'));
  EXPECT_EQ(found, 4);
  EXPECT_TRUE(at.take('/'));
  ASSERT_TRUE(at.integer(found));
  EXPECT_EQ(found, 5);
  for (const char* text : {"1.5", "x", "", "-", "1e3", "1-2"}) {
    TextCursor other = cursor(text);
    EXPECT_FALSE(other.integer(found)) << text;
  }
}

TEST(Text, NamesKeepTheirInnerBlanksAndLoseComments) {
  EXPECT_EQ(cursor("  White  Color \t# x").rest_of_line(), "White  Color");
  EXPECT_EQ(cursor("Material__#25 #x").rest_of_line(), "Material__#25");
  EXPECT_EQ(cursor("a \\\n b\nc").rest_of_line(), "a b");
  EXPECT_EQ(cursor("a\\b\\").rest_of_line(), "a\\b\\");
  EXPECT_EQ(cursor("# all").rest_of_line(), "");
  EXPECT_EQ(cursor("#").rest_of_line(), "");
  EXPECT_EQ(cursor("").rest_of_line(), "");
}

TEST(Text, ForeignTextIsShownSafelyAndShort) {
  EXPECT_EQ(shown("abc"), "\"abc\"");
  EXPECT_EQ(shown("a\n\x01\x7F\xFF"), "\"a\\x0A\\x01\\x7F\\xFF\"");
  EXPECT_EQ(shown("\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80"), "\"\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80\"");
  EXPECT_EQ(shown("\xC0\x80\xED\xA0\x80"), "\"\\xC0\\x80\\xED\\xA0\\x80\"");  // overlong, surrogate
  EXPECT_EQ(shown(std::string(1000, 'x')), "\"" + std::string(40, 'x') + "...\"");
}

TEST(Text, NamesThatAreNotUtf8AreReadAsLatin1) {
  EXPECT_EQ(to_utf8("Stra\xC3\x9F"
                    "e"),
            "Stra\xC3\x9F"
            "e");
  EXPECT_EQ(to_utf8("Stra\xDF"
                    "e"),
            "Stra\xC3\x9F"
            "e");
  EXPECT_EQ(to_utf8("\xE2\x82"), "\xC3\xA2\xC2\x82");  // cut off inside a character
}

}  // namespace
}  // namespace lustro
