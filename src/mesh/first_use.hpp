// Numbers vertices by their first use in the triangles: neighbours on the surface become neighbours in memory, and what is unused stands last.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "parallel/big_memory.hpp"

namespace lustro {

struct FirstUse {
  BigArray<std::uint32_t> new_of_old;  ///< one a vertex; those that no triangle names are the last ones, in their order
  std::size_t used = 0;
  bool is_sorted = false;  ///< every vertex keeps its number
};

/// The numbers of vertices in the order in which the triangles' corners name them first; the same for any number of threads.
/// vertices  the triangles' indices are below it
[[nodiscard]] FirstUse number_by_first_use(std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t vertices, int threads);

/// Gives the triangles' corners those numbers.
void renumber(std::span<std::array<std::uint32_t, 3>> triangles, const FirstUse& numbers, int threads);

}  // namespace lustro
