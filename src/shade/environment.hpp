// Light from infinitely far away, all around, as a surface without a mirror's sharpness receives it: nine numbers a channel.
//
//   source  Ramamoorthi and Hanrahan 2001, An Efficient Representation for Irradiance Environment Maps: the cosine keeps 99 % of the energy in
//           spherical harmonics of order 0 to 2
#pragma once

#include <array>

#include "lustro/vec.hpp"
#include "math/lane.hpp"

namespace lustro {

/// What a white Lambert surface shows under the environment, as a polynomial of its normal: of 1, x, y, z, xy, yz, xz, z^2, x^2 - y^2.
struct ShadingEnvironment {
  std::array<Vec3f, 9> of{};
};

/// k_d's factor for a unit normal. The orders that are left out may ring below 0, where there is no light.
template <class F>
LUSTRO_INLINE Vec3<F> light_around(const ShadingEnvironment& environment, const Vec3<F>& n) {
  const std::array<F, 9> basis{F(1), n.x, n.y, n.z, n.x * n.y, n.y * n.z, n.x * n.z, n.z * n.z, n.x * n.x - n.y * n.y};
  Vec3<F> sum = vec_cast<F>(environment.of[0]);
  for (std::size_t i = 1; i < basis.size(); ++i) {
    sum = sum + vec_cast<F>(environment.of[i]) * basis[i];
  }
  return {lane_max(sum.x, F(0)), lane_max(sum.y, F(0)), lane_max(sum.z, F(0))};
}

}  // namespace lustro
