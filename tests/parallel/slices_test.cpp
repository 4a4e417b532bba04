// Every step is in one slice.
#include "parallel/slices.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace lustro {
namespace {

TEST(Slices, CoverEveryStepOnce) {
  for (const std::size_t count : {0U, 1U, 16383U, 32768U, 100001U}) {
    for (const int threads : {0, 1, 2, 5}) {
      std::vector<int> visits(count, 0);
      parallel_slices(count, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          ++visits[i];
        }
      });
      EXPECT_EQ(visits, std::vector<int>(count, 1));
    }
  }
}

TEST(Slices, NothingIsNotCutAtAll) {
  parallel_slices(0, 2, [](std::size_t, std::size_t) { ADD_FAILURE(); });
}

TEST(Slices, SmallLoopsStayWhole) {
  EXPECT_EQ(slice_count(2 * kSmallestSlice - 1, 8), 1U);
  EXPECT_EQ(slice_count(2 * kSmallestSlice, 8), 2U);
  EXPECT_EQ(slice_count(100 * kSmallestSlice, 1), 1U);
  EXPECT_EQ(slice_count(100 * kSmallestSlice, 2), 8U);
}

}  // namespace
}  // namespace lustro
