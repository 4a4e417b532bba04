// Numbers vertices by their first use in the triangles: neighbours on the surface become neighbours in memory, and what is unused falls out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lustro {

/// Renumbers the triangles' vertices in the order in which their corners name them first.
///
/// vertices  the triangles' indices are below it
/// returns   for each new vertex its old index; the same for any number of threads
[[nodiscard]] std::vector<std::uint32_t> number_by_first_use(std::span<std::array<std::uint32_t, 3>> triangles, std::size_t vertices,
                                                             int threads);

}  // namespace lustro
