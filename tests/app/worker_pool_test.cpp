// Jobs in processes: every job ends once, whatever the process that ran it came to.
#include "app/worker_pool.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <set>
#include <vector>

#include "app/sanitized.hpp"

namespace lustro::app {
namespace {

using ::testing::HasSubstr;

std::map<std::size_t, JobEnd> ends_of(std::size_t count, int workers, const WorkerLimits& limits,
                                      const std::function<std::string(std::size_t)>& job) {
  std::map<std::size_t, JobEnd> ends;
  const Result<void> ran = run_in_workers(count, workers, limits, job, [&](const JobEnd& end) {
    EXPECT_TRUE(ends.emplace(end.job, end).second) << "job " << end.job << " ended twice";
  });
  EXPECT_TRUE(ran);
  EXPECT_EQ(ends.size(), count);
  return ends;
}

TEST(WorkerPool, EveryJobEndsOnceWithItsText) {
  const auto ends = ends_of(200, 3, {}, [](std::size_t i) { return std::string(i * 1000, static_cast<char>('a' + i % 26)); });
  std::set<int> processes;
  for (const auto& [job, end] : ends) {
    EXPECT_TRUE(end.has_result);
    EXPECT_EQ(end.text, std::string(job * 1000, static_cast<char>('a' + job % 26)));
    processes.insert(end.process);
  }
  EXPECT_LE(processes.size(), 3U);  // one is used again and again
  EXPECT_FALSE(processes.contains(::getpid()));
  EXPECT_TRUE(run_in_workers(0, 3, {}, nullptr, nullptr));
}

TEST(WorkerPool, AJobThatKillsItsProcessTakesNoOtherDown) {
  const auto ends = ends_of(30, 2, {}, [](std::size_t i) -> std::string {
    if (i % 10 == 3) {
      ::raise(SIGKILL);
    }
    if (i % 10 == 7) {
      ::_exit(5);
    }
    return "fine";
  });
  for (const auto& [job, end] : ends) {
    EXPECT_EQ(end.has_result, job % 10 != 3 && job % 10 != 7) << job;
    EXPECT_FALSE(end.timed_out);
  }
  EXPECT_THAT(ends.at(13).text, HasSubstr("signal 9"));
  EXPECT_THAT(ends.at(17).text, HasSubstr("ended with code 5"));
}

TEST(WorkerPool, AJobThatNeverEndsIsKilledAfterItsTime) {
  const auto ends = ends_of(6, 2, {.seconds = 0.2}, [](std::size_t i) -> std::string {
    while (i == 1 || i == 4) {
      ::pause();
    }
    return "fine";
  });
  for (const auto& [job, end] : ends) {
    EXPECT_EQ(end.has_result, job != 1 && job != 4);
    EXPECT_EQ(end.timed_out, job == 1 || job == 4);
  }
  EXPECT_EQ(ends.at(4).text, "took more than 0.2 s");
}

TEST(WorkerPool, MemoryBeyondTheLimitIsRefused) {
  if (lustro::testing::kIsSanitized) {
    GTEST_SKIP() << "a sanitizer takes its memory beforehand";
  }
  constexpr std::size_t kMegabyte = 1'000'000;
  const auto ends = ends_of(4, 1, {.bytes = 50 * kMegabyte}, [](std::size_t i) -> std::string {
    // Not caught, so that the worker ends. Far more than the limit, since memory that this process has freed is there for its copies.
    std::vector<char> block(i == 1 ? 300 * kMegabyte : 30 * kMegabyte, 'x');
    return std::string(1, block.back());
  });
  for (const auto& [job, end] : ends) {
    EXPECT_EQ(end.has_result, job != 1) << job << ": " << end.text;  // 30 MB again and again: what is freed is there for the next
  }
  EXPECT_THAT(ends.at(1).text, HasSubstr("memory"));
}

}  // namespace
}  // namespace lustro::app
