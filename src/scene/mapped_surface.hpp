// What maps do to the surface of one triangle of a prepared scene: the steps between a mesh's vertices and shade/texturing.hpp, once for the
// reference's face (reference/face.hpp, F = float) and for the kernels' faces (F = N floats).
//
// AnyFace offers: scene, instance, material, side, and of vertex i
//   Vec3<F> stated_position(i), stated_normal(i)       the mesh's own, object space
//   Vec3<F> normal(i)                                  world, unit, times side
//   std::array<F, 4> stated_tangent(i)                 Mesh::tangents
//   Vec2<F> stated_uv(set, i)                          Mesh::uvs, Mesh::uvs1
//   F stated_alpha(i)                                  Mesh::alphas
#pragma once

#include <array>
#include <cstddef>

#include "scene/prepare.hpp"
#include "shade/interpolation.hpp"
#include "shade/opacity.hpp"
#include "shade/reflection.hpp"
#include "shade/texturing.hpp"

namespace lustro {

/// The footprints of both sets of texture coordinates; of a set that no map lies on: nothing.
template <class F, class AnyFace>
LUSTRO_INLINE std::array<Footprint<F>, 2> footprints_on(const AnyFace& face, const Weights<F>& w, const WeightSlopes<F>& slopes) {
  std::array<Footprint<F>, 2> at{};
  for (std::size_t set = 0; set < 2; ++set) {
    if ((face.material.maps.uv_sets >> set & 1U) != 0) {
      at[set] = footprint_at<F>({face.stated_uv(set, 0), face.stated_uv(set, 1), face.stated_uv(set, 2)}, w, slopes);
    }
  }
  return at;
}

/// The opacity without its halo, 0..1. slopes: where it has a map.
template <class Fetch, class F, class AnyFace>
LUSTRO_INLINE F opacity_on(const AnyFace& face, const Weights<F>& w, const WeightSlopes<F>& slopes) {
  const ShadingOpacity& stated = face.material.opacity;
  F opacity(stated.opacity);
  if (stated.has_vertex_alphas) {
    opacity = opacity * ((face.stated_alpha(0) * w[0] + face.stated_alpha(1) * w[1]) + face.stated_alpha(2) * w[2]);
  }
  if (stated.has_map) {
    const std::size_t set = stated.map.uv_set;
    const MapValue<F> value =
        look_up<Fetch>(stated.map, footprint_at<F>({face.stated_uv(set, 0), face.stated_uv(set, 1), face.stated_uv(set, 2)}, w, slopes));
    opacity = opacity * select(value.applies > F(0), chosen_channel(stated.map, value), F(1));
  }
  return clamp01(opacity);
}

/// The frame in which a normal map speaks, interpolated from the vertices: of the object where its matrix is a similarity, which turns the
/// result, else of the world.
template <class F>
struct TangentFrame {
  Vec3<F> tangent, normal;
  F handedness;  ///< its sign alone counts

  LUSTRO_INLINE Vec3<F> turn(const Instance& instance, const Vec3<F>& value) const {
    const Vec3<F> result = from_tangent_frame(value, tangent, handedness, normal);
    return instance.is_similarity ? instance.normal_from_object.turned(result) : result;
  }
};

template <class F, class AnyFace>
LUSTRO_INLINE TangentFrame<F> tangent_frame_on(const AnyFace& face, NormalInterpolation mode, const Weights<F>& w) {
  const Instance& instance = face.instance;
  const bool turns_once = instance.is_similarity;
  std::array<Vec3<F>, 3> normals, tangents;
  std::array<F, 3> handedness{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<F, 4> stated = face.stated_tangent(i);
    const Vec3<F> tangent{stated[0], stated[1], stated[2]};
    normals[i] = turns_once ? face.stated_normal(i) : face.normal(i) * face.side;  // of the front
    tangents[i] = turns_once ? tangent : unit_or(instance.relative_from_object.turned(tangent), Vec3<F>{});
    handedness[i] = !turns_once && instance.is_mirrored ? -stated[3] : stated[3];
  }
  const Vec3<F> normal = mode == NormalInterpolation::lerp ? weighted_sum(normals, w) : slerp_normal(normals, w, normals[0]);
  return {weighted_sum(tangents, w), normal, (handedness[0] * w[0] + handedness[1] * w[1]) + handedness[2] * w[2]};
}

/// The normal that is lit, where a map changes it: the normal map first, the bumps upon it. Maps speak of the front; seen from behind with
/// two_sided, all is turned round together.
///
/// at      footprints_on()
/// normal  the interpolated one, world, unit, times side
template <class Fetch, class F, class AnyFace>
LUSTRO_INLINE Vec3<F> mapped_normal(const AnyFace& face, NormalInterpolation mode, const Weights<F>& w, const WeightSlopes<F>& slopes,
                                    const std::array<Footprint<F>, 2>& at, const Vec3<F>& normal) {
  const Instance& instance = face.instance;
  const ShadingMaps& maps = face.material.maps;
  Vec3<F> n = normal * face.side;
  if (maps.has(MapKind::normal)) {
    const MapValue<F> value = look_up_normal<Fetch>(maps, at);
    const Vec3<F> stated =
        maps.normal_is_object_space ? instance.normal_from_object.turned(value.rgb) : tangent_frame_on(face, mode, w).turn(instance, value.rgb);
    n = stated_normal(stated, value.applies, n);
  }
  if (maps.has(MapKind::bump)) {
    const ShadingMap& map = maps[MapKind::bump];
    const Vec3<F> a = face.stated_position(0);
    const SurfaceSlopes<F> surface = surface_slopes(instance.relative_from_object.turned(face.stated_position(1) - a),
                                                    instance.relative_from_object.turned(face.stated_position(2) - a), slopes);
    const HeightSlopes<F> heights = height_slopes<Fetch>(map, at[map.uv_set]);
    n = bumped_normal(n, surface, {heights.dx * F(instance.size), heights.dy * F(instance.size)});
  }
  return n * face.side;
}

/// How the interpolated normal changes on the image. Of the linear blend, also for slerp: it chooses the level of detail alone.
template <class F, class AnyFace>
LUSTRO_INLINE DirectionSlopes<F> normal_slopes_on(const AnyFace& face, const Weights<F>& w, const WeightSlopes<F>& slopes,
                                                  const Vec3<F>& normal) {
  if (face.scene.shading.interpolation == Interpolation::flat) {
    return {normal, {}, {}};
  }
  const Instance& instance = face.instance;
  const bool turns_once = instance.is_similarity;
  std::array<Vec3<F>, 3> n;
  for (std::size_t i = 0; i < 3; ++i) {
    n[i] = turns_once ? face.stated_normal(i) : face.normal(i);
  }
  const Vec3<F> sum = weighted_sum(n, w);
  const F scale = F(1) / square_root(lane_max(dot(sum, sum), F(1e-12F)));
  const Vec3<F> unit = sum * scale;
  const auto slope = [&](const Weights<F>& change) {
    const Vec3<F> step = weighted_sum(n, change);
    const Vec3<F> across = (step - unit * dot(unit, step)) * scale;
    return turns_once ? instance.normal_from_object.turned(across) * face.side : across;
  };
  return {normal, slope(slopes.dx), slope(slopes.dy)};
}

/// The view as it is mirrored at a pixel.
///
/// x, y    on the image, pixels
/// normal  the one that is lit, world, unit
template <class F, class AnyFace>
LUSTRO_INLINE DirectionSlopes<F> mirrored_view_on(const AnyFace& face, const Weights<F>& w, const WeightSlopes<F>& slopes, const F& x,
                                                  const F& y, const Vec3<F>& normal) {
  const View& view = face.scene.view;
  const std::array<Vec3<F>, 2> change = view.to_eye_slopes_at(x, y);
  return mirrored_view(normal_slopes_on(face, w, slopes, normal), {view.to_eye_at(x, y), change[0], change[1]});
}

}  // namespace lustro
