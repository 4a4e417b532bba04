// The maps of a material by name: one table for readers, writers and reports.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "lustro/texture.hpp"

namespace lustro {

/// One place of MaterialTextures.
struct TextureSlot {
  std::string_view key;  ///< as in the scene file
  std::optional<TextureUse> MaterialTextures::*use;
  TextureContent content;  ///< what the numbers of its pictures mean
  bool is_scalar;          ///< one value: `channel` says which
};

inline constexpr std::array<TextureSlot, 10> kTextureSlots{{
    {"ambient", &MaterialTextures::ambient, TextureContent::color, false},
    {"diffuse", &MaterialTextures::diffuse, TextureContent::color, false},
    {"specular", &MaterialTextures::specular, TextureContent::color, false},
    {"emission", &MaterialTextures::emission, TextureContent::color, false},
    {"shininess", &MaterialTextures::shininess, TextureContent::data, true},
    {"opacity", &MaterialTextures::opacity, TextureContent::data, true},
    {"decal", &MaterialTextures::decal, TextureContent::color, false},
    {"bump", &MaterialTextures::bump, TextureContent::data, true},
    {"normal", &MaterialTextures::normal, TextureContent::data, false},
    {"displacement", &MaterialTextures::displacement, TextureContent::data, true},
}};

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
