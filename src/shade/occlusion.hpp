// How much of the light from all around arrives at a point: which part of the hemisphere above it is open (ambient obscurance: Zhukov, Iones and
// Kronin 1998). F is a lane type, as in shade/lighting.hpp.
//
//   a = sum_i w_i V_i / sum_i w_i        w_i = max(N.D_i, 0)
//
// The scene is cut by many parallel lines in each of some directions, and every line keeps the depths at which it meets surfaces, sorted. Each
// line serves both of its ends: of every direction, the one that lies above the surface is D_i. V_i is 1 where the line meets nothing between
// the point and the radius, and rises from 0 at half of the radius to 1 at all of it where it does. The four lines around the point are
// weighted bilinearly. As in shade/depth_map.hpp each is compared with the depth of the receiver's own plane, lifted, at that line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "lustro/vec.hpp"
#include "math/affine_rows.hpp"
#include "math/lane.hpp"

namespace lustro {

/// Parallel lines in one direction.
struct OcclusionLines {
  AffineRows place;  ///< from a point relative to the eye to (lines to the right, lines down, depth in layers' units)
  Vec3f up;          ///< unit, from which depth is measured: against the lines' direction
};

/// The same for all lanes: scene/occlusion_maps.cpp makes it.
struct ShadingOcclusion {
  static constexpr std::int32_t kLayers = 8;       ///< depths that a line keeps: those nearest to its upper end
  static constexpr std::int32_t kWords = 4;        ///< of two layers each, the nearer one below
  static constexpr std::int32_t kNothing = 65535;  ///< a layer that is not used
  static constexpr float kLift = 0.3F;             ///< lines by which the receiver's plane is lifted

  std::span<const OcclusionLines> directions;
  const std::int32_t* layers = nullptr;  ///< directions x size x size x kWords
  std::int32_t size = 0;                 ///< lines on a side
  float lift = 0;                        ///< kLift lines, world units
  float across = 1;                      ///< lines a world unit
  float deep = 1;                        ///< layers' units a world unit
  float reach = 0;                       ///< the radius in layers' units
};

/// How far away, in layers' units, a line's nearest surface above the plane is; huge where there is none.
///
/// side  1 where the line's upper end is above the plane, else -1
template <class F>
LUSTRO_INLINE F nearest_above(const std::int32_t* layers, const IntOf<F>& first, const F& depth, const F& side) {
  const F nothing(static_cast<float>(ShadingOcclusion::kNothing));
  F nearest(1e30F);
  for (std::int32_t word = 0; word < ShadingOcclusion::kWords; ++word) {
    const IntOf<F> both = gather(layers, first + IntOf<F>(word));
    const F upper = to_float(both & IntOf<F>(0xFFFF));
    if (!any_of(upper < nothing)) {
      break;  // nor is anything below
    }
    const auto look = [&](const F& layer) {
      const F above = select(layer < nothing, (depth - layer) * side, F(-1));
      nearest = select(above > F(0), lane_min(nearest, above), nearest);
    };
    look(upper);
    look(to_float((both >> 16) & IntOf<F>(0xFFFF)));
  }
  return nearest;
}

/// V of one direction.
template <class F>
LUSTRO_INLINE F openness_along(const ShadingOcclusion& occlusion, std::size_t direction, const Vec3<F>& position, const Vec3<F>& face_normal) {
  using I = IntOf<F>;
  const AffineRows& place = occlusion.directions[direction].place;
  const Vec3<F> at = place(position);
  const Vec3<F> turned = place.turned(face_normal);
  const F steep = F(1e-2F * occlusion.deep);
  const F facing = select(turned.z < F(0), -lane_max(-turned.z, steep), lane_max(turned.z, steep));
  const F scale = F(occlusion.deep * occlusion.deep) / facing;
  const F slope_x = -turned.x * scale * F(1 / (occlusion.across * occlusion.across));
  const F slope_y = -turned.y * scale * F(1 / (occlusion.across * occlusion.across));
  const F lifted = at.z + scale * F(occlusion.lift);
  const F side = select(turned.z < F(0), F(1), F(-1));

  const F most(static_cast<float>(occlusion.size) - 1.5F);
  const F left = lane_min(lane_max(at.x - F(0.5F), F(0)), most);  // NaN: the first line
  const F top = lane_min(lane_max(at.y - F(0.5F), F(0)), most);
  const I column = truncate(left);
  const I row = truncate(top);
  const F share_x = left - to_float(column);
  const F share_y = top - to_float(row);
  const F corner = (lifted + slope_x * ((to_float(column) + F(0.5F)) - at.x)) + slope_y * ((to_float(row) + F(0.5F)) - at.y);
  const auto first_map = static_cast<std::int32_t>(direction) * (occlusion.size * occlusion.size);
  const auto open = [&](std::int32_t x, std::int32_t y) {
    const I line = (I(first_map) + (row + I(y)) * I(occlusion.size)) + (column + I(x));
    const F depth = (corner + slope_x * F(static_cast<float>(x))) + slope_y * F(static_cast<float>(y));
    const F nearest = nearest_above(occlusion.layers, line * I(ShadingOcclusion::kWords), depth, side);
    return clamp01(nearest * F(2 / occlusion.reach) - F(1));
  };
  const F upper_left = open(0, 0);
  const F lower_left = open(0, 1);
  const F upper = upper_left + (open(1, 0) - upper_left) * share_x;
  const F lower = lower_left + (open(1, 1) - lower_left) * share_x;
  return upper + (lower - upper) * share_y;
}

/// a, 0..1.
///
/// normal       N, unit, on the side that is lit
/// face_normal  of the receiver, unit, either side
template <class F>
LUSTRO_INLINE F openness_at(const ShadingOcclusion& occlusion, const Vec3<F>& position, const Vec3<F>& normal, const Vec3<F>& face_normal) {
  const F turn = select(dot(normal, face_normal) < F(0), F(-1), F(1));
  const Vec3<F> above = face_normal * turn;
  F sum(0);
  F weights(0);
  for (std::size_t i = 0; i < occlusion.directions.size(); ++i) {
    const Vec3<F> up = vec_cast<F>(occlusion.directions[i].up);
    const F along = dot(normal, up);
    const F weight = lane_max(select(dot(above, up) < F(0), -along, along), F(0));
    if (!any_of(weight > F(0))) {
      continue;
    }
    sum = sum + weight * openness_along(occlusion, i, position, above);
    weights = weights + weight;
  }
  return select(weights > F(0), clamp01(sum / weights), F(1));
}

}  // namespace lustro
