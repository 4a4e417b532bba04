// Hues a golden angle apart never come close to their neighbours (Vogel 1979), whatever their number; saturation and brightness change with
// them in cycles of three and two, so that also the hues that meet again after many turns differ.
#include "image/id_color.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "math/lane.hpp"

namespace lustro {

Vec3f id_color(float id) {
  if (!(id >= 0) || !(id < 1e18F)) {
    return {0, 0, 0};
  }
  const auto index = static_cast<std::uint64_t>(id + 0.5F);
  // the fraction of index / golden ratio, in 32 bits, from a start at a clear blue
  const auto turn = static_cast<std::uint32_t>(index * 2654435769U + 0x92000000U);
  const float hue = static_cast<float>(turn >> 8) * 0x1p-24F * 6;
  constexpr std::array<float, 3> kSaturation{0.75F, 0.5F, 0.95F};
  constexpr std::array<float, 2> kValue{0.95F, 0.7F};
  const float saturation = kSaturation[index % 3];
  const float value = kValue[(index / 3) % 2];
  const auto channel = [&](float shift) {  // HSV to RGB (Smith 1978) as three shifted trapezoids
    const float place = hue + shift < 6 ? hue + shift : hue + shift - 6;
    return value - value * saturation * clamp01(std::min(place, 4 - place));
  };
  return {channel(5), channel(3), channel(1)};
}

}  // namespace lustro
