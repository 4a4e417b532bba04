// The WebP reader: sizes are asked for and checked first, then libwebp writes into our memory. It asks less of a file's end than we do: what the
// RIFF header states must be there.
#include "image/webp.hpp"

#include <fmt/format.h>

#include "image/byte_reader.hpp"
#include "image/decode_bytes.hpp"

#ifdef LUSTRO_HAS_WEBP
#include <webp/decode.h>
#endif

namespace lustro {

#ifdef LUSTRO_HAS_WEBP

Result<ByteImage> decode_webp(std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits) {
  const std::size_t stated = std::size_t{ByteReader(bytes).u32(4)} + 8;
  if (bytes.size() < 12 || bytes.size() < stated) {
    return fail(ErrorKind::malformed, at_picture_byte(where, bytes.size()),
                fmt::format("the WebP file ends here, and its header states {} bytes", stated));
  }
  const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  WebPBitstreamFeatures features{};
  if (WebPGetFeatures(data, bytes.size(), &features) != VP8_STATUS_OK) {
    return fail(ErrorKind::malformed, where, "the header of the WebP file is broken");
  }
  if (features.has_animation != 0) {
    return fail(ErrorKind::unsupported, where, "is an animated WebP file, and a single picture was expected");
  }
  if (auto ok = check_image_size(features.width, features.height, where, limits); !ok) {
    return tl::unexpected(std::move(ok).error());
  }
  return within_memory(where, [&]() -> Result<ByteImage> {
    ByteImage image{features.width, features.height, features.has_alpha != 0 ? 4 : 3, {}};
    const std::size_t row = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
    image.pixels.resize(row * static_cast<std::size_t>(image.height));
    const auto decode = image.channels == 4 ? WebPDecodeRGBAInto : WebPDecodeRGBInto;
    if (decode(data, bytes.size(), image.pixels.data(), image.pixels.size(), static_cast<int>(row)) == nullptr) {
      return fail(ErrorKind::malformed, where, "the data of the WebP file is broken");
    }
    return image;
  });
}

#else

Result<ByteImage> decode_webp(std::span<const std::byte>, const std::string& where, const ImageLimits&) {
  return fail(ErrorKind::unsupported, where, "is a WebP file, and this build reads none: it was made without libwebp (Debian: libwebp-dev)");
}

#endif

}  // namespace lustro
