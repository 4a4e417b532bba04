// PNG (W3C, Portable Network Graphics, 3rd edition): written by ourselves, read by libspng.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "image/decode_bytes.hpp"
#include "image/limits.hpp"
#include "lustro/image.hpp"

namespace lustro {

/// A whole PNG file. One channel gives gray, three give RGB; two and four have alpha, which is left out where its stored value is the largest
/// one everywhere. `srgb` is marked by an sRGB chunk; with `none` there is no such chunk, because then the values are numbers or the classic
/// unmanaged colours, for neither of which a gamma could be stated truly. No timestamp, nothing that depends on the threads: equal images give
/// equal bytes. The image has a size and as many values as that takes. errors  usage where bits or level are out of range
[[nodiscard]] Result<std::vector<std::byte>> encode_png(const Image& image, const WriteOptions& options);

/// The same of the bytes that to_bytes() makes: both give the same file. errors  usage, also for other than 8 bits
///
/// keep_alpha   writes an alpha that is the largest everywhere, too: the parts of an animation must be of one kind
[[nodiscard]] Result<std::vector<std::byte>> encode_png(const ByteImage& image, const WriteOptions& options, bool keep_alpha = false);

/// Any PNG: gray of 1 to 16 bits, palette, RGB, alpha, tRNS, interlaced. One channel for opaque gray, three for opaque colour, four with alpha.
/// Values are decoded by `transfer`; gAMA and iCCP chunks are not applied. errors  malformed, limit
[[nodiscard]] Result<Image> decode_png(std::span<const std::byte> bytes, const std::string& where, Transfer transfer,
                                       const ImageLimits& limits = {}, AlphaForm alpha = AlphaForm::premultiplied);

}  // namespace lustro
