// Colours that tell numbers apart.
#pragma once

#include "lustro/vec.hpp"

namespace lustro {

/// The colour of an object, a material or a triangle by its index; 0..1, to be stored as it stands. Black where the index is negative or no
/// number.
[[nodiscard]] Vec3f id_color(float id);

}  // namespace lustro
