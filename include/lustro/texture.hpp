// Textures: what varies over a surface, and how it is looked up.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lustro/image.hpp"
#include "lustro/result.hpp"
#include "lustro/vec.hpp"

namespace lustro {

/// What stands beside the picture's edge, along one axis.
enum class Wrap : std::uint8_t {
  repeat,
  mirrored_repeat,
  clamp_to_edge,
  clamp_to_border,  ///< outside 0..1 lies the sampler's border
};

/// How texels become a value.
enum class TextureFilter : std::uint8_t { nearest, linear };

/// How mip levels are chosen.
enum class MipFilter : std::uint8_t {
  none,     ///< the picture itself, however small it appears
  nearest,  ///< the level next to the footprint's size
  linear,   ///< between the two levels around it: with TextureFilter::linear, trilinear
};

/// How a texture is looked up. The defaults are what a picture needs to look right: trilinear, repeated.
struct Sampler {
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
  TextureFilter magnify = TextureFilter::linear;
  TextureFilter minify = TextureFilter::linear;
  MipFilter mip = MipFilter::linear;
  int anisotropy = 1;                       ///< 1..16: looks taken at most along the footprint's long axis
  std::array<float, 4> border{0, 0, 0, 0};  ///< RGBA of `clamp_to_border`
  float lod_bias = 0;                       ///< -16..16, added to the level that a footprint asks for: below 0 sharper (OpenGL 4.6, 8.14.1)
  bool blend_u = true;                      ///< false: the nearest texel along that axis, whatever the filters
  bool blend_v = true;
  friend bool operator==(const Sampler&, const Sampler&) = default;
};

/// What the numbers of a picture mean.
enum class TextureContent : std::uint8_t {
  color,  ///< light: 8 and 16 bits are sRGB and are decoded when the transfer is `srgb`
  data,   ///< normals, heights, exponents: as they stand
};

class Texture;  // a decoded picture and its mip levels: src/texture/texture.hpp

/// A picture as a texture with all its mip levels: straight alpha, the top row first.
/// pixels   1 to 4 channels, linear or data; one is gray, two gray and alpha
/// errors   usage for an image without pixels or with more than four channels; limit beyond 16384 x 16384
[[nodiscard]] Result<std::shared_ptr<const Texture>> make_texture(const Image& pixels, int threads = 0);

/// One map of a material: a texture, where it lies on the surface and what its values mean.
///
/// A surface's (u, v) becomes uv' = (m[0] u + m[1] v + m[2], m[3] u + m[4] v + m[5]); (0, 0) is the corner at the picture's top left, v goes
/// down, as in glTF. (OBJ's v goes up: its importer states m = {1, 0, 0, 0, -1, 1}.)
/// A value then is texel * gain + base, channel by channel.
struct TextureUse {
  std::shared_ptr<const Texture> texture{};
  Sampler sampler{};
  std::uint8_t uv_set = 0;  ///< 0: Mesh::uvs, 1: Mesh::uvs1
  std::array<float, 6> uv_matrix{1, 0, 0, 0, 1, 0};
  Vec3f gain{1, 1, 1};
  Vec3f base{0, 0, 0};
  std::uint8_t channel = 0;     ///< of a map with one value: 0 r, 1 g, 2 b, 3 a, 4 luminance (Rec. 709)
  bool leaves_outside = false;  ///< where uv' lies outside 0..1 the material is untouched (MTL's -clamp on)
  std::string name{};           ///< for messages and `explain`: the file, or `images[3]`
  friend bool operator==(const TextureUse&, const TextureUse&) = default;
};

/// How reflection maps surround the surface, infinitely far away. World directions; (0, 0) is a picture's top left.
enum class ReflectionShape : std::uint8_t {
  sphere,  ///< one picture: u = 1/2 + atan2(x, -z) / 2 pi, v = arccos(y) / pi: its middle is seen along -z, its top along +y, its right along +x
  cube,  ///< six pictures, as OpenGL has them (4.6, table 8.19): seen from outside the cube each is upright and not mirrored, +y up; right is -z
         ///< on +x, +z on -x, and +x on +y, whose top is -z, on -y, whose top is +z, and on +z; -x on -z
};

/// What a mirroring surface shows: k_s times the maps' colour in the direction in which the view is reflected about the lit normal.
///
/// Of a TextureUse the texture, filters, gain, base and uv_matrix count, the last one in the picture's own coordinates (the identity shows it
/// upright, whatever the mesh's coordinates are). A face that is missing is black.
struct ReflectionMap {
  ReflectionShape shape = ReflectionShape::sphere;
  std::array<std::optional<TextureUse>, 6> faces{};  ///< sphere: the first; cube: right, left, top, bottom, front, back (+x -x +y -y +z -z)
  friend bool operator==(const ReflectionMap&, const ReflectionMap&) = default;
};

/// What a material's textures drive. Colours multiply their coefficient, one value each for the others.
struct MaterialTextures {
  std::optional<TextureUse> ambient{};       ///< rgb * k_a
  std::optional<TextureUse> diffuse{};       ///< rgb * k_d
  std::optional<TextureUse> specular{};      ///< rgb * k_s
  std::optional<TextureUse> emission{};      ///< rgb * k_e
  std::optional<TextureUse> shininess{};     ///< value * n
  std::optional<TextureUse> opacity{};       ///< value * opacity
  std::optional<TextureUse> decal{};         ///< rgba: laid over k_a and k_d by its alpha
  std::optional<TextureUse> bump{};          ///< height, in units of the surface: Blinn 1978 with Mikkelsen 2010
  std::optional<TextureUse> normal{};        ///< rgb * 2 - 1 in the tangent frame
  std::optional<TextureUse> displacement{};  ///< height along the vertex normal, in units of the mesh: the mesh is subdivided for it
  std::optional<ReflectionMap> reflection{};
  bool normal_is_object_space = false;  ///< the normal map states normals of the object, not of the tangent frame
  friend bool operator==(const MaterialTextures&, const MaterialTextures&) = default;
};

}  // namespace lustro
