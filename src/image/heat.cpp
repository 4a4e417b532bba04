// Nine colours of our own choice, of evenly rising lightness, with straight lines between them in the encoded space.
#include "image/heat.hpp"

#include <algorithm>
#include <array>

#include "image/srgb.hpp"
#include "math/lane.hpp"

namespace lustro {

Vec3f heat_color(float t) {
  static constexpr std::array<Vec3f, 9> kColors{{{0, 0, 0},
                                                 {0.10F, 0.06F, 0.25F},
                                                 {0.28F, 0.08F, 0.45F},
                                                 {0.47F, 0.13F, 0.51F},
                                                 {0.67F, 0.20F, 0.50F},
                                                 {0.86F, 0.29F, 0.42F},
                                                 {0.97F, 0.46F, 0.36F},
                                                 {1.00F, 0.68F, 0.46F},
                                                 {1.00F, 0.96F, 0.78F}}};
  const float scaled = clamp01(t) * static_cast<float>(kColors.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(scaled), kColors.size() - 2);
  const float share = scaled - static_cast<float>(low);
  const Vec3f encoded = kColors[low] * (1 - share) + kColors[low + 1] * share;
  return {srgb_decode(encoded.x), srgb_decode(encoded.y), srgb_decode(encoded.z)};
}

}  // namespace lustro
