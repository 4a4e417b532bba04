// parallel_for on oneTBB; on plain threads where the thread sanitizer watches.
#include "parallel/parallel_for.hpp"

#if defined(__SANITIZE_THREAD__)
#define LUSTRO_PLAIN_THREADS
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define LUSTRO_PLAIN_THREADS
#endif
#endif

#ifdef LUSTRO_PLAIN_THREADS
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#else
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#endif

namespace lustro {
namespace {

#ifdef LUSTRO_PLAIN_THREADS

// The sanitizer does not see how the system's oneTBB orders its work, and would report races inside it. What is to be watched are the bodies of
// the loops, so they run on threads that it knows, with no more order than a loop promises.
void run_on_threads(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failure_mutex;
  std::vector<std::thread> workers(thread_count(threads));
  for (std::thread& worker : workers) {
    worker = std::thread([&] {
      try {
        for (std::size_t i = next.fetch_add(1, std::memory_order_relaxed); i < count; i = next.fetch_add(1, std::memory_order_relaxed)) {
          body(i);
        }
      } catch (...) {
        const std::lock_guard lock(failure_mutex);
        failure = std::current_exception();
        next = count;
      }
    });
  }
  for (std::thread& worker : workers) {
    worker.join();
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
}

#else

void run_on_threads(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
  // More threads than cores are granted when they are asked for; without this oneTBB prints a warning and ignores the request.
  const int cores = tbb::info::default_concurrency();
  const tbb::global_control allowance(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(std::max(threads, cores)));
  tbb::task_arena arena(threads > 0 ? threads : cores);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, body); });
}

#endif

}  // namespace

std::size_t thread_count(int threads) {
#ifdef LUSTRO_PLAIN_THREADS
  return threads > 0 ? static_cast<std::size_t>(threads) : 4;
#else
  return static_cast<std::size_t>(threads > 0 ? threads : tbb::info::default_concurrency());
#endif
}

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
  if (threads == 1 || count <= 1) {
    for (std::size_t i = 0; i < count; ++i) {
      body(i);
    }
    return;
  }
  run_on_threads(count, threads, body);
}

}  // namespace lustro
