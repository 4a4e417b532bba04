// Any bytes through the readers of PNG, EXR and PFM: a picture whose sizes fit together, or an error with a message.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "image/decode.hpp"
#include "image/pfm.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lustro;
  const auto bytes = std::as_bytes(std::span(data, size));
  // A sound file of a few kilobytes may well state a gigabyte of black; here that would only cost time.
  constexpr ImageLimits kLimits{.pixels = 1 << 20, .chunk_bytes = 1 << 25};
  const auto image = decode_image(bytes, "input", Transfer::srgb, kLimits);
  if (!image) {
    if (image.error().message.empty() || image.error().where.empty()) {
      std::abort();
    }
    return 0;
  }
  const std::size_t floats =
      static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height) * static_cast<std::size_t>(image->channels);
  if (image->width < 1 || image->height < 1 || floats != image->pixels.size()) {
    std::abort();
  }
  if (format_of_content(bytes) == ImageFormat::pfm) {  // what was read can be written and read again
    const auto again = decode_pfm(encode_pfm(*image), "again");
    if (!again || again->width != image->width || again->height != image->height || again->channels != image->channels) {
      std::abort();
    }
  }
  return 0;
}
