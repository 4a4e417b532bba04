// Surface coefficients of the classic lighting model, and what a material file said beyond them.
#pragma once

#include <array>
#include <cstdint>
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

/// The wrap modes of both axes.
struct WrapPair {
  Wrap u = Wrap::repeat;
  Wrap v = Wrap::repeat;
  friend bool operator==(const WrapPair&, const WrapPair&) = default;
};

/// Which channel of a picture a map of one value is.
enum class TextureChannel : std::uint8_t {
  automatic,  ///< the luminance; of `opacity` the alpha of a picture that has one
  red,
  green,
  blue,
  alpha,
  luminance,
};

/// A texture as a scene file states it. load_meshes() reads its picture and makes the TextureUse.
///
/// A surface's (u, v) becomes R(rotation) ((u, v) * scale) + offset, with R turning counter-clockwise; or, with a `matrix` m,
/// (m[0] u + m[1] v + m[2], m[3] u + m[4] v + m[5]).
struct StatedTexture {
  std::string file{};  ///< relative to the scene file
  WrapPair wrap{};
  TextureFilter magnify = TextureFilter::linear;
  TextureFilter minify = TextureFilter::linear;
  MipFilter mip = MipFilter::linear;
  int anisotropy = 1;  ///< 1..16
  float lod_bias = 0;  ///< -16..16, see Sampler
  Color border{};      ///< of Wrap::clamp_to_border
  float border_alpha = 0;
  Vec2f offset{0, 0};
  Vec2f scale{1, 1};
  float rotation = 0;                            ///< degrees
  std::optional<std::array<float, 6>> matrix{};  ///< in place of offset, scale and rotation
  bool v_down = false;                           ///< v counts from the picture's top row, as in glTF; else from the bottom, as in OBJ
  int uv_set = 0;                                ///< 0 or 1
  Vec3f gain{1, 1, 1};                           ///< value * gain + base; a map of one value takes the first
  Vec3f base{0, 0, 0};
  TextureChannel channel = TextureChannel::automatic;
  bool once = false;  ///< outside of 0..1 the material is as without the texture
  friend bool operator==(const StatedTexture&, const StatedTexture&) = default;
};

/// The reflection map of a scene file: one picture for a sphere, six for a cube.
struct StatedReflection {
  ReflectionShape shape = ReflectionShape::sphere;
  std::optional<StatedTexture> picture{}, right{}, left{}, top{}, bottom{}, front{}, back{};
  friend bool operator==(const StatedReflection&, const StatedReflection&) = default;
};

/// The textures of a material of a scene file, by what they drive.
struct StatedTextures {
  std::optional<StatedTexture> ambient{}, diffuse{}, specular{}, emission{}, shininess{}, opacity{}, decal{}, bump{}, normal{}, displacement{};
  std::optional<StatedReflection> reflection{};
  bool object_space = false;  ///< `normal` holds normals of the object
  friend bool operator==(const StatedTextures&, const StatedTextures&) = default;
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
  std::optional<Culling> cull{};       ///< faces of which this side is seen are left out; else the scene's

  // What an MTL file says beyond the classic model, kept for the renderers that use it.
  Color transmission{{1, 1, 1}};      ///< Tf
  float refraction = 1;               ///< Ni
  float sharpness = 60;               ///< sharpness of reflections
  bool halo = false;                  ///< d -halo
  std::optional<int> illumination{};  ///< illum 0..10
  std::vector<TextureMap> maps{};

  StatedTextures stated_textures{};  ///< of a scene file: what load_meshes() makes `textures` of
  MaterialTextures textures{};       ///< what varies over the surface

  friend bool operator==(const Material&, const Material&) = default;
};

/// The classic material of that name (`jade`, `polished_gold`, ...), or nothing. Colours are `encoded`.
/// source  Kilgard, teapots.c, 1993; Blythe and McReynolds, SIGGRAPH notes, 1998. Opacity is 1, as teapots.c has it.
[[nodiscard]] std::optional<Material> library_material(std::string_view name);

/// All 29 library materials, in the order of the table.
[[nodiscard]] const std::vector<Material>& material_library();

}  // namespace lustro
