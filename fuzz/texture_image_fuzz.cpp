// Any bytes through the readers of JPEG, WebP, TGA, BMP and Radiance pictures, and as textures through all the others: a picture whose sizes fit
// together, or an error with a message. TGA has no mark of its own: what is nothing else is read as one.
#include <cstddef>
#include <cstdint>
#include <span>

#include "image/decode_texture.hpp"
#include "image_checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lustro;
  const auto bytes = std::as_bytes(std::span(data, size));
  constexpr ImageLimits kLimits{.side = 512, .pixels = 1 << 14, .chunk_bytes = 1 << 22};
  const auto image = decode_texture_image(bytes, "input.tga", TextureContent::color, Transfer::srgb, kLimits);
  check_image(image);
  return 0;
}
