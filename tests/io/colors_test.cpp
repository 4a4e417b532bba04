// Colours into 0..1.
#include "io/colors.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace lustro {
namespace {

using Colors = std::vector<Vec3f>;

Colors settled(Colors colors, std::size_t notes) {
  NoteBook book("f");
  settle_colors(colors, "vertex", book);
  EXPECT_EQ(book.notes().size(), notes);
  return colors;
}

TEST(Colors, InsideTheRangeNothingChanges) {
  EXPECT_EQ(settled({{0, 0.25F, 1}}, 0), (Colors{{0, 0.25F, 1}}));
}

TEST(Colors, ALittleOutsideIsClamped) {
  EXPECT_EQ(settled({{-0.1F, 1.001F, 2}}, 1), (Colors{{0, 1, 1}}));
}

TEST(Colors, ScalesOf255And65535AreSeen) {
  EXPECT_EQ(settled({{0, 51, 255}, {1, 0, 3}}, 1), (Colors{{0, 51.0F / 255, 1}, {1.0F / 255, 0, 3.0F / 255}}));
  EXPECT_EQ(settled({{0, 256, 65535}}, 1), (Colors{{0, 256.0F / 65535, 1}}));
}

TEST(Colors, WhatIsNoNumberLeavesTheMaterialAsItIs) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  EXPECT_EQ(settled({{nan, 0.5F, nan}, {inf, -inf, 1}}, 2), (Colors{{1, 0.5F, 1}, {1, 0, 1}}));
}

}  // namespace
}  // namespace lustro
