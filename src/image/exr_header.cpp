// A walk over the headers of an EXR file (OpenEXR File Layout), before OpenEXR reads it: OpenEXR takes the memory that a header asks for at
// once, and a file of a hundred bytes may ask for gigabytes.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include "image/exr.hpp"

namespace lustro {
namespace {

/// Little-endian numbers and strings from a range that is never left.
class Cursor {
 public:
  explicit Cursor(std::span<const std::byte> bytes) : bytes_(bytes) {}
  [[nodiscard]] std::size_t offset() const { return offset_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - offset_; }

  std::optional<std::uint8_t> u8() {
    if (left() < 1) {
      return std::nullopt;
    }
    return static_cast<std::uint8_t>(bytes_[offset_++]);
  }
  std::optional<std::int32_t> i32() {
    if (left() < 4) {
      return std::nullopt;
    }
    std::uint32_t v = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      v |= static_cast<std::uint32_t>(bytes_[offset_ + i]) << (8 * i);
    }
    offset_ += 4;
    return static_cast<std::int32_t>(v);
  }
  /// Up to 255 bytes and a final 0.
  std::optional<std::string_view> name() {
    const auto* begin = reinterpret_cast<const char*>(bytes_.data()) + offset_;
    const void* end = left() == 0 ? nullptr : std::memchr(begin, 0, std::min<std::size_t>(left(), 256));
    if (end == nullptr) {
      return std::nullopt;
    }
    const auto length = static_cast<std::size_t>(static_cast<const char*>(end) - begin);
    offset_ += length + 1;
    return std::string_view(begin, length);
  }
  std::span<const std::byte> take(std::size_t count) {
    const auto part = bytes_.subspan(offset_, count);
    offset_ += count;
    return part;
  }

 private:
  std::span<const std::byte> bytes_;
  std::size_t offset_ = 0;
};

/// What one header says about the sizes of its part.
struct Part {
  std::int64_t data_width = 0, data_height = 0;
  std::int64_t display_width = 0, display_height = 0;
  std::int64_t pixel_bytes = -1;  ///< of all channels together
  int compression = -1;
  std::int64_t tile_width = 0, tile_height = 0;  ///< 0: scan lines
  bool is_deep = false;
};

bool read_box(std::span<const std::byte> data, std::int64_t& width, std::int64_t& height) {
  Cursor in(data);
  const auto x0 = in.i32(), y0 = in.i32(), x1 = in.i32(), y1 = in.i32();
  if (!y1) {
    return false;
  }
  width = std::int64_t{*x1} - *x0 + 1;
  height = std::int64_t{*y1} - *y0 + 1;
  return true;
}

bool read_channels(std::span<const std::byte> data, std::int64_t& pixel_bytes) {
  Cursor in(data);
  pixel_bytes = 0;
  for (;;) {
    const auto name = in.name();
    if (!name) {
      return false;
    }
    if (name->empty()) {
      return in.left() == 0;
    }
    const auto type = in.i32();
    if (in.left() < 12 || *type < 0 || *type > 2) {
      return false;
    }
    in.take(12);  // linearity, reserved, both samplings
    pixel_bytes += *type == 1 ? 2 : 4;
  }
}

/// The strings of a `stringvector`: a length and that many bytes each.
bool is_string_vector(std::span<const std::byte> data) {
  Cursor in(data);
  while (in.left() > 0) {
    const auto length = in.i32();
    if (!length || *length < 0 || static_cast<std::size_t>(*length) > in.left()) {
      return false;
    }
    in.take(static_cast<std::size_t>(*length));
  }
  return true;
}

/// A thumbnail: width, height, and four bytes a pixel.
bool is_preview(std::span<const std::byte> data) {
  Cursor in(data);
  const auto width = in.i32(), height = in.i32();
  return height && *width >= 0 && *height >= 0 && std::int64_t{*width} * *height == static_cast<std::int64_t>(in.left() / 4) &&
         in.left() % 4 == 0;
}

/// Whether the data has the size of its type. OpenEXR reads what the type needs and goes on from there, whatever size is stated: without this
/// check it could come to see other attributes than this walk does. Types that it does not know it takes by the stated size.
bool has_size_of_type(std::string_view type, std::span<const std::byte> data) {
  static constexpr std::pair<std::string_view, std::size_t> kSizes[] = {{"box2i", 16},
                                                                        {"box2f", 16},
                                                                        {"chromaticities", 32},
                                                                        {"compression", 1},
                                                                        {"deepImageState", 1},
                                                                        {"double", 8},
                                                                        {"envmap", 1},
                                                                        {"float", 4},
                                                                        {"int", 4},
                                                                        {"keycode", 28},
                                                                        {"lineOrder", 1},
                                                                        {"m33f", 36},
                                                                        {"m33d", 72},
                                                                        {"m44f", 64},
                                                                        {"m44d", 128},
                                                                        {"rational", 8},
                                                                        {"tiledesc", 9},
                                                                        {"timecode", 8},
                                                                        {"v2i", 8},
                                                                        {"v2f", 8},
                                                                        {"v2d", 16},
                                                                        {"v3i", 12},
                                                                        {"v3f", 12},
                                                                        {"v3d", 24}};
  const auto* found = std::ranges::find(kSizes, type, &std::pair<std::string_view, std::size_t>::first);
  if (found != std::end(kSizes)) {
    return data.size() == found->second;
  }
  std::int64_t ignored = 0;
  return type == "stringvector"  ? is_string_vector(data)
         : type == "preview"     ? is_preview(data)
         : type == "chlist"      ? read_channels(data, ignored)
         : type == "floatvector" ? data.size() % 4 == 0
                                 : type != "idmanifest";  // packed, of any size: nothing that a picture needs
}

/// Returns false for data that has the wrong shape for its name.
bool read_attribute(std::string_view name, std::span<const std::byte> data, Part& part) {
  Cursor in(data);
  if (name == "dataWindow") {
    return read_box(data, part.data_width, part.data_height);
  }
  if (name == "displayWindow") {
    return read_box(data, part.display_width, part.display_height);
  }
  if (name == "channels") {
    return read_channels(data, part.pixel_bytes);
  }
  if (name == "compression") {
    part.compression = in.u8().value_or(255);
    return part.compression <= 9;
  }
  if (name == "tiles") {
    const auto width = in.i32(), height = in.i32();
    if (!height || *width < 1 || *height < 1) {
      return false;
    }
    part.tile_width = *width;
    part.tile_height = *height;
  }
  if (name == "type") {
    const std::string_view type(reinterpret_cast<const char*>(data.data()), data.size());
    part.is_deep = type == "deepscanline" || type == "deeptile";
  }
  return true;
}

/// Scan lines that are packed together, by the compression's number in the file.
std::int64_t lines_a_chunk(int compression) {
  constexpr int kLines[] = {1, 1, 1, 16, 32, 16, 32, 32, 32, 256};  // none, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA, DWAB
  return kLines[compression];
}

/// The most that one byte of the file can become: deflate makes 1032 (PXR24 a third more), DWA drops all but one of 64 coefficients besides.
std::int64_t expansion(int compression) {
  return compression == 0 ? 1 : (compression >= 8 ? 1032 * 64 : 1376);
}

Result<void> check_part(const Part& part, std::size_t file_bytes, const std::string& where, const ImageLimits& limits) {
  if (part.is_deep) {
    return fail(ErrorKind::unsupported, where, "holds deep pixels, which are not read");
  }
  if (part.pixel_bytes < 0 || part.compression < 0 || part.data_width == 0 || part.display_width == 0) {
    return fail(ErrorKind::malformed, where,
                "the EXR header lacks one of the attributes channels, compression, dataWindow and displayWindow, or states it empty");
  }
  for (const auto& [width, height] : {std::pair{part.data_width, part.data_height}, std::pair{part.display_width, part.display_height}}) {
    if (auto ok = check_image_size(width, height, where, limits); !ok) {
      return ok;
    }
  }
  if (part.tile_width > limits.side || part.tile_height > limits.side) {
    return fail(
        ErrorKind::limit, where,
        fmt::format("states tiles of {} x {} pixels; at most {} x {} are read", part.tile_width, part.tile_height, limits.side, limits.side));
  }
  const std::int64_t lines = part.tile_height > 0 ? part.tile_height : lines_a_chunk(part.compression);
  const std::int64_t width = std::max(part.data_width, part.tile_width);
  if (width * lines > limits.chunk_bytes / std::max<std::int64_t>(part.pixel_bytes, 1)) {
    return fail(ErrorKind::limit, where,
                fmt::format("has channels of {} bytes a pixel, {} lines together: more than {} bytes in one piece", part.pixel_bytes, lines,
                            limits.chunk_bytes));
  }
  if (part.data_width * part.data_height * part.pixel_bytes / expansion(part.compression) > static_cast<std::int64_t>(file_bytes)) {
    return fail(
        ErrorKind::malformed, where,
        fmt::format("states a size of {} x {} pixels, which a file of {} bytes cannot hold", part.data_width, part.data_height, file_bytes));
  }
  return {};
}

}  // namespace

Result<void> check_exr_headers(std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits) {
  constexpr std::int32_t kMagic = 20000630;
  constexpr std::int32_t kDeep = 0x800;
  constexpr std::int32_t kMultipart = 0x1000;
  Cursor in(bytes);
  const auto broken = [&](const char* expected) {
    return fail(ErrorKind::malformed, fmt::format("{}: byte {}", where, in.offset()),
                fmt::format("the EXR header is broken: {} was expected", expected));
  };
  if (in.i32() != kMagic) {
    return broken("the number 20000630");
  }
  const auto version = in.i32();
  if (!version) {
    return broken("the version");
  }
  if ((*version & 0xFF) != 2) {
    return fail(ErrorKind::unsupported, where, fmt::format("has version {} of the EXR layout; version 2 is read", *version & 0xFF));
  }
  if ((*version & kDeep) != 0) {
    return fail(ErrorKind::unsupported, where, "holds deep pixels, which are not read");
  }
  for (bool first = true;; first = false) {
    Part part;
    bool is_empty = true;
    for (;;) {
      const auto name = in.name();
      if (!name) {
        return broken("an attribute's name of at most 255 bytes");
      }
      if (name->empty()) {
        break;
      }
      is_empty = false;
      const auto type = in.name();
      const auto size = in.i32();
      if (!type || !size || *size < 0 || static_cast<std::size_t>(*size) > in.left()) {
        return broken("an attribute's type, size and data");
      }
      const auto data = in.take(static_cast<std::size_t>(*size));
      if (!has_size_of_type(*type, data) || !read_attribute(*name, data, part)) {
        return broken(std::string("a valid attribute `").append(*name).append("`").c_str());
      }
    }
    const bool is_multipart = (*version & kMultipart) != 0;
    if (is_multipart && is_empty && !first) {
      return {};
    }
    if (auto ok = check_part(part, bytes.size(), where, limits); !ok || !is_multipart) {
      return ok;
    }
  }
}

}  // namespace lustro
