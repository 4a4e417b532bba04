// Two loops that do nothing but copy, and nothing but multiply and add: see machine.hpp. The best of several runs counts, since what disturbs a
// run only slows it down. The arithmetic is written in the compilers' vector types, because what is asked is the widest registers' rate.
#include "machine.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "lustro/render.hpp"
#include "parallel/parallel_for.hpp"

namespace lustro::app {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kSecondsEach = 0.1;

/// Work done a second by the best of the runs that fit into the time; at least three.
template <class Run>
double best_rate(double work, const Run& run) {
  double best = 0;
  const Clock::time_point begin = Clock::now();
  for (int i = 0; i < 3 || std::chrono::duration<double>(Clock::now() - begin).count() < kSecondsEach; ++i) {
    const Clock::time_point start = Clock::now();
    run();
    best = std::max(best, work / std::chrono::duration<double>(Clock::now() - start).count());
  }
  return best;
}

double copy_rate(int threads) {
  constexpr std::size_t kChunk = std::size_t{1} << 20;
  const std::size_t chunks = 32 * static_cast<std::size_t>(std::min(threads, 16));
  std::vector<std::byte> from(chunks * kChunk, std::byte{1}), to(chunks * kChunk);
  return best_rate(2.0 * static_cast<double>(from.size()),
                   [&] { parallel_for(chunks, threads, [&](std::size_t i) { std::memcpy(&to[i * kChunk], &from[i * kChunk], kChunk); }); });
}

constexpr std::int64_t kSteps = 20000;
constexpr std::size_t kChains = 10;  // enough to hide the latency of two units, few enough for sixteen registers

// The body of multiply_adds() once for each width: a compiler lowers vector types before it could inline them into a function of another target.
#define LUSTRO_MULTIPLY_ADDS(name, bytes, attributes)                                                                            \
  attributes float name(float seed) {                                                                                            \
    using Lanes = float __attribute__((vector_size(bytes)));                                                                     \
    const Lanes scale = Lanes{} + 0.75F, shift = Lanes{} + 0.25F;                                                                \
    Lanes a = Lanes{} + seed, b = a + 1, c = a + 2, d = a + 3, e = a + 4, f = a + 5, g = a + 6, h = a + 7, i = a + 8, j = a + 9; \
    for (std::int64_t step = 0; step < kSteps; ++step) { /* each x goes to 1: no overflow, no denormals */                       \
      a = a * scale + shift, b = b * scale + shift, c = c * scale + shift, d = d * scale + shift;                                \
      e = e * scale + shift, f = f * scale + shift, g = g * scale + shift, h = h * scale + shift;                                \
      i = i * scale + shift, j = j * scale + shift;                                                                              \
    }                                                                                                                            \
    a = (((a + b) + (c + d)) + ((e + f) + (g + h))) + (i + j);                                                                   \
    return a[0];                                                                                                                 \
  }

LUSTRO_MULTIPLY_ADDS(multiply_adds_16, 16, )
#if defined(__x86_64__)
LUSTRO_MULTIPLY_ADDS(multiply_adds_32, 32, __attribute__((target("avx2"))))
LUSTRO_MULTIPLY_ADDS(multiply_adds_64, 64, __attribute__((target("avx512f"))))
#endif
#undef LUSTRO_MULTIPLY_ADDS

struct Widest {
  float (*run)(float);
  int lanes;
};

Widest widest() {
#if defined(__x86_64__)
  const auto targets = available_targets();
  const auto has = [&](Target target) { return std::find(targets.begin(), targets.end(), target) != targets.end(); };
  if (has(Target::avx512)) {
    return {multiply_adds_64, 16};
  }
  if (has(Target::avx2)) {
    return {multiply_adds_32, 8};
  }
#endif
  return {multiply_adds_16, 4};
}

double operation_rate(int threads) {
  const Widest body = widest();
  const std::size_t chunks = 32 * static_cast<std::size_t>(threads);
  std::vector<float> results(chunks);
  const double work = 2.0 * static_cast<double>(kChains * chunks) * static_cast<double>(kSteps) * body.lanes;
  return best_rate(work,
                   [&] { parallel_for(chunks, threads, [&](std::size_t i) { results[i] = body.run(static_cast<float>(i) + results[i]); }); });
}

}  // namespace

MachineLimits measure_machine(int threads) {
  return {.copy_bytes_per_second = copy_rate(threads), .operations_per_second = operation_rate(threads)};
}

}  // namespace lustro::app
