// Loops over slices of an index range, for work that is too small a step at a time.
#pragma once

#include <algorithm>
#include <cstddef>

#include "parallel/parallel_for.hpp"

namespace lustro {

/// Fewer steps than these are not worth a second thread.
inline constexpr std::size_t kSmallestSlice = 16384;

/// How many slices of at least `least` steps a loop is cut into: a few a thread, so that an unlucky thread does not hold up the others.
[[nodiscard]] inline std::size_t slice_count(std::size_t count, int threads, std::size_t least = kSmallestSlice) {
  const std::size_t most = count / std::max<std::size_t>(least, 1);
  return most < 2 || threads == 1 ? 1 : std::min(most, 4 * thread_count(threads));
}

/// Calls body(begin, end) for slices that cover 0..count-1, at the same time and in any order; not at all where there is nothing.
template <class Body>
void parallel_slices(std::size_t count, int threads, const Body& body, std::size_t least = kSmallestSlice) {
  if (count == 0) {
    return;
  }
  const std::size_t slices = slice_count(count, threads, least);
  if (slices == 1) {
    body(std::size_t{0}, count);
    return;
  }
  parallel_for(slices, threads, [&](std::size_t slice) { body(count * slice / slices, count * (slice + 1) / slices); });
}

}  // namespace lustro
