// The TGA reader: header, palette, packets, corner, in that order. Nothing is taken before the file is seen to hold it.
#include "image/tga.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <vector>

#include "image/byte_reader.hpp"
#include "image/decode_bytes.hpp"

namespace lustro {
namespace {

constexpr std::size_t kHeaderSize = 18;
constexpr std::size_t kFooterSize = 26;
constexpr std::string_view kSignature("TRUEVISION-XFILE.\0", 18);

struct TgaHeader {
  std::size_t id_length = 0;
  bool has_palette = false;
  int type = 0;  // 1 palette, 2 colour, 3 gray
  bool is_packed = false;
  std::size_t palette_first = 0, palette_length = 0;
  int palette_bits = 0;
  int width = 0, height = 0, bits = 0;
  int attribute_bits = 0;
  bool from_right = false, from_top = false;

  [[nodiscard]] std::size_t pixel_bytes() const { return (static_cast<std::size_t>(bits) + 7) / 8; }
  [[nodiscard]] std::size_t palette_entry_bytes() const { return (static_cast<std::size_t>(palette_bits) + 7) / 8; }
  [[nodiscard]] std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

bool is_color_depth(int bits) {
  return bits == 15 || bits == 16 || bits == 24 || bits == 32;
}

Result<TgaHeader> read_header(const ByteReader& in, const std::string& where, const ImageLimits& limits) {
  if (in.size() < kHeaderSize) {
    return fail(ErrorKind::malformed, at_picture_byte(where, in.size()), "the TGA file ends inside its header of 18 bytes");
  }
  TgaHeader h;
  h.id_length = in.u8(0);
  h.has_palette = in.u8(1) == 1;
  const int type = in.u8(2);
  h.is_packed = type >= 9;
  h.type = h.is_packed ? type - 8 : type;
  h.palette_first = in.u16(3);
  h.palette_length = in.u16(5);
  h.palette_bits = in.u8(7);
  h.width = in.u16(12);
  h.height = in.u16(14);
  h.bits = in.u8(16);
  h.attribute_bits = in.u8(17) & 15;
  h.from_right = (in.u8(17) & 16) != 0;
  h.from_top = (in.u8(17) & 32) != 0;
  if (in.u8(1) > 1 || h.type < 1 || h.type > 3 || type > 11) {
    return fail(ErrorKind::malformed, at_picture_byte(where, 1),
                fmt::format("a TGA file of type 1, 2, 3, 9, 10 or 11 was expected, and colour map {}, type {} was found", in.u8(1), type));
  }
  if ((in.u8(17) & 0xC0) != 0) {
    return fail(ErrorKind::unsupported, at_picture_byte(where, 17), "the rows of the TGA file are interleaved, which is not read");
  }
  const bool fits = h.type == 1   ? h.has_palette && is_color_depth(h.palette_bits) && (h.bits == 8 || h.bits == 16)
                    : h.type == 2 ? is_color_depth(h.bits)
                                  : h.bits == 8 || h.bits == 16;
  if (!fits) {
    return fail(ErrorKind::malformed, at_picture_byte(where, 16),
                fmt::format("a TGA file of type {} cannot have {} bits a pixel and {} a colour of its map", type, h.bits,
                            h.has_palette ? h.palette_bits : 0));
  }
  if (auto ok = check_image_size(h.width, h.height, where, limits); !ok) {
    return tl::unexpected(std::move(ok).error());
  }
  return h;
}

/// The attributes type of the extension area, -1 where there is none.
int attributes_type(std::span<const std::byte> bytes) {
  constexpr std::size_t kAttributesAt = 494;
  const ByteReader in(bytes);
  if (!has_tga_footer(bytes)) {
    return -1;
  }
  const std::size_t area = in.u32(bytes.size() - kFooterSize);
  return area != 0 && area + kAttributesAt < bytes.size() - kFooterSize ? in.u8(area + kAttributesAt) : -1;
}

Error ends_too_early(const std::string& where, std::size_t size, std::size_t needed) {
  return {ErrorKind::malformed, at_picture_byte(where, size),
          fmt::format("the TGA file ends here, and its pixels take {} bytes or more", needed)};
}

/// The pixels as the file has them, unpacked: a byte per 8 bits, in the file's order.
Result<std::vector<std::uint8_t>> read_raw(std::span<const std::byte> bytes, std::size_t begin, const TgaHeader& h, const std::string& where) {
  const std::size_t step = h.pixel_bytes();
  const std::size_t total = h.pixels() * step;
  const std::size_t rest = bytes.size() - begin;
  const std::size_t least = h.is_packed ? (h.pixels() + 127) / 128 * (1 + step) : total;
  if (rest < least) {
    return tl::unexpected(ends_too_early(where, bytes.size(), least));
  }
  std::vector<std::uint8_t> raw(total);
  const auto* const in = reinterpret_cast<const std::uint8_t*>(bytes.data());
  if (!h.is_packed) {
    std::memcpy(raw.data(), in + begin, total);
    return raw;
  }
  std::size_t at = begin;
  for (std::size_t to = 0; to < total;) {
    const std::size_t packet = at;
    const std::uint8_t head = at < bytes.size() ? in[at] : std::uint8_t{0};
    const std::size_t count = std::size_t{1} + (head & 127);
    const bool is_run = (head & 128) != 0;
    const std::size_t length = (is_run ? 1 : count) * step;
    ++at;
    if (at > bytes.size() || length > bytes.size() - at) {
      return tl::unexpected(ends_too_early(where, bytes.size(), at + length - begin));
    }
    if (count * step > total - to) {
      return fail(ErrorKind::malformed, at_picture_byte(where, packet),
                  fmt::format("a packet of {} pixels, where the TGA file's picture has {} left", count, (total - to) / step));
    }
    for (std::size_t i = 0; i < count; ++i, to += step) {
      std::memcpy(raw.data() + to, in + at + (is_run ? 0 : i * step), step);
    }
    at += length;
  }
  return raw;
}

/// RGBA of a stored colour of 15 to 32 bits.
std::array<std::uint8_t, 4> color_of(const std::uint8_t* stored, int bits) {
  if (bits >= 24) {
    return {stored[2], stored[1], stored[0], bits == 32 ? stored[3] : std::uint8_t{255}};
  }
  const unsigned value = stored[0] | (unsigned{stored[1]} << 8);
  return {to_8_bits((value >> 10) & 31, 31), to_8_bits((value >> 5) & 31, 31), to_8_bits(value & 31, 31),
          (value & 0x8000) != 0 ? std::uint8_t{255} : std::uint8_t{0}};
}

/// The palette as RGBA; its first entry is the colour of index palette_first.
std::vector<std::array<std::uint8_t, 4>> read_palette(std::span<const std::byte> bytes, std::size_t begin, const TgaHeader& h) {
  const auto* const in = reinterpret_cast<const std::uint8_t*>(bytes.data()) + begin;
  std::vector<std::array<std::uint8_t, 4>> palette(h.palette_length);
  for (std::size_t i = 0; i < palette.size(); ++i) {
    palette[i] = color_of(in + i * h.palette_entry_bytes(), h.palette_bits);
  }
  return palette;
}

/// Turns the rows to begin at the top left, and drops the alpha that means nothing or divides by the one that was multiplied in.
void finish(ByteImage& image, const TgaHeader& h, int attributes) {
  const auto step = static_cast<std::size_t>(image.channels);
  const std::size_t row = step * static_cast<std::size_t>(image.width);
  for (int y = 0; !h.from_top && y < image.height / 2; ++y) {
    auto* const upper = image.pixels.data() + static_cast<std::size_t>(y) * row;
    std::swap_ranges(upper, upper + row, image.pixels.data() + static_cast<std::size_t>(image.height - 1 - y) * row);
  }
  for (std::size_t at = 0; h.from_right && at < image.pixels.size(); at += row) {
    for (std::size_t left = 0, right = row - step; left < right; left += step, right -= step) {
      std::swap_ranges(image.pixels.data() + at + left, image.pixels.data() + at + left + step, image.pixels.data() + at + right);
    }
  }
  if (attributes == 4 && image.channels == 4) {
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
      const std::uint32_t alpha = image.pixels[i + 3];
      for (std::size_t c = 0; c < 3 && alpha != 0; ++c) {
        image.pixels[i + c] = to_8_bits(std::min<std::uint32_t>(image.pixels[i + c], alpha), alpha);
      }
    }
  }
  drop_empty_alpha(image);
}

Result<ByteImage> read_picture(std::span<const std::byte> bytes, const TgaHeader& h, const std::string& where) {
  const std::size_t palette_begin = kHeaderSize + h.id_length;
  const std::size_t palette_bytes = h.has_palette ? h.palette_length * h.palette_entry_bytes() : 0;
  const std::size_t begin = palette_begin + palette_bytes;
  if (begin > bytes.size()) {
    return tl::unexpected(Error{ErrorKind::malformed, at_picture_byte(where, bytes.size()), "the TGA file ends before its pixels begin"});
  }
  const auto raw = read_raw(bytes, begin, h, where);
  if (!raw) {
    return tl::unexpected(raw.error());
  }
  const int attributes = attributes_type(bytes);
  const bool alpha_is_defined = attributes < 0 || attributes > 2;
  const int color_bits = h.type == 1 ? h.palette_bits : h.bits;
  const bool has_alpha = alpha_is_defined && (color_bits == 32 || (color_bits == 16 && h.attribute_bits == 1));
  ByteImage image{h.width, h.height, (h.type == 3 ? 1 : 3), {}};
  if (h.type == 3) {
    image.channels = h.bits == 16 && alpha_is_defined ? 2 : 1;
  } else if (has_alpha) {
    image.channels = 4;
  }
  const auto step = static_cast<std::size_t>(image.channels);
  image.pixels.resize(h.pixels() * step);
  const auto palette = h.type == 1 ? read_palette(bytes, palette_begin, h) : std::vector<std::array<std::uint8_t, 4>>();
  const std::size_t from_step = h.pixel_bytes();
  for (std::size_t i = 0; i < h.pixels(); ++i) {
    const std::uint8_t* const stored = raw->data() + i * from_step;
    std::uint8_t* const to = image.pixels.data() + i * step;
    if (h.type == 3) {
      std::copy_n(stored, step, to);
      continue;
    }
    if (h.type == 2) {
      std::copy_n(color_of(stored, h.bits).begin(), step, to);
      continue;
    }
    const std::size_t index = stored[0] | (from_step == 2 ? std::size_t{stored[1]} << 8 : 0);
    if (index < h.palette_first || index - h.palette_first >= palette.size()) {
      return fail(ErrorKind::malformed, where,
                  fmt::format("pixel {} of the TGA file has colour {} of a map with {} from {} on", i, index, palette.size(), h.palette_first));
    }
    std::copy_n(palette[index - h.palette_first].begin(), step, to);
  }
  finish(image, h, attributes);
  return image;
}

}  // namespace

bool has_tga_footer(std::span<const std::byte> bytes) {
  return bytes.size() >= kHeaderSize + kFooterSize &&
         std::memcmp(bytes.data() + bytes.size() - kSignature.size(), kSignature.data(), kSignature.size()) == 0;
}

Result<ByteImage> decode_tga(std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits) {
  const auto header = read_header(ByteReader(bytes), where, limits);
  if (!header) {
    return tl::unexpected(header.error());
  }
  return within_memory(where, [&] { return read_picture(bytes, *header, where); });
}

}  // namespace lustro
