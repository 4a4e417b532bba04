// Telling image formats apart, and reading a file of any of them.
#include "image/decode.hpp"

#include <algorithm>
#include <cstring>
#include <string_view>

#include "image/exr.hpp"
#include "image/file.hpp"
#include "image/pfm.hpp"
#include "image/png.hpp"

namespace lustro {
namespace {

Error not_an_image(const std::string& where) {
  switch (format_of_name(where)) {
    case ImageFormat::png:
      return {ErrorKind::malformed, where, "is no PNG file: it does not begin with the PNG signature"};
    case ImageFormat::exr:
      return {ErrorKind::malformed, where, "is no EXR file: it does not begin with the number 20000630"};
    case ImageFormat::pfm:
      return {ErrorKind::malformed, where, "is no PFM file: it does not begin with `PF` or `Pf`"};
    case ImageFormat::unknown:
      break;
  }
  return {ErrorKind::unsupported, where, "is neither a PNG nor an EXR nor a PFM file"};
}

}  // namespace

ImageFormat format_of_content(std::span<const std::byte> head) {
  const auto begins_with = [&](std::string_view magic) {
    return head.size() >= magic.size() && std::memcmp(head.data(), magic.data(), magic.size()) == 0;
  };
  if (begins_with("\x89PNG\r\n\x1a\n")) {
    return ImageFormat::png;
  }
  if (begins_with("\x76\x2f\x31\x01")) {
    return ImageFormat::exr;
  }
  if (head.size() >= 3 && (begins_with("PF") || begins_with("Pf")) &&
      std::string_view(" \t\n\r").find(static_cast<char>(head[2])) != std::string_view::npos) {
    return ImageFormat::pfm;
  }
  return ImageFormat::unknown;
}

ImageFormat format_of_name(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension == ".png"   ? ImageFormat::png
         : extension == ".exr" ? ImageFormat::exr
         : extension == ".pfm" ? ImageFormat::pfm
                               : ImageFormat::unknown;
}

Result<Image> decode_image(std::span<const std::byte> bytes, const std::string& where, Transfer transfer, const ImageLimits& limits) {
  switch (format_of_content(bytes)) {
    case ImageFormat::png:
      return decode_png(bytes, where, transfer, limits);
    case ImageFormat::exr:
      return decode_exr(bytes, where, limits);
    case ImageFormat::pfm:
      return decode_pfm(bytes, where, limits);
    case ImageFormat::unknown:
      break;
  }
  return tl::unexpected(not_an_image(where));
}

Result<Image> read_image(const std::filesystem::path& file, Transfer transfer) {
  const auto accept = [&](std::span<const std::byte> head) -> Result<void> {
    if (format_of_content(head) == ImageFormat::unknown) {
      return tl::unexpected(not_an_image(file.string()));
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
