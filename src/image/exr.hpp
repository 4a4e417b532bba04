// OpenEXR files: float, linear, alpha premultiplied, as the format itself says.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "image/limits.hpp"
#include "lustro/image.hpp"

namespace lustro {

/// A whole EXR file: 32-bit float channels `Y`, `R G B`, with `A` where the image has alpha, and each layer's as NAME.CHANNEL. Scan lines, ZIP
/// compression at a fixed level, no date and no program name: equal pixels give equal bytes. A layer's labels are the `stringvector` attribute
/// NAME.labels.
/// errors  usage where a layer does not fit to the picture or a name cannot stand in a file
[[nodiscard]] Result<std::vector<std::byte>> encode_exr(const Image& color, std::span<const Layer> layers);

/// The picture of an EXR file (the first part of several): R, G, B and A, or Y and A, or the only channel there is, from half, float or uint;
/// other channels and layers are ignored. Where the data window is not the display window the picture is the display window, empty where there
/// is no data. errors  malformed, limit, unsupported (deep pixels, subsampled channels, no colour among several channels)
[[nodiscard]] Result<Image> decode_exr(std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits = {});

/// Walks the headers of an EXR file without taking memory, so that OpenEXR itself never sees sizes that the file cannot hold.
/// errors  malformed with the byte offset, limit, unsupported
[[nodiscard]] Result<void> check_exr_headers(std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits);

}  // namespace lustro
