// The parallel loop: every index once, no more threads than asked for, and what an iteration wrote is there when the loop has ended.
#include "parallel/parallel_for.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace lustro {
namespace {

TEST(ParallelFor, VisitsEveryIndexOnceForEveryNumberOfThreads) {
  for (const int threads : {0, 1, 2, 3, 8}) {
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{1000}}) {
      std::vector<int> visits(count, 0);
      parallel_for(count, threads, [&](std::size_t i) { ++visits[i]; });
      EXPECT_EQ(visits, std::vector<int>(count, 1)) << threads << " threads, " << count << " iterations";
    }
  }
}

TEST(ParallelFor, UsesNoMoreThreadsThanAskedFor) {
  for (const int threads : {1, 2, 3}) {
    std::atomic<int> inside = 0;
    std::atomic<int> most = 0;
    parallel_for(2000, threads, [&](std::size_t) {
      const int now = ++inside;
      int seen = most.load();
      while (seen < now && !most.compare_exchange_weak(seen, now)) {
      }
      --inside;
    });
    EXPECT_LE(most.load(), threads);
    EXPECT_GE(most.load(), 1);
  }
}

// Plain memory on both sides of the loop: the thread sanitizer watches that its beginning and its end order the accesses.
TEST(ParallelFor, ThreadsSeeWhatWasWrittenBeforeAndAreSeenAfter) {
  std::vector<long> values(5000);
  for (int round = 0; round < 20; ++round) {
    std::iota(values.begin(), values.end(), round);
    std::vector<long> doubled(values.size());
    parallel_for(values.size(), 4, [&](std::size_t i) { doubled[i] = 2 * values[i]; });
    const long n = static_cast<long>(values.size());
    EXPECT_EQ(std::accumulate(doubled.begin(), doubled.end(), 0L), n * (n - 1) + 2L * round * n);
  }
}

TEST(ParallelFor, LoopsMayStandInsideLoops) {
  constexpr std::size_t kOuter = 20;
  constexpr std::size_t kInner = 50;
  std::vector<int> visits(kOuter * kInner, 0);
  parallel_for(kOuter, 4, [&](std::size_t i) { parallel_for(kInner, 2, [&](std::size_t j) { ++visits[i * kInner + j]; }); });
  EXPECT_EQ(visits, std::vector<int>(kOuter * kInner, 1));
}

TEST(ParallelFor, ThreadsHandAnExceptionToTheCaller) {
  for (const int threads : {1, 4}) {
    EXPECT_THROW(parallel_for(100, threads,
                              [](std::size_t i) {
                                if (i == 40) {
                                  throw std::runtime_error("forty");
                                }
                              }),
                 std::runtime_error);
  }
}

}  // namespace
}  // namespace lustro
