// The sRGB transfer function (IEC 61966-2-1) and the rounding of values to integers. Both decide stored bytes, so neither uses libm.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "math/lane.hpp"

namespace lustro {

/// The sRGB encoding of a linear value: 12.92 x up to 0.0031308, 1.055 x^(1/2.4) - 0.055 above. Not clamped; negative values follow the straight
/// part; exactly 1 at x = 1. Absolute error below 1e-6 over 0..1.
[[nodiscard]] float srgb_encode(float linear);

/// The linear value of an sRGB-encoded one: u / 12.92 up to 0.04045, ((u + 0.055) / 1.055)^2.4 above. Not clamped; exactly 1 at u = 1.
/// Relative error below 1e-5 over 0..1.
[[nodiscard]] float srgb_decode(float encoded);

/// round(255 clamp(x, 0, 1)), halves upwards; NaN is 0.
[[nodiscard]] inline std::uint8_t quantize8(float x) {
  return static_cast<std::uint8_t>(clamp01(x) * 255.0F + 0.5F);
}

/// round(65535 clamp(x, 0, 1)), halves upwards; NaN is 0.
[[nodiscard]] std::uint16_t quantize16(float x);

/// quantize8(srgb_encode(x)) for every float x by one look-up. The bits of x, clamped to 2^-13..1, fall into buckets of 2^16 floats, each so
/// narrow that the byte rises at most once in it: an entry holds the byte before the rise, and in its low half what carries into that byte from
/// the rise on. Where the polynomial of srgb_encode() rounds to and fro around a rise (four rises, within four floats), the table rises once.
struct SrgbTable {
  static constexpr std::uint32_t kFirst = 0x39000000;  ///< the bits of 2^-13, which is still stored as 0
  static constexpr std::uint32_t kLast = 0x3F800000;   ///< the bits of 1
  std::array<std::uint32_t, ((kLast - kFirst) >> 16) + 1> entries{};
};

/// A constant: image/srgb_table.cpp.
[[nodiscard]] const SrgbTable& srgb_table();

/// The byte that a linear value is stored as: never less for a larger value. Rows of lanes do the same.
[[nodiscard]] inline std::uint8_t srgb_byte(const SrgbTable& table, float linear) {
  const float x = lane_min(lane_max(linear, std::bit_cast<float>(SrgbTable::kFirst)), 1.0F);  // NaN becomes the first bucket
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const std::uint32_t entry = table.entries[(bits - SrgbTable::kFirst) >> 16];
  return static_cast<std::uint8_t>((entry + (bits & 0xFFFF)) >> 16);
}

}  // namespace lustro
