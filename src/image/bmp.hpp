// Windows bitmaps (Microsoft, Bitmap Storage; OS/2's first and second headers).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image/limits.hpp"
#include "lustro/image.hpp"

namespace lustro {

/// 1, 2, 4, 8, 16, 24 and 32 bits, RLE4 and RLE8, bit fields, upwards and downwards. Three channels, four where the header states a mask for
/// alpha and it is not 0 everywhere; the fourth byte of plain 32 bits means nothing.
/// errors  malformed with the byte offset; limit; unsupported for other headers and for JPEG, PNG and fax data inside
[[nodiscard]] Result<ByteImage> decode_bmp(std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits = {});

/// Unpacks RLE8 or RLE4 (bits: 8 or 4) to one colour index a pixel, the rows in the file's order. Pixels that are left out are 0.
/// begin   where the packed bytes begin in `bytes`, for messages
/// errors  malformed where data or its end mark is missing, or lies outside of the picture
[[nodiscard]] Result<std::vector<std::uint8_t>> unpack_bmp_runs(std::span<const std::byte> bytes, std::size_t begin, int width, int height,
                                                                int bits, const std::string& where);

}  // namespace lustro
