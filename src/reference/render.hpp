// The reference renderer: every pixel by the plainest way, which defines what correct is.
#pragma once

#include <span>

#include "lustro/render.hpp"
#include "scene/prepare.hpp"

namespace lustro {

/// Draws into `result`: colour, the layers (made already, one for each of `aovs`), statistics, and bytes where they are asked for.
void render_reference(const PreparedScene& scene, std::span<const Aov> aovs, const RenderOptions& options, Rendering& result);

}  // namespace lustro
