// What the lights see, by the reference's own pixels.
#pragma once

#include "scene/prepare.hpp"

namespace lustro {

/// Draws the maps' keys.
void draw_depth_maps(const PreparedScene& scene, DepthMaps& maps, int threads);

}  // namespace lustro
