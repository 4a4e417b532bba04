// Big arrays hold what ordinary ones hold.
#include "parallel/big_memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace lustro {
namespace {

TEST(BigMemory, ArraysBeginWithZeros) {
  for (const std::size_t size : {0U, 1U, 5'000'000U}) {
    const BigArray<std::uint32_t> array = make_big_array<std::uint32_t>(size);
    EXPECT_TRUE(std::all_of(array.get(), array.get() + size, [](std::uint32_t x) { return x == 0; }));
  }
}

TEST(BigMemory, ListsKeepTheirElements) {
  std::vector<int> list{1, 2, 3};
  resize_big(list, 3'000'000);
  EXPECT_EQ(list[1], 2);
  EXPECT_EQ(list.back(), 0);
  resize_big(list, 2);
  EXPECT_EQ(list, (std::vector<int>{1, 2}));
}

}  // namespace
}  // namespace lustro
