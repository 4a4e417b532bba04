// Images to files: the format by the extension, the bytes by that format's encoder, the file whole or not at all.
#include <fmt/format.h>

#include <new>

#include "image/decode.hpp"
#include "image/exr.hpp"
#include "image/pfm.hpp"
#include "image/png.hpp"

namespace lustro {
namespace {

template <class AnyImage>
Result<void> check_image(const AnyImage& image) {
  const auto count = static_cast<std::int64_t>(image.pixels.size());
  if (image.width < 1 || image.height < 1 || image.channels < 1 || image.channels > 4 ||
      std::int64_t{image.width} * image.height * image.channels != count) {
    return fail(ErrorKind::usage, "",
                fmt::format("an image of {} x {} pixels and {} channels with {} values cannot be written", image.width, image.height,
                            image.channels, count));
  }
  return {};
}

Result<std::vector<std::byte>> encode(ImageFormat format, const Image& image, const WriteOptions& options) {
  switch (format) {
    case ImageFormat::png:
      return encode_png(image, options);
    case ImageFormat::exr:
      return encode_exr(image, {});
    case ImageFormat::pfm:
      return encode_pfm(image);
    case ImageFormat::jpeg:
    case ImageFormat::webp:
    case ImageFormat::tga:
    case ImageFormat::bmp:
    case ImageFormat::hdr:
    case ImageFormat::unknown:
      break;
  }
  return fail(ErrorKind::unsupported, "", "images are written as .png, .exr or .pfm");
}

/// Encodes, then writes; every error names the file.
template <class AnyImage, class Encode>
Result<void> encode_and_write(const std::filesystem::path& file, const AnyImage& image, Encode encode_bytes) {
  try {
    Result<std::vector<std::byte>> bytes = check_image(image).and_then(encode_bytes);
    if (!bytes) {
      return fail(bytes.error().kind, file.string(), bytes.error().message);
    }
    return write_file_atomically(file, *bytes);
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::limit, file.string(), "the encoded picture does not fit into memory");
  }
}

}  // namespace

Result<void> write_image(const std::filesystem::path& file, const Image& image, const WriteOptions& options) {
  return encode_and_write(file, image, [&] { return encode(format_of_name(file), image, options); });
}

Result<void> write_image(const std::filesystem::path& file, const ByteImage& image, const WriteOptions& options) {
  return encode_and_write(file, image, [&]() -> Result<std::vector<std::byte>> {
    if (format_of_name(file) != ImageFormat::png) {
      return fail(ErrorKind::unsupported, "", "a picture of bytes is written as .png");
    }
    return encode_png(image, options);
  });
}

Result<void> write_exr_layers(const std::filesystem::path& file, const Image& color, std::span<const Layer> layers) {
  return encode_and_write(file, color, [&] { return encode_exr(color, layers); });
}

}  // namespace lustro
