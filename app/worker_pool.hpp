// Jobs in processes of their own, so that a hostile file can take nothing down but its own picture. The limits are kept by the system, not by
// the job: a process that takes too long is killed, one that takes too much memory is refused more.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "lustro/result.hpp"

namespace lustro::app {

struct WorkerLimits {
  double seconds = 0;       ///< of one job, by the clock; 0: none
  std::uint64_t bytes = 0;  ///< that a process may allocate beside what it began with; files that are mapped do not count; 0: none
};

struct JobEnd {
  std::size_t job = 0;
  bool has_result = false;
  std::string text;        ///< what the job returned, or why it did not: one sentence without a final full stop
  bool timed_out = false;  ///< it was killed for the time
  int process = 0;         ///< that ran it
};

/// Runs job(i) for i in 0..count-1 in `workers` processes, each of which runs one job after the other and is replaced when it dies. An interrupt
/// ends the processes, then this one.
///
/// job     is called in a worker: a copy of this process from the moment of the call, with its files and data
/// ended   is called here, for every job once, in the order in which they end
/// errors  io where the system gives no more processes
[[nodiscard]] Result<void> run_in_workers(std::size_t count, int workers, const WorkerLimits& limits,
                                          const std::function<std::string(std::size_t)>& job, const std::function<void(const JobEnd&)>& ended);

}  // namespace lustro::app
