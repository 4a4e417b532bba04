// An image file's bytes to floats, whatever its format.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "image/decode_bytes.hpp"
#include "image/limits.hpp"
#include "lustro/image.hpp"

namespace lustro {

enum class ImageFormat { unknown, png, exr, pfm, jpeg, webp, tga, bmp, hdr };

/// What the first bytes of a file say. A TGA file has none that tell.
[[nodiscard]] ImageFormat format_of_content(std::span<const std::byte> head);

/// What the end of a name says, in any case: .png, .exr, .pfm, .jpg (.jpeg, .jpe, .jfif), .webp, .tga (.icb, .vda, .vst), .bmp (.dib), .hdr
/// (.pic, .rgbe).
[[nodiscard]] ImageFormat format_of_name(const std::filesystem::path& file);

/// An image file of any format by its content; TGA by the last bytes that its newer files have, or by the extension of `where`. Where all that
/// says nothing, so does the error.
[[nodiscard]] Result<Image> decode_image(std::span<const std::byte> bytes, const std::string& where, Transfer transfer,
                                         const ImageLimits& limits = {}, AlphaForm alpha = AlphaForm::premultiplied);

}  // namespace lustro
