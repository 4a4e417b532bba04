// Complete GLSL ES 3.00 shaders of the lighting equation, cut from lighting.glsl, fog.glsl, vertex.glsl and fragment.glsl: only what the chosen
// model needs, comments kept, no preprocessor left.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lustro/options.hpp"

namespace lustro {

enum class GlslStage : std::uint8_t { vertex, fragment };

/// What is known of a light before its numbers are. What a light does not have is left out of the shader.
struct GlslKnownLight {
  LightType type = LightType::directional;
  bool has_polynomial = true;  ///< f = 1 / (c + l d + q d^2) with another result than 1
  bool has_power = true;       ///< f = 1 / d^p, of a p that is no polynomial
  bool has_range = true;
  bool has_exponent = true;  ///< of a spot, as the next
  bool has_beam = true;
  friend bool operator==(const GlslKnownLight&, const GlslKnownLight&) = default;
};

/// What a pair of shaders does. Both stages must be made from the same options.
struct GlslOptions {
  Lighting lighting = Lighting::phong;
  Interpolation interpolation = Interpolation::phong;
  Projection projection = Projection::perspective;
  TermSet terms{};
  bool two_sided = false;   ///< lights the back of a face with its normals turned round (gl_FrontFacing)
  bool normalized = false;  ///< energy-normalised specular lobes, times N.L
  bool fog = false;
  Transfer transfer = Transfer::srgb;  ///< `srgb` encodes the result
  int max_lights = 8;                  ///< the size of the uniform array `lights`, at least 1

  /// The lights, where they are known: their sum is written out, without `light_count`, for just these (at most max_lights). It is faster.
  std::optional<std::vector<GlslKnownLight>> known_lights{};
};

/// The text of one shader, `#version 300 es` first.
///
/// Where the equation stands follows the interpolation: `phong` lights every fragment with the interpolated, renormalised normal; `gouraud`
/// lights the vertices in the vertex shader, clamps to 0..1 there and interpolates; `flat` lights the face's centre with the face's normal in
/// the vertex shader and passes the colour on as a `flat` varying. For `flat` every vertex carries its face's `face_normal` and `face_center`:
/// screen-space derivatives would give the normal, but not the centre.
///
/// uniforms  eye_from_object, clip_from_eye, normal_from_object; material, ambient_light, lights, light_count (structs as in shade/lighting.hpp,
///           positions relative to the eye); fog; view_to_eye for an orthographic view
[[nodiscard]] std::string glsl_shader(GlslStage stage, const GlslOptions& options);

}  // namespace lustro
