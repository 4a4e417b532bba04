// The sRGB transfer function (IEC 61966-2-1) and the rounding of values to integers. Both decide stored bytes, so neither uses libm.
#pragma once

#include <cstdint>

namespace lustro {

/// The sRGB encoding of a linear value: 12.92 x up to 0.0031308, 1.055 x^(1/2.4) - 0.055 above. Not clamped; negative values follow the straight
/// part; exactly 1 at x = 1. Absolute error below 1e-6 over 0..1.
[[nodiscard]] float srgb_encode(float linear);

/// The linear value of an sRGB-encoded one: u / 12.92 up to 0.04045, ((u + 0.055) / 1.055)^2.4 above. Not clamped; exactly 1 at u = 1.
/// Relative error below 1e-5 over 0..1.
[[nodiscard]] float srgb_decode(float encoded);

/// round(255 clamp(x, 0, 1)), halves upwards; NaN is 0.
[[nodiscard]] std::uint8_t quantize8(float x);

/// round(65535 clamp(x, 0, 1)), halves upwards; NaN is 0.
[[nodiscard]] std::uint16_t quantize16(float x);

}  // namespace lustro
