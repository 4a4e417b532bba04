// The words of the scene file as C++ enums. The same words name the JSON values, the command's flags and the Python keywords
// (src/scene/words.hpp turns them into text and back).
#pragma once

#include <cstdint>

namespace lustro {

/// How a point is lit. Formulas in shade/lighting.hpp.
enum class Lighting : std::uint8_t {
  constant,     ///< k_d alone, unlit (MTL illum 0)
  lambert,      ///< ambient and diffuse, no highlight
  phong,        ///< highlight by (R.V)^n, Phong 1975
  blinn_phong,  ///< highlight by (N.H)^n, Blinn 1977
  ggx,          ///< microfacets as glTF 2.0 asks, Walter et al. 2007; alpha^2 = 2 / (n + 2)
};

/// Where the lighting is evaluated.
enum class Interpolation : std::uint8_t {
  flat,     ///< once a face, at its centre, with the face's normal
  gouraud,  ///< at the vertices; the colour, clamped to 0..1 there, is interpolated (Gouraud 1971)
  phong,    ///< at every pixel, with the interpolated normal (Phong 1975)
};

/// How `phong` interpolates the normal.
enum class NormalInterpolation : std::uint8_t {
  lerp,   ///< weighted sum, then normalised
  slerp,  ///< spherical weighted average (Buss and Fillmore 2001); on an edge the classic sin formula
};

/// How missing vertex normals are made from the faces around a vertex.
enum class VertexNormals : std::uint8_t { uniform, area, angle };

/// Which side of a face is not drawn. The side that is seen is decided by the winding on the image, as for `two_sided`.
enum class Culling : std::uint8_t { none, back, front };

/// What is stored for a linear value.
enum class Transfer : std::uint8_t {
  none,  ///< the value itself
  srgb,  ///< its sRGB encoding; encoded inputs are decoded first
};

enum class Projection : std::uint8_t { perspective, orthographic };

/// Where the camera stands when the scene names no eye.
enum class ViewPreset : std::uint8_t { three_quarter, iso, front, back, left, right, top, bottom };

/// How a spot light's strength falls between its beam and its cutoff; t goes from 0 at the cutoff's cosine to 1 at the beam's.
enum class SpotFade : std::uint8_t {
  smoothstep,  ///< t^2 (3 - 2 t)
  quadratic,   ///< t^2, as KHR_lights_punctual asks
};

/// What a material's opacity means.
enum class AlphaMode : std::uint8_t {
  blend,   ///< the share of what lies behind that is hidden
  mask,    ///< a sample is covered where the opacity is at least the material's cutoff, else there is nothing
  opaque,  ///< nothing: the surface hides what lies behind
};

/// What a glTF file's metal-and-roughness materials become. Coefficients and exponent are the same.
enum class GltfShading : std::uint8_t {
  classic,  ///< highlights by (N.H)^n
  ggx,      ///< the lighting that glTF asks for; so, too, where the scene's lighting is `ggx`
};

enum class LightType : std::uint8_t {
  directional,
  point,
  spot,
  rectangle,  ///< an area that shines from its front
  disk,       ///< the same, round
  sphere,     ///< a ball that shines all around
};

/// Whether the light has a size.
[[nodiscard]] constexpr bool is_area(LightType type) {
  return type == LightType::rectangle || type == LightType::disk || type == LightType::sphere;
}

enum class FogMode : std::uint8_t { linear, exp, exp2 };

/// What brings a linear picture into the range that a byte can store, after the exposure and before the transfer (image/tone.hpp has the
/// formulas).
enum class ToneOperator : std::uint8_t {
  none,      ///< nothing: what is brighter than 1 is stored as 1
  reinhard,  ///< by the luminance L / (1 + L), Reinhard et al. 2002, equation 3
  aces,      ///< the fit of ACES' reference and output transforms by Stephen Hill
  agx,       ///< Troy Sobotka's AgX, as Benjamin Wrensch approximates it by a polynomial
};

enum class ColorSpace : std::uint8_t {
  linear,   ///< light itself
  encoded,  ///< sRGB when the transfer is `srgb` (8-bit colours, MTL, library materials); as it stands when it is `none`
};

/// The parts of the lighting sum.
struct TermSet {
  bool ambient = true;
  bool diffuse = true;
  bool specular = true;
  bool emission = true;
  friend bool operator==(const TermSet&, const TermSet&) = default;
};

}  // namespace lustro
