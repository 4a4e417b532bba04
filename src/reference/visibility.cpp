// Filling: every sample in the triangle's bounding box is asked.
#include "reference/visibility.hpp"

#include <algorithm>
#include <bit>

#include "reference/face.hpp"
#include "reference/opacity.hpp"
#include "scene/samples.hpp"

namespace lustro {

Visibility::Visibility(const PreparedScene& scene, const Rectangle& area) : scene_(scene), area_(area) {
  const std::size_t pixels = static_cast<std::size_t>(area.right - area.left) * static_cast<std::size_t>(area.bottom - area.top);
  const std::size_t samples = pixels * static_cast<std::size_t>(scene.view.samples);
  keys_.assign(samples, 0);
  winners_.assign(samples, kNothing);
  layers_.resize(pixels);
}

std::uint64_t key_at(const View& view, const ScreenTriangle& t, std::int32_t px, std::int32_t py) {
  if (!covers(t, px, py)) {
    return 0;
  }
  const float depth_key = depth_key_at(t, edges_at(t, px, py));
  if (!(depth_key >= depth_key_of(view, view.depth_far))) {
    return 0;
  }
  return (std::uint64_t{std::bit_cast<std::uint32_t>(depth_key)} << 32) | (~t.id & 0xFFFFFFFFU);
}

void Visibility::draw(const ScreenTriangle& t, std::uint32_t index) {
  // Samples lie up to half a pixel from the centre, so a pixel is asked when the box touches it.
  const auto [left, right] = std::minmax({t.x[0], t.x[1], t.x[2]});
  const auto [top, bottom] = std::minmax({t.y[0], t.y[1], t.y[2]});
  const auto pixel_at = [](std::int32_t units) { return units >> 8; };
  const int first_x = std::max(area_.left, pixel_at(left));
  const int last_x = std::min(area_.right - 1, pixel_at(right));
  const int first_y = std::max(area_.top, pixel_at(top));
  const int last_y = std::min(area_.bottom - 1, pixel_at(bottom));
  const auto pattern = sample_pattern(scene_.view.samples);
  const ShadingOpacity& opacity = face_of(scene_, t).material.opacity;

  for (int y = first_y; y <= last_y; ++y) {
    for (int x = first_x; x <= last_x; ++x) {
      bool is_listed = false;
      for (std::size_t s = 0; s < pattern.size(); ++s) {
        const std::int32_t px = x * kSubpixelUnits + kSubpixelUnits / 2 + pattern[s].x;
        const std::int32_t py = y * kSubpixelUnits + kSubpixelUnits / 2 + pattern[s].y;
        const std::uint64_t key = key_at(scene_.view, t, px, py);
        if (opacity.mode == AlphaMode::blend) {
          is_listed = is_listed || key > 0;
          continue;
        }
        const std::size_t sample = at(x, y, static_cast<int>(s));
        if (key > keys_[sample] && (opacity.mode == AlphaMode::opaque || opacity_at(scene_, t, px, py) >= opacity.cutoff)) {
          keys_[sample] = key;
          winners_[sample] = index;
        }
      }
      if (is_listed) {
        layers_[pixel(x, y)].push_back(index);
      }
    }
  }
}

}  // namespace lustro
