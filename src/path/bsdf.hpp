// The classic model as something that scatters light: evaluated by shade/lighting.hpp, sampled by its lobes. In classic units: what is here
// called "reflected" is pi f cos, so that a delta light of colour c shows c times it, and a radiance L from the solid angle dw shows L dw / pi
// times it.
//
//   Lambert          k_d cos                                  by the cosine
//   Phong            k_s (R.V)^n, or normalised times N.L     about the mirrored view by (n + 1) / 2 pi cos^n (Lafortune and Willems 1994)
//   Blinn-Phong      k_s (N.H)^n, or normalised times N.L     H about N by the same, L the view mirrored about H
//   GGX              F D Vis N.L                              H by D cos (Walter et al. 2007)
//   illumination 3   k_s: a mirror                            5: by Fresnel; 6: and (1 - k_s) T_f refracted; 7: by Fresnel
//
// With an illumination of 3 to 7 the mirror stands for the highlight; only delta lights, which no mirror shows, keep theirs.
#pragma once

#include "path/surface_point.hpp"
#include "scene/prepare.hpp"

namespace lustro {

/// pi f cos of the two terms, whose lights may have different colours.
struct Reflected {
  Vec3f diffuse, specular;
  [[nodiscard]] Vec3f sum() const { return diffuse + specular; }
};

/// A direction that was chosen.
struct ScatterSample {
  Vec3f direction{};      ///< unit, away from the surface
  Reflected weight{};     ///< f cos / density: of a mirror and a refraction their share over its probability, as specular
  float density = 0;      ///< by solid angle; 0: nothing was chosen
  bool is_delta = false;  ///< a mirrored or refracted ray: no other strategy finds it
  bool passes = false;    ///< refracted
};

class Bsdf {
 public:
  /// Both must outlive it.
  Bsdf(const SurfacePoint& point, const ShadingMaterial& material, const Shading& shading, bool is_front);

  /// Whether anything is scattered but by mirrors.
  [[nodiscard]] bool is_rough() const { return cosine_share_ + lobe_share_ > 0; }

  /// Whether sample() looks at its choice: there is more than the cosine.
  [[nodiscard]] bool has_choice() const { return cosine_share_ < 1; }

  /// pi f cos for light from `to_light` (unit), without mirrors.
  [[nodiscard]] Reflected reflected(const Vec3f& to_light) const;
  /// The density with which sample() chooses it, without mirrors.
  [[nodiscard]] float density(const Vec3f& to_light) const;
  /// choice: which lobe
  [[nodiscard]] ScatterSample sample(float choice, const Vec2f& u) const;

 private:
  [[nodiscard]] float lobe_density(const Vec3f& to_light) const;
  [[nodiscard]] Vec3f sample_lobe(const Vec2f& u) const;  // 0: nothing
  [[nodiscard]] ScatterSample sample_diffuse(const Vec2f& u) const;
  [[nodiscard]] ScatterSample sample_rough(const Vec3f& direction) const;
  [[nodiscard]] ScatterSample sample_mirror() const;
  [[nodiscard]] ScatterSample sample_refraction() const;

  const SurfacePoint& point_;
  Lighting lighting_;
  bool normalized_;
  bool has_specular_term_;
  Vec3f specular_;             // of the rough lobe
  Vec3f mirror_, refraction_;  // shares of light
  float ratio_ = 1, cosine_ = 0, cosine_behind_ = 0;
  Vec3f facing_normal_;                                                                // on the side of the eye
  float cosine_share_ = 0, lobe_share_ = 0, mirror_share_ = 0, refraction_share_ = 0;  // probabilities
};

/// Rec. 709
[[nodiscard]] inline float luminance_of(const Vec3f& c) {
  return (c.x * 0.2126F + c.y * 0.7152F) + c.z * 0.0722F;
}

}  // namespace lustro
