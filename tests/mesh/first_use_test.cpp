// Vertices are numbered as they are met, by any number of threads.
#include "mesh/first_use.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace lustro {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

TEST(FirstUse, NumbersVerticesAsTheyAreMet) {
  Triangles triangles{{4, 2, 6}, {2, 4, 0}};
  EXPECT_THAT(number_by_first_use(triangles, 8, 1), testing::ElementsAre(4, 2, 6, 0));
  EXPECT_EQ(triangles, (Triangles{{0, 1, 2}, {1, 0, 3}}));
}

TEST(FirstUse, TheNumberOfThreadsChangesNothing) {
  std::mt19937 engine(3);
  for (const std::uint32_t vertices : {7U, 30000U, 200000U}) {
    Triangles stated(70000);
    for (std::size_t t = 0; t < stated.size(); ++t) {
      for (std::uint32_t& v : stated[t]) {
        v = (engine() % 2 == 0 ? static_cast<std::uint32_t>(engine()) : static_cast<std::uint32_t>(t + engine() % 50)) % vertices;
      }
    }
    std::vector<std::uint32_t> number(vertices, 0xFFFFFFFFU);
    std::vector<std::uint32_t> expected;
    for (const auto& t : stated) {
      for (const std::uint32_t v : t) {
        if (number[v] == 0xFFFFFFFFU) {
          number[v] = static_cast<std::uint32_t>(expected.size());
          expected.push_back(v);
        }
      }
    }
    for (const int threads : {1, 2, 3, 7, 20}) {
      Triangles triangles = stated;
      EXPECT_EQ(number_by_first_use(triangles, vertices, threads), expected);
      for (std::size_t t = 0; t < stated.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
          ASSERT_EQ(triangles[t][k], number[stated[t][k]]);
        }
      }
    }
  }
}

}  // namespace
}  // namespace lustro
