// parallel_for on oneTBB; on plain threads (LUSTRO_THREADS=std, and where the thread sanitizer watches); or in order, on the calling thread
// (LUSTRO_THREADS=off).
#include "parallel/parallel_for.hpp"

#if defined(__SANITIZE_THREAD__)
#define LUSTRO_WATCHED
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define LUSTRO_WATCHED
#endif
#endif

#if defined(LUSTRO_THREADS_STD) || defined(LUSTRO_WATCHED)
#define LUSTRO_PLAIN_THREADS
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#elif !defined(LUSTRO_THREADS_OFF)
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#endif

namespace lustro {
namespace {

#if defined(LUSTRO_PLAIN_THREADS)

std::size_t core_count() {
#ifdef LUSTRO_WATCHED
  return 4;
#else
  return std::max(std::thread::hardware_concurrency(), 1U);
#endif
}

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

#elif defined(LUSTRO_THREADS_OFF)

std::size_t core_count() {
  return 1;
}

void run_on_threads(std::size_t count, int /*threads*/, const std::function<void(std::size_t)>& body) {
  for (std::size_t i = 0; i < count; ++i) {
    body(i);
  }
}

#else

std::size_t core_count() {
  return static_cast<std::size_t>(tbb::info::default_concurrency());
}

void run_on_threads(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
  // More threads than cores are granted when they are asked for; without this oneTBB prints a warning and ignores the request.
  const int cores = static_cast<int>(core_count());
  const tbb::global_control allowance(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(std::max(threads, cores)));
  tbb::task_arena arena(threads > 0 ? threads : cores);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, body); });
}

#endif

}  // namespace

std::size_t thread_count(int threads) {
#if defined(LUSTRO_THREADS_OFF) && !defined(LUSTRO_PLAIN_THREADS)
  threads = 1;
#endif
  return threads > 0 ? static_cast<std::size_t>(threads) : core_count();
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

void parallel_jobs(std::size_t count, int threads, const std::function<void(std::size_t, int)>& job) {
  const bool is_one = count == 1;
  parallel_for(count, is_one ? 1 : threads, [&](std::size_t i) { job(i, is_one ? threads : 1); });
}

}  // namespace lustro
