// Fog on the Euclidean distance from the eye (OpenGL 2.1 specification, 3.10, equations 3.31 to 3.33): C = f C_r + (1 - f) C_f.
#pragma once

#include "lustro/options.hpp"
#include "lustro/vec.hpp"
#include "math/lane.hpp"
#include "math/power.hpp"

namespace lustro {

/// Fog, ready for shading. The same for all lanes.
struct ShadingFog {
  FogMode mode = FogMode::exp;
  float density = 1;
  float end = 1;
  float range_scale = 1;  ///< 1 / (end - start)
  Vec3f color{};
};

/// f: the share of the surface's colour that reaches the eye, 0..1.
///   linear (end - d) / (end - start)      exp e^(-density d)      exp2 e^(-(density d)^2)
template <class F>
LUSTRO_INLINE F fog_factor(const ShadingFog& fog, const F& distance) {
  constexpr float kLog2E = 1.44269504F;
  if (fog.mode == FogMode::linear) {
    return clamp01((F(fog.end) - distance) * F(fog.range_scale));
  }
  const F depth = F(fog.density) * distance;
  return clamp01(exp2_of((fog.mode == FogMode::exp ? depth : depth * depth) * F(-kLog2E)));
}

}  // namespace lustro
