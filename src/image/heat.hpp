// A colour scale for errors: from black over violet and orange to a pale yellow, ever lighter, so that it also reads in grayscale.
#pragma once

#include "lustro/vec.hpp"

namespace lustro {

/// The linear colour of t, clamped to 0..1; NaN is 0.
[[nodiscard]] Vec3f heat_color(float t);

}  // namespace lustro
