// kLanes fragments at a time: where they lie in their triangles and what the vertices say of them. Part of a row (row.cpp).
//
// The lanes of one batch show the same material, and so the same instance. What a lane calculates is what the reference calculates for that
// fragment (reference/triangle.cpp, reference/face.hpp), operation by operation.
#pragma once

#include "raster/frame.hpp"
#include "raster/row_texture.hpp"
#include "scene/mapped_surface.hpp"
#include "shade/depth_map.hpp"
#include "shade/interpolation.hpp"
#include "shade/occlusion.hpp"
#include "shade/shadow_catcher.hpp"
#include "simd/lanes.hpp"

// What a kernel fills is not cleared first.
// NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
namespace lustro::HWY_NAMESPACE {

/// One of something for each vertex.
template <class T>
using Three = std::array<T, 3>;

/// The vertices of kLanes triangles of one mesh, and what its lists say of them.
struct Vertices {
  Three<Int> index;
  const Record* only;  // where all lanes show one triangle

  [[nodiscard]] HWY_INLINE Vec3<Float> look_up(const std::vector<Vec3f>& list, std::size_t i) const {
    return only != nullptr ? vec_cast<Float>(list[only->vertex[i]]) : gather(list, index[i]);
  }
  [[nodiscard]] HWY_INLINE Vec2<Float> look_up(const std::vector<Vec2f>& list, std::size_t i) const {
    return only != nullptr ? Vec2<Float>{Float(list[only->vertex[i]].x), Float(list[only->vertex[i]].y)} : gather(list, index[i]);
  }
  [[nodiscard]] HWY_INLINE std::array<Float, 4> look_up(const std::vector<std::array<float, 4>>& list, std::size_t i) const {
    if (only != nullptr) {
      const std::array<float, 4>& four = list[only->vertex[i]];
      return {Float(four[0]), Float(four[1]), Float(four[2]), Float(four[3])};
    }
    return gather(list, index[i]);
  }
  [[nodiscard]] HWY_INLINE Float look_up(const std::vector<float>& list, std::size_t i) const {
    return only != nullptr ? Float(list[only->vertex[i]]) : gather(list.data(), index[i]);
  }
  template <class List>
  [[nodiscard]] HWY_INLINE Three<Vec3<Float>> look_up(const List& list) const {
    return {look_up(list, 0), look_up(list, 1), look_up(list, 2)};
  }
};

/// kLanes triangles of one instance and material.
struct Faces {
  const PreparedScene& scene;
  const Instance& instance;
  const ShadingMaterial& material;
  Vertices vertices;
  Float side;                  // -1 where the back is seen and lit with its normals turned round
  Three<Vec3<Float>> normals;  // of the vertices, as the mesh states them; not for flat interpolation

  [[nodiscard]] Vec3<Float> stated_position(std::size_t i) const { return vertices.look_up(instance.mesh->positions, i); }
  [[nodiscard]] std::array<Float, 4> stated_tangent(std::size_t i) const { return vertices.look_up(instance.mesh->tangents, i); }
  [[nodiscard]] Vec2<Float> stated_uv(std::size_t set, std::size_t i) const {
    return vertices.look_up(set == 0 ? instance.mesh->uvs : instance.mesh->uvs1, i);
  }
  [[nodiscard]] Float stated_alpha(std::size_t i) const { return vertices.look_up(instance.mesh->alphas, i); }
  [[nodiscard]] Vec3<Float> position(std::size_t i) const { return instance.relative_from_object(stated_position(i)); }
  [[nodiscard]] const Vec3<Float>& stated_normal(std::size_t i) const { return normals[i]; }
  [[nodiscard]] Vec3<Float> normal(std::size_t i) const {
    const Vec3<Float> n = instance.normal_from_object(stated_normal(i));
    return (instance.is_similarity ? n : normalize(n)) * side;
  }
  [[nodiscard]] Vec3<Float> object_normal() const {
    const Vec3<Float> a = stated_position(0);
    const Vec3<Float> ab = stated_position(1) - a;
    const Vec3<Float> ac = stated_position(2) - a;
    Float size = lane_abs(ab.x);
    for (const Float& part : {ab.y, ab.z, ac.x, ac.y, ac.z}) {
      size = lane_max(lane_abs(part), size);
    }
    const Float scale = Float(1) / size;
    return cross(ab * scale, ac * scale);
  }
  [[nodiscard]] Vec3<Float> face_normal() const { return normalize(instance.normal_from_object(object_normal())) * side; }

  [[nodiscard]] HWY_INLINE Vec3<Float> normal_at(NormalInterpolation mode, const Weights<Float>& w) const {
    const bool turns_once = instance.is_similarity;
    const Three<Vec3<Float>> n = turns_once ? normals : Three<Vec3<Float>>{normal(0), normal(1), normal(2)};
    const Vec3<Float> sum = weighted_sum(n, w);
    Vec3<Float> fallback{};
    if (HWY_UNLIKELY(any_of(dot(sum, sum) < Float(1e-12F)))) {  // where normals cancel, and only there, the face's is needed
      fallback = turns_once ? normalize(object_normal()) : face_normal();
    }
    const Vec3<Float> interpolated = interpolate_normal(mode, n, w, fallback);
    return turns_once ? instance.normal_from_object(interpolated) * side : interpolated;
  }

  [[nodiscard]] Vec3<Float> tint(const Weights<Float>& w) const {
    const std::vector<Vec3f>& colors = instance.drawable->colors;
    if (colors.empty()) {
      return {Float(1), Float(1), Float(1)};
    }
    return weighted_sum<Float>(vertices.look_up(colors), w);
  }
};

/// Coefficients under vertex colours.
HWY_INLINE Coefficients<Float> tinted(const Coefficients<float>& stated, const Vec3<Float>& tint) {
  return {vec_cast<Float>(stated.ambient) * tint, vec_cast<Float>(stated.diffuse) * tint, vec_cast<Float>(stated.specular),
          vec_cast<Float>(stated.emission), stated.shininess};
}

/// Where kLanes fragments lie on the image and in their triangles.
struct FragmentPlaces {
  Float x, y, depth;
  Weights<Float> weights;
  Float corner_weight1, corner_weight2;  // of the screen triangle's own corners
};

/// Edge function from corner `from` to corner `to`, as a float of the exact whole number.
template <bool kSmall>
HWY_INLINE Float edge_of(Int from_x, Int from_y, Int to_x, Int to_y, Int px, Int py) {
  if constexpr (kSmall) {
    return to_float((to_x - from_x) * (py - from_y) - (to_y - from_y) * (px - from_x));
  } else {
    return narrow(widen(to_x - from_x) * widen(py - from_y) - widen(to_y - from_y) * widen(px - from_x));
  }
}

/// The words of a record by their place.
enum RecordWord : std::size_t { word_x = 0, word_y = 3, word_inverse_area = 6, word_key = 7, word_vertex = 10, word_flags = 15 };

HWY_INLINE Vertices vertices_of(const Words& words, const Record* only) {
  return {{words[word_vertex], words[word_vertex + 1], words[word_vertex + 2]}, only};
}

/// Faces::side
HWY_INLINE Float side_of(const Shading& shading, Int flags) {
  return shading.two_sided ? select((flags & Int(Record::kBack)) > Int(0), Float(-1), Float(1)) : Float(1);
}

/// The weights of clipped triangles' vertices, or their slopes, lane by lane: rare.
inline HWY_NOINLINE void unclip(const Frame& frame, Int flags, const Mask& clipped, const Weights<Float>& at, Weights<Float>& weights) {
  alignas(64) std::array<std::uint32_t, kLanes> chosen{}, flag{};
  alignas(64) std::array<std::array<float, kLanes>, 3> in, out;
  store_where(clipped, chosen.data(), Int(1));
  store(flag.data(), flags);
  for (std::size_t k = 0; k < 3; ++k) {
    store(in[k].data(), at[k]);
    store(out[k].data(), weights[k]);
  }
  for (std::size_t i = 0; i < kLanes; ++i) {
    if (chosen[i] != 0) {
      const std::array<Vec3f, 3>& corner = frame.loose[flag[i] >> Record::kLooseShift].corner_weights;
      const auto blend = [&](float a, float b, float c) { return (a * in[0][i] + b * in[1][i]) + c * in[2][i]; };
      out[0][i] = blend(corner[0].x, corner[1].x, corner[2].x);
      out[1][i] = blend(corner[0].y, corner[1].y, corner[2].y);
      out[2][i] = blend(corner[0].z, corner[1].z, corner[2].z);
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    weights[k] = load(out[k].data());
  }
}

/// From the corners of the screen triangle to the vertices of the mesh's: linear, so for weights and their slopes alike.
HWY_INLINE Weights<Float> at_vertices(const Frame& frame, Int flags, const Weights<Float>& at_corners) {
  const Mask is_swapped = (flags & Int(Record::kSwapped)) > Int(0);
  Weights<Float> weights{at_corners[0], select(is_swapped, at_corners[2], at_corners[1]), select(is_swapped, at_corners[1], at_corners[2])};
  const Mask is_clipped = (flags & Int(Record::kClipped)) > Int(0);
  if (HWY_UNLIKELY(any_of(is_clipped))) {
    unclip(frame, flags, is_clipped, at_corners, weights);
  }
  return weights;
}

/// reference/triangle.cpp: interpolants_at()
HWY_INLINE FragmentPlaces locate(const Frame& frame, const Words& words, Int px, Int py) {
  const View& view = frame.scene->view;
  const Int flags = words[word_flags];
  const Int x0 = words[word_x], x1 = words[word_x + 1], x2 = words[word_x + 2];
  const Int y0 = words[word_y], y1 = words[word_y + 1], y2 = words[word_y + 2];
  const Float inverse_area = from_bits(words[word_inverse_area]);
  const Float key0 = from_bits(words[word_key]);
  const Float key1 = from_bits(words[word_key + 1]);
  const Float key2 = from_bits(words[word_key + 2]);
  Float e1, e2;
  if (HWY_LIKELY(all_of((flags & Int(Record::kSmall)) > Int(0)))) {
    e1 = edge_of<true>(x2, y2, x0, y0, px, py);
    e2 = edge_of<true>(x0, y0, x1, y1, px, py);
  } else {
    e1 = edge_of<false>(x2, y2, x0, y0, px, py);
    e2 = edge_of<false>(x0, y0, x1, y1, px, py);
  }
  const Float slope1 = (key1 - key0) * inverse_area;
  const Float slope2 = (key2 - key0) * inverse_area;
  const Float key = (key0 + slope1 * e1) + slope2 * e2;
  Float w1 = e1 * inverse_area;
  Float w2 = e2 * inverse_area;
  FragmentPlaces at;
  if (view.projection == Projection::perspective) {
    at.depth = Float(1) / key;
    w1 = (w1 * key1) * at.depth;
    w2 = (w2 * key2) * at.depth;
  } else {
    at.depth = Float(view.depth_far) - key * Float(view.depth_far - view.depth_near);
  }
  at.corner_weight1 = w1;
  at.corner_weight2 = w2;
  at.weights = at_vertices(frame, flags, {(Float(1) - w1) - w2, w1, w2});
  at.x = to_float(px) * Float(1.0F / kSubpixelUnits);  // exact, as a division by a power of two is
  at.y = to_float(py) * Float(1.0F / kSubpixelUnits);
  return at;
}

/// reference/triangle.cpp: weight_slopes_at()
HWY_INLINE WeightSlopes<Float> slopes_at(const Frame& frame, const Words& words, const FragmentPlaces& at) {
  const WeightSlopes<Float> corners =
      weight_slopes<Float>(frame.scene->view.projection == Projection::perspective, {words[word_x], words[word_x + 1], words[word_x + 2]},
                           {words[word_y], words[word_y + 1], words[word_y + 2]}, from_bits(words[word_inverse_area]),
                           {from_bits(words[word_key]), from_bits(words[word_key + 1]), from_bits(words[word_key + 2])}, at.corner_weight1,
                           at.corner_weight2, at.depth);
  const Int flags = words[word_flags];
  return {at_vertices(frame, flags, corners.dx), at_vertices(frame, flags, corners.dy)};
}

/// kLanes fragments of one material, ready to be lit. Everything is made where it stays: what is cleared first, or copied, goes through memory.
struct Batch {
  FragmentPlaces at;
  Faces faces;
  Vec3<Float> position;
  Vec3<Float> normal;          // where it is asked for
  WeightSlopes<Float> slopes;  // where the material has maps, or a map of its opacity

  HWY_INLINE Batch(const Frame& frame, const Instance& instance, const ShadingMaterial& material, const Vertices& vertices, const Words& words,
                   Int px, Int py, bool needs_normal)
      : at(locate(frame, words, px, py)),
        faces{.scene = *frame.scene,
              .instance = instance,
              .material = material,
              .vertices = vertices,
              .side = side_of(frame.scene->shading, words[word_flags]),
              .normals = is_flat(frame) ? Three<Vec3<Float>>{} : vertices.look_up(instance.mesh->normals)},
        position(frame.scene->view.point_at(at.x, at.y, at.depth)),
        normal(!needs_normal    ? Vec3<Float>{}
               : is_flat(frame) ? faces.face_normal()
                                : faces.normal_at(frame.scene->shading.normals, at.weights)),
        slopes(HWY_UNLIKELY(material.maps.has_any() || material.opacity.has_map) ? slopes_at(frame, words, at) : WeightSlopes<Float>{}) {}

  [[nodiscard]] HWY_INLINE static bool is_flat(const Frame& frame) { return frame.scene->shading.interpolation == Interpolation::flat; }
};

/// What the maps say of a batch.
struct Mapped {
  std::array<Footprint<Float>, 2> at;
  MapFactors<Float> factors;
  Vec3<Float> reflection;  // what is seen in the mirrored view, where there is a reflection map
};

/// `count` fragments from `begin` on. Lanes beyond them calculate the first one again. needs_normal: of Phong interpolation.
HWY_INLINE Batch make_batch(const Frame& frame, const TileScratch& s, const TileScratch::Fragments& fragments, const Instance& instance,
                            const ShadingMaterial& material, std::size_t begin, std::size_t count, bool needs_normal = true) {
  const PreparedScene& scene = *frame.scene;
  Int px = load(&fragments.x[begin]);
  Int py = load(&fragments.y[begin]);
  Words words;
  const auto* records = reinterpret_cast<const std::uint32_t*>(s.records.data());
  const Record* only = nullptr;
  if (HWY_LIKELY(count >= kLanes)) {
    const std::uint32_t first = fragments.record[begin];
    if (all_of(load(&fragments.record[begin]) == Int(static_cast<std::int32_t>(first)))) {
      only = &s.records[first];
      repeat(records + std::size_t{16} * first, words);
    } else {
      transpose(records, &fragments.record[begin], words);
    }
  } else {
    const Mask is_used = first_lanes(count);
    px = select(is_used, px, Int(fragments.x[begin]));
    py = select(is_used, py, Int(fragments.y[begin]));
    alignas(64) std::array<std::uint32_t, kLanes> record;
    store(record.data(), select(is_used, load(&fragments.record[begin]), Int(static_cast<std::int32_t>(fragments.record[begin]))));
    transpose(records, record.data(), words);
  }
  const bool is_asked_for = scene.shading.interpolation == Interpolation::phong || frame.wants_all || material.maps.reflects;
  return {frame, instance, material, vertices_of(words, only), words, px, py, needs_normal && is_asked_for};
}

/// The opacity of what catches shadows, but for its strength.
inline HWY_NOINLINE Float shadow_on(const Faces& faces, const Vec3<Float>& position, const Vec3<Float>& normal) {
  const PreparedScene& scene = faces.scene;
  const Vec3<Float> face_normal = faces.face_normal();
  return caught_shadow(scene.surrounding_light(), scene.lights, position, normal, [&](std::size_t i) {
    return i == scene.lights.size() ? openness_at(scene.occlusion.shading, position, normal, face_normal)
                                    : visibility_of(scene.lights[i], scene.shadows.maps[i], position, face_normal, normal);
  });
}

/// reference/opacity.cpp: opacity_at()
HWY_INLINE Float opacity_of(const Faces& faces, const FragmentPlaces& at, const WeightSlopes<Float>& slopes) {
  const Float opacity = opacity_on<LaneFetch, Float>(faces, at.weights, slopes);
  const ShadingOpacity& stated = faces.material.opacity;
  if (HWY_LIKELY(!stated.has_halo && !(stated.catches > 0))) {
    return opacity;
  }
  const Shading& shading = faces.scene.shading;
  const Vec3<Float> normal = shading.interpolation == Interpolation::flat ? faces.face_normal() : faces.normal_at(shading.normals, at.weights);
  const View& view = faces.scene.view;
  return stated.catches > 0 ? shadow_on(faces, view.point_at(at.x, at.y, at.depth), normal) * Float(stated.catches)
                            : halo(opacity, dot(normal, view.to_eye_at(at.x, at.y)));
}

/// Looks the material's maps up; the normal becomes theirs.
inline HWY_NOINLINE void look_up_maps(Batch& batch, Mapped& mapped) {
  const Faces& faces = batch.faces;
  const ShadingMaps& maps = faces.material.maps;
  mapped.at = footprints_on<Float>(faces, batch.at.weights, batch.slopes);
  mapped.factors = map_factors<LaneFetch>(maps, mapped.at);
  if (maps.changes_normal()) {
    batch.normal = mapped_normal<LaneFetch>(faces, faces.scene.shading.normals, batch.at.weights, batch.slopes, mapped.at, batch.normal);
  }
  if (HWY_UNLIKELY(maps.reflects)) {
    mapped.reflection = look_up_reflection<LaneFetch>(
        faces.material.reflection, mirrored_view_on(faces, batch.at.weights, batch.slopes, batch.at.x, batch.at.y, batch.normal));
  }
}

}  // namespace lustro::HWY_NAMESPACE
// NOLINTEND(cppcoreguidelines-pro-type-member-init)
