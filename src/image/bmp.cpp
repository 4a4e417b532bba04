// The bitmap reader: headers of eight sizes to one description, then rows of indices or of masked words.
#include "image/bmp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "image/byte_reader.hpp"
#include "image/decode_bytes.hpp"

namespace lustro {
namespace {

constexpr std::size_t kFileHeader = 14;
constexpr std::uint32_t kPlain = 0, kRle8 = 1, kRle4 = 2, kBitFields = 3, kAlphaBitFields = 6;

struct BmpHeader {
  std::size_t pixels_at = 0;
  std::size_t palette_at = 0;
  std::size_t palette_length = 0;
  std::size_t palette_entry = 4;  // bytes
  int width = 0, height = 0, bits = 0;
  bool from_top = false;
  std::uint32_t compression = kPlain;
  std::array<std::uint32_t, 4> masks{};  // r, g, b, a; a = 0: no alpha

  [[nodiscard]] bool is_packed() const { return compression == kRle8 || compression == kRle4; }
  [[nodiscard]] std::size_t row_bytes() const { return (static_cast<std::size_t>(width) * static_cast<std::size_t>(bits) + 31) / 32 * 4; }
};

bool is_contiguous(std::uint32_t mask) {
  const std::uint32_t bits = mask == 0 ? 0 : mask >> std::countr_zero(mask);
  return (bits & (bits + 1)) == 0;
}

/// The masks of 16 and 32 bits: stated, or what holds without them.
Result<void> read_masks(const ByteReader& in, std::size_t header_size, const std::string& where, BmpHeader& h) {
  if (h.compression == kPlain) {
    h.masks = h.bits == 16 ? std::array<std::uint32_t, 4>{0x7C00, 0x3E0, 0x1F, 0} : std::array<std::uint32_t, 4>{0xFF0000, 0xFF00, 0xFF, 0};
    return {};
  }
  const bool has_alpha = header_size >= 56 || h.compression == kAlphaBitFields;
  std::uint32_t seen = 0;
  for (std::size_t c = 0; c < (has_alpha ? 4U : 3U); ++c) {
    h.masks[c] = in.u32(kFileHeader + 40 + 4 * c);
    if (!is_contiguous(h.masks[c]) || (h.masks[c] & seen) != 0) {
      return fail(ErrorKind::malformed, at_picture_byte(where, kFileHeader + 40 + 4 * c),
                  fmt::format("0x{:08X} is no mask of a colour", h.masks[c]));
    }
    seen |= h.masks[c];
  }
  return {};
}

/// What the header says in the fields that both kinds have: OS/2's first header in 16 bits, all others in 32.
Result<BmpHeader> read_sizes(const ByteReader& in, std::size_t size, const std::string& where) {
  BmpHeader h;
  const bool is_core = size == 12;
  const std::int64_t height = is_core ? std::int64_t{in.u16(20)} : std::int64_t{in.i32(22)};
  const std::int64_t width = is_core ? std::int64_t{in.u16(18)} : std::int64_t{in.i32(18)};
  h.from_top = height < 0;
  if (auto ok = check_image_size(width, height < 0 ? -height : height, where, {}); !ok) {
    return tl::unexpected(std::move(ok).error());
  }
  h.width = static_cast<int>(width);
  h.height = static_cast<int>(height < 0 ? -height : height);
  h.bits = in.u16(is_core ? 24 : 28);
  h.compression = is_core ? kPlain : in.u32(30);
  h.palette_entry = is_core ? 3 : 4;
  h.palette_length = is_core ? 0 : in.u32(46);
  h.pixels_at = in.u32(10);
  return h;
}

Result<BmpHeader> read_header(const ByteReader& in, const std::string& where, const ImageLimits& limits) {
  const std::size_t size = in.u32(kFileHeader);
  constexpr std::array<std::size_t, 7> kSizes{12, 40, 52, 56, 64, 108, 124};
  if (in.u8(0) != 'B' || in.u8(1) != 'M') {
    return fail(ErrorKind::malformed, at_picture_byte(where, 0), "is no bitmap: it does not begin with `BM`");
  }
  if (in.size() < kFileHeader + 4 || (std::ranges::find(kSizes, size) != kSizes.end() && in.size() < kFileHeader + size)) {
    return fail(ErrorKind::malformed, at_picture_byte(where, in.size()), "the bitmap ends inside its header");
  }
  if (std::ranges::find(kSizes, size) == kSizes.end()) {
    return fail(ErrorKind::unsupported, at_picture_byte(where, kFileHeader),
                fmt::format("the bitmap's header has {} bytes; read are those of 12, 40, 52, 56, 64, 108 and 124", size));
  }
  auto read = read_sizes(in, size, where);
  if (!read) {
    return read;
  }
  BmpHeader& h = *read;
  if (auto ok = check_image_size(h.width, h.height, where, limits); !ok) {
    return tl::unexpected(std::move(ok).error());
  }
  const bool has_fields = h.compression == kBitFields || h.compression == kAlphaBitFields;
  if (h.compression > kAlphaBitFields || h.compression == 4 || h.compression == 5 || (has_fields && (size == 64 || size == 12))) {
    return fail(ErrorKind::unsupported, at_picture_byte(where, 30), fmt::format("the bitmap's compression {} is not read", h.compression));
  }
  const bool is_indexed = h.bits == 1 || h.bits == 2 || h.bits == 4 || h.bits == 8;
  const bool fits = h.compression == kRle8   ? h.bits == 8
                    : h.compression == kRle4 ? h.bits == 4
                    : has_fields             ? h.bits == 16 || h.bits == 32
                                             : is_indexed || h.bits == 16 || h.bits == 24 || h.bits == 32;
  if (!fits) {
    return fail(ErrorKind::malformed, at_picture_byte(where, 28),
                fmt::format("a bitmap of compression {} cannot have {} bits a pixel", h.compression, h.bits));
  }
  const std::size_t masks = size == 40 && has_fields ? (h.compression == kAlphaBitFields ? 16U : 12U) : 0U;
  h.palette_at = kFileHeader + size + masks;
  if (in.size() < h.palette_at) {
    return fail(ErrorKind::malformed, at_picture_byte(where, in.size()), "the bitmap ends inside its masks");
  }
  if (h.bits == 16 || h.bits == 32) {
    if (auto ok = read_masks(in, size, where, h); !ok) {
      return tl::unexpected(std::move(ok).error());
    }
  }
  if (is_indexed) {
    const std::size_t most = std::size_t{1} << h.bits;
    h.palette_length = h.palette_length == 0 ? most : std::min(h.palette_length, most);
    if (h.pixels_at > h.palette_at) {  // OS/2's files may have fewer than the depth allows
      h.palette_length = std::min(h.palette_length, (h.pixels_at - h.palette_at) / h.palette_entry);
    }
  }
  const std::size_t behind_palette = h.palette_at + (is_indexed ? h.palette_length * h.palette_entry : 0);
  if (h.pixels_at < behind_palette || h.pixels_at > in.size()) {
    return fail(
        ErrorKind::malformed, at_picture_byte(where, 10),
        fmt::format("the bitmap's pixels cannot begin at byte {} of {}: header and colours end at {}", h.pixels_at, in.size(), behind_palette));
  }
  return read;
}

/// One index a pixel, row by row, unpacked.
Result<std::vector<std::uint8_t>> read_indices(std::span<const std::byte> bytes, const BmpHeader& h, const std::string& where) {
  if (h.is_packed()) {
    return unpack_bmp_runs(bytes, h.pixels_at, h.width, h.height, h.bits, where);
  }
  const auto width = static_cast<std::size_t>(h.width);
  const auto bits = static_cast<std::size_t>(h.bits);
  std::vector<std::uint8_t> indices(width * static_cast<std::size_t>(h.height));
  const auto* const in = reinterpret_cast<const std::uint8_t*>(bytes.data()) + h.pixels_at;
  const std::size_t in_a_byte = 8 / bits;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::size_t x = i % width;
    const std::uint8_t byte = in[i / width * h.row_bytes() + x / in_a_byte];
    indices[i] = static_cast<std::uint8_t>((byte >> (8 - bits * (x % in_a_byte + 1))) & ((1U << bits) - 1));
  }
  return indices;
}

Result<void> fill_indexed(std::span<const std::byte> bytes, const BmpHeader& h, const std::string& where, ByteImage& image) {
  const auto indices = read_indices(bytes, h, where);
  if (!indices) {
    return tl::unexpected(indices.error());
  }
  const ByteReader in(bytes);
  for (std::size_t i = 0; i < indices->size(); ++i) {
    const std::size_t index = (*indices)[i];
    if (index >= h.palette_length) {
      return fail(ErrorKind::malformed, where, fmt::format("a pixel of the bitmap has colour {} of {}", index, h.palette_length));
    }
    const std::size_t entry = h.palette_at + index * h.palette_entry;
    for (std::size_t c = 0; c < 3; ++c) {
      image.pixels[3 * i + c] = in.u8(entry + 2 - c);
    }
  }
  return {};
}

void fill_masked(std::span<const std::byte> bytes, const BmpHeader& h, ByteImage& image) {
  const ByteReader in(bytes);
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::size_t step = static_cast<std::size_t>(h.bits) / 8;
  std::size_t to = 0;
  for (std::size_t y = 0; y < static_cast<std::size_t>(h.height); ++y) {
    const std::size_t row = h.pixels_at + y * h.row_bytes();
    for (std::size_t x = 0; x < static_cast<std::size_t>(h.width); ++x) {
      const std::size_t at = row + x * step;
      if (h.bits == 24) {
        image.pixels[to++] = in.u8(at + 2);
        image.pixels[to++] = in.u8(at + 1);
        image.pixels[to++] = in.u8(at);
        continue;
      }
      const std::uint32_t word = h.bits == 16 ? in.u16(at) : in.u32(at);
      for (std::size_t c = 0; c < channels; ++c) {
        const std::uint32_t mask = h.masks[c];
        const int shift = mask == 0 ? 0 : std::countr_zero(mask);
        image.pixels[to++] = mask == 0 ? std::uint8_t{0} : to_8_bits((word & mask) >> shift, mask >> shift);
      }
    }
  }
}

Result<ByteImage> read_picture(std::span<const std::byte> bytes, const BmpHeader& h, const std::string& where) {
  const std::size_t rest = bytes.size() - h.pixels_at;
  const std::size_t pixels = static_cast<std::size_t>(h.width) * static_cast<std::size_t>(h.height);
  const std::size_t needed = h.is_packed() ? pixels / 1024 : h.row_bytes() * static_cast<std::size_t>(h.height);
  if (rest < needed) {
    return fail(ErrorKind::malformed, at_picture_byte(where, bytes.size()),
                fmt::format("the bitmap ends after {} bytes of its pixels, and {} x {} of them take {}{}", rest, h.width, h.height, needed,
                            h.is_packed() ? " or more" : ""));
  }
  ByteImage image{h.width, h.height, h.bits > 8 && h.masks[3] != 0 ? 4 : 3, {}};
  const std::size_t row = static_cast<std::size_t>(h.width) * static_cast<std::size_t>(image.channels);
  image.pixels.resize(row * static_cast<std::size_t>(h.height));
  if (h.bits > 8) {
    fill_masked(bytes, h, image);
  } else if (auto ok = fill_indexed(bytes, h, where, image); !ok) {
    return tl::unexpected(std::move(ok).error());
  }
  for (int y = 0; !h.from_top && y < h.height / 2; ++y) {
    auto* const upper = image.pixels.data() + static_cast<std::size_t>(y) * row;
    std::swap_ranges(upper, upper + row, image.pixels.data() + static_cast<std::size_t>(h.height - 1 - y) * row);
  }
  drop_empty_alpha(image);
  return image;
}

}  // namespace

Result<ByteImage> decode_bmp(std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits) {
  const auto header = read_header(ByteReader(bytes), where, limits);
  if (!header) {
    return tl::unexpected(header.error());
  }
  return within_memory(where, [&] { return read_picture(bytes, *header, where); });
}

}  // namespace lustro
