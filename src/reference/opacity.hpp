// How much of what lies behind a triangle hides at a point of the image.
#pragma once

#include <cstdint>

#include "reference/triangle.hpp"
#include "scene/prepare.hpp"

namespace lustro {

/// The opacity at image point (px, py), 1/256 pixel, inside the triangle: 0..1.
[[nodiscard]] float opacity_at(const PreparedScene& scene, const ScreenTriangle& t, std::int32_t px, std::int32_t py);

}  // namespace lustro
