// The numbers of an accessor, whatever their type, stride and sparseness.
#pragma once

#include <cstdint>
#include <vector>

#include "io/gltf_file.hpp"

namespace lustro {

/// count x components floats; normalised integers as 0..1 or -1..1, matrices column by column.
/// errors  malformed where sparse indices are not; limit
[[nodiscard]] Result<std::vector<float>> read_floats(GltfFile& file, std::uint32_t index);

/// count x components whole numbers. Not for floats.
[[nodiscard]] Result<std::vector<std::uint32_t>> read_whole(GltfFile& file, std::uint32_t index);

/// to[i] += weight * value i. Where all but sparse values are 0, only those are touched.
/// to  count x components
[[nodiscard]] Result<void> add_weighted(GltfFile& file, std::uint32_t index, double weight, std::vector<double>& to);

}  // namespace lustro
