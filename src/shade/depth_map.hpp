// How much of a light arrives at a point: the point's depth from the light against the depths that the light sees (Williams 1978), as a share of
// the texels around it (Reeves, Salesin and Cook 1987). F is a lane type, as in shade/lighting.hpp.
//
// Two things make surfaces shadow themselves (acne) or leak light, and are kept apart here:
//   slope     every texel is compared with the depth of the receiver's own plane at that texel's centre, not with the point's depth: exact for
//             flat surfaces at any slope (Schueler 2005, Isidoro 2006, receiver plane depth)
//   lift      that plane is lifted off the surface, along its normal, by kLift texels as they lie on the surface's place in space: more than
//             rounding and neighbours that bend towards the light can make up, less than shadows are wrong by for being made of texels
//
// A third thing is the mesh itself: facing_share() ends the light where a face turns away from it that its smooth normals do not.
//
// A texel whose depth is nearer to the light than the lifted plane is in shadow. Keys stand for depths: larger is nearer, and linear on the map
// (1 / depth in perspective), so that a plane is linear on the map, too.
#pragma once

#include <cstddef>
#include <cstdint>

#include "lustro/vec.hpp"
#include "math/affine_rows.hpp"
#include "math/lane.hpp"
#include "shade/lighting.hpp"

namespace lustro {

/// How a light sees the scene: in parallel, in a cone by one picture, or all around by the six faces of a cube.
enum class DepthShape : std::uint8_t { none, parallel, cone, cube };

/// A map of depths, the same for all lanes: scene/depth_maps.cpp lays it out, a renderer draws it.
struct DepthMap {
  static constexpr float kLift = 0.5F;

  DepthShape shape = DepthShape::none;
  std::int32_t size = 0;      ///< texels a side of a face
  std::int32_t softness = 0;  ///< texels by which edges are blurred on either side
  /// From a point relative to the eye to (texels times depth from the map's centre, to the right and down; depth) in a cone; in parallel
  /// without the depth; of a cube to the point relative to the light, in the world's orientation.
  AffineRows place;
  float texels = 1;             ///< a unit, at depth 1 where it is no parallel map
  float nearest = 0;            ///< depth
  float key_scale = 1;          ///< of a parallel map: key = (farthest - depth) key_scale
  float farthest = 0;           ///< depth
  const float* keys = nullptr;  ///< faces x size x size, row by row; not above 0 where there is nothing
};

/// A point on a map: where it lies, and the key of its plane, lifted.
template <class F>
struct DepthPlane {
  F x, y;              ///< texels, from the upper left corner of the face
  F key;               ///< at (x, y)
  F slope_x, slope_y;  ///< of the key, a texel
  IntOf<F> first;      ///< of the face's keys
};

/// normal  of the receiver, unit, either side
template <class F>
LUSTRO_INLINE DepthPlane<F> depth_plane(const DepthMap& map, const Vec3<F>& position, const Vec3<F>& normal) {
  const F center(static_cast<float>(map.size) * 0.5F);
  const F lift((DepthMap::kLift + 0.5F * static_cast<float>(map.softness)) / map.texels);  // world units, at depth 1
  if (map.shape == DepthShape::parallel) {
    const Vec3<F> at = map.place(position);
    const Vec3<F> turned = map.place.turned(normal);
    const F facing = lane_max(lane_abs(turned.z), F(1e-3F));
    const F scale = F(map.key_scale) / select(turned.z < F(0), -facing, facing);
    const F slope = scale * F(1 / (map.texels * map.texels));
    return {at.x + center,    at.y + center,    (F(map.farthest) - at.z + lift / facing) * F(map.key_scale),
            turned.x * slope, turned.y * slope, IntOf<F>(0)};
  }
  Vec3<F> at = map.place(position);
  Vec3<F> n;  // such that n.x x + n.y y + n.z is the plane's distance from the light along its normal where it has the depth 1
  IntOf<F> face(0);
  if (map.shape == DepthShape::cone) {
    const Vec3<F> turned = map.place.turned(normal);
    const F scale(1 / (map.texels * map.texels));
    n = {turned.x * scale, turned.y * scale, turned.z};
  } else {  // the axis along which the point is farthest, then the two others in their order
    const F x = lane_abs(at.x);
    const F y = lane_abs(at.y);
    const F z = lane_abs(at.z);
    const auto choose = [&](const Vec3<F>& v) {
      const auto is_x = x >= y;
      const auto is_z = z > lane_max(x, y);
      return Vec3<F>{select(is_z, v.x, select(is_x, v.y, v.z)), select(is_z, v.y, select(is_x, v.z, v.x)),
                     select(is_z, v.z, select(is_x, v.x, v.y))};
    };
    face = select(z > lane_max(x, y), IntOf<F>(4), select(x >= y, IntOf<F>(0), IntOf<F>(2)));
    at = choose(at);
    n = choose(normal);
    face = face + select(at.z < F(0), IntOf<F>(1), IntOf<F>(0));
    n.z = select(at.z < F(0), -n.z, n.z);
    at = {at.x * F(map.texels), at.y * F(map.texels), lane_abs(at.z)};
    n = {n.x * F(1 / map.texels), n.y * F(1 / map.texels), n.z};
  }
  const F depth = lane_max(at.z, F(map.nearest));
  const F inverse = F(1) / depth;
  const F x = at.x * inverse;
  const F y = at.y * inverse;
  const F distance = ((n.x * x + n.y * y) + n.z) * depth;  // of the plane
  const F apart = lane_max(lane_abs(distance), depth * F(1e-5F));
  const F lifted = lane_max(apart - lift * depth, apart * F(0.25F));
  const F slope = F(1) / select(distance < F(0), -lifted, lifted);
  return {x + center, y + center, inverse * (apart / lifted), n.x * slope, n.y * slope, face * IntOf<F>(map.size * map.size)};
}

/// The first of the texels that a look-up reads on a side, and where in it: from the place on the map, within the map whatever that is.
template <class F>
LUSTRO_INLINE F lowest_texel(const DepthMap& map, const F& at) {
  const float reach = 0.5F + static_cast<float>(map.softness);
  return lane_min(lane_max(at, F(reach)), F(static_cast<float>(map.size) - reach - 0.5F)) - F(reach);  // NaN: the first texel
}

/// The texels that a look-up reads: a square of 2 + 2 softness a side.
template <class F>
struct DepthSquare {
  IntOf<F> first;      ///< the upper left one
  F share_x, share_y;  ///< of the last column and row; the first ones count by the rest
  F key;               ///< of the plane, at the centre of the first texel
  F slope_x, slope_y;  ///< of the key, a texel
};

template <class F>
LUSTRO_INLINE DepthSquare<F> square_around(const DepthMap& map, const Vec3<F>& position, const Vec3<F>& normal) {
  const DepthPlane<F> plane = depth_plane(map, position, normal);
  const F left = lowest_texel(map, plane.x);
  const F top = lowest_texel(map, plane.y);
  const IntOf<F> column = truncate(left);
  const IntOf<F> row = truncate(top);
  return {plane.first + row * IntOf<F>(map.size) + column,
          left - to_float(column),
          top - to_float(row),
          (plane.key + plane.slope_x * ((to_float(column) + F(0.5F)) - plane.x)) + plane.slope_y * ((to_float(row) + F(0.5F)) - plane.y),
          plane.slope_x,
          plane.slope_y};
}

/// v, 0..1: the share of the texels around the point that are not nearer to the light than the receiver's plane. The square that counts has 1 +
/// 2 softness texels a side and lies around the point; texels that it cuts count by what of them lies within. Exactly 1 or 0 where they agree.
template <class F>
LUSTRO_INLINE F share_that_is_lit(const DepthMap& map, const DepthSquare<F>& square) {
  using I = IntOf<F>;
  const std::int32_t last = 1 + 2 * map.softness;  // the texels on a side are one more
  const auto lit = [&](const F& nearest, std::int32_t x, std::int32_t y) {
    const F key = (square.key + square.slope_x * F(static_cast<float>(x))) + square.slope_y * F(static_cast<float>(y));
    return select(nearest <= lane_max(key, F(0)), F(1), F(0));
  };
  // Two rows, two texels of each at a time: their number is even. All but the last products are whole numbers.
  F sum(0), uppermost(0), lowest(0);
  for (std::int32_t y = 0; y <= last; y += 2) {
    const I upper = square.first + I(y) * I(map.size);
    F upper_sum(0), upper_first(0), upper_last(0), lower_sum(0), lower_first(0), lower_last(0);
    for (std::int32_t x = 0; x <= last; x += 2) {
      const TwoPairs<F> nearest = gather_pairs(map.keys, upper + I(x), upper + I(map.size + x));
      const F upper_left = lit(nearest.first_left, x, y);
      const F lower_left = lit(nearest.second_left, x, y + 1);
      upper_last = lit(nearest.first_right, x + 1, y);
      lower_last = lit(nearest.second_right, x + 1, y + 1);
      if (x == 0) {
        upper_first = upper_left;
        lower_first = lower_left;
      }
      upper_sum = upper_sum + upper_left;
      lower_sum = lower_sum + lower_left;
      if (x + 1 < last) {
        upper_sum = upper_sum + upper_last;
        lower_sum = lower_sum + lower_last;
      }
    }
    const F upper_row = upper_sum + (upper_last - upper_first) * square.share_x;
    const F lower_row = lower_sum + (lower_last - lower_first) * square.share_x;
    if (y == 0) {
      uppermost = upper_row;
      sum = upper_row;
    } else {
      sum = sum + upper_row;
    }
    if (y + 1 < last) {
      sum = sum + lower_row;
    }
    lowest = lower_row;
  }
  sum = sum + (lowest - uppermost) * square.share_y;
  return last == 1 ? sum : sum / F(static_cast<float>(last * last));
}

template <class F>
LUSTRO_INLINE F visibility_in(const DepthMap& map, const Vec3<F>& position, const Vec3<F>& normal) {
  return share_that_is_lit(map, square_around(map, position, normal));
}

/// How much of a light a face lets its smooth normal see: clamp01(4 (F.L) / (N.L)). Where normals are interpolated, faces that turn away from
/// the light, or lie along it, still have normals that face it; there the map compares the face with itself, texel by texel at random. Instead
/// light ends where the face turns away, softly. Exactly 1 where the face sees at least a quarter of what its normal sees: on all that is flat.
///
/// face_normal  F, unit; turned to the side of N
/// n_dot_l      of the normal that is lit
template <class F>
LUSTRO_INLINE F facing_share(const Vec3<F>& face_normal, const Vec3<F>& normal, const Vec3<F>& to_light, const F& n_dot_l) {
  const F f_dot_l = dot(face_normal, to_light);
  const F turned = select(dot(face_normal, normal) < F(0), -f_dot_l, f_dot_l);
  return clamp01(F(4) * turned / lane_max(n_dot_l, F(1e-6F)));
}

/// v of a light at a point of a face, whose lit normal is `normal`.
template <class F>
LUSTRO_INLINE F visibility_of(const ShadingLight& light, const DepthMap& map, const Vec3<F>& position, const Vec3<F>& face_normal,
                              const Vec3<F>& normal) {
  const Vec3<F> to_light = incident_light(light, position).to_light;
  return visibility_in(map, position, face_normal) * facing_share(face_normal, normal, to_light, dot(normal, to_light));
}

}  // namespace lustro
