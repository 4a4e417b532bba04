// Where a pixel's coverage samples lie: the standard patterns of Direct3D 11, which every GPU knows. All renderers share them.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace lustro {

/// Fixed-point image coordinates: 8 subpixel bits, 256 units a pixel.
inline constexpr std::int32_t kSubpixelUnits = 256;

/// An offset from the pixel's centre, 1/256 pixel, x to the right, y down.
struct SampleOffset {
  std::int32_t x, y;
};

/// The pattern for 1, 2, 4, 8 or 16 samples a pixel.
/// source  Microsoft, D3D11_STANDARD_MULTISAMPLE_QUALITY_LEVELS (given there in 1/16 pixel)
[[nodiscard]] inline std::span<const SampleOffset> sample_pattern(int samples) {
  constexpr auto at = [](std::int32_t x, std::int32_t y) { return SampleOffset{x * 16, y * 16}; };
  static constexpr std::array k1{at(0, 0)};
  static constexpr std::array k2{at(4, 4), at(-4, -4)};
  static constexpr std::array k4{at(-2, -6), at(6, -2), at(-6, 2), at(2, 6)};
  static constexpr std::array k8{at(1, -3), at(-1, 3), at(5, 1), at(-3, -5), at(-5, 5), at(-7, -1), at(3, 7), at(7, -7)};
  static constexpr std::array k16{at(1, 1),  at(-1, -3), at(-3, 2),  at(4, -1), at(-5, -2), at(2, 5),  at(5, 3), at(3, -5),
                                  at(-2, 6), at(0, -7),  at(-4, -6), at(-6, 4), at(-8, 0),  at(7, -4), at(6, 7), at(-7, -8)};
  switch (samples) {
    case 2:
      return k2;
    case 4:
      return k4;
    case 8:
      return k8;
    case 16:
      return k16;
    default:
      return k1;
  }
}

}  // namespace lustro
