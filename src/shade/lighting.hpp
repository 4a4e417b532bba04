// THE lighting equation: the only place where light meets surface. F is a lane type: float for the reference, N floats for a kernel.
// shade/lighting.glsl is its mirror, line for line.
//
//   I = k_e + a (k_a I_a + k_d E) + sum_i f_i s_i [ a k_a l_a + v_i (k_d l_d max(N.L, 0) + k_s l_s spec) ]
//
//   spec = 0                    lambert      Lambert 1760
//          max(R.V, 0)^n        phong        Phong 1975, R = 2 (N.L) N - L
//          max(N.H, 0)^n        blinn-phong  Blinn 1977, H = (L + V) / |L + V|
//   spec = 0 where N.L <= 0
//
//   v_i is the share of the light that is not in shadow (shade/depth_map.hpp), 1 where there are no shadows, as in the shader: what light i
//   brings directly vanishes in its shadow; its ambient colour stays, which stands for what it brings by way of all other surfaces.
//
//   a is the share of the hemisphere that nothing near by hides (shade/occlusion.hpp), 1 where the scene has no occlusion, as in the shader.
//
//   E is what a white Lambert surface shows under the scene's environment (shade/environment.hpp), 0 where there is none, as in the shader. The
//   environment's highlights are reflection maps (scene/surroundings.hpp).
//
//   ggx: k_d (1 - F) in place of k_d, and k_s spec = F D Vis max(N.L, 0), the microfacets of glTF 2.0, appendix B; see reflect_ggx()
//
// source  OpenGL 2.1 specification, 2.14.1, for the terms and their gates; docs/using/scene-file.md for falloff, beam and clamping
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>

#include "lustro/options.hpp"
#include "lustro/vec.hpp"
#include "math/lane.hpp"
#include "math/power.hpp"
#include "shade/environment.hpp"

namespace lustro {

/// A point to be lit. Positions are relative to the eye: large coordinates lose no digits.
template <class F>
struct Surface {
  Vec3<F> position;  ///< world orientation, relative to the eye
  Vec3<F> normal;    ///< N, unit, on the side that is seen
  Vec3<F> to_eye;    ///< V, unit
};

/// The material at that point. A term that is switched off has its coefficient 0.
/// N  Exponent where n is the same in all lanes, LaneExponent<F> where a map changes it
template <class F, class N = Exponent>
struct Coefficients {
  Vec3<F> ambient, diffuse, specular, emission;
  N shininess;  ///< n
};

/// A light, ready to shine: scene/prepare.cpp makes it from lustro::Light. The same for all lanes.
struct ShadingLight {
  LightType type = LightType::directional;
  Vec3f position;  ///< relative to the eye
  Vec3f travel;    ///< unit, the way that the light travels
  Vec3f ambient, diffuse, specular;
  Vec3f attenuation{1, 0, 0};   ///< constant, linear, quadratic
  float falloff = 0;            ///< p of 1/d^p where p is none of 0, 1, 2 (those are polynomials), else 0
  float attenuation_limit = 1;  ///< 1, or a huge number for `unclamped`
  float range_scale = 0;        ///< 1 / range; 0: none
  float cos_cutoff = 0;
  float cos_beam = 0;
  float beam_scale = 0;  ///< 1 / (cos_beam - cos_cutoff); 0: no beam
  SpotFade fade = SpotFade::smoothstep;
  Exponent exponent;
  bool has_shadow = false;  ///< v is asked for
};

/// How a light arrives at a point.
template <class F>
struct Incident {
  Vec3<F> to_light;     ///< L, unit
  F distance;           ///< 0 for a directional light
  F attenuation;        ///< f
  F spot;               ///< s
  F visibility = F(1);  ///< v: set by light_surface()
};

/// One light's part of the sum.
template <class F>
struct LightTerms {
  Vec3<F> ambient, diffuse, specular;
};

/// The whole sum, term by term. The colour is their sum in exactly this order.
template <class F>
struct Terms {
  Vec3<F> ambient, diffuse, specular, emission;

  Vec3<F> sum() const { return ((ambient + diffuse) + specular) + emission; }
};

/// f = 1 / (c + l d + q d^2), or 1 / d^p; at most the limit.
template <class F>
LUSTRO_INLINE F fall_off(const ShadingLight& light, const F& distance) {
  F attenuation;
  if (light.falloff == 0.0F) {
    if (light.attenuation == Vec3f{1, 0, 0}) {
      return F(1);
    }
    const Vec3<F> c = vec_cast<F>(light.attenuation);
    attenuation = F(1) / (c.x + (c.y + c.z * distance) * distance);
  } else {
    attenuation = power(distance, -light.falloff);
  }
  return lane_min(attenuation, F(light.attenuation_limit));
}

/// f, where a range is stated times clamp(1 - (d / range)^4, 0, 1).
/// source  KHR_lights_punctual, range property
template <class F>
LUSTRO_INLINE F attenuate(const ShadingLight& light, const F& distance) {
  const F attenuation = fall_off(light, distance);
  if (light.range_scale == 0.0F) {
    return attenuation;
  }
  const F share = distance * F(light.range_scale);
  const F square = share * share;
  return attenuation * clamp01(F(1) - square * square);
}

/// s = 0 outside the cutoff, else cs^exponent, faded from 1 at the beam to 0 at the cutoff by smoothstep between the cosines, or by t^2.
template <class F>
LUSTRO_INLINE F spot_factor(const ShadingLight& light, const F& cs) {
  F spot = power(cs, light.exponent);
  if (light.beam_scale != 0.0F) {
    const F t = clamp01((cs - F(light.cos_cutoff)) * F(light.beam_scale));
    spot = spot * (t * t * (light.fade == SpotFade::quadratic ? F(1) : F(3) - F(2) * t));
  }
  return select(cs < F(light.cos_cutoff), F(0), spot);
}

/// L, distance, f and s of a light at a point.
template <class F>
LUSTRO_INLINE Incident<F> incident_light(const ShadingLight& light, const Vec3<F>& position) {
  if (light.type == LightType::directional) {
    return {vec_cast<F>(-light.travel), F(0), F(1), F(1), F(1)};
  }
  const Vec3<F> offset = vec_cast<F>(light.position) - position;
  const F distance = square_root(lane_max(dot(offset, offset), F(1e-30F)));  // in the light itself L is 0: no diffuse, no highlight
  const Vec3<F> to_light = offset * (F(1) / distance);
  const F attenuation = attenuate(light, distance);
  if (light.type == LightType::point) {
    return {to_light, distance, attenuation, F(1), F(1)};
  }
  return {to_light, distance, attenuation, spot_factor(light, -dot(vec_cast<F>(light.travel), to_light)), F(1)};
}

/// R = 2 (N.L) N - L
template <class F>
LUSTRO_INLINE Vec3<F> reflect_about(const Vec3<F>& normal, const Vec3<F>& to_light) {
  return normal * (F(2) * dot(normal, to_light)) - to_light;
}

/// R.V
template <class F>
LUSTRO_INLINE F r_dot_v(const Surface<F>& s, const Vec3<F>& to_light) {
  return dot(reflect_about(s.normal, to_light), s.to_eye);
}

/// N.H, 0 where L and V are opposite and H does not exist.
template <class F>
LUSTRO_INLINE F n_dot_h(const Surface<F>& s, const Vec3<F>& to_light) {
  const Vec3<F> sum = to_light + s.to_eye;
  return dot(s.normal, sum) / lane_max(length(sum), F(1e-15F));
}

/// What makes the lobe reflect exactly the share k_s of a uniform environment at normal incidence; the lobe is then a BRDF and is weighted by
/// N.L.
///   phong        (n + 2) / 2                            Lafortune and Willems 1994, times pi for classic units
///   blinn-phong  (n + 2) (n + 4) / (8 (2^(-n/2) + n))   exact at normal incidence, times pi
template <Lighting model, class N>
LUSTRO_INLINE N lobe_normalization(N n) {
  if constexpr (model == Lighting::phong) {
    return (n + N(2)) * N(0.5F);
  } else {
    return ((n + N(2)) * (n + N(4))) / (N(8) * (exp2_of(n * N(-0.5F)) + n));
  }
}

/// spec, gated: 0 where N.L <= 0.
template <Lighting model, class F, class N>
LUSTRO_INLINE F specular_factor(const Surface<F>& s, const N& shininess, const Vec3<F>& to_light, const F& n_dot_l, bool normalized) {
  F cosine;
  if constexpr (model == Lighting::phong) {
    cosine = r_dot_v(s, to_light);
  } else {
    cosine = n_dot_h(s, to_light);
  }
  const auto is_lit = n_dot_l > F(0);
  if (!any_of(is_lit)) {
    return F(0);  // without the power
  }
  F spec = power(lane_max(cosine, F(0)), shininess);
  if (normalized) {
    spec = spec * (F(lobe_normalization<model>(shininess.n)) * n_dot_l);
  }
  return select(is_lit, spec, F(0));
}

/// What a material reflects of a light at full strength, k_a l_a, k_d l_d and k_s l_s. K is F, or float where it is the same in all lanes.
template <class K>
struct Reflection {
  Vec3<K> ambient, diffuse, specular;
};

template <class K, class N>
LUSTRO_INLINE Reflection<K> reflection_of(const Coefficients<K, N>& k, const ShadingLight& light) {
  return {k.ambient * vec_cast<K>(light.ambient), k.diffuse * vec_cast<K>(light.diffuse), k.specular * vec_cast<K>(light.specular)};
}

/// f s [ k_a l_a + k_d l_d max(N.L, 0) + k_s l_s spec ]: one light's part.
template <Lighting model, class F, class K, class N>
LUSTRO_INLINE LightTerms<F> reflect_light(const Surface<F>& s, const Reflection<K>& k, const N& shininess, const Incident<F>& in,
                                          bool normalized) {
  const F strength = in.attenuation * in.spot;
  const F n_dot_l = dot(s.normal, in.to_light);
  LightTerms<F> part;
  part.ambient = vec_cast<F>(k.ambient) * strength;
  part.diffuse = vec_cast<F>(k.diffuse) * (strength * lane_max(n_dot_l, F(0)));
  if constexpr (model != Lighting::lambert) {
    const F spec = specular_factor<model>(s, shininess, in.to_light, n_dot_l, normalized);
    part.specular = vec_cast<F>(k.specular) * (strength * spec);
  }
  return part;
}

/// F, D and Vis of GGX, but for the colour of F.
template <class F>
struct Microfacets {
  F grazing;  ///< (1 - |V.H|)^5
  F lobe;     ///< D Vis N.L, 0 where N.L <= 0
};

/// The microfacets' part of reflect_ggx(). D's (N.H)^2 (a - 1) + 1 is a (N.H)^2 + |N x H|^2, which does not cancel where the lobe is narrow.
template <class F, class A>
LUSTRO_INLINE Microfacets<F> microfacets(const Surface<F>& s, const A& a, const Vec3<F>& to_light, const F& n_dot_l) {
  const Vec3<F> both = to_light + s.to_eye;
  const F square = lane_max(dot(both, both), F(1e-12F));  // below it L and V are opposite, and H does not exist
  const F from_grazing = lane_max(F(1) - lane_abs(dot(s.to_eye, both)) / square_root(square), F(0));
  const F from_grazing2 = from_grazing * from_grazing;
  const F along = dot(s.normal, both);
  const Vec3<F> across = cross(s.normal, both);
  const F spread = lane_max((F(a) * (along * along) + dot(across, across)) / square, F(a));
  const F n_dot_v = lane_abs(dot(s.normal, s.to_eye));
  const F masking_l = n_dot_l + square_root(F(a) + F(A(1) - a) * (n_dot_l * n_dot_l));
  const F masking_v = n_dot_v + square_root(F(a) + F(A(1) - a) * (n_dot_v * n_dot_v));
  const F lobe = (F(a) * n_dot_l) / ((spread * spread) * (masking_l * masking_v));
  return {(from_grazing2 * from_grazing2) * from_grazing, select(n_dot_l > F(0), lobe, F(0))};
}

/// One light's part by GGX, times pi for classic units: a perfect mirror of any roughness reflects at most what arrives. a = alpha^2 = 2 / (n +
/// 2).
///   F   = k_s + (1 - k_s) (1 - |V.H|)^5        Schlick 1994; k_s counts 1 where it is more
///   D   = a / ((N.H)^2 (a - 1) + 1)^2          Trowbridge and Reitz 1975, Walter et al. 2007
///   Vis = 1 / ((N.L + sqrt(a + (1 - a) (N.L)^2)) (|N.V| + sqrt(a + (1 - a) (N.V)^2)))    Smith 1967, masking and shadowing apart
///   f s [ k_a l_a + k_d l_d (1 - F) max(N.L, 0) + l_s F D Vis max(N.L, 0) ]
/// source  glTF 2.0 specification, appendix B.2 and B.3
template <class F, class K, class N>
LUSTRO_INLINE LightTerms<F> reflect_ggx(const Surface<F>& s, const Reflection<K>& k, const Vec3<K>& specular, const Vec3f& light_specular,
                                        const N& shininess, const Incident<F>& in) {
  using A = std::remove_cvref_t<decltype(shininess.n)>;
  const F share = in.attenuation * in.spot;
  const F n_dot_l = dot(s.normal, in.to_light);
  LightTerms<F> part{vec_cast<F>(k.ambient) * share, {}, {}};
  if (!any_of(n_dot_l > F(0))) {
    return part;
  }
  const Microfacets<F> facets = microfacets(s, A(2) / (shininess.n + A(2)), in.to_light, n_dot_l);
  const Vec3<F> facing = vec_cast<F>(Vec3<K>{lane_min(specular.x, K(1)), lane_min(specular.y, K(1)), lane_min(specular.z, K(1))});
  const Vec3<F> not_facing = Vec3<F>{F(1), F(1), F(1)} - facing;
  const Vec3<F> fresnel = facing + not_facing * facets.grazing;
  part.diffuse = (vec_cast<F>(k.diffuse) * (share * lane_max(n_dot_l, F(0)))) * (not_facing * (F(1) - facets.grazing));
  part.specular = (vec_cast<F>(light_specular) * fresnel) * (share * facets.lobe);
  return part;
}

/// What reaches a point from all around, and from no light.
struct SurroundingLight {
  Vec3f ambient;                                    ///< I_a
  const ShadingEnvironment* environment = nullptr;  ///< E; null: none
  bool is_occluded = false;                         ///< a is asked for

  SurroundingLight(const Vec3f& ambient_, const ShadingEnvironment* environment_ = nullptr,  // NOLINT(google-explicit-constructor)
                   bool is_occluded_ = false)
      : ambient(ambient_), environment(environment_), is_occluded(is_occluded_) {}
};

/// What no light brings: a k_a I_a, a k_d E, k_e; of `constant` k_d alone.
template <class F, class K, class N>
LUSTRO_INLINE Terms<F> unlit_terms(Lighting model, const Vec3<F>& normal, const Coefficients<K, N>& k, const SurroundingLight& around,
                                   const F& openness) {
  if (model == Lighting::constant) {
    return {{}, vec_cast<F>(k.diffuse), {}, {}};
  }
  Terms<F> terms{vec_cast<F>(k.ambient * vec_cast<K>(around.ambient)), {}, {}, vec_cast<F>(k.emission)};
  if (around.environment != nullptr) {
    terms.diffuse = vec_cast<F>(k.diffuse) * light_around(*around.environment, normal);
  }
  if (around.is_occluded) {
    terms.ambient = terms.ambient * openness;
    terms.diffuse = terms.diffuse * openness;
  }
  return terms;
}

/// The whole equation at one point. reflection_at(i) is reflection_of() light i, visibility_at(i) the v of a light that has a shadow, and a in
/// the place after the last light where there is occlusion; visit(i, incident, part) sees every light's part, in order.
template <Lighting model, class F, class K, class N, class ReflectionAt, class VisibilityAt, class Visit>
LUSTRO_INLINE Terms<F> light_surface(const Surface<F>& s, const Coefficients<K, N>& k, const SurroundingLight& around,
                                     std::span<const ShadingLight> lights, bool normalized, ReflectionAt&& reflection_at,
                                     VisibilityAt&& visibility_at, Visit&& visit) {
  if constexpr (model == Lighting::constant) {
    return unlit_terms(model, s.normal, k, around, F(1));
  } else {
    const F openness = around.is_occluded ? visibility_at(lights.size()) : F(1);
    Terms<F> terms = unlit_terms(model, s.normal, k, around, openness);
    for (std::size_t i = 0; i < lights.size(); ++i) {
      Incident<F> in = incident_light(lights[i], s.position);
      LightTerms<F> part;
      if constexpr (model == Lighting::ggx) {
        part = reflect_ggx(s, reflection_at(i), k.specular, lights[i].specular, k.shininess, in);
      } else {
        part = reflect_light<model>(s, reflection_at(i), k.shininess, in, normalized);
      }
      if (around.is_occluded) {
        part.ambient = part.ambient * openness;
      }
      if (lights[i].has_shadow) {
        in.visibility = visibility_at(i);
        part.diffuse = part.diffuse * in.visibility;
        part.specular = part.specular * in.visibility;
      }
      terms.ambient += part.ambient;
      terms.diffuse += part.diffuse;
      terms.specular += part.specular;
      visit(i, in, part);
    }
    return terms;
  }
}

/// The same with the model chosen at run time.
template <class F, class K, class N, class ReflectionAt, class VisibilityAt, class Visit>
LUSTRO_INLINE Terms<F> light_surface(Lighting model, const Surface<F>& s, const Coefficients<K, N>& k, const SurroundingLight& around,
                                     std::span<const ShadingLight> lights, bool normalized, ReflectionAt&& reflection_at,
                                     VisibilityAt&& visibility_at, Visit&& visit) {
  switch (model) {
    case Lighting::constant:
      return light_surface<Lighting::constant>(s, k, around, lights, normalized, reflection_at, visibility_at, visit);
    case Lighting::lambert:
      return light_surface<Lighting::lambert>(s, k, around, lights, normalized, reflection_at, visibility_at, visit);
    case Lighting::phong:
      return light_surface<Lighting::phong>(s, k, around, lights, normalized, reflection_at, visibility_at, visit);
    case Lighting::ggx:
      return light_surface<Lighting::ggx>(s, k, around, lights, normalized, reflection_at, visibility_at, visit);
    case Lighting::blinn_phong:
      break;
  }
  return light_surface<Lighting::blinn_phong>(s, k, around, lights, normalized, reflection_at, visibility_at, visit);
}

/// The same from the coefficients alone.
template <class F, class N, class VisibilityAt, class Visit>
LUSTRO_INLINE Terms<F> light_surface(Lighting model, const Surface<F>& s, const Coefficients<F, N>& k, const SurroundingLight& around,
                                     std::span<const ShadingLight> lights, bool normalized, VisibilityAt&& visibility_at, Visit&& visit) {
  return light_surface(
      model, s, k, around, lights, normalized, [&](std::size_t i) { return reflection_of(k, lights[i]); }, visibility_at, visit);
}

/// The same without shadows.
template <class F, class N, class Visit>
LUSTRO_INLINE Terms<F> light_surface(Lighting model, const Surface<F>& s, const Coefficients<F, N>& k, const SurroundingLight& around,
                                     std::span<const ShadingLight> lights, bool normalized, Visit&& visit) {
  return light_surface(
      model, s, k, around, lights, normalized, [](std::size_t) { return F(1); }, visit);
}

}  // namespace lustro
