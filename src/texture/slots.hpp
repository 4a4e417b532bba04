// The maps of a material by name: one table for readers, writers and reports.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "lustro/texture.hpp"

namespace lustro {

/// One place of MaterialTextures. The faces of a reflection map are no members of it: their `use` and `stated` are null.
struct TextureSlot {
  std::string_view key;  ///< as in the scene file
  std::optional<TextureUse> MaterialTextures::*use;
  std::optional<StatedTexture> StatedTextures::*stated;
  TextureContent content;  ///< what the numbers of its pictures mean
  bool is_scalar;          ///< one value: `channel` says which
};

inline constexpr std::array<TextureSlot, 10> kTextureSlots{{
    {"ambient", &MaterialTextures::ambient, &StatedTextures::ambient, TextureContent::color, false},
    {"diffuse", &MaterialTextures::diffuse, &StatedTextures::diffuse, TextureContent::color, false},
    {"specular", &MaterialTextures::specular, &StatedTextures::specular, TextureContent::color, false},
    {"emission", &MaterialTextures::emission, &StatedTextures::emission, TextureContent::color, false},
    {"shininess", &MaterialTextures::shininess, &StatedTextures::shininess, TextureContent::data, true},
    {"opacity", &MaterialTextures::opacity, &StatedTextures::opacity, TextureContent::data, true},
    {"decal", &MaterialTextures::decal, &StatedTextures::decal, TextureContent::color, false},
    {"bump", &MaterialTextures::bump, &StatedTextures::bump, TextureContent::data, true},
    {"normal", &MaterialTextures::normal, &StatedTextures::normal, TextureContent::data, false},
    {"displacement", &MaterialTextures::displacement, &StatedTextures::displacement, TextureContent::data, true},
}};

/// The faces of ReflectionMap in their order; a sphere's picture stands at the first place.
inline constexpr std::array<std::string_view, 6> kCubeFaces{"right", "left", "top", "bottom", "front", "back"};

/// Each face of a reflection map.
inline constexpr TextureSlot kReflectionSlot{"reflection", nullptr, nullptr, TextureContent::color, false};

/// The place of that name; null where there is none.
[[nodiscard]] constexpr const TextureSlot* texture_slot(std::string_view key) {
  for (const TextureSlot& slot : kTextureSlots) {
    if (slot.key == key) {
      return &slot;
    }
  }
  return nullptr;
}

}  // namespace lustro
