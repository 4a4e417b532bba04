// From linear, premultiplied floats to the integers that a PNG stores.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "image/tone.hpp"
#include "lustro/image.hpp"

namespace lustro {

/// The 8-bit values of all pixels, interleaved: divided by alpha (the last of 2 or 4 channels), toned, encoded, rounded. Alpha itself is only
/// rounded. Where alpha is 0 the colour is 0. threads  0: one a core
[[nodiscard]] std::vector<std::uint8_t> stored8(const Image& image, Transfer transfer, const Tone& tone = {}, int threads = 0);

/// The same in 16 bits, in the machine's byte order.
[[nodiscard]] std::vector<std::uint16_t> stored16(const Image& image, Transfer transfer, const Tone& tone = {}, int threads = 0);

/// The 8-bit values of one pixel of RGBA.
void store_pixel8(const std::array<float, 4>& pixel, Transfer transfer, const Toning& toning, std::array<std::uint8_t, 4>& out);

}  // namespace lustro
