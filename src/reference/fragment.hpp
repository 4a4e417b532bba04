// Shading one fragment: one triangle in one pixel.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lustro/render.hpp"
#include "reference/triangle.hpp"
#include "scene/prepare.hpp"

namespace lustro {

/// What a fragment shows.
struct Fragment {
  Terms<float> terms;
  Vec3f fog;         ///< what the fog adds; the terms are already dimmed by it
  Vec3f scene_part;  ///< k_a I_a + k_e + k_s times the reflection map: what no light brings
  Vec3f albedo;
  Vec3f position;  ///< relative to the eye
  Vec3f normal;
  Vec3f weights;
  float depth = 0;
  std::uint32_t instance = 0, triangle = 0, material = 0;
};

/// Shades triangle `t` at image point (px, py), 1/256 pixel, inside the triangle.
///
/// light_parts  empty, or one entry a light: receives its ambient + diffuse + specular
/// explanation  null, or receives every number on the way
[[nodiscard]] Fragment shade_fragment(const PreparedScene& scene, const ScreenTriangle& t, std::int32_t px, std::int32_t py,
                                      std::span<Vec3f> light_parts, FragmentExplanation* explanation);

}  // namespace lustro
