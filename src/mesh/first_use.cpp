// Every thread marks the vertices of its own run of triangles; what earlier runs have marked is taken off; then the marks are numbered.
#include "mesh/first_use.hpp"

#include <algorithm>
#include <atomic>
#include <vector>

#include "parallel/slices.hpp"

namespace lustro {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// More runs would take more memory for their marks than the threads are worth.
constexpr std::size_t kMostRuns = 8;

}  // namespace

FirstUse number_by_first_use(std::span<const Triangle> triangles, std::size_t vertices, int threads) {
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

  // Marks that are new to their run, and how many there are in each slice of the vertices; behind the last run, those that nobody marked.
  const std::size_t slices = slice_count(vertices, threads);
  const auto slice_begin = [&](std::size_t s) { return vertices * s / slices; };
  std::vector<std::size_t> counts(slices * (runs + 1));
  FirstUse numbers;
  numbers.new_of_old = make_big_array<std::uint32_t>(vertices);
  constexpr std::uint32_t kUnused = 1;
  parallel_for(slices, threads, [&](std::size_t s) {
    const std::size_t begin = slice_begin(s);
    std::vector<std::uint8_t> seen(slice_begin(s + 1) - begin);
    for (std::size_t r = 0; r < runs; ++r) {
      std::uint8_t* const mark = marks.get() + r * vertices + begin;
      std::size_t count = 0;
      for (std::size_t v = 0; v < seen.size(); ++v) {
        const auto is_new = static_cast<std::uint8_t>(mark[v] & (seen[v] ^ 1U));
        seen[v] |= is_new;
        mark[v] = is_new;
        count += is_new;
      }
      counts[s * (runs + 1) + r] = count;
    }
    std::size_t unused = 0;
    for (std::size_t v = 0; v < seen.size(); ++v) {
      if (seen[v] == 0) {
        numbers.new_of_old[begin + v] = kUnused;
        ++unused;
      }
    }
    counts[s * (runs + 1) + runs] = unused;
  });
  std::vector<std::size_t> first(runs + 1);
  for (std::size_t r = 0; r < runs; ++r) {
    first[r + 1] = first[r];
    for (std::size_t s = 0; s < slices; ++s) {
      first[r + 1] += counts[s * (runs + 1) + r];
    }
  }
  numbers.used = first[runs];

  std::atomic<bool> is_sorted = true;
  if (numbers.used < vertices) {
    std::size_t next = numbers.used;
    for (std::size_t s = 0; s < slices; ++s) {
      for (std::size_t v = slice_begin(s); counts[s * (runs + 1) + runs] != 0 && v < slice_begin(s + 1); ++v) {
        if (numbers.new_of_old[v] == kUnused) {
          is_sorted = is_sorted && v == next;
          numbers.new_of_old[v] = static_cast<std::uint32_t>(next++);
        }
      }
    }
  }
  parallel_for(runs, threads, [&](std::size_t r) {
    std::uint8_t* const mark = marks.get() + r * vertices;
    auto next = static_cast<std::uint32_t>(first[r]);
    bool sorted = true;
    for (const Triangle& triangle : run(r)) {
      for (const std::uint32_t v : triangle) {
        if (mark[v] != 0) {
          mark[v] = 0;
          sorted &= v == next;
          numbers.new_of_old[v] = next++;
        }
      }
    }
    if (!sorted) {
      is_sorted = false;
    }
  });
  numbers.is_sorted = is_sorted;
  return numbers;
}

void renumber(std::span<Triangle> triangles, const FirstUse& numbers, int threads) {
  if (numbers.is_sorted) {
    return;
  }
  parallel_slices(triangles.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (Triangle& t : triangles.subspan(begin, end - begin)) {
      t = {numbers.new_of_old[t[0]], numbers.new_of_old[t[1]], numbers.new_of_old[t[2]]};
    }
  });
}

}  // namespace lustro
