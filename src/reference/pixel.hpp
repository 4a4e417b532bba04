// One pixel: what its samples show shaded once per triangle, weighted by the samples that show it and by what blended triangles before it let
// through, and summed.
#pragma once

#include <array>
#include <vector>

#include "reference/fragment.hpp"
#include "reference/visibility.hpp"

namespace lustro {

/// A resolved pixel. The colour is by definition the sum of its terms in the order of color(); everything is weighted by coverage, and what lies
/// behind blended triangles by what they let through.
struct Pixel {
  Terms<float> terms;
  Vec3f fog;
  Vec3f background;
  float alpha = 0;
  float coverage = 0;
  float uncovered = 0;  ///< the background's share
  Vec3f scene_part;
  Vec3f albedo;
  std::vector<Vec3f> light_parts;  ///< empty, or one a light
  Fragment dominant;               ///< the fragment that brings the most to the pixel, the first of equals; meaningless without coverage

  [[nodiscard]] std::array<float, 4> color() const {
    const Vec3f rgb = (terms.sum() + fog) + background;
    return {rgb.x, rgb.y, rgb.z, alpha};
  }
};

/// Resolves pixel (x, y).
///
/// wants_lights  also split the sum by lights
/// explanation   null, or receives its fragments
[[nodiscard]] Pixel resolve_pixel(const PreparedScene& scene, const std::vector<ScreenTriangle>& triangles, const Visibility& visibility, int x,
                                  int y, bool wants_lights, std::vector<FragmentExplanation>* explanation);

}  // namespace lustro
