// An image file's bytes to the values of a texture.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "image/limits.hpp"
#include "lustro/image.hpp"
#include "lustro/options.hpp"
#include "lustro/texture.hpp"

namespace lustro {

/// A picture of any format that decode_image() knows as straight (not premultiplied) linear floats, the top row first.
///
/// content   color: 8 and 16 bits are decoded by `transfer`; data: they are divided by their largest value, whatever `transfer` says. Floats
///           (EXR, HDR, PFM) stand as they are
/// where     the file, for messages and, of TGA, for its extension
/// errors    malformed, limit, unsupported; unsupported always where the core stands alone, without readers of image files
[[nodiscard]] Result<Image> decode_texture_image(std::span<const std::byte> bytes, const std::string& where, TextureContent content,
                                                 Transfer transfer, const ImageLimits& limits = {});

}  // namespace lustro
