// Every thread marks the vertices of its own run of triangles; what earlier runs have marked is taken off; then the marks are numbered.
#include "mesh/first_use.hpp"

#include <algorithm>

#include "parallel/big_memory.hpp"
#include "parallel/slices.hpp"

namespace lustro {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// More runs would take more memory for their marks than the threads are worth.
constexpr std::size_t kMostRuns = 8;

}  // namespace

std::vector<std::uint32_t> number_by_first_use(std::span<Triangle> triangles, std::size_t vertices, int threads) {
  const std::size_t runs = triangles.size() < kSmallestSlice ? 1 : std::min(kMostRuns, thread_count(threads));
  const auto run = [&](std::size_t r) {
    const std::size_t begin = triangles.size() * r / runs;
    return triangles.subspan(begin, triangles.size() * (r + 1) / runs - begin);
  };
  const BigArray<std::uint8_t> marks = make_big_array<std::uint8_t>(runs * vertices);
  parallel_for(runs, threads, [&](std::size_t r) {
    std::uint8_t* const mark = marks.get() + r * vertices;
    for (const Triangle& triangle : run(r)) {
      mark[triangle[0]] = 1;
      mark[triangle[1]] = 1;
      mark[triangle[2]] = 1;
    }
  });

  const std::size_t slices = slice_count(vertices, threads);
  std::vector<std::size_t> counts(slices * runs);
  parallel_for(slices, threads, [&](std::size_t s) {
    const std::size_t begin = vertices * s / slices;
    const std::size_t end = vertices * (s + 1) / slices;
    std::vector<std::uint8_t> seen(marks.get() + begin, marks.get() + end);
    counts[s * runs] = static_cast<std::size_t>(std::count(seen.begin(), seen.end(), std::uint8_t{1}));
    for (std::size_t r = 1; r < runs; ++r) {
      std::uint8_t* const mark = marks.get() + r * vertices + begin;
      std::size_t count = 0;
      for (std::size_t v = 0; v < seen.size(); ++v) {
        const auto is_new = static_cast<std::uint8_t>(mark[v] & (seen[v] ^ 1U));
        seen[v] |= is_new;
        mark[v] = is_new;
        count += is_new;
      }
      counts[s * runs + r] = count;
    }
  });
  std::vector<std::size_t> first(runs + 1);
  for (std::size_t r = 0; r < runs; ++r) {
    first[r + 1] = first[r];
    for (std::size_t s = 0; s < slices; ++s) {
      first[r + 1] += counts[s * runs + r];
    }
  }

  std::vector<std::uint32_t> old_of_new;
  resize_big(old_of_new, first[runs]);
  const BigArray<std::uint32_t> new_of_old = make_big_array<std::uint32_t>(vertices);
  parallel_for(runs, threads, [&](std::size_t r) {
    std::uint8_t* const mark = marks.get() + r * vertices;
    auto next = static_cast<std::uint32_t>(first[r]);
    for (const Triangle& triangle : run(r)) {
      for (const std::uint32_t v : triangle) {
        if (mark[v] != 0) {
          mark[v] = 0;
          new_of_old[v] = next;
          old_of_new[next++] = v;
        }
      }
    }
  });
  parallel_slices(triangles.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (Triangle& triangle : triangles.subspan(begin, end - begin)) {
      triangle = {new_of_old[triangle[0]], new_of_old[triangle[1]], new_of_old[triangle[2]]};
    }
  });
  return old_of_new;
}

}  // namespace lustro
