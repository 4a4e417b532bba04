// Radiance pictures (Greg Ward, Real Pixels, Graphics Gems II, 1991; the file format as Radiance's filefmts.pdf states it).
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "image/limits.hpp"
#include "lustro/image.hpp"

namespace lustro {

/// Linear RGB of an RGBE picture: mantissa 2^(exponent - 136), as most programs read it, without the half step that Radiance adds. Plain pixels,
/// old and new runs, any order of the axes. EXPOSURE, COLORCORR and PRIMARIES of the header are not applied.
/// errors  malformed with the byte offset; limit; unsupported for XYZE
[[nodiscard]] Result<Image> decode_hdr(std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits = {});

}  // namespace lustro
