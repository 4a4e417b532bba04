#include "io/percent.hpp"

#include <gtest/gtest.h>

namespace lustro {
namespace {

TEST(Percent, IsUndone) {
  EXPECT_EQ(without_percent(""), "");
  EXPECT_EQ(without_percent("a b"), "a b");
  EXPECT_EQ(without_percent("a%20b%2F%c3%A9"), "a b/\xC3\xA9");
  EXPECT_EQ(without_percent("%2525"), "%25");  // once
}

TEST(Percent, NeedsTwoDigits) {
  for (const char* text : {"%", "a%", "%2", "%2g", "%g2", "%%20", "%-1"}) {
    EXPECT_FALSE(without_percent(text)) << text;
  }
}

}  // namespace
}  // namespace lustro
