// A surface that shows nothing but the shadows on it: black, and as opaque as they are dark (MTL, illum 10; product pictures' floors).
//
//   opacity = 1 - lit / unhindered
//
//   lit         the luminance of a white Lambert surface there: a I_a + a E + sum_i f_i s_i [ a l_a + v_i l_d max(N.L, 0) ]
//   unhindered  the same with a = v_i = 1
//
// source  docs/using/shadows.md; luminance: Rec. ITU-R BT.709
#pragma once

#include <cstddef>
#include <span>

#include "shade/lighting.hpp"

namespace lustro {

template <class F>
LUSTRO_INLINE F luminance_of(const Vec3<F>& c) {
  return (F(0.2126F) * c.x + F(0.7152F) * c.y) + F(0.0722F) * c.z;
}

/// visibility_at(i)  v of light i, and a in the place after the last light; asked for where there are shadows, and occlusion
template <class F, class VisibilityAt>
LUSTRO_INLINE F caught_shadow(const SurroundingLight& around, std::span<const ShadingLight> lights, const Vec3<F>& position,
                              const Vec3<F>& normal, VisibilityAt&& visibility_at) {
  const F open = around.is_occluded ? visibility_at(lights.size()) : F(1);
  F unhindered = luminance_of(vec_cast<F>(around.ambient));
  if (around.environment != nullptr) {
    unhindered = unhindered + luminance_of(light_around(*around.environment, normal));
  }
  F lit = unhindered * open;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const ShadingLight& light = lights[i];
    const Incident<F> in = incident_light(light, position);
    const F strength = in.attenuation * in.spot;
    const F ambient = strength * luminance_of(vec_cast<F>(light.ambient));
    const F direct = luminance_of(vec_cast<F>(light.diffuse)) * (strength * lane_max(dot(normal, in.to_light), F(0)));
    unhindered = unhindered + (ambient + direct);
    lit = lit + (ambient * open + direct * (light.has_shadow ? visibility_at(i) : F(1)));
  }
  return select(unhindered > F(0), clamp01(F(1) - lit / unhindered), F(0));
}

}  // namespace lustro
