// What arrives at a point of the lights and of all that surrounds it: the factors of the lighting equation that look beyond the surface.
#pragma once

#include <vector>

#include "lustro/vec.hpp"
#include "reference/face.hpp"

namespace lustro {

/// v of each light, and a in the place after them; 1 where there are no shadows, or no occlusion.
///
/// position  relative to the eye
/// normal    N, unit, on the side that is lit
[[nodiscard]] std::vector<float> visibilities_at(const Face& face, const Vec3f& position, const Vec3f& normal);

}  // namespace lustro
