// Any bytes through the readers of JPEG, WebP, TGA, BMP and Radiance pictures, and as textures through all the others: a picture whose sizes fit
// together, or an error with a message. TGA has no mark of its own: what is nothing else is read as one.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "image/decode_texture.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lustro;
  const auto bytes = std::as_bytes(std::span(data, size));
  constexpr ImageLimits kLimits{.side = 512, .pixels = 1 << 14, .chunk_bytes = 1 << 22};
  const auto image = decode_texture_image(bytes, "input.tga", TextureContent::color, Transfer::srgb, kLimits);
  if (!image) {
    if (image.error().message.empty() || image.error().where.empty()) {
      std::abort();
    }
    return 0;
  }
  const std::size_t floats =
      static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height) * static_cast<std::size_t>(image->channels);
  const bool has_channels = image->channels == 1 || image->channels == 3 || image->channels == 4;
  if (image->width < 1 || image->height < 1 || !has_channels || floats != image->pixels.size()) {
    std::abort();
  }
  return 0;
}
