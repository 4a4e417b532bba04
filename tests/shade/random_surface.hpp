// Random surfaces under random lights, from the bits of mt19937, so that every system draws the same ones.
#pragma once

#include <random>
#include <vector>

#include "shade/textbook.hpp"

namespace lustro {

class RandomSurface {
 public:
  explicit RandomSurface(std::uint32_t seed) : bits_(seed) {}

  /// 0 <= x < 1
  float unit() { return static_cast<float>(bits_() >> 8) * 0x1p-24F; }
  float between(float low, float high) { return low + (high - low) * unit(); }
  double wide(float low, float high) { return static_cast<double>(between(low, high)); }
  bool chance(float share) { return unit() < share; }
  std::size_t below(std::size_t n) { return bits_() % n; }

  Vec3f color(float brightest = 1) { return {between(0, brightest), between(0, brightest), between(0, brightest)}; }

  /// Even over the sphere.
  Vec3f direction() {
    for (;;) {
      const Vec3d v = vec_cast<double>(Vec3f{between(-1, 1), between(-1, 1), between(-1, 1)});
      if (const double l = dot(v, v); l < 1 && l > 1e-4) {
        return vec_cast<float>(normalize(v));
      }
    }
  }

  /// A point before the eye, which looks at it in perspective or, now and then, from the same side everywhere; most normals face the eye.
  Surface<float> surface() {
    Surface<float> s;
    s.position = {between(-5, 5), between(-5, 5), between(-10, -1)};
    s.normal = direction();
    s.to_eye = chance(0.25F) ? direction() : vec_cast<float>(normalize(vec_cast<double>(-s.position)));
    if (dot(s.normal, s.to_eye) < 0 && chance(0.8F)) {
      s.normal = -s.normal;
    }
    return s;
  }

  Coefficients<float> coefficients() {
    return {.ambient = color(), .diffuse = color(), .specular = color(), .emission = color(), .shininess = exponent(200, 1000)};
  }

  Lighting model() {
    constexpr Lighting kModels[] = {Lighting::constant, Lighting::lambert, Lighting::phong, Lighting::blinn_phong, Lighting::ggx};
    return kModels[below(5)];
  }

  /// Of any type, bright or dim, most spots aimed at the place where the surfaces are.
  Light light() {
    constexpr LightType kTypes[] = {LightType::directional, LightType::point, LightType::spot};
    Light out;
    out.type = kTypes[below(3)];
    out.position = vec_cast<double>(Vec3f{between(-8, 8), between(-8, 8), between(-12, 4)});
    out.direction = vec_cast<double>(direction());
    if (chance(0.8F)) {
      out.direction = vec_cast<double>(Vec3f{between(-2, 2), between(-2, 2), between(-8, -3)}) - out.position;
    }
    out.ambient.rgb = color();
    out.diffuse.rgb = color(2);
    out.specular.rgb = color(2);
    out.attenuation.unclamped = chance(0.3F);
    if (chance(0.5F)) {
      constexpr double kPowers[] = {0, 0.5, 1, 1.7, 2, 3};
      out.attenuation.falloff = kPowers[below(6)];
    } else if (chance(0.8F)) {
      out.attenuation.constant = wide(0.1F, 2);
      out.attenuation.linear = wide(0, 0.5F);
      out.attenuation.quadratic = wide(0, 0.3F);
    }
    if (chance(0.3F)) {
      out.attenuation.range = wide(1, 20);
    }
    out.cutoff = wide(10, 90);
    if (chance(0.5F)) {
      out.beam = out.cutoff * 0.9 * static_cast<double>(unit());
      out.fade = chance(0.5F) ? SpotFade::quadratic : SpotFade::smoothstep;
    }
    out.exponent = static_cast<double>(exponent(60, 128));
    return out;
  }

  std::vector<Light> lights(std::size_t count) {
    std::vector<Light> out;
    while (out.size() < count) {
      out.push_back(light());
    }
    return out;
  }

  /// Whether the point lies so near to a step of the equation (the gate, the edge of a cone) that a rounding decides.
  static bool is_at_an_edge(const textbook::Point& p, const Light& light) {
    const Vec3d travel = normalize(light.direction);
    const Vec3d l = light.type == LightType::directional ? -travel : normalize(light.position - p.position);
    const bool at_cone = light.type == LightType::spot && std::abs(-dot(travel, l) - textbook::cosine_of(light.cutoff)) < 1e-5;
    return std::abs(dot(p.normal, l)) < 1e-5 || at_cone;
  }

 private:
  float exponent(float usual, float rare) {
    switch (below(8)) {
      case 0:
        return 0;
      case 1:
        return 1;
      case 2:
        return rare;
      default:
        return between(1, usual);
    }
  }

  std::mt19937 bits_;
};

}  // namespace lustro
