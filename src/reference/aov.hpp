// The layers beside the colour picture: which there are, what they are called, what a pixel puts into them.
#pragma once

#include <span>
#include <vector>

#include "lustro/render.hpp"
#include "reference/pixel.hpp"

namespace lustro {

/// `light` without a number becomes one AOV a light.
/// errors  usage for a light that the scene does not have
[[nodiscard]] Result<std::vector<Aov>> unfold_aovs(std::span<const Aov> aovs, const PreparedScene& scene);

/// An empty layer with its name, channels and labels.
[[nodiscard]] Layer make_layer(const Aov& aov, const PreparedScene& scene);

/// One pixel's values, one a channel.
void store_aov(const Aov& aov, const PreparedScene& scene, const Pixel& pixel, std::span<float> out);

}  // namespace lustro
