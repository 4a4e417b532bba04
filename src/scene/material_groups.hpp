// The groups of the material library, for lists and sheets.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "lustro/material.hpp"

namespace lustro {

enum class MaterialGroup : std::uint8_t { gem, metal, plastic, rubber };

/// The group of a library material, or nothing for another name.
[[nodiscard]] std::optional<MaterialGroup> material_group(std::string_view name);

/// `gem`, `metal`, `plastic`, `rubber`
[[nodiscard]] std::string_view material_group_name(MaterialGroup group);

}  // namespace lustro
