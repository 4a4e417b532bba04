// Taking turns: see measure.hpp.
#include "common/measure.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <limits>
#include <nlohmann/json.hpp>

namespace lustro::bench {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Time that all threads of this process have had, milliseconds.
double processor_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

void print(const nlohmann::ordered_json& line) {
  std::printf("%s\n", line.dump().c_str());
  std::fflush(stdout);
}

}  // namespace

std::vector<Times> in_turns(const std::vector<Side>& sides, const Patience& patience) {
  std::vector<std::vector<double>> taken(sides.size());
  std::vector<double> processor(sides.size(), std::numeric_limits<double>::infinity());
  std::vector<int> count(sides.size(), 0);
  for (std::size_t s = 0; s < sides.size(); ++s) {
    sides[s].run(count[s]++);
  }
  const Clock::time_point start = Clock::now();
  for (int round = 0; round < patience.rounds && (round < 2 || milliseconds_since(start) < 1e3 * patience.most_seconds); ++round) {
    for (std::size_t s = 0; s < sides.size(); ++s) {
      const Clock::time_point turn = Clock::now();
      do {
        const double processor_before = processor_milliseconds();
        const Clock::time_point once = Clock::now();
        sides[s].run(count[s]++);
        taken[s].push_back(milliseconds_since(once));
        processor[s] = std::min(processor[s], processor_milliseconds() - processor_before);
      } while (milliseconds_since(turn) < patience.turn_ms);
    }
  }
  std::vector<Times> times;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    std::vector<double>& t = taken[s];
    std::sort(t.begin(), t.end());
    times.push_back({t.front(), (t[(t.size() - 1) / 2] + t[t.size() / 2]) / 2, processor[s], static_cast<int>(t.size())});
  }
  return times;
}

void report(std::string_view key, std::string_view check, const std::vector<Side>& sides, const std::vector<Times>& times) {
  nlohmann::ordered_json line{{"key", key}, {"check", check}};
  for (std::size_t s = 0; s < sides.size(); ++s) {
    line["sides"][sides[s].name] = {
        {"min_ms", times[s].min_ms}, {"median_ms", times[s].median_ms}, {"processor_ms", times[s].processor_ms}, {"runs", times[s].runs}};
  }
  print(line);
}

void report_failure(std::string_view key, std::string_view why) {
  print({{"key", key}, {"failed", why}});
}

}  // namespace lustro::bench
