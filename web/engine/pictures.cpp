// Pictures of the formats that libraries read: in the page these are JavaScript's (web/src/engine/pictures.ts), asked for here. TGA, BMP, HDR
// and PFM are read by the library itself. Texels are the same bits as the command's.
#include <emscripten/val.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "image/decode_bytes.hpp"
#include "image/exr.hpp"
#include "image/file.hpp"
#include "image/jpeg.hpp"
#include "image/limits.hpp"
#include "image/png.hpp"
#include "image/srgb.hpp"
#include "image/webp.hpp"

namespace lustro {
namespace {

/// What JavaScript made of a picture: width x height x channels integers.
template <class Int>
struct Pixels {
  int width = 0, height = 0, channels = 0;
  std::vector<Int> values;
};

/// Module.decodePicture(format, bytes) gives {width, height, channels, depth, data} or {error}.
Result<emscripten::val> ask_page(const char* format, std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits) {
  using emscripten::val;
  const val view(emscripten::typed_memory_view(bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data())));  // NOLINT
  val picture = val::module_property("decodePicture")(std::string(format), view);
  if (const val error = picture["error"]; error.isString()) {
    return fail(ErrorKind::malformed, where, error.as<std::string>());
  }
  if (const auto done = check_image_size(picture["width"].as<int>(), picture["height"].as<int>(), where, limits); !done) {
    return tl::unexpected(done.error());
  }
  return picture;
}

template <class Int>
Pixels<Int> pixels_of(const emscripten::val& picture) {
  Pixels<Int> pixels{picture["width"].as<int>(), picture["height"].as<int>(), picture["channels"].as<int>(), {}};
  pixels.values.resize(static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height) *
                       static_cast<std::size_t>(pixels.channels));
  const emscripten::val target(emscripten::typed_memory_view(pixels.values.size(), pixels.values.data()));
  target.call<void>("set", picture["data"]);
  return pixels;
}

/// As image/png_read.cpp makes floats of 16 bits.
Image image_of_words(const Pixels<std::uint16_t>& words, Transfer transfer, AlphaForm alpha_form) {
  constexpr auto kMax = static_cast<float>(std::numeric_limits<std::uint16_t>::max());
  Image image(words.width, words.height, words.channels == 2 ? 4 : words.channels);
  const auto from_step = static_cast<std::size_t>(words.channels);
  const auto step = static_cast<std::size_t>(image.channels);
  const bool has_alpha = step == 4;
  for (std::size_t from = 0, to = 0; from < words.values.size(); from += from_step, to += step) {
    const float alpha = has_alpha ? static_cast<float>(words.values[from + from_step - 1]) / kMax : 1.0F;
    const float factor = alpha_form == AlphaForm::premultiplied && has_alpha ? alpha : 1.0F;
    for (std::size_t c = 0; c < std::min<std::size_t>(step, 3); ++c) {
      const float plain = static_cast<float>(words.values[from + (from_step < 3 ? 0 : c)]) / kMax;
      image.pixels[to + c] = (transfer == Transfer::srgb ? srgb_decode(plain) : plain) * factor;
    }
    if (has_alpha) {
      image.pixels[to + 3] = alpha;
    }
  }
  return image;
}

Result<ByteImage> bytes_from_page(const char* format, std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits) {
  const auto picture = ask_page(format, bytes, where, limits);
  if (!picture) {
    return tl::unexpected(picture.error());
  }
  return within_memory(where, [&]() -> Result<ByteImage> {
    Pixels<std::uint8_t> pixels = pixels_of<std::uint8_t>(*picture);
    return ByteImage{pixels.width, pixels.height, pixels.channels, std::move(pixels.values)};
  });
}

}  // namespace

Result<Image> decode_png(std::span<const std::byte> bytes, const std::string& where, Transfer transfer, const ImageLimits& limits,
                         AlphaForm alpha) {
  const auto picture = ask_page("png", bytes, where, limits);
  if (!picture) {
    return tl::unexpected(picture.error());
  }
  return within_memory(where, [&]() -> Result<Image> {
    if ((*picture)["depth"].as<int>() == 16) {
      return image_of_words(pixels_of<std::uint16_t>(*picture), transfer, alpha);
    }
    Pixels<std::uint8_t> pixels = pixels_of<std::uint8_t>(*picture);
    return image_of_bytes({pixels.width, pixels.height, pixels.channels, std::move(pixels.values)}, transfer, alpha);
  });
}

Result<ByteImage> decode_jpeg(std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits) {
  return bytes_from_page("jpeg", bytes, where, limits);
}

Result<ByteImage> decode_webp(std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits) {
  return bytes_from_page("webp", bytes, where, limits);
}

Result<Image> decode_exr(std::span<const std::byte> /*bytes*/, const std::string& where, const ImageLimits& /*limits*/) {
  return fail(ErrorKind::unsupported, where, "is an EXR file, which the page does not read: Radiance HDR is read, and the command reads both");
}

Result<std::vector<std::byte>> read_file_bytes(const std::filesystem::path& file,
                                               const std::function<Result<void>(std::span<const std::byte>)>& /*accept*/) {
  return fail(ErrorKind::unsupported, file.string(), "the page reads no such files");
}

Result<void> write_file_atomically(const std::filesystem::path& file, std::span<const std::byte> /*bytes*/) {
  return fail(ErrorKind::unsupported, file.string(), "the page writes no files");
}

}  // namespace lustro
