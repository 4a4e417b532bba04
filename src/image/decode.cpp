// Telling image formats apart, and reading a file of any of them.
#include "image/decode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <string_view>

#include "image/bmp.hpp"
#include "image/decode_texture.hpp"
#include "image/exr.hpp"
#include "image/file.hpp"
#include "image/hdr.hpp"
#include "image/jpeg.hpp"
#include "image/lower_case.hpp"
#include "image/pfm.hpp"
#include "image/png.hpp"
#include "image/tga.hpp"
#include "image/webp.hpp"

namespace lustro {
namespace {

struct Kind {
  ImageFormat format;
  std::string_view what;    ///< `is no ...`
  std::string_view begins;  ///< `it does not begin with ...`
  std::array<std::string_view, 4> extensions;
};

constexpr std::array<Kind, 8> kKinds{{
    {ImageFormat::png, "PNG file", "the PNG signature", {".png"}},
    {ImageFormat::exr, "EXR file", "the number 20000630", {".exr"}},
    {ImageFormat::pfm, "PFM file", "`PF` or `Pf`", {".pfm"}},
    {ImageFormat::jpeg, "JPEG file", "the bytes FF D8 FF", {".jpg", ".jpeg", ".jpe", ".jfif"}},
    {ImageFormat::webp, "WebP file", "`RIFF` and `WEBP`", {".webp"}},
    {ImageFormat::tga, "TGA file", "a header of one", {".tga", ".icb", ".vda", ".vst"}},
    {ImageFormat::bmp, "bitmap", "`BM` and a header", {".bmp", ".dib"}},
    {ImageFormat::hdr, "Radiance picture", "`#?`", {".hdr", ".pic", ".rgbe"}},
}};

/// Formats that are known by their first bytes, so that the message can say what was found.
struct Stranger {
  std::string_view begins;
  std::string_view what;
};

constexpr std::array<Stranger, 9> kStrangers{{
    {"GIF8", "a GIF file"},
    {"DDS ", "a DDS file"},
    {"\xABKTX", "a KTX file"},
    {std::string_view("II*\0", 4), "a TIFF file"},
    {std::string_view("MM\0*", 4), "a TIFF file"},
    {"8BPS", "a Photoshop file"},
    {std::string_view("\0\0\0\x0CjP  ", 8), "a JPEG 2000 file"},
    {"\xFF\x0A", "a JPEG XL file"},
    {"gimp xcf", "a GIMP file"},
}};

bool begins_with(std::span<const std::byte> head, std::string_view magic) {
  return head.size() >= magic.size() && std::memcmp(head.data(), magic.data(), magic.size()) == 0;
}

constexpr std::string_view kRead = "PNG, JPEG, WebP, TGA, BMP, Radiance HDR, EXR and PFM are read";

Error not_an_image(std::span<const std::byte> head, const std::string& where) {
  for (const Stranger& stranger : kStrangers) {
    if (begins_with(head, stranger.begins)) {
      return {ErrorKind::unsupported, where, fmt::format("is {}: {}", stranger.what, kRead)};
    }
  }
  const ImageFormat named = format_of_name(where);
  for (const Kind& kind : kKinds) {
    if (kind.format == named) {
      return {ErrorKind::malformed, where, fmt::format("is no {}: it does not begin with {}", kind.what, kind.begins)};
    }
  }
  return {ErrorKind::unsupported, where, fmt::format("is no image that is known: {}", kRead)};
}

Result<Image> as_floats(Result<ByteImage> bytes, Transfer transfer, AlphaForm alpha, const std::string& where) {
  if (!bytes) {
    return tl::unexpected(std::move(bytes).error());
  }
  return within_memory(where, [&]() -> Result<Image> { return image_of_bytes(*bytes, transfer, alpha); });
}

/// Floats that have no alpha, or a premultiplied one.
Result<Image> with_alpha(Result<Image> image, AlphaForm alpha) {
  if (image && alpha == AlphaForm::straight) {
    unpremultiply(*image);
  }
  return image;
}

}  // namespace

ImageFormat format_of_content(std::span<const std::byte> head) {
  const auto begins = [&](std::string_view magic) { return begins_with(head, magic); };
  if (begins("\x89PNG\r\n\x1a\n")) {
    return ImageFormat::png;
  }
  if (begins("\x76\x2f\x31\x01")) {
    return ImageFormat::exr;
  }
  if (begins("\xFF\xD8\xFF")) {
    return ImageFormat::jpeg;
  }
  if (begins("RIFF") && head.size() >= 12 && begins_with(head.subspan(8), "WEBP")) {
    return ImageFormat::webp;
  }
  if (begins("BM") && head.size() >= 16 && head[15] == std::byte{0}) {  // the header's size, up to 124
    return ImageFormat::bmp;
  }
  if (begins("#?")) {
    return ImageFormat::hdr;
  }
  if (head.size() >= 3 && (begins("PF") || begins("Pf")) &&
      std::string_view(" \t\n\r").find(static_cast<char>(head[2])) != std::string_view::npos) {
    return ImageFormat::pfm;
  }
  return ImageFormat::unknown;
}

ImageFormat format_of_name(const std::filesystem::path& file) {
  const std::string extension = lower_case(file.extension().string());
  for (const Kind& kind : kKinds) {
    if (!extension.empty() && std::ranges::find(kind.extensions, extension) != kind.extensions.end()) {
      return kind.format;
    }
  }
  return ImageFormat::unknown;
}

Result<Image> decode_image(std::span<const std::byte> bytes, const std::string& where, Transfer transfer, const ImageLimits& limits,
                           AlphaForm alpha) {
  switch (format_of_content(bytes)) {
    case ImageFormat::png:
      return decode_png(bytes, where, transfer, limits, alpha);
    case ImageFormat::exr:
      return with_alpha(decode_exr(bytes, where, limits), alpha);
    case ImageFormat::pfm:
      return decode_pfm(bytes, where, limits);
    case ImageFormat::hdr:
      return decode_hdr(bytes, where, limits);
    case ImageFormat::jpeg:
      return as_floats(decode_jpeg(bytes, where, limits), transfer, alpha, where);
    case ImageFormat::webp:
      return as_floats(decode_webp(bytes, where, limits), transfer, alpha, where);
    case ImageFormat::bmp:
      return as_floats(decode_bmp(bytes, where, limits), transfer, alpha, where);
    case ImageFormat::tga:
    case ImageFormat::unknown:
      break;
  }
  if (has_tga_footer(bytes) || format_of_name(where) == ImageFormat::tga) {
    return as_floats(decode_tga(bytes, where, limits), transfer, alpha, where);
  }
  return tl::unexpected(not_an_image(bytes, where));
}

Result<Image> decode_texture_image(std::span<const std::byte> bytes, const std::string& where, TextureContent content, Transfer transfer,
                                   const ImageLimits& limits) {
  return decode_image(bytes, where, content == TextureContent::color ? transfer : Transfer::none, limits, AlphaForm::straight);
}

Result<Image> read_image(const std::filesystem::path& file, Transfer transfer) {
  const auto accept = [&](std::span<const std::byte> head) -> Result<void> {
    if (format_of_content(head) == ImageFormat::unknown && format_of_name(file) != ImageFormat::tga) {
      return tl::unexpected(not_an_image(head, file.string()));
    }
    return {};
  };
  const auto bytes = read_file_bytes(file, accept);
  if (!bytes) {
    return tl::unexpected(bytes.error());
  }
  return decode_image(*bytes, file.string(), transfer);
}

}  // namespace lustro
