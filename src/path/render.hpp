// The path tracer: passes over the picture until it is good enough.
#pragma once

#include <cstdint>
#include <span>

#include "lustro/render.hpp"
#include "scene/prepare.hpp"

namespace lustro {

/// Draws the colour, and into `result`'s layers of AovKind::variance (`aovs`, one a layer) the variance; statistics and bytes. Other layers are
/// left as they are.
///
/// fingerprint  what a file of PathOptions::resume must be about: path_fingerprint()
/// errors       usage for options out of range, and for a file to resume that is about something else; unsupported in a build without Embree;
///              limit; io, malformed of that file
[[nodiscard]] Result<void> render_path(const PreparedScene& scene, std::span<const Aov> aovs, const RenderOptions& options,
                                       std::uint64_t fingerprint, Rendering& result);

}  // namespace lustro
