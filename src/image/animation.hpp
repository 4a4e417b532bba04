// Pictures that follow each other in one file: APNG, animated WebP, GIF. One encoder a kind, one frame at a time.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "lustro/image.hpp"

namespace lustro {

/// What all frames have in common.
struct AnimationOptions {
  int width = 0, height = 0;
  int frames = 0;  ///< so many will be added
  double frames_per_second = 30;
  bool has_alpha = false;  ///< false: the frames' alpha is left out
  Transfer transfer = Transfer::srgb;
  int quality = 90;  ///< WebP: 0..99; 100 is without loss
  int threads = 0;   ///< of APNG
};

/// The frames play without end.
struct AnimationEncoder {
  /// Takes the next frame: four channels, of the animation's size.
  /// errors  usage for another size or one frame too many; limit for memory; io never
  std::function<Result<void>(const ByteImage&)> add;
  /// The whole file, when all frames are in.
  std::function<Result<std::vector<std::byte>>()> finish;
};

/// APNG (W3C PNG 3rd edition, 4.9): every frame is the part of the picture that has changed. Without loss; shows as a still picture where
/// animations are not known.
[[nodiscard]] Result<AnimationEncoder> make_apng_encoder(const AnimationOptions& options);

/// Animated WebP, by libwebp.
/// errors  unsupported in a build without it; limit above 16383 pixels a side
[[nodiscard]] Result<AnimationEncoder> make_webp_encoder(const AnimationOptions& options);

/// GIF89a, by giflib: one table of at most 256 colours for all frames, ordered dithering between them, so that what stands still looks still.
/// Alpha is all or nothing.
/// errors  unsupported in a build without it; usage above 50 frames a second, which viewers do not show
[[nodiscard]] Result<AnimationEncoder> make_gif_encoder(const AnimationOptions& options);

/// errors  usage for a frame that is not of the animation's size, four channels
[[nodiscard]] Result<void> check_frame(const AnimationOptions& options, const ByteImage& frame, int index);

}  // namespace lustro
