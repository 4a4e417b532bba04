// The only place where threads are made: a loop whose iterations write only to places they own.
#pragma once

#include <cstddef>
#include <functional>

namespace lustro {

/// Calls body(i) for every i in 0..count-1, on at most `threads` threads (0: one a core). The order is free, so a body may depend on nothing
/// that another one writes.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

/// The same of jobs that have loops of their own: job(i, its threads). A single job has all threads, of several each has one.
void parallel_jobs(std::size_t count, int threads, const std::function<void(std::size_t, int)>& job);

/// How many threads parallel_for() uses: `threads`, or one a core where it is 0.
[[nodiscard]] std::size_t thread_count(int threads);

}  // namespace lustro
