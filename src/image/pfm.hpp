// Portable float maps (Paul Debevec): a text header, then raw floats, the bottom row first.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "image/limits.hpp"
#include "lustro/image.hpp"

namespace lustro {

/// `PF` for colour, `Pf` for one channel, little endian. The format has no alpha: what is written is the picture over black, which for
/// premultiplied colours are the colours themselves.
[[nodiscard]] std::vector<std::byte> encode_pfm(const Image& image);

/// Either byte order; 1 or 3 channels; multiplied by the absolute value of the header's scale.
/// errors  malformed with the byte offset; limit
[[nodiscard]] Result<Image> decode_pfm(std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits = {});

}  // namespace lustro
