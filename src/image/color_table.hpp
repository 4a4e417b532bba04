// The few colours that stand for all colours of some pictures.
// source  Heckbert 1982, Color image quantization for frame buffer display; the boxes are split as Wu 1991 does, where the sum of squared errors
//         is largest, at their mean
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lustro/image.hpp"

namespace lustro {

using Rgb8 = std::array<std::uint8_t, 3>;

/// How often colours occur, to six bits a channel.
class ColorCounts {
 public:
  ColorCounts();
  /// Counts the pixels of a picture of four channels that are at least half opaque.
  void add(const ByteImage& picture);
  /// At most `most` colours; fewer where there are fewer. Where no more colours occur than that (to six bits), they are the colours themselves.
  [[nodiscard]] std::vector<Rgb8> table(std::size_t most) const;

 private:
  struct Cell {
    std::uint64_t count = 0;
    std::array<std::uint64_t, 3> sum{};
  };
  std::vector<Cell> cells_;
};

/// For each of 64 x 64 x 64 cells of colours (cell_of()) the entry of the table that is nearest to its middle, the first of equals.
[[nodiscard]] std::vector<std::uint8_t> nearest_entries(const std::vector<Rgb8>& table);

[[nodiscard]] constexpr std::size_t cell_of(int r, int g, int b) {
  return static_cast<std::size_t>((r >> 2) << 12 | (g >> 2) << 6 | (b >> 2));
}

}  // namespace lustro
