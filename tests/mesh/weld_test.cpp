// Welding against the obvious quadratic loop.
#include "mesh/weld.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "mesh/shapes.hpp"

namespace lustro {
namespace {

using testing::ElementsAre;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::vector<std::uint32_t> weld_slowly(const std::vector<Vec3f>& positions, double tolerance) {
  std::vector<std::uint32_t> first;
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    std::uint32_t found = i;
    for (std::uint32_t j = 0; j < i && found == i; ++j) {
      const bool near =
          tolerance > 0 ? length(vec_cast<double>(positions[i]) - vec_cast<double>(positions[j])) <= tolerance : positions[i] == positions[j];
      found = first[j] == j && near ? j : i;
    }
    first.push_back(found);
  }
  return first;
}

TEST(Weld, EqualPositionsGetTheIndexOfTheFirst) {
  const std::vector<Vec3f> positions{{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {-0.0F, 0, -0.0F}, {1, 2, 3.0000002F}, {1, 2, 3}};
  EXPECT_THAT(weld_positions(positions), ElementsAre(0, 1, 0, 1, 4, 0));
}

TEST(Weld, WhatIsNotFiniteIsWeldedWithNothing) {
  const std::vector<Vec3f> positions{{kNan, 0, 0}, {kNan, 0, 0}, {kInfinity, 0, 0}, {kInfinity, 0, 0}, {1, 0, 0}, {1, 0, 0}};
  EXPECT_THAT(weld_positions(positions), ElementsAre(0, 1, 2, 3, 4, 4));
  EXPECT_THAT(weld_positions(positions, 0.1), ElementsAre(0, 1, 2, 3, 4, 4));
}

TEST(Weld, AToleranceReachesAcrossCellsAndNoFarther) {
  const std::vector<Vec3f> positions{{0.0999F, 0.0999F, -0.0001F}, {0.1001F, 0.1001F, 0.0001F}, {0.25F, 0.1F, 0}, {0.0999F, 0.0999F, 0.1F}};
  EXPECT_THAT(weld_positions(positions, 0.1), ElementsAre(0, 0, 2, 3));
  EXPECT_THAT(weld_positions(positions, 0.2), ElementsAre(0, 0, 0, 0));
}

TEST(Weld, MatchesTheQuadraticLoop) {
  std::mt19937 random(1);
  for (const double tolerance : {0.0, 0.01, 0.1, 1.0, 1e-30, 1e30}) {
    std::vector<Vec3f> positions;
    for (int i = 0; i < 1500; ++i) {
      const auto coordinate = [&] {
        return static_cast<float>(static_cast<int>(random() % 9) - 4) * 0.25F + (random() % 2 != 0 ? 0.007F : 0.0F);
      };
      positions.push_back({coordinate(), coordinate(), coordinate()});
    }
    EXPECT_EQ(weld_positions(positions, tolerance), weld_slowly(positions, tolerance)) << tolerance;
  }
}

TEST(Weld, HugeCoordinatesWithATinyToleranceAreNoOverflow) {
  const std::vector<Vec3f> positions{{3e38F, -3e38F, 1}, {3e38F, -3e38F, 1}, {1e-38F, 0, 0}, {0, 0, 0}};
  EXPECT_THAT(weld_positions(positions, 1e-300), ElementsAre(0, 0, 2, 3));
}

}  // namespace
}  // namespace lustro
