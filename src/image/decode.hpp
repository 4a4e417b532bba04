// An image file's bytes to floats, whatever its format.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "image/limits.hpp"
#include "lustro/image.hpp"

namespace lustro {

enum class ImageFormat { unknown, png, exr, pfm };

/// What the first bytes of a file say.
[[nodiscard]] ImageFormat format_of_content(std::span<const std::byte> head);

/// What the end of a name says: .png, .exr, .pfm in any case.
[[nodiscard]] ImageFormat format_of_name(const std::filesystem::path& file);

/// A PNG, EXR or PFM file by its content; where that says nothing, the error follows the extension of `where`.
[[nodiscard]] Result<Image> decode_image(std::span<const std::byte> bytes, const std::string& where, Transfer transfer,
                                         const ImageLimits& limits = {});

}  // namespace lustro
