// The reference renderer: every pixel by the plainest way, which defines what correct is.
#pragma once

#include "lustro/render.hpp"
#include "scene/prepare.hpp"

namespace lustro {

/// Draws into `result`: colour, layers, statistics, and bytes where they are asked for.
/// errors  usage for a layer of a light that is not there
[[nodiscard]] Result<void> render_reference(const PreparedScene& scene, const RenderOptions& options, Rendering& result);

}  // namespace lustro
