// Where the frames of a turntable go: a folder of pictures, an animation, a film.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "image/animation.hpp"
#include "lustro/image.hpp"
#include "outputs.hpp"

namespace lustro::app {

struct FrameSink {
  std::function<Result<void>(const ByteImage&)> add;
  std::function<Result<std::vector<std::string>>()> finish;  ///< the names of what was written
};

/// The sink that the output's name asks for: .apng and .png, .webp, .gif, .mp4, or, without an extension, a folder of PNG.
/// errors  unsupported for another extension, for MP4 without ffmpeg; io where the place cannot be written to
[[nodiscard]] Result<FrameSink> make_frame_sink(const std::string& output, const AnimationOptions& options, const PngFlags& png);

}  // namespace lustro::app
