// Filling: every sample in the triangle's bounding box is asked.
#include "reference/visibility.hpp"

#include <algorithm>
#include <bit>

#include "scene/samples.hpp"

namespace lustro {

Visibility::Visibility(const Rectangle& area, int samples) : area_(area), samples_(samples) {
  const std::size_t count =
      static_cast<std::size_t>(area.right - area.left) * static_cast<std::size_t>(area.bottom - area.top) * static_cast<std::size_t>(samples);
  keys_.assign(count, 0);
  winners_.assign(count, kNothing);
}

void Visibility::draw(const View& view, const ScreenTriangle& t, std::uint32_t index) {
  // Samples lie up to half a pixel from the centre, so a pixel is asked when the box touches it.
  const auto [left, right] = std::minmax({t.x[0], t.x[1], t.x[2]});
  const auto [top, bottom] = std::minmax({t.y[0], t.y[1], t.y[2]});
  const auto pixel = [](std::int32_t units) { return units >> 8; };
  const int first_x = std::max(area_.left, pixel(left));
  const int last_x = std::min(area_.right - 1, pixel(right));
  const int first_y = std::max(area_.top, pixel(top));
  const int last_y = std::min(area_.bottom - 1, pixel(bottom));
  const auto pattern = sample_pattern(samples_);
  const float farthest = depth_key_of(view, view.depth_far);

  for (int y = first_y; y <= last_y; ++y) {
    for (int x = first_x; x <= last_x; ++x) {
      for (std::size_t s = 0; s < pattern.size(); ++s) {
        const std::int32_t px = x * kSubpixelUnits + kSubpixelUnits / 2 + pattern[s].x;
        const std::int32_t py = y * kSubpixelUnits + kSubpixelUnits / 2 + pattern[s].y;
        if (!covers(t, px, py)) {
          continue;
        }
        const float depth_key = depth_key_at(t, edges_at(t, px, py));
        if (!(depth_key >= farthest)) {
          continue;  // behind the far plane
        }
        const std::uint64_t key = (std::uint64_t{std::bit_cast<std::uint32_t>(depth_key)} << 32) | (~t.id & 0xFFFFFFFFU);
        const std::size_t sample = at(x, y) + s;
        if (key > keys_[sample]) {
          keys_[sample] = key;
          winners_[sample] = index;
        }
      }
    }
  }
}

}  // namespace lustro
