// WebP pictures, read by libwebp. (Animations are written by animation_webp.cpp.)
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "image/limits.hpp"
#include "lustro/image.hpp"

namespace lustro {

/// Lossy and lossless WebP; three channels, four with alpha.
/// errors  malformed, limit; unsupported for animations, and in a build without libwebp
[[nodiscard]] Result<ByteImage> decode_webp(std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits = {});

}  // namespace lustro
