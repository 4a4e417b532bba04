// Our side of every comparison of frames: the subject turns, and each frame goes from the mesh to bytes in memory.
#pragma once

#include "common/subjects.hpp"
#include "lustro/render.hpp"

namespace lustro::bench {

/// Draws frames of a scene with one renderer. Throws std::runtime_error where a scene cannot be drawn.
class OurFrames {
 public:
  OurFrames(const Subject& subject, Scene scene, int threads = 0);
  /// Leaves out the faces that look away, or lights both sides.
  void cull(bool culls);
  /// Frame `i` of the turn.
  const Rendering& draw(int i);

 private:
  const Subject& subject_;
  Scene scene_;
  RenderOptions options_;
  Renderer renderer_;
  Rendering picture_;
};

/// Share of pixels in which a channel of the colour differs by more than 2/255. Equal sizes, RGBA.
[[nodiscard]] double share_that_differs(const ByteImage& a, const ByteImage& b);

}  // namespace lustro::bench
