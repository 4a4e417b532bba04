// A picture in which nothing was drawn: why, and what it looks like all the same.
#pragma once

#include <string>

#include "lustro/render.hpp"

namespace lustro::app {

/// Why no pixel was covered, in words that help to change it.
[[nodiscard]] std::string why_empty(const Scene& scene, const RenderStats& stats);

/// The background and nothing else, for scenes that have no triangle at all.
[[nodiscard]] Rendering empty_rendering(const Scene& scene);

}  // namespace lustro::app
