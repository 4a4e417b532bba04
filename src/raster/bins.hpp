// Which clusters may be seen, and in which tiles.
#pragma once

#include <cstdint>
#include <vector>

#include "raster/frame.hpp"

namespace lustro {

/// Tiles, bounds included.
struct TileRange {
  int left, top, right, bottom;
};

/// What sorting works with, used again from picture to picture.
struct BinWork {
  /// A stretch of an instance's clusters, and what of it may be seen.
  struct Part {
    std::uint32_t instance = 0;
    std::uint32_t first = 0, last = 0;
    std::vector<VisibleCluster> clusters;
    std::vector<TileRange> ranges;  ///< of `clusters`
    std::vector<ScreenTriangle> loose;
  };
  std::vector<Part> parts;  ///< the first `used` are the picture's
  std::size_t used = 0;
  std::vector<TileRange> ranges;  ///< of the frame's clusters
};

/// The tiles of the scene's picture, and whose its materials are.
/// tile  pixels a side of a picture with one sample a pixel
void lay_out_geometry(Frame& frame, const PreparedScene& scene, int tile = 64);

/// Fills the frame's clusters, loose triangles and the tiles' lists from its scene. The frame's other members are set before.
void sort_into_tiles(Frame& frame, BinWork& work, int threads);

}  // namespace lustro
