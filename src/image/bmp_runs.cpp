// The run-length codes of Windows bitmaps: (n, colour) repeats, (0, n >= 3) states n pixels, (0, 0) ends a row, (0, 1) the picture, (0, 2)
// moves.
#include <fmt/format.h>

#include <algorithm>

#include "image/bmp.hpp"
#include "image/byte_reader.hpp"
#include "image/decode_bytes.hpp"

namespace lustro {

Result<std::vector<std::uint8_t>> unpack_bmp_runs(std::span<const std::byte> bytes, std::size_t begin, int width, int height, int bits,
                                                  const std::string& where) {
  const ByteReader in(bytes);
  const auto columns = static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  std::vector<std::uint8_t> indices(columns * rows);
  std::size_t x = 0;
  std::size_t y = 0;
  const auto cut = [&] {
    return fail(ErrorKind::malformed, at_picture_byte(where, bytes.size()),
                "the bitmap ends here, without the mark for the end of its packed pixels");
  };
  /// Half a byte or a byte at place i of a stretch that begins at `at`.
  const auto index_at = [&](std::size_t at, std::size_t i) -> std::uint8_t {
    if (bits == 8) {
      return in.u8(at + i);
    }
    const std::uint8_t both = in.u8(at + i / 2);
    return i % 2 == 0 ? static_cast<std::uint8_t>(both >> 4) : static_cast<std::uint8_t>(both & 15);
  };
  for (std::size_t at = begin;;) {
    if (bytes.size() < 2 || at > bytes.size() - 2) {
      return cut();
    }
    const std::size_t code = at;
    const std::size_t count = in.u8(at);
    const std::uint8_t value = in.u8(at + 1);
    at += 2;
    if (count == 0 && value == 1) {
      return indices;
    }
    if (count == 0 && value == 0) {
      x = 0;
      ++y;
      continue;
    }
    if (count == 0 && value == 2) {
      if (bytes.size() - at < 2) {
        return cut();
      }
      x += in.u8(at);
      y += in.u8(at + 1);
      at += 2;
      if (x > columns || y > rows) {
        return fail(ErrorKind::malformed, at_picture_byte(where, code), "a move leads out of the bitmap's picture");
      }
      continue;
    }
    const std::size_t pixels = count == 0 ? value : count;
    if (y >= rows || pixels > columns - x) {
      return fail(ErrorKind::malformed, at_picture_byte(where, code),
                  fmt::format("{} pixels at ({}, {}) lie outside of the bitmap's {} x {}", pixels, x, y, width, height));
    }
    if (count == 0) {
      const std::size_t stretch = bits == 8 ? pixels : (pixels + 1) / 2;
      if (stretch > bytes.size() - at) {
        return cut();
      }
      for (std::size_t i = 0; i < pixels; ++i) {
        indices[y * columns + x++] = index_at(at, i);
      }
      at += stretch + stretch % 2;  // stretches end on even bytes
    } else {
      for (std::size_t i = 0; i < pixels; ++i) {
        indices[y * columns + x++] = index_at(code + 1, bits == 8 ? 0 : i % 2);
      }
    }
  }
}

}  // namespace lustro
