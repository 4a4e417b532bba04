// An Explanation as readable text and as JSON.
#pragma once

#include <string>

#include "json_out.hpp"
#include "lustro/render.hpp"
#include "scene/prepare.hpp"

namespace lustro::app {

/// The equation with its numbers, fragment by fragment, light by light, term by term.
[[nodiscard]] std::string explanation_text(const Scene& scene, const PreparedScene& prepared, const Explanation& explanation);

/// Everything that the Explanation holds.
[[nodiscard]] Json explanation_json(const Explanation& explanation);

/// Whether ambient + diffuse + specular + emission + fog + background, summed in this order, is the colour, bit for bit.
[[nodiscard]] bool terms_sum_to_color(const Explanation& explanation);

}  // namespace lustro::app
