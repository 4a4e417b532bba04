// JPEG pictures (ITU-T T.81; JFIF), read by libjpeg-turbo.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "image/limits.hpp"
#include "lustro/image.hpp"

namespace lustro {

/// Baseline and progressive JPEG: one channel for gray, three for colour, also from CMYK and YCCK (ink over white, without a profile). The
/// pixels stand as they are stored: the orientation that a camera's EXIF data may state is not applied, and no profile is.
/// errors  malformed, also for a file that ends too early; limit; unsupported for 12 bits and lossless JPEG, and in a build without libjpeg
[[nodiscard]] Result<ByteImage> decode_jpeg(std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits = {});

}  // namespace lustro
