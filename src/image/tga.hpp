// Truevision TGA (Truevision, TGA file format specification 2.0, 1989-1991).
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "image/limits.hpp"
#include "lustro/image.hpp"

namespace lustro {

/// Whether the file ends as TGA 2.0 asks; the first bytes of a TGA file say nothing.
[[nodiscard]] bool has_tga_footer(std::span<const std::byte> bytes);

/// Types 1, 2, 3, 9, 10 and 11: palette, colour and gray, plain and packed, of 8, 15, 16, 24 and 32 bits, from any corner. One channel for gray,
/// two for gray of 16 bits (gray and alpha), three for colour, four with alpha.
///
/// Alpha is what 32 bits have, and 16 where the descriptor says so, unless the extension area calls it undefined (attributes types 0 to 2) or it
/// is 0 everywhere. Premultiplied colours (type 4) are divided by it.
/// errors  malformed with the byte offset, limit, unsupported
[[nodiscard]] Result<ByteImage> decode_tga(std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits = {});

}  // namespace lustro
