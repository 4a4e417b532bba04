// Strips of fragments on their way through shading. Part of a row (row.cpp).
#pragma once

#include "raster/row_fragment.hpp"

// What a kernel fills is not cleared first.
// NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
namespace lustro::HWY_NAMESPACE {

/// Fragments on their way through shading, a stage at a time. Each stage is a short loop, so that the processor works at several of its vectors
/// at once, and the compiler keeps what all of them need in registers.
struct Strip {
  using Rows = std::array<std::array<float, kStrip>, 3>;
  alignas(64) Rows position, normal, to_eye, tint, color;
  enum Coefficient : std::size_t { ambient, diffuse, specular, emission, coefficient_count };
  alignas(64) std::array<Rows, coefficient_count> coefficients;  // those that differ from point to point, where there are maps
  std::uint32_t differing;                                       // bit i: coefficient i is one of them
  alignas(64) std::array<float, kStrip> shininess;               // where a map does
  alignas(64) Rows reflection;                                   // reflected_surroundings(), where there is a reflection map

  HWY_INLINE static void put(Rows& rows, std::size_t i, const Vec3<Float>& value) {
    store(&rows[0][i], value.x);
    store(&rows[1][i], value.y);
    store(&rows[2][i], value.z);
  }
  HWY_INLINE void put_coefficient(Coefficient which, std::size_t i, const Vec3<Float>& value) { put(coefficients[which], i, value); }
  /// stated: the material's
  [[nodiscard]] HWY_INLINE Vec3<Float> coefficient(Coefficient which, std::size_t i, const Vec3f& stated) const {
    return (differing >> which & 1U) != 0 ? get(coefficients[which], i) : vec_cast<Float>(stated);
  }
  [[nodiscard]] HWY_INLINE Coefficients<Float> coefficients_at(std::size_t i, const Coefficients<float>& stated) const {
    return {coefficient(ambient, i, stated.ambient), coefficient(diffuse, i, stated.diffuse), coefficient(specular, i, stated.specular),
            coefficient(emission, i, stated.emission), stated.shininess};
  }
  HWY_INLINE static Vec3<Float> get(const Rows& rows, std::size_t i) { return {load(&rows[0][i]), load(&rows[1][i]), load(&rows[2][i])}; }
};

/// Fragments of one material in a row.
struct Run {
  const Frame& frame;
  TileScratch& s;
  const TileScratch::Fragments& fragments;
  const Instance& instance;
  const ShadingMaterial& material;
  std::size_t begin, count;

  /// Flat and Gouraud interpolation light faces and their vertices.
  [[nodiscard]] HWY_INLINE bool asks_for_normals() const {
    return frame.scene->shading.interpolation == Interpolation::phong || frame.wants_all || material.maps.reflects;
  }
  /// The fragments from i on, a multiple of kLanes. Lanes beyond the last calculate it again.
  [[nodiscard]] HWY_INLINE Batch batch(const FaceTable& faces, std::size_t i, bool needs_normal = true) const {
    Int px = load(&fragments.x[begin + i]);
    Int py = load(&fragments.y[begin + i]);
    if (HWY_UNLIKELY(count - i < kLanes)) {
      const Mask is_used = first_lanes(count - i);
      px = select(is_used, px, Int(fragments.x[begin + count - 1]));
      py = select(is_used, py, Int(fragments.y[begin + count - 1]));
    }
    return {faces, i / kLanes, px, py, needs_normal};
  }
  /// Strip by strip.
  template <class Shade>
  void in_strips(Shade&& shade) const {
    for (std::size_t i = 0; i < count; i += kStrip) {
      shade(Run{frame, s, fragments, instance, material, begin + i, count - i < kStrip ? count - i : kStrip});
    }
  }
};

/// The triangles of a run of at most kStrip fragments.
struct RunFaces : FaceTable {
  HWY_INLINE RunFaces(const Run& run, const FaceWants& wants) : FaceTable(run.frame, run.s.records.data(), run.instance, run.material) {
    list(&run.fragments.record[run.begin], run.count);
    find(wants);
  }
};

/// What shading asks of faces.
HWY_INLINE FaceWants wants_of_shading(const Run& run) {
  const PreparedScene& scene = *run.frame.scene;
  const ShadingMaps& maps = run.material.maps;
  return {.slopes = maps.has_any(),
          .positions = scene.shading.interpolation != Interpolation::phong || maps.has(MapKind::bump) || scene.looks_beyond(),
          .normals = scene.shading.interpolation != Interpolation::flat,
          .tangents = maps.has(MapKind::normal) && !maps.normal_is_object_space,
          .colors = !run.instance.drawable->colors.empty(),
          .uv_sets = maps.uv_sets};
}

/// What its opacity does.
HWY_INLINE FaceWants wants_of_opacity(const Frame& frame, const ShadingMaterial& material) {
  const ShadingOpacity& opacity = material.opacity;
  const bool has_normal = opacity.has_halo || opacity.catches > 0;
  const bool is_flat = frame.scene->shading.interpolation == Interpolation::flat;
  return {.slopes = opacity.has_map,
          .positions = opacity.catches > 0 || (has_normal && is_flat),
          .normals = has_normal && !is_flat,
          .alphas = opacity.has_vertex_alphas,
          .uv_sets = opacity.has_map ? 1U << opacity.map.uv_set : 0U};
}

}  // namespace lustro::HWY_NAMESPACE
// NOLINTEND(cppcoreguidelines-pro-type-member-init)
