// Welding: positions that are the same point get one index. STL repeats every position in every facet, so its faces touch only after this.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lustro/vec.hpp"

namespace lustro {

/// For every position the index of the first one that is the same point, so that result[i] <= i and result[result[i]] == result[i].
///
/// positions  V x 3; at most 2^32 - 2; one that is not finite is welded with nothing
/// tolerance  0: equal coordinates (-0 equals 0). Else the largest distance to the first point, object space. A point that lies near
///            several first points takes the earliest one, so the result depends on the order but never on a hash. Expected time is linear
/// threads    0: one a core, for equal coordinates; the result is the same for any number
[[nodiscard]] std::vector<std::uint32_t> weld_positions(std::span<const Vec3f> positions, double tolerance = 0, int threads = 0);

}  // namespace lustro
