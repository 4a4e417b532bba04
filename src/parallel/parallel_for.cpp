// parallel_for on oneTBB.
#include "parallel/parallel_for.hpp"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace lustro {

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
  if (threads == 1 || count <= 1) {
    for (std::size_t i = 0; i < count; ++i) {
      body(i);
    }
    return;
  }
  // More threads than cores are granted when they are asked for; without this oneTBB prints a warning and ignores the request.
  const int cores = tbb::info::default_concurrency();
  const tbb::global_control allowance(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(std::max(threads, cores)));
  tbb::task_arena arena(threads > 0 ? threads : cores);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, body); });
}

}  // namespace lustro
