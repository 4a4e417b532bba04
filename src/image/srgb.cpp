// The two curves of IEC 61966-2-1 on our own power function. The published constants 0.0031308 and 0.04045 are rounded: the two pieces meet
// within 3e-8 of each other, far below any step that is stored.
#include "image/srgb.hpp"

#include "math/power.hpp"

namespace lustro {

float srgb_encode(float linear) {
  if (linear <= 0.0031308F) {
    return 12.92F * linear;
  }
  // (1 + 0.055) x^n - 0.055, arranged so that the roundings vanish at x = 1
  const float root = power(linear, 1.0F / 2.4F);
  return root + 0.055F * (root - 1.0F);
}

float srgb_decode(float encoded) {
  if (encoded <= 0.04045F) {
    return encoded / 12.92F;
  }
  return power((encoded + 0.055F) / 1.055F, 2.4F);
}

std::uint16_t quantize16(float x) {
  return static_cast<std::uint16_t>(clamp01(x) * 65535.0F + 0.5F);
}

}  // namespace lustro
