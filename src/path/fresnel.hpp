// What a smooth boundary between two transparent materials does with light: Fresnel's equations and Snell's law.
#pragma once

#include <algorithm>
#include <cmath>

#include "lustro/vec.hpp"

namespace lustro {

/// The share of unpolarised light that is mirrored, and the cosine behind the boundary (0: nothing passes).
///
/// cosine  of the angle between the direction and the normal on its side, 0..1
/// ratio   index of the material behind over that of the one before
/// source  Fresnel 1823; Born and Wolf, Principles of Optics, 1.5.2
struct Fresnel {
  float reflected = 1;
  float cosine_behind = 0;
};
[[nodiscard]] inline Fresnel fresnel_dielectric(float cosine, float ratio) {
  const float sine2_behind = (1.0F - cosine * cosine) / (ratio * ratio);
  if (!(sine2_behind < 1.0F)) {
    return {};  // total reflection
  }
  const float behind = std::sqrt(1.0F - sine2_behind);
  const float parallel = (ratio * cosine - behind) / (ratio * cosine + behind);
  const float across = (cosine - ratio * behind) / (cosine + ratio * behind);
  return {0.5F * (parallel * parallel + across * across), behind};
}

/// Where light that leaves along `to_eye` comes from through the boundary. normal: on the side of to_eye. Unit.
[[nodiscard]] inline Vec3f refracted(const Vec3f& to_eye, const Vec3f& normal, float cosine, float cosine_behind, float ratio) {
  return normalize(normal * (cosine / ratio - cosine_behind) - to_eye * (1.0F / ratio));
}

}  // namespace lustro
