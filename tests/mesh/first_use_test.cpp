// Vertices are numbered as they are met, by any number of threads.
#include "mesh/first_use.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace lustro {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

std::vector<std::uint32_t> list_of(const FirstUse& numbers, std::size_t vertices) {
  return {numbers.new_of_old.get(), numbers.new_of_old.get() + vertices};
}

TEST(FirstUse, NumbersVerticesAsTheyAreMet) {
  Triangles triangles{{4, 2, 6}, {2, 4, 0}};
  const FirstUse numbers = number_by_first_use(triangles, 8, 1);
  EXPECT_THAT(list_of(numbers, 8), testing::ElementsAre(3, 4, 1, 5, 0, 6, 2, 7));
  EXPECT_EQ(numbers.used, 4U);
  EXPECT_FALSE(numbers.is_sorted);
  renumber(triangles, numbers, 1);
  EXPECT_EQ(triangles, (Triangles{{0, 1, 2}, {1, 0, 3}}));
  EXPECT_TRUE(number_by_first_use(triangles, 8, 1).is_sorted);
  EXPECT_FALSE(number_by_first_use(Triangles{{1, 2, 3}}, 4, 1).is_sorted);
}

TEST(FirstUse, TheNumberOfThreadsChangesNothing) {
  std::mt19937 engine(3);
  for (const std::uint32_t vertices : {7U, 30000U, 200000U, 2000000U}) {
    Triangles stated(70000);
    for (std::size_t t = 0; t < stated.size(); ++t) {
      for (std::uint32_t& v : stated[t]) {
        v = (engine() % 2 == 0 ? static_cast<std::uint32_t>(engine()) : static_cast<std::uint32_t>(t + engine() % 50)) % vertices;
      }
    }
    constexpr std::uint32_t kNone = 0xFFFFFFFFU;
    std::vector<std::uint32_t> expected(vertices, kNone);
    std::uint32_t next = 0;
    for (const auto& t : stated) {
      for (const std::uint32_t v : t) {
        expected[v] = expected[v] == kNone ? next++ : expected[v];
      }
    }
    const std::uint32_t used = next;
    for (std::uint32_t& number : expected) {
      number = number == kNone ? next++ : number;
    }
    for (const int threads : {1, 2, 3, 7, 20}) {
      const FirstUse numbers = number_by_first_use(stated, vertices, threads);
      EXPECT_EQ(list_of(numbers, vertices), expected);
      EXPECT_EQ(numbers.used, used);
      Triangles triangles = stated;
      renumber(triangles, numbers, threads);
      for (std::size_t t = 0; t < stated.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
          ASSERT_EQ(triangles[t][k], expected[stated[t][k]]);
        }
      }
      EXPECT_TRUE(number_by_first_use(triangles, vertices, threads).is_sorted);
    }
  }
}

}  // namespace
}  // namespace lustro
