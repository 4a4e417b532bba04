// Times of two or more sides of a comparison, taken in turns in one run, and the lines in which they are reported.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace lustro::bench {

struct Times {
  double min_ms = 0;
  double median_ms = 0;
  double processor_ms = 0;  ///< of all threads together, the minimum: what other processes take does not count
  int runs = 0;
};

/// One side: `run(i)` does the whole work of its i-th time.
struct Side {
  std::string name;
  std::function<void(int)> run;
};

/// How often and how long.
struct Patience {
  int rounds = 7;            ///< every side has its turn so often
  double turn_ms = 150;      ///< a turn repeats its work until so much time is over, so that short work finds its caches as it leaves them
  double most_seconds = 60;  ///< of all rounds together; at least two are made
};

/// Every side once to warm up, then in turns: a, b, a, b, ... Each repetition is timed by itself.
[[nodiscard]] std::vector<Times> in_turns(const std::vector<Side>& sides, const Patience& patience = {});

/// One line of JSON on stdout: {"key": .., "check": .., "sides": {name: {"min_ms": .., "median_ms": .., "processor_ms": .., "runs": ..},
/// ..}}.
///
/// key    which comparison
/// check  what was compared before, and how well it agreed
void report(std::string_view key, std::string_view check, const std::vector<Side>& sides, const std::vector<Times>& times);

/// The same for a comparison whose sides do not give the same answer: {"key": .., "failed": why}.
void report_failure(std::string_view key, std::string_view why);

}  // namespace lustro::bench
