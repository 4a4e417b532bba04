// Any bytes through the readers of PNG, EXR and PFM: a picture whose sizes fit together, or an error with a message.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "image/decode.hpp"
#include "image/pfm.hpp"
#include "image_checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lustro;
  const auto bytes = std::as_bytes(std::span(data, size));
  // A sound file of a few kilobytes may well state a gigabyte of black; here that would only cost time.
  constexpr ImageLimits kLimits{.pixels = 1 << 20, .chunk_bytes = 1 << 25};
  const auto image = decode_image(bytes, "input", Transfer::srgb, kLimits);
  check_image(image);
  if (image && format_of_content(bytes) == ImageFormat::pfm) {  // what was read can be written and read again
    const auto again = decode_pfm(encode_pfm(*image), "again");
    if (!again || again->width != image->width || again->height != image->height || again->channels != image->channels) {
      std::abort();
    }
  }
  return 0;
}
