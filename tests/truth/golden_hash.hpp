// What golden_hashes.txt holds of a scene: one hash of its float picture and of five layers.
#pragma once

#include <string>

#include "lustro/render.hpp"

namespace lustro::truth {

/// 16 hexadecimal digits: FNV-1a (Fowler, Noll, Vo), 64 bits, over the floats' bits of colour, diffuse, specular, depth, normal and
/// barycentrics; where the scene cannot be drawn, why. `options` says who draws; the stored bytes of the picture are added to `bytes`, if it is
/// given.
[[nodiscard]] std::string golden_hash(const Scene& scene, const RenderOptions& options, std::string* bytes = nullptr);

}  // namespace lustro::truth
