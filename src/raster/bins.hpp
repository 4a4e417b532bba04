// Which clusters may be seen, and in which tiles.
#pragma once

#include "raster/frame.hpp"

namespace lustro {

/// Fills the frame's clusters, loose triangles and the tiles' lists from its scene. The frame's other members are set before.
void sort_into_tiles(Frame& frame, int threads);

}  // namespace lustro
