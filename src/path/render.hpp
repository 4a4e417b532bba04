// The path tracer: passes over the picture until it is good enough.
#pragma once

#include <span>

#include "lustro/render.hpp"
#include "scene/prepare.hpp"

namespace lustro {

/// Draws the colour, and into `result`'s layers of AovKind::variance (`aovs`, one a layer) the variance; statistics and bytes. Other layers are
/// left as they are.
/// errors  usage for options out of range; unsupported in a build without Embree; limit
[[nodiscard]] Result<void> render_path(const PreparedScene& scene, std::span<const Aov> aovs, const RenderOptions& options, Rendering& result);

}  // namespace lustro
