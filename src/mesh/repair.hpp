// Values that cannot be drawn are replaced, in parallel; each function returns how many there were.
#pragma once

#include <cstddef>
#include <vector>

#include "lustro/vec.hpp"

namespace lustro {

/// Colours that are not finite become white.
std::size_t whiten(std::vector<Vec3f>& colors, int threads);

/// Texture coordinates that are not finite become (0, 0).
std::size_t replace_uvs(std::vector<Vec2f>& uvs, int threads);

/// Normals become unit vectors; those that cannot become (0, 0, 0).
std::size_t normalize_normals(std::vector<Vec3f>& normals, int threads);

}  // namespace lustro
