// That the factors of an Explanation multiply to its terms, and those add up to its fragments: what a reader does with pencil and paper.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lustro/lustro.hpp"

namespace lustro {

inline void expect_near(const Vec3f& a, const Vec3f& b, const char* what) {
  const float tolerance = 2e-6F + 2e-5F * std::max({std::abs(b.x), std::abs(b.y), std::abs(b.z)});
  EXPECT_NEAR(a.x, b.x, tolerance) << what;
  EXPECT_NEAR(a.y, b.y, tolerance) << what;
  EXPECT_NEAR(a.z, b.z, tolerance) << what;
}

/// Of classic lighting (not GGX) that is not normalised.
inline void expect_products(const Explanation& e) {
  for (const FragmentExplanation& f : e.fragments) {
    Vec3f ambient{}, diffuse{}, specular{}, emission{};
    for (const ShadingExplanation& s : f.shadings) {
      if (f.lighting == Lighting::constant) {
        return;
      }
      Vec3f sums[3]{s.k_ambient * e.ambient_light * s.openness, s.k_diffuse * s.from_environment * s.openness, {}};
      for (const LightExplanation& l : s.lights) {
        const float strength = l.attenuation * l.spot;
        const float cosine = f.lighting == Lighting::phong ? l.r_dot_v : l.n_dot_h;
        const bool has_highlight = f.lighting != Lighting::lambert && l.n_dot_l > 0;
        const float spec = has_highlight ? std::pow(std::max(cosine, 0.0F), s.shininess) : 0;
        expect_near(s.k_ambient * l.light_ambient * (strength * s.openness), l.ambient, "a light's ambient");
        expect_near(s.k_diffuse * l.light_diffuse * (strength * l.visibility * std::max(l.n_dot_l, 0.0F)), l.diffuse, "a light's diffuse");
        expect_near(s.k_specular * l.light_specular * (strength * l.visibility * spec), l.specular, "a light's specular");
        sums[0] += l.ambient;
        sums[1] += l.diffuse;
        sums[2] += l.specular;
      }
      expect_near(sums[0] * s.clamp, s.ambient, "ambient");
      expect_near(sums[1] * s.clamp, s.diffuse, "diffuse");
      expect_near(sums[2] * s.clamp, s.specular, "specular");
      expect_near(s.k_emission * s.clamp, s.emission, "emission");
      ambient += s.ambient * s.weight;
      diffuse += s.diffuse * s.weight;
      specular += s.specular * s.weight;
      emission += s.emission * s.weight;
    }
    expect_near(ambient * f.maps_ambient * f.fog_factor, f.ambient, "the fragment's ambient");
    expect_near(diffuse * f.maps_diffuse * f.fog_factor, f.diffuse, "the fragment's diffuse");
    expect_near((specular * f.maps_specular + f.reflection) * f.fog_factor, f.specular, "the fragment's specular");
    expect_near(emission * f.maps_emission * f.fog_factor, f.emission, "the fragment's emission");
  }
}

}  // namespace lustro
