// Reflection maps: pictures that surround the surface, infinitely far away, and are seen in the direction in which it mirrors the view. F is a
// lane type: float for the reference, N floats for a kernel; Fetch reads texels (texture/sample.hpp).
//
//   source  Blinn and Newell 1976, Texture and reflection in computer generated images (longitude and latitude);
//           Greene 1986, Environment mapping and other applications of world projections, with the faces of OpenGL 4.6, table 8.19 (cube)
//
// Where we differ: a footprint on the sphere is measured by its angle, as the equator sees it, since around the poles every footprint spans the
// picture's whole width; and a cube's faces end in their edges.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "lustro/texture.hpp"
#include "lustro/vec.hpp"
#include "math/lane.hpp"
#include "math/trig.hpp"
#include "shade/lighting.hpp"
#include "shade/texturing.hpp"
#include "texture/sample.hpp"

namespace lustro {

/// A material's reflection map, ready to be looked up. The same for all lanes.
struct ShadingReflection {
  ReflectionShape shape = ReflectionShape::sphere;
  std::uint32_t present = 0;  ///< bit i: there is face i; of a sphere: face 0
  std::array<ShadingMap, 6> faces;

  [[nodiscard]] bool has_face(std::size_t i) const { return (present >> i & 1U) != 0; }
};

/// A direction, unit, and how it changes on the image: a pixel to the right, a pixel down.
template <class F>
struct DirectionSlopes {
  Vec3<F> at, dx, dy;
};

/// R = 2 (N.V) N - V of a normal and a direction to the eye that both change on the image.
template <class F>
LUSTRO_INLINE DirectionSlopes<F> mirrored_view(const DirectionSlopes<F>& normal, const DirectionSlopes<F>& to_eye) {
  const Vec3<F>& n = normal.at;
  const Vec3<F>& v = to_eye.at;
  const F cosine = dot(n, v);
  const auto slope = [&](const Vec3<F>& dn, const Vec3<F>& dv) { return (n * (F(2) * (dot(dn, v) + dot(n, dv))) + dn * (F(2) * cosine)) - dv; };
  return {n * (F(2) * cosine) - v, slope(normal.dx, to_eye.dx), slope(normal.dy, to_eye.dy)};
}

/// Where a direction is seen on the picture around: u = 1/2 + atan2(x, -z) / 2 pi, v = arccos(y) / pi.
template <class F>
LUSTRO_INLINE Footprint<F> on_sphere(const DirectionSlopes<F>& d) {
  constexpr float kPerTurn = 0.15915494F, kPerHalfTurn = 0.31830989F;  // 1 / 2 pi, 1 / pi
  const F flat2 = d.at.x * d.at.x + d.at.z * d.at.z;
  const auto is_pole = flat2 < F(1e-30F);
  const F flat = square_root(lane_max(flat2, F(1e-30F)));
  const F x = select(is_pole, F(0), d.at.x / flat);  // along the equator, unit; at a pole any will do
  const F z = select(is_pole, F(-1), d.at.z / flat);
  const F longitude = angle_of(lane_abs(x), -z);
  const F length = square_root(flat2 + d.at.y * d.at.y);
  const F colatitude = angle_of(select(is_pole, F(0), flat) / length, d.at.y / length);
  const auto along_u = [&](const Vec3<F>& step) { return (x * step.z - z * step.x) * F(kPerTurn); };
  const auto along_v = [&](const Vec3<F>& step) { return (d.at.y * (x * step.x + z * step.z) - flat * step.y) * F(kPerHalfTurn); };
  return {F(0.5F) + select(x < F(0), -longitude, longitude) * F(kPerTurn),
          colatitude * F(kPerHalfTurn),
          along_u(d.dx),
          along_v(d.dx),
          along_u(d.dy),
          along_v(d.dy)};
}

/// The face of a cube that a direction meets: 0 to 5 for +x -x +y -y +z -z, a whole number a lane.
template <class F>
LUSTRO_INLINE F cube_face(const Vec3<F>& d) {
  const F x = lane_abs(d.x), y = lane_abs(d.y), z = lane_abs(d.z);
  const F on_x = select(d.x < F(0), F(1), F(0));
  const F on_y = select(d.y < F(0), F(3), F(2));
  const F on_z = select(d.z < F(0), F(5), F(4));
  return select(y > x, select(z > y, on_z, on_y), select(z > x, on_z, on_x));
}

/// Where a direction is seen on a face that it meets.
template <class F>
LUSTRO_INLINE Footprint<F> on_cube_face(std::size_t face, const DirectionSlopes<F>& d) {
  struct Axes {  // of table 8.19: s_c, t_c and |m_a| by x, y and z
    Vec3f s, t, major;
  };
  static constexpr std::array<Axes, 6> kAxes{{{{0, 0, -1}, {0, -1, 0}, {1, 0, 0}},
                                              {{0, 0, 1}, {0, -1, 0}, {-1, 0, 0}},
                                              {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                              {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                                              {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
                                              {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}};
  const Vec3<F> s_axis = vec_cast<F>(kAxes[face].s), t_axis = vec_cast<F>(kAxes[face].t), major_axis = vec_cast<F>(kAxes[face].major);
  const F inverse = F(1) / dot(major_axis, d.at);
  const F s = dot(s_axis, d.at) * inverse;  // -1..1
  const F t = dot(t_axis, d.at) * inverse;
  const auto slope = [&](const Vec3<F>& axis, const F& value, const Vec3<F>& step) {
    return (dot(axis, step) - value * dot(major_axis, step)) * (inverse * F(0.5F));
  };
  return {(s + F(1)) * F(0.5F),   (t + F(1)) * F(0.5F),   slope(s_axis, s, d.dx),
          slope(t_axis, t, d.dx), slope(s_axis, s, d.dy), slope(t_axis, t, d.dy)};
}

/// The maps' colour in a direction; black where a cube has no face.
template <class Fetch, class F>
Vec3<F> look_up_reflection(const ShadingReflection& map, const DirectionSlopes<F>& d) {
  if (map.shape == ReflectionShape::sphere) {
    return look_up<Fetch>(map.faces[0], on_sphere(d)).rgb;
  }
  const F chosen = cube_face(d.at);
  Vec3<F> color{F(0), F(0), F(0)};
  for (std::size_t face = 0; face < map.faces.size(); ++face) {
    const auto is_seen = chosen == F(static_cast<float>(face));
    if (map.has_face(face) && any_of(is_seen)) {
      const Vec3<F> rgb = look_up<Fetch>(map.faces[face], on_cube_face(face, d)).rgb;
      color = {select(is_seen, rgb.x, color.x), select(is_seen, rgb.y, color.y), select(is_seen, rgb.z, color.z)};
    }
  }
  return color;
}

/// What a surface mirrors: k_s under its maps times the reflection map. It belongs to the specular term.
template <class F>
LUSTRO_INLINE Vec3<F> reflected_surroundings(const Vec3f& specular, const MapFactors<F>& factors, const Vec3<F>& color) {
  return (vec_cast<F>(specular) * factors.specular) * color;
}

}  // namespace lustro
