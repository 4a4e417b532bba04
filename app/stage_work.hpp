// The least that each stage of a picture has to do: bytes that must move, operations that the equation asks for. A model, stated here, to hold
// the measured times against.
#pragma once

#include <cstdint>

#include "lustro/scene.hpp"

namespace lustro::app {

/// What one picture consists of.
struct FrameFacts {
  std::uint64_t triangles = 0;
  std::uint64_t vertices = 0;
  std::uint64_t pixels = 0;
  std::uint64_t pixels_covered = 0;
  int lights = 0;
  Shading shading;
};

struct StageWork {
  double bytes = 0;
  double operations = 0;  ///< multiplications, additions, divisions and square roots, each counted once
};

/// Every mesh is read in pieces of 128 triangles, each described by a sphere, a box and a cone in one cache line that is tested.
[[nodiscard]] StageWork cull_work(const FrameFacts& facts);
/// Every vertex (12 bytes) and every triangle (4 bytes) is read once, transformed once, set up once; each covered pixel is tested once. What a
/// renderer culls it need not read, so that it may go below this.
[[nodiscard]] StageWork visibility_work(const FrameFacts& facts);
/// Each covered pixel is lit once by every light; 4 bytes are written for every pixel.
[[nodiscard]] StageWork shading_work(const FrameFacts& facts);

}  // namespace lustro::app
