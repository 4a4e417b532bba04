// The one path from a float pixel to stored integers, for both widths.
#include "image/store.hpp"

#include <algorithm>

#include "image/srgb.hpp"
#include "parallel/parallel_for.hpp"

namespace lustro {
namespace {

template <class Int, class Quantize>
std::vector<Int> stored(const Image& image, Transfer transfer, Quantize quantize) {
  const auto channels = static_cast<std::size_t>(image.channels);
  const bool has_alpha = channels == 2 || channels == 4;
  const std::size_t colors = has_alpha ? channels - 1 : channels;
  const auto row_length = static_cast<std::size_t>(image.width) * channels;
  std::vector<Int> out(image.pixels.size());
  parallel_for(static_cast<std::size_t>(image.height), 0, [&](std::size_t y) {
    for (std::size_t i = y * row_length; i < (y + 1) * row_length; i += channels) {
      const float alpha = has_alpha ? image.pixels[i + colors] : 1.0F;
      const float divisor = std::min(alpha, 1.0F);  // more than full coverage is full coverage
      for (std::size_t c = 0; c < colors; ++c) {
        const float color = alpha > 0 ? image.pixels[i + c] / divisor : 0.0F;
        out[i + c] = quantize(transfer == Transfer::srgb ? srgb_encode(color) : color);
      }
      if (has_alpha) {
        out[i + colors] = quantize(alpha);
      }
    }
  });
  return out;
}

}  // namespace

std::vector<std::uint8_t> stored8(const Image& image, Transfer transfer) {
  return stored<std::uint8_t>(image, transfer, quantize8);
}

std::vector<std::uint16_t> stored16(const Image& image, Transfer transfer) {
  return stored<std::uint16_t>(image, transfer, quantize16);
}

ByteImage to_bytes(const Image& image, Transfer transfer) {
  return {.width = image.width, .height = image.height, .channels = image.channels, .pixels = stored8(image, transfer)};
}

}  // namespace lustro
