// How much of a kind a mesh may hold.
#pragma once

#include <cstddef>

namespace lustro {

/// Most positions, normals, uvs, faces or corners: indices are 32 bits wide, and the highest value means `none`.
inline constexpr std::size_t kMostElements = 0xFFFFFFFEU;

/// Most materials: nine bytes state one, and it takes hundreds in memory.
inline constexpr std::size_t kMostMaterials = std::size_t{1} << 20U;

}  // namespace lustro
