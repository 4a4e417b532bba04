// What the encoders of animations share.
#include "image/animation.hpp"

#include <fmt/format.h>

namespace lustro {

Result<void> check_frame(const AnimationOptions& options, const ByteImage& frame, int index) {
  const std::size_t bytes = static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height) * 4;
  if (frame.width != options.width || frame.height != options.height || frame.channels != 4 || frame.pixels.size() != bytes) {
    return fail(ErrorKind::usage, "",
                fmt::format("frame {} has {} x {} pixels of {} channels, and the animation {} x {} of 4", index, frame.width, frame.height,
                            frame.channels, options.width, options.height));
  }
  if (index >= options.frames) {
    return fail(ErrorKind::usage, "", fmt::format("the animation has {} frames, and one more was added", options.frames));
  }
  return {};
}

}  // namespace lustro
