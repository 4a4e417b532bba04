// Shading a tile: the fragments that are seen, kLanes at a time, each once; then samples to pixels. Part of a row (row.cpp).
//
// The lanes of one batch show the same material, and so the same instance. What a lane calculates is what the reference calculates for that
// fragment (reference/fragment.cpp), operation by operation.
#pragma once

#include <bit>
#include <cstring>

#include "raster/frame.hpp"
#include "shade/interpolation.hpp"
#include "simd/lanes.hpp"

// What a kernel fills is not cleared first.
// NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
namespace lustro::HWY_NAMESPACE {

/// kLanes triangles of one instance and material.
struct Faces {
  const PreparedScene& scene;
  const Instance& instance;
  const ShadingMaterial& material;
  std::array<Int, 3> vertices;
  const Record* only;  // where all lanes show one triangle
  Float side;          // -1 where the back is seen and lit with its normals turned round

  [[nodiscard]] HWY_INLINE Vec3<Float> at_vertex(const std::vector<Vec3f>& list, std::size_t i) const {
    return only != nullptr ? vec_cast<Float>(list[only->vertex[i]]) : gather(list, vertices[i]);
  }
  [[nodiscard]] Vec3<Float> stated_position(std::size_t i) const { return at_vertex(instance.mesh->positions, i); }
  [[nodiscard]] Vec3<Float> position(std::size_t i) const { return instance.relative_from_object(stated_position(i)); }
  [[nodiscard]] Vec3<Float> stated_normal(std::size_t i) const { return at_vertex(instance.mesh->normals, i); }
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
    const std::array<Vec3<Float>, 3> n = turns_once ? std::array<Vec3<Float>, 3>{stated_normal(0), stated_normal(1), stated_normal(2)}
                                                    : std::array<Vec3<Float>, 3>{normal(0), normal(1), normal(2)};
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
    return weighted_sum<Float>({at_vertex(colors, 0), at_vertex(colors, 1), at_vertex(colors, 2)}, w);
  }
};

/// Where kLanes fragments lie on the image and in their triangles.
struct FragmentPlaces {
  Float x, y, depth;
  Weights<Float> weights;
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

/// The weights of clipped triangles' vertices, lane by lane: rare.
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
  const Float w0 = (Float(1) - w1) - w2;
  const Mask is_swapped = (flags & Int(Record::kSwapped)) > Int(0);
  at.weights = {w0, select(is_swapped, w2, w1), select(is_swapped, w1, w2)};
  const Mask is_clipped = (flags & Int(Record::kClipped)) > Int(0);
  if (HWY_UNLIKELY(any_of(is_clipped))) {
    unclip(frame, flags, is_clipped, {w0, w1, w2}, at.weights);
  }
  at.x = to_float(px) * Float(1.0F / kSubpixelUnits);  // exact, as a division by a power of two is
  at.y = to_float(py) * Float(1.0F / kSubpixelUnits);
  return at;
}

/// One evaluation of the equation.
struct Shaded {
  Terms<Float> terms;
  Vec3<Float> scene_part;
};

/// visit(i, part) sees every light's part.
template <class Visit>
HWY_INLINE Shaded evaluate(const PreparedScene& scene, const ShadingMaterial& material, const Surface<Float>& surface, const Vec3<Float>& tint,
                           Visit&& visit) {
  const Coefficients<float>& stated = material.coefficients;
  Coefficients<Float> k{vec_cast<Float>(stated.ambient), vec_cast<Float>(stated.diffuse), vec_cast<Float>(stated.specular),
                        vec_cast<Float>(stated.emission), stated.shininess};
  k.ambient = k.ambient * tint;
  k.diffuse = k.diffuse * tint;
  Shaded result;
  result.terms = light_surface(
      material.lighting, surface, k, scene.ambient, scene.lights, scene.shading.normalized,
      [&](std::size_t i, const Incident<Float>&, const LightTerms<Float>& part) { visit(i, (part.ambient + part.diffuse) + part.specular); });
  result.scene_part = material.lighting != Lighting::constant ? k.ambient * vec_cast<Float>(scene.ambient) + k.emission : k.diffuse;
  return result;
}

template <class V>
HWY_INLINE void scale_terms(Terms<Float>& terms, const V& by) {
  terms.ambient = terms.ambient * by;
  terms.diffuse = terms.diffuse * by;
  terms.specular = terms.specular * by;
  terms.emission = terms.emission * by;
}

/// Where the batch's outputs go: consecutive places from `begin` on.
struct OutputSlot {
  TileScratch& s;
  std::size_t begin;

  HWY_INLINE void put(std::size_t which, const Float& value) const { store(&s.output[which][begin], value); }
  HWY_INLINE void put(std::size_t which, const Vec3<Float>& value) const {
    put(which, value.x);
    put(which + 1, value.y);
    put(which + 2, value.z);
  }
  [[nodiscard]] float* light(std::size_t i) const { return &s.light_output[i * 3 * (TileScratch::kFragments + TileScratch::kPadding) + begin]; }
  void put_light(std::size_t i, const Vec3<Float>& value) const {
    constexpr std::size_t kRow = TileScratch::kFragments + TileScratch::kPadding;
    store(light(i), value.x);
    store(light(i) + kRow, value.y);
    store(light(i) + 2 * kRow, value.z);
  }
  [[nodiscard]] Vec3<Float> get_light(std::size_t i) const {
    constexpr std::size_t kRow = TileScratch::kFragments + TileScratch::kPadding;
    return {load(light(i)), load(light(i) + kRow), load(light(i) + 2 * kRow)};
  }
};

inline Shaded shade_flat(const Faces& faces, bool wants_lights, const OutputSlot& out) {
  const Vec3<Float> center = ((faces.position(0) + faces.position(1)) + faces.position(2)) * Float(1.0F / 3.0F);
  const Surface<Float> surface{center, faces.face_normal(), faces.scene.view.to_eye_from(center)};
  const Float third(1.0F / 3.0F);
  return evaluate(faces.scene, faces.material, surface, faces.tint({third, third, third}), [&](std::size_t i, const Vec3<Float>& part) {
    if (wants_lights) {
      out.put_light(i, part);
    }
  });
}

inline Shaded shade_gouraud(const Faces& faces, const Weights<Float>& w, bool wants_lights, const OutputSlot& out) {
  Shaded sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<Float> position = faces.position(i);
    const Surface<Float> surface{position, faces.normal(i), faces.scene.view.to_eye_from(position)};
    const Weights<Float> corner{Float(i == 0 ? 1.0F : 0.0F), Float(i == 1 ? 1.0F : 0.0F), Float(i == 2 ? 1.0F : 0.0F)};
    const Vec3<Float> tint = faces.tint(corner);
    Shaded vertex = evaluate(faces.scene, faces.material, surface, tint, [](std::size_t, const Vec3<Float>&) {});
    const Vec3<Float> total = vertex.terms.sum();
    const auto scale = [](Float c) { return select(c > Float(1), Float(1) / c, Float(1)); };
    const Vec3<Float> by{scale(total.x), scale(total.y), scale(total.z)};
    scale_terms(vertex.terms, by);
    vertex.scene_part = vertex.scene_part * by;
    const auto add = [&](Vec3<Float>& to, const Vec3<Float>& value) { to = i == 0 ? value * w[i] : to + value * w[i]; };
    add(sum.terms.ambient, vertex.terms.ambient);
    add(sum.terms.diffuse, vertex.terms.diffuse);
    add(sum.terms.specular, vertex.terms.specular);
    add(sum.terms.emission, vertex.terms.emission);
    add(sum.scene_part, vertex.scene_part);
    if (wants_lights) {  // once more, now that the clamp is known
      evaluate(faces.scene, faces.material, surface, tint, [&](std::size_t l, const Vec3<Float>& part) {
        Vec3<Float> value = i == 0 ? Vec3<Float>{} : out.get_light(l);
        add(value, part * by);
        out.put_light(l, value);
      });
    }
  }
  return sum;
}

/// kLanes fragments of one material, ready to be lit.
struct Batch {
  FragmentPlaces at;
  Faces faces;
  Vec3<Float> position;
  Vec3<Float> normal;  // where it is asked for
};

/// `count` fragments from `begin` on. Lanes beyond them calculate the first one again.
HWY_INLINE Batch make_batch(const Frame& frame, const TileScratch& s, const TileScratch::Fragments& fragments, const Instance& instance,
                            const ShadingMaterial& material, std::size_t begin, std::size_t count) {
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
  const FragmentPlaces at = locate(frame, words, px, py);
  const Mask is_back = (words[word_flags] & Int(Record::kBack)) > Int(0);
  const Faces faces{scene,    instance,
                    material, {words[word_vertex], words[word_vertex + 1], words[word_vertex + 2]},
                    only,     scene.shading.two_sided ? select(is_back, Float(-1), Float(1)) : Float(1)};
  Vec3<Float> normal{};
  if (scene.shading.interpolation == Interpolation::phong || frame.wants_all) {
    normal = scene.shading.interpolation == Interpolation::flat ? faces.face_normal() : faces.normal_at(scene.shading.normals, at.weights);
  }
  return {at, faces, scene.view.point_at(at.x, at.y, at.depth), normal};
}

/// visit(i, part) sees every light's part where layers of lights are stored.
template <class Visit>
HWY_INLINE Shaded shade_phong(const Batch& batch, Visit&& visit) {
  const Faces& faces = batch.faces;
  return evaluate(faces.scene, faces.material, {batch.position, batch.normal, faces.scene.view.to_eye_at(batch.at.x, batch.at.y)},
                  faces.tint(batch.at.weights), visit);
}

/// Dims the terms by the fog, and says what it adds.
HWY_INLINE Vec3<Float> add_fog(const ShadingFog& fog, const Vec3<Float>& position, Terms<Float>& terms, Float& clear) {
  clear = fog_factor(fog, length(position));
  scale_terms(terms, Vec3<Float>{clear, clear, clear});
  return vec_cast<Float>(fog.color) * (Float(1) - clear);
}

/// image/store.cpp for lanes: the bytes of opaque pixels, alpha the highest.
HWY_INLINE void store_words(const Frame& frame, const Vec3<Float>& rgb, std::uint32_t* words) {
  const Int opaque(static_cast<std::int32_t>(0xFF000000U));
  if (frame.srgb == nullptr) {
    const auto quantize = [](Float color) { return truncate(clamp01(color) * Float(255) + Float(0.5F)); };
    store(words, (quantize(rgb.x) | quantize(rgb.y) << 8) | (quantize(rgb.z) << 16 | opaque));
    return;
  }
  const auto byte_of = [entries = frame.srgb->entries.data()](Float color) {
    const Float x = lane_min(lane_max(color, Float(std::bit_cast<float>(SrgbTable::kFirst))), Float(1));
    const Int place = bits_of(x) - Int(static_cast<std::int32_t>(SrgbTable::kFirst));
    return (gather(entries, place >> 16) + (place & Int(0xFFFF))) >> 16;
  };
  store(words, (byte_of(rgb.x) | byte_of(rgb.y) << 8) | (byte_of(rgb.z) << 16 | opaque));
}

inline constexpr std::size_t kStrip = 128;  ///< fragments

/// Fragments on their way through shading, a stage at a time. Each stage is a short loop, so that the processor works at several of its vectors
/// at once, and the compiler keeps what all of them need in registers.
struct Strip {
  using Rows = std::array<std::array<float, kStrip>, 3>;
  alignas(64) Rows position, normal, to_eye, tint, color;

  HWY_INLINE static void put(Rows& rows, std::size_t i, const Vec3<Float>& value) {
    store(&rows[0][i], value.x);
    store(&rows[1][i], value.y);
    store(&rows[2][i], value.z);
  }
  HWY_INLINE static Vec3<Float> get(const Rows& rows, std::size_t i) { return {load(&rows[0][i]), load(&rows[1][i]), load(&rows[2][i])}; }
};

/// As a pixel sums its parts: from 0 on, each weighted by 1; and 0 of the background.
HWY_INLINE Vec3<Float> sum_whole(const PreparedScene& scene, const Vec3<Float>& position, Terms<Float>& t) {
  Vec3<Float> fog{};
  if (scene.fog) {
    Float clear;
    fog = add_fog(*scene.fog, position, t, clear);
  }
  const Vec3<Float> zero{};
  const Terms<Float> sums{zero + t.ambient, zero + t.diffuse, zero + t.specular, zero + t.emission};
  const std::array<float, 4>& back = scene.background;
  return (sums.sum() + (zero + fog)) + Vec3<Float>{Float(back[0] * 0.0F), Float(back[1] * 0.0F), Float(back[2] * 0.0F)};
}

/// Fragments of one material in a row.
struct Run {
  const Frame& frame;
  TileScratch& s;
  const TileScratch::Fragments& fragments;
  const Instance& instance;
  const ShadingMaterial& material;
  std::size_t begin, count;

  [[nodiscard]] HWY_INLINE Batch batch(std::size_t i) const {
    return make_batch(frame, s, fragments, instance, material, begin + i, count - i < kLanes ? count - i : kLanes);
  }
  /// Strip by strip.
  template <class Shade>
  void in_strips(Shade&& shade) const {
    for (std::size_t i = 0; i < count; i += kStrip) {
      shade(Run{frame, s, fragments, instance, material, begin + i, count - i < kStrip ? count - i : kStrip});
    }
  }
};

/// What the equation asks for at each point, for Phong interpolation.
inline HWY_NOINLINE void make_surfaces(const Run& run, Strip& strip) {
  const bool has_tint = !run.instance.drawable->colors.empty();
  for (std::size_t i = 0; i < run.count; i += kLanes) {
    const Batch batch = run.batch(i);
    Strip::put(strip.position, i, batch.position);
    Strip::put(strip.normal, i, batch.normal);
    Strip::put(strip.to_eye, i, run.frame.scene->view.to_eye_at(batch.at.x, batch.at.y));
    if (has_tint) {
      Strip::put(strip.tint, i, batch.faces.tint(batch.at.weights));
    }
  }
}

/// The equation at the strip's points: visit(i, position, terms) for every vector of them.
template <class Visit>
HWY_INLINE void light_surfaces(const Run& run, const Strip& strip, Visit&& visit) {
  const PreparedScene& scene = *run.frame.scene;
  const ShadingMaterial& material = run.material;
  const bool has_tint = !run.instance.drawable->colors.empty();
  Reflection<float>* reflections = run.s.reflections.data();  // without a tint they are the same everywhere
  for (std::size_t l = 0; l < scene.lights.size(); ++l) {
    reflections[l] = reflection_of(material.coefficients, scene.lights[l]);
  }
  for (std::size_t i = 0; i < run.count; i += kLanes) {
    const Surface<Float> surface{Strip::get(strip.position, i), Strip::get(strip.normal, i), Strip::get(strip.to_eye, i)};
    Terms<Float> terms;
    if (has_tint) {
      terms = evaluate(scene, material, surface, Strip::get(strip.tint, i), [](std::size_t, const Vec3<Float>&) {}).terms;
    } else {
      terms = light_surface(
          material.lighting, surface, material.coefficients, scene.ambient, scene.lights, scene.shading.normalized,
          [reflections](std::size_t l) -> const Reflection<float>& { return reflections[l]; },
          [](std::size_t, const Incident<Float>&, const LightTerms<Float>&) {});
    }
    visit(i, surface.position, terms);
  }
}

inline HWY_NOINLINE void light_whole(const Run& run, Strip& strip) {
  light_surfaces(run, strip, [&](std::size_t i, const Vec3<Float>& position, Terms<Float>& terms) {
    Strip::put(strip.color, i, sum_whole(*run.frame.scene, position, terms));
  });
}

HWY_INLINE void store_terms(TileScratch& s, std::size_t at, const Terms<Float>& t, const Vec3<Float>& fog) {
  store_transposed({t.ambient.x, t.ambient.y, t.ambient.z, t.diffuse.x, t.diffuse.y, t.diffuse.z, t.specular.x, t.specular.y, t.specular.z,
                    t.emission.x, t.emission.y, t.emission.z, fog.x, fog.y, fog.z, Float(0)},
                   &s.part_terms[at * TileScratch::terms]);
}

inline HWY_NOINLINE void light_parts(const Run& run, const Strip& strip) {
  light_surfaces(run, strip, [&](std::size_t i, const Vec3<Float>& position, Terms<Float>& terms) {
    Vec3<Float> fog{};
    if (run.frame.scene->fog) {
      Float clear;
      fog = add_fog(*run.frame.scene->fog, position, terms, clear);
    }
    store_terms(run.s, run.begin + i, terms, fog);
  });
}

/// Flat and Gouraud interpolation light faces and their vertices.
inline HWY_NOINLINE void light_faces(const Run& run, Strip& strip) {
  const PreparedScene& scene = *run.frame.scene;
  for (std::size_t i = 0; i < run.count; i += kLanes) {
    const Batch batch = run.batch(i);
    const OutputSlot no_output{run.s, 0};
    Shaded shaded = scene.shading.interpolation == Interpolation::flat ? shade_flat(batch.faces, false, no_output)
                                                                       : shade_gouraud(batch.faces, batch.at.weights, false, no_output);
    Strip::put(strip.color, i, sum_whole(scene, batch.position, shaded.terms));
  }
}

inline HWY_NOINLINE void store_pixels(const Run& run, const Strip& strip) {
  const Frame& frame = run.frame;
  const TileScratch& s = run.s;
  const TileArea& area = s.area;
  const auto width = static_cast<std::size_t>(frame.scene->view.width);
  const std::size_t first = static_cast<std::size_t>(area.top) * width + static_cast<std::size_t>(area.left);
  const float alpha = 1.0F + frame.scene->background[3] * 0.0F;
  for (std::size_t i = 0; i < run.count; i += kLanes) {
    const Int column = (load(&run.fragments.x[run.begin + i]) >> 8) - Int(area.left);
    const Int row = (load(&run.fragments.y[run.begin + i]) >> 8) - Int(area.top);
    alignas(64) std::array<std::uint32_t, kLanes> places, words;  // from the tile's first pixel on
    store(places.data(), row * Int(frame.scene->view.width) + column);
    const std::size_t count = run.count - i < kLanes ? run.count - i : kLanes;
    if (frame.bytes != nullptr) {
      store_words(frame, Strip::get(strip.color, i), words.data());
      for (std::size_t lane = 0; lane < count; ++lane) {
        std::memcpy(frame.bytes + 4 * (first + places[lane]), &words[lane], 4);
      }
    }
    if (frame.color != nullptr) {
      for (std::size_t lane = 0; lane < count; ++lane) {
        const std::array<float, 4> color{strip.color[0][i + lane], strip.color[1][i + lane], strip.color[2][i + lane], alpha};
        std::memcpy(frame.color + 4 * (first + places[lane]), color.data(), sizeof color);
      }
    }
  }
}

/// Everything that layers may ask for, of any interpolation.
inline HWY_NOINLINE void shade_all(const Run& run, std::size_t i) {
  const Frame& frame = run.frame;
  TileScratch& s = run.s;
  const PreparedScene& scene = *frame.scene;
  const Batch batch = run.batch(i);
  const OutputSlot out{s, run.begin + i};
  for (std::size_t l = 0; frame.wants_lights && l < scene.lights.size(); ++l) {
    out.put_light(l, {});  // which is what a material brings that no light reaches
  }
  Shaded shaded;
  switch (scene.shading.interpolation) {
    case Interpolation::flat:
      shaded = shade_flat(batch.faces, frame.wants_lights, out);
      break;
    case Interpolation::gouraud:
      shaded = shade_gouraud(batch.faces, batch.at.weights, frame.wants_lights, out);
      break;
    case Interpolation::phong:
      shaded = shade_phong(batch, [&](std::size_t l, const Vec3<Float>& part) {
        if (frame.wants_lights) {
          out.put_light(l, part);
        }
      });
      break;
  }
  Vec3<Float> fog{};
  if (scene.fog) {
    Float clear;
    fog = add_fog(*scene.fog, batch.position, shaded.terms, clear);
    shaded.scene_part = shaded.scene_part * clear;
    for (std::size_t l = 0; frame.wants_lights && l < scene.lights.size(); ++l) {
      out.put_light(l, out.get_light(l) * clear);
    }
  }
  store_terms(s, run.begin + i, shaded.terms, fog);
  if (frame.wants_all) {
    out.put(TileScratch::scene_part, shaded.scene_part);
    out.put(TileScratch::albedo, vec_cast<Float>(run.material.albedo) * batch.faces.tint(batch.at.weights));
    out.put(TileScratch::normal, batch.normal);
    out.put(TileScratch::position, batch.position);
    out.put(TileScratch::weights, Vec3<Float>{batch.at.weights[0], batch.at.weights[1], batch.at.weights[2]});
    out.put(TileScratch::depth, batch.at.depth);
  }
}

/// Parts of pixels: what is known of them goes into the outputs, at their places.
inline void shade_parts(const Run& all) {
  if (all.frame.scene->shading.interpolation != Interpolation::phong || all.frame.wants_all) {
    for (std::size_t i = 0; i < all.count; i += kLanes) {
      shade_all(all, i);
    }
    return;
  }
  Strip strip;
  all.in_strips([&](const Run& run) {
    make_surfaces(run, strip);
    light_parts(run, strip);
  });
}

/// Fragments that are all of their pixels: lit, summed and stored.
inline void shade_whole(const Run& all) {
  Strip strip;
  all.in_strips([&](const Run& run) {
    if (run.frame.scene->shading.interpolation == Interpolation::phong) {
      make_surfaces(run, strip);
      light_whole(run, strip);
    } else {
      light_faces(run, strip);
    }
    store_pixels(run, strip);
  });
}

}  // namespace lustro::HWY_NAMESPACE
// NOLINTEND(cppcoreguidelines-pro-type-member-init)
