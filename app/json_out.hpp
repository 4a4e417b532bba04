// Results as JSON: keys in the order in which they are said, numbers in the fewest digits that read back to the same bits.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "lustro/material.hpp"
#include "lustro/mesh.hpp"
#include "lustro/result.hpp"
#include "lustro/vec.hpp"

namespace lustro::app {

using Json = nlohmann::ordered_json;

/// 0.1F as 0.1, not as 0.10000000149011612. What is not finite has no place in JSON and becomes null.
[[nodiscard]] Json json_number(float x);
[[nodiscard]] Json json_number(double x);

[[nodiscard]] Json json_vector(const Vec3f& v);
[[nodiscard]] Json json_vector(const Vec3d& v);
[[nodiscard]] Json json_bounds(const Bounds& bounds);  ///< null where empty
[[nodiscard]] Json json_color(const Color& color);     ///< {"rgb": [r, g, b], "space": "srgb" | "linear"}
[[nodiscard]] Json json_material(const Material& material);
[[nodiscard]] Json json_notes(const Notes& notes);

/// The document on stdout, indented by two, with a final newline. Text that is not UTF-8 is replaced, not refused.
[[nodiscard]] Result<void> print_json(const Json& json);

}  // namespace lustro::app
