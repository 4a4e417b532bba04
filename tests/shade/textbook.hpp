// The lighting equation as a textbook prints it: double precision, libm, no thought of speed. It is written from docs/using/scene-file.md and
// shares nothing with src/shade, so that agreement means something.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "lustro/scene.hpp"
#include "shade/lighting.hpp"

namespace lustro::textbook {

inline constexpr double kPi = 3.14159265358979323846;

inline double cosine_of(double degrees) {
  return std::cos(degrees * kPi / 180);
}

/// x^n with x^0 = 1.
inline double raise(double x, double n) {
  return n == 0 ? 1 : std::pow(std::max(x, 0.0), n);
}

/// f
inline double attenuation(const Light& light, double d) {
  if (light.type == LightType::directional) {
    return 1;
  }
  const Attenuation& a = light.attenuation;
  const double f = a.falloff ? 1 / std::pow(d, *a.falloff) : 1 / (a.constant + a.linear * d + a.quadratic * d * d);
  return (a.unclamped ? f : std::min(f, 1.0)) * (a.range ? std::clamp(1 - std::pow(d / *a.range, 4), 0.0, 1.0) : 1);
}

/// s, for a point towards which the light's ray makes an angle of cosine cs with the axis of the spot.
inline double spot(const Light& light, double cs) {
  if (light.type != LightType::spot) {
    return 1;
  }
  if (cs < cosine_of(light.cutoff)) {
    return 0;
  }
  double s = raise(cs, light.exponent);
  if (light.beam) {
    const double t = std::clamp((cs - cosine_of(light.cutoff)) / (cosine_of(*light.beam) - cosine_of(light.cutoff)), 0.0, 1.0);
    s *= light.fade == SpotFade::quadratic ? t * t : t * t * (3 - 2 * t);
  }
  return s;
}

/// A point, its normal and the way to the eye; the eye is the origin.
struct Point {
  Vec3d position, normal, to_eye;
};

/// What makes the lobe's albedo 1 at normal incidence (Lafortune and Willems 1994; its analogue for N.H), in units where white is 1.
inline double normalization(Lighting model, double n) {
  return model == Lighting::phong ? (n + 2) / 2 : (n + 2) * (n + 4) / (8 * (std::pow(2, -n / 2) + n));
}

/// glTF 2.0, appendix B: its metallic-roughness BRDF with c_diff = k_d, f0 = k_s, alpha^2 = 2 / (n + 2), times N.L and, for classic units, pi.
struct Microfacet {
  Vec3d diffuse, specular;
};
inline Microfacet microfacet(const Vec3d& n, const Vec3d& l, const Vec3d& v, const Vec3d& k_d, const Vec3d& k_s, double exponent) {
  const double n_dot_l = dot(n, l);
  if (n_dot_l <= 0) {
    return {};
  }
  const Vec3d h = normalize(l + v);
  const double a2 = 2 / (exponent + 2);
  const double n_dot_h = dot(n, h);
  const double n_dot_v = std::abs(dot(n, v));
  const double d = a2 / (kPi * std::pow(n_dot_h * n_dot_h * (a2 - 1) + 1, 2));
  const auto g = [&](double c) { return 2 * c / (c + std::sqrt(a2 + (1 - a2) * c * c)); };
  const double visibility = g(n_dot_l) * g(n_dot_v) / (4 * n_dot_l * n_dot_v);
  const double x = std::pow(1 - std::abs(dot(v, h)), 5);
  const Vec3d one{1, 1, 1};
  const Vec3d f0{std::min(k_s.x, 1.0), std::min(k_s.y, 1.0), std::min(k_s.z, 1.0)};
  const Vec3d f = f0 + (one - f0) * x;
  return {k_d * (one - f) * n_dot_l, f * (kPi * d * visibility * n_dot_l)};
}

struct Result {
  Vec3d ambient, diffuse, specular, emission;
};

/// I = k_e + k_a I_a + sum_i f_i s_i [ k_a l_a + k_d l_d max(N.L, 0) + k_s l_s spec ], term by term.
inline Result light(Lighting model, const Point& p, const Coefficients<double>& k, const Vec3d& scene_ambient, const std::vector<Light>& lights,
                    bool normalized) {
  if (model == Lighting::constant) {
    return {{}, k.diffuse, {}, {}};
  }
  Result result{k.ambient * scene_ambient, {}, {}, k.emission};
  for (const Light& light : lights) {
    const Vec3d travel = normalize(light.direction);
    const Vec3d offset = light.position - p.position;
    const Vec3d l = light.type == LightType::directional ? -travel : normalize(offset);
    const double fs = attenuation(light, length(offset)) * spot(light, -dot(travel, l));
    const double n_dot_l = dot(p.normal, l);
    const Vec3d r = 2 * n_dot_l * p.normal - l;
    const Vec3d h = normalize(l + p.to_eye);
    if (model == Lighting::ggx) {
      const Microfacet facets = microfacet(p.normal, l, p.to_eye, k.diffuse, k.specular, static_cast<double>(k.shininess.n));
      result.ambient += k.ambient * vec_cast<double>(light.ambient.rgb) * fs;
      result.diffuse += facets.diffuse * vec_cast<double>(light.diffuse.rgb) * fs;
      result.specular += facets.specular * vec_cast<double>(light.specular.rgb) * fs;
      continue;
    }
    double spec = 0;
    if (model != Lighting::lambert && n_dot_l > 0) {
      spec = raise(model == Lighting::phong ? dot(r, p.to_eye) : dot(p.normal, h), static_cast<double>(k.shininess.n));
      spec *= normalized ? normalization(model, static_cast<double>(k.shininess.n)) * n_dot_l : 1;
    }
    result.ambient += k.ambient * vec_cast<double>(light.ambient.rgb) * fs;
    result.diffuse += k.diffuse * vec_cast<double>(light.diffuse.rgb) * (fs * std::max(n_dot_l, 0.0));
    result.specular += k.specular * vec_cast<double>(light.specular.rgb) * (fs * spec);
  }
  return result;
}

/// The light as the equation's code wants it, by the docstrings of ShadingLight; the eye is the origin.
inline ShadingLight ready(const Light& light) {
  ShadingLight out;
  out.type = light.type;
  out.position = vec_cast<float>(light.position);
  out.travel = vec_cast<float>(normalize(light.direction));
  out.ambient = light.ambient.rgb;
  out.diffuse = light.diffuse.rgb;
  out.specular = light.specular.rgb;
  const Attenuation& a = light.attenuation;
  const double p = a.falloff.value_or(0);
  out.attenuation = vec_cast<float>(Vec3d{a.constant, a.linear, a.quadratic});
  if (a.falloff && (p == 0 || p == 1 || p == 2)) {
    out.attenuation = {p == 0 ? 1.0F : 0.0F, p == 1 ? 1.0F : 0.0F, p == 2 ? 1.0F : 0.0F};
  } else if (a.falloff) {
    out.falloff = static_cast<float>(p);
  }
  out.attenuation_limit = a.unclamped ? 1e30F : 1.0F;
  out.range_scale = a.range ? static_cast<float>(1 / *a.range) : 0;
  out.cos_cutoff = static_cast<float>(light.cutoff == 90 ? 0 : cosine_of(light.cutoff));
  if (light.beam) {
    out.fade = light.fade;
    out.cos_beam = static_cast<float>(cosine_of(*light.beam));
    out.beam_scale = static_cast<float>(1 / (cosine_of(*light.beam) - cosine_of(light.cutoff)));
  }
  out.exponent = static_cast<float>(light.exponent);
  return out;
}

}  // namespace lustro::textbook
