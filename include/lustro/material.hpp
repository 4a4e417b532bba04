// Surface coefficients of the classic lighting model, and what a material file said beyond them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lustro/options.hpp"
#include "lustro/texture.hpp"
#include "lustro/vec.hpp"

namespace lustro {

/// A colour and the space it is written in. r, g, b >= 0; they may exceed 1.
struct Color {
  Vec3f rgb{};
  ColorSpace space = ColorSpace::linear;
  friend bool operator==(const Color&, const Color&) = default;
};

/// One map statement of an MTL file with all its options (Ramey, Rose, Tyerman), kept as written.
struct TextureMap {
  std::string statement{};  ///< as written: map_Kd, bump, refl, ...
  std::string file{};       ///< as written, relative to the MTL file
  std::string library{};    ///< the MTL file that states it, as the mesh names that one
  bool blend_u = true, blend_v = true, color_correction = false, clamp = false;
  float boost = 0;
  float bump_multiplier = 1;
  float base = 0, gain = 1;  ///< -mm: value * gain + base
  Vec3f offset, scale{1, 1, 1}, turbulence;
  int texture_resolution = 0;
  char channel = 0;    ///< -imfchan: r g b m l z; 0 is the statement's default
  std::string type{};  ///< -type: sphere, cube_top, ...
  friend bool operator==(const TextureMap&, const TextureMap&) = default;
};

/// Coefficients of the lighting equation. The defaults are OpenGL's (GL 2.1, table 2.10).
struct Material {
  std::string name{};
  Color ambient{{0.2F, 0.2F, 0.2F}};
  Color diffuse{{0.8F, 0.8F, 0.8F}};
  Color specular{{0, 0, 0}};
  Color emission{{0, 0, 0}};
  float shininess = 0;  ///< the exponent n, 0..10000
  float opacity = 1;    ///< 0..1
  AlphaMode alpha_mode = AlphaMode::blend;
  float alpha_cutoff = 0.5F;           ///< of AlphaMode::mask
  std::optional<Lighting> lighting{};  ///< the material's own model, else the scene's

  // What an MTL file says beyond the classic model, kept for the renderers that use it.
  Color transmission{{1, 1, 1}};      ///< Tf
  float refraction = 1;               ///< Ni
  float sharpness = 60;               ///< sharpness of reflections
  bool halo = false;                  ///< d -halo
  std::optional<int> illumination{};  ///< illum 0..10
  std::vector<TextureMap> maps{};

  MaterialTextures textures{};  ///< what varies over the surface

  friend bool operator==(const Material&, const Material&) = default;
};

/// The classic material of that name (`jade`, `polished_gold`, ...), or nothing. Colours are `encoded`.
/// source  Kilgard, teapots.c, 1993; Blythe and McReynolds, SIGGRAPH notes, 1998. Opacity is 1, as teapots.c has it.
[[nodiscard]] std::optional<Material> library_material(std::string_view name);

/// All 29 library materials, in the order of the table.
[[nodiscard]] const std::vector<Material>& material_library();

}  // namespace lustro
