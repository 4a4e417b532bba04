// Bytes to floats by a table of 256 entries.
#include "image/decode_bytes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "image/srgb.hpp"

namespace lustro {

Image image_of_bytes(const ByteImage& bytes, Transfer transfer, AlphaForm alpha_form) {
  std::array<float, 256> linear{};
  std::array<float, 256> plain{};
  for (std::size_t i = 0; i < plain.size(); ++i) {
    plain[i] = static_cast<float>(i) / 255.0F;
    linear[i] = transfer == Transfer::srgb ? srgb_decode(plain[i]) : plain[i];
  }
  const auto from_step = static_cast<std::size_t>(bytes.channels);
  const bool has_alpha = from_step == 2 || from_step == 4;
  Image image(bytes.width, bytes.height, has_alpha ? 4 : bytes.channels);
  const auto to_step = static_cast<std::size_t>(image.channels);
  for (std::size_t from = 0, to = 0; from < bytes.pixels.size(); from += from_step, to += to_step) {
    const float alpha = has_alpha ? plain[bytes.pixels[from + from_step - 1]] : 1.0F;
    const float factor = alpha_form == AlphaForm::premultiplied ? alpha : 1.0F;
    for (std::size_t c = 0; c < std::min<std::size_t>(to_step, 3); ++c) {
      image.pixels[to + c] = linear[bytes.pixels[from + (from_step == 2 ? 0 : c)]] * factor;
    }
    if (has_alpha) {
      image.pixels[to + 3] = alpha;
    }
  }
  return image;
}

void unpremultiply(Image& image) {
  if (image.channels != 4) {
    return;
  }
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    const float alpha = image.pixels[i + 3];
    for (std::size_t c = 0; c < 3; ++c) {
      image.pixels[i + c] = alpha == 0 ? 0.0F : image.pixels[i + c] / alpha;
    }
  }
}

void drop_empty_alpha(ByteImage& image) {
  if (image.channels != 2 && image.channels != 4) {
    return;
  }
  const auto step = static_cast<std::size_t>(image.channels);
  for (std::size_t i = step - 1; i < image.pixels.size(); i += step) {
    if (image.pixels[i] != 0) {
      return;
    }
  }
  std::size_t to = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    if (i % step != step - 1) {
      image.pixels[to++] = image.pixels[i];
    }
  }
  image.pixels.resize(to);
  --image.channels;
}

std::string at_picture_byte(const std::string& where, std::size_t offset) {
  return fmt::format("{}: byte {}", where, offset);
}

}  // namespace lustro
