// Shading a tile: the fragments that are seen, kLanes at a time, each once; then samples to pixels. Part of a row (row.cpp).
//
// What a lane calculates is what the reference calculates for that fragment (reference/fragment.cpp), operation by operation.
#pragma once

#include <bit>
#include <cstring>

#include "raster/row_maps.hpp"
#include "raster/row_strip.hpp"
#include "raster/row_visibility.hpp"

// What a kernel fills is not cleared first.
// NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
namespace lustro::HWY_NAMESPACE {

/// Reads what find_visibilities() has stored.
struct SeenAt {
  const float* seen;
  HWY_INLINE Float operator()(std::size_t light) const { return load(seen + light * kStrip); }
};

/// One evaluation of the equation.
struct Shaded {
  Terms<Float> terms;
  Vec3<Float> scene_part;
};

/// seen   of the fragments, their place in TileScratch::visibilities: find_visibilities()
/// after  maps of a pixel that are laid upon the light of a face or a vertex, or null: of its parts alone, the terms are left as they are
/// visit(i, part) sees every light's part.
template <class N, class Visit>
inline Shaded evaluate(const PreparedScene& scene, const ShadingMaterial& material, const Surface<Float>& surface,
                       const Coefficients<Float, N>& k, const float* seen, const Mapped* after, Visit&& visit) {
  Shaded result;
  result.terms = light_surface(material.lighting, surface, k, scene.surrounding_light(), scene.lights, scene.shading.normalized, SeenAt{seen},
                               [&](std::size_t i, const Incident<Float>&, const LightTerms<Float>& part) {
                                 if (after != nullptr) {
                                   const MapFactors<Float>& by = after->factors;
                                   visit(i, (part.ambient * by.ambient + part.diffuse * by.diffuse) + part.specular * by.specular);
                                 } else {
                                   visit(i, (part.ambient + part.diffuse) + part.specular);
                                 }
                               });
  const SurroundingLight around = scene.surrounding_light();
  const Float openness = around.is_occluded ? SeenAt{seen}(scene.lights.size()) : Float(1);
  Terms<Float> unlit = unlit_terms(material.lighting, surface.normal, k, around, openness);
  if (after != nullptr) {
    modulate(after->factors, unlit);
  }
  result.scene_part = (unlit.ambient + unlit.diffuse) + unlit.emission;
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

/// reference/fragment.cpp: maps_after_light()
HWY_INLINE const Mapped* maps_after_light(const ShadingMaterial& material, const Mapped* mapped) {
  return material.maps.has(MapKind::decal) ? nullptr : mapped;
}

inline Shaded shade_flat(const Faces& faces, const float* seen, const Mapped* mapped, bool wants_lights, const OutputSlot& out) {
  const Vec3<Float> center = ((faces.position(0) + faces.position(1)) + faces.position(2)) * Float(1.0F / 3.0F);
  const Surface<Float> surface{center, faces.face_normal(), faces.scene.view.to_eye_from(center)};
  const Float third(1.0F / 3.0F);
  Coefficients<Float> k = tinted(faces.material.coefficients, faces.tint({third, third, third}));
  const Mapped* after = maps_after_light(faces.material, mapped);
  if (after != mapped) {
    apply_factors(faces.material.maps, mapped->factors, k);
  }
  Shaded shaded = evaluate(faces.scene, faces.material, surface, k, seen, after, [&](std::size_t i, const Vec3<Float>& part) {
    if (wants_lights) {
      out.put_light(i, part);
    }
  });
  if (after != nullptr) {
    modulate(after->factors, shaded.terms);
  }
  return shaded;
}

inline Shaded shade_gouraud(const Faces& faces, const Weights<Float>& w, const float* seen, const Mapped* mapped, bool wants_lights,
                            const OutputSlot& out) {
  const Mapped* after = maps_after_light(faces.material, mapped);
  Shaded sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<Float> position = faces.position(i);
    const Surface<Float> surface{position, faces.normal(i), faces.scene.view.to_eye_from(position)};
    const Weights<Float> corner{Float(i == 0 ? 1.0F : 0.0F), Float(i == 1 ? 1.0F : 0.0F), Float(i == 2 ? 1.0F : 0.0F)};
    Coefficients<Float> k = tinted(faces.material.coefficients, faces.tint(corner));
    const auto ignore = [](std::size_t, const Vec3<Float>&) {};
    Shaded vertex = evaluate(faces.scene, faces.material, surface, k, seen, after, ignore);
    const Vec3<Float> total = vertex.terms.sum();
    const auto scale = [](Float c) { return select(c > Float(1), Float(1) / c, Float(1)); };
    const Vec3<Float> by{scale(total.x), scale(total.y), scale(total.z)};
    if (after != mapped) {
      apply_factors(faces.material.maps, mapped->factors, k);
      vertex = evaluate(faces.scene, faces.material, surface, k, seen, nullptr, ignore);
    }
    scale_terms(vertex.terms, by);
    vertex.scene_part = vertex.scene_part * by;
    const auto add = [&](Vec3<Float>& to, const Vec3<Float>& value) { to = i == 0 ? value * w[i] : to + value * w[i]; };
    add(sum.terms.ambient, vertex.terms.ambient);
    add(sum.terms.diffuse, vertex.terms.diffuse);
    add(sum.terms.specular, vertex.terms.specular);
    add(sum.terms.emission, vertex.terms.emission);
    add(sum.scene_part, vertex.scene_part);
    if (wants_lights) {  // once more, now that the clamp is known
      evaluate(faces.scene, faces.material, surface, k, seen, after, [&](std::size_t l, const Vec3<Float>& part) {
        Vec3<Float> value = i == 0 ? Vec3<Float>{} : out.get_light(l);
        add(value, part * by);
        out.put_light(l, value);
      });
    }
  }
  if (after != nullptr) {
    modulate(after->factors, sum.terms);
  }
  return sum;
}

/// visit(i, part) sees every light's part where layers of lights are stored.
template <class Visit>
HWY_INLINE Shaded shade_phong(const Batch& batch, const float* seen, const Mapped* mapped, Visit&& visit) {
  const Faces& faces = batch.faces;
  const Surface<Float> surface{batch.position, batch.normal, faces.scene.view.to_eye_at(batch.at.x, batch.at.y)};
  Coefficients<Float> k = tinted(faces.material.coefficients, faces.tint(batch.at.weights));
  if (mapped == nullptr) {
    return evaluate(faces.scene, faces.material, surface, k, seen, nullptr, visit);
  }
  const ShadingMaps& maps = faces.material.maps;
  apply_factors(maps, mapped->factors, k);
  if (!maps.has(MapKind::shininess)) {
    return evaluate(faces.scene, faces.material, surface, k, seen, nullptr, visit);
  }
  const Coefficients<Float, LaneExponent<Float>> varying{k.ambient, k.diffuse, k.specular, k.emission,
                                                         textured_shininess<LaneFetch>(maps, mapped->at, k.shininess.n)};
  return evaluate(faces.scene, faces.material, surface, varying, seen, nullptr, visit);
}

/// Dims the terms by the fog, and says what it adds.
HWY_INLINE Vec3<Float> add_fog(const ShadingFog& fog, const Vec3<Float>& position, Terms<Float>& terms, Float& clear) {
  clear = fog_factor(fog, length(position));
  scale_terms(terms, Vec3<Float>{clear, clear, clear});
  return vec_cast<Float>(fog.color) * (Float(1) - clear);
}

inline HWY_NOINLINE Vec3<Float> toned_out_of_line(const Toning& toning, const Vec3<Float>& linear) {
  return toned(toning, linear);
}

/// image/store.cpp for lanes: the bytes of opaque pixels, alpha the highest.
HWY_INLINE void store_words(const Frame& frame, const Vec3<Float>& linear, std::uint32_t* words) {
  const Vec3<Float> rgb = HWY_UNLIKELY(frame.toning.changes()) ? toned_out_of_line(frame.toning, linear) : linear;
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

/// What the equation asks for at each point, for Phong interpolation.
inline HWY_NOINLINE void make_surfaces(const Run& run, const FaceTable& faces, Strip& strip) {
  if (HWY_UNLIKELY(run.material.maps.has_any())) {
    make_mapped_surfaces(run, faces, strip);
    return;
  }
  const bool has_tint = !run.instance.drawable->colors.empty();
  for (std::size_t i = 0; i < run.count; i += kLanes) {
    const Batch batch = run.batch(faces, i);
    put_surface(run, strip, i, batch);
    if (has_tint) {
      Strip::put(strip.tint, i, batch.faces.tint(batch.at.weights));
    }
  }
}

/// The equation at the strip's points: visit(i, position, terms) for every vector of them.
template <class Visit>
HWY_INLINE void light_surfaces(const Run& run, const FaceTable& faces, const Strip& strip, Visit&& visit) {
  const PreparedScene& scene = *run.frame.scene;
  const ShadingMaterial& material = run.material;
  const bool has_tint = !run.instance.drawable->colors.empty();
  const float* seen = run.s.visibilities.data();
  if (HWY_UNLIKELY(scene.looks_beyond())) {
    find_visibilities(run, faces, strip);
  }
  Reflection<float>* reflections = run.s.reflections.data();  // without a tint they are the same everywhere
  for (std::size_t l = 0; l < scene.lights.size(); ++l) {
    reflections[l] = reflection_of(material.coefficients, scene.lights[l]);
  }
  for (std::size_t i = 0; i < run.count; i += kLanes) {
    const Surface<Float> surface{Strip::get(strip.position, i), Strip::get(strip.normal, i), Strip::get(strip.to_eye, i)};
    const auto ignore = [](std::size_t, const Vec3<Float>&) {};
    Terms<Float> terms;
    if (HWY_UNLIKELY(material.maps.has_any())) {
      const Coefficients<Float> k = strip.coefficients_at(i, material.coefficients);
      if (material.maps.has(MapKind::shininess)) {
        const Coefficients<Float, LaneExponent<Float>> varying{k.ambient, k.diffuse, k.specular, k.emission, {load(&strip.shininess[i])}};
        terms = evaluate(scene, material, surface, varying, seen + i, nullptr, ignore).terms;
      } else {
        terms = light_surface(material.lighting, surface, k, scene.surrounding_light(), scene.lights, scene.shading.normalized, SeenAt{seen + i},
                              [](std::size_t, const Incident<Float>&, const LightTerms<Float>&) {});
      }
      if (material.maps.reflects) {
        terms.specular += Strip::get(strip.reflection, i);
      }
    } else if (has_tint) {
      terms = evaluate(scene, material, surface, tinted(material.coefficients, Strip::get(strip.tint, i)), seen + i, nullptr, ignore).terms;
    } else {
      terms = light_surface(
          material.lighting, surface, material.coefficients, scene.surrounding_light(), scene.lights, scene.shading.normalized,
          [reflections](std::size_t l) -> const Reflection<float>& { return reflections[l]; }, SeenAt{seen + i},
          [](std::size_t, const Incident<Float>&, const LightTerms<Float>&) {});
    }
    visit(i, surface.position, terms);
  }
}

inline HWY_NOINLINE void light_whole(const Run& run, const FaceTable& faces, Strip& strip) {
  light_surfaces(run, faces, strip, [&](std::size_t i, const Vec3<Float>& position, Terms<Float>& terms) {
    Strip::put(strip.color, i, sum_whole(*run.frame.scene, position, terms));
  });
}

HWY_INLINE void store_terms(TileScratch& s, std::size_t at, const Terms<Float>& t, const Vec3<Float>& fog) {
  store_transposed({t.ambient.x, t.ambient.y, t.ambient.z, t.diffuse.x, t.diffuse.y, t.diffuse.z, t.specular.x, t.specular.y, t.specular.z,
                    t.emission.x, t.emission.y, t.emission.z, fog.x, fog.y, fog.z, Float(0)},
                   &s.part_terms[at * TileScratch::terms]);
}

inline HWY_NOINLINE void light_parts(const Run& run, const FaceTable& faces, const Strip& strip) {
  light_surfaces(run, faces, strip, [&](std::size_t i, const Vec3<Float>& position, Terms<Float>& terms) {
    Vec3<Float> fog{};
    if (run.frame.scene->fog) {
      Float clear;
      fog = add_fog(*run.frame.scene->fog, position, terms, clear);
    }
    store_terms(run.s, run.begin + i, terms, fog);
  });
}

/// reference/fragment.cpp: add_reflection()
HWY_INLINE void add_reflection(const ShadingMaterial& material, const Mapped& mapped, Shaded& shaded) {
  if (HWY_UNLIKELY(material.maps.reflects)) {
    const Vec3<Float> part = reflected_surroundings(material.coefficients.specular, mapped.factors, mapped.reflection);
    shaded.terms.specular += part;
    shaded.scene_part += part;
  }
}

/// Flat and Gouraud interpolation light faces and their vertices.
inline HWY_NOINLINE void light_faces(const Run& run, const FaceTable& faces, Strip& strip) {
  const PreparedScene& scene = *run.frame.scene;
  for (std::size_t i = 0; i < run.count; i += kLanes) {
    Batch batch = run.batch(faces, i, run.asks_for_normals());
    Mapped maps;
    if (run.material.maps.has_any()) {
      look_up_maps(batch, maps);
    }
    const Mapped* mapped = run.material.maps.has_any() ? &maps : nullptr;
    const float* seen = find_visibilities(scene, run.s, batch);
    const OutputSlot no_output{run.s, 0};
    Shaded shaded = scene.shading.interpolation == Interpolation::flat
                        ? shade_flat(batch.faces, seen, mapped, false, no_output)
                        : shade_gouraud(batch.faces, batch.at.weights, seen, mapped, false, no_output);
    add_reflection(run.material, maps, shaded);
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
    const Int place = row * Int(frame.scene->view.width) + column;
    store(places.data(), place);
    const std::size_t count = run.count - i < kLanes ? run.count - i : kLanes;
    if (frame.bytes != nullptr) {
      store_words(frame, Strip::get(strip.color, i), words.data());
      if (count == kLanes && all_of(place == Int(static_cast<std::int32_t>(places[0])) + lane_numbers())) {
        std::memcpy(frame.bytes + 4 * (first + places[0]), words.data(), sizeof words);
      } else {
        for (std::size_t lane = 0; lane < count; ++lane) {
          std::memcpy(frame.bytes + 4 * (first + places[lane]), &words[lane], 4);
        }
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
inline HWY_NOINLINE void shade_all(const Run& run, const FaceTable& faces, std::size_t i) {
  const Frame& frame = run.frame;
  TileScratch& s = run.s;
  const PreparedScene& scene = *frame.scene;
  Batch batch = run.batch(faces, i, run.asks_for_normals());
  Mapped maps;
  if (run.material.maps.has_any()) {
    look_up_maps(batch, maps);
  }
  const Mapped* mapped = run.material.maps.has_any() ? &maps : nullptr;
  const float* seen = find_visibilities(scene, s, batch);
  const OutputSlot out{s, run.begin + i};
  for (std::size_t l = 0; frame.wants_lights && l < scene.lights.size(); ++l) {
    out.put_light(l, {});  // which is what a material brings that no light reaches
  }
  Shaded shaded;
  switch (scene.shading.interpolation) {
    case Interpolation::flat:
      shaded = shade_flat(batch.faces, seen, mapped, frame.wants_lights, out);
      break;
    case Interpolation::gouraud:
      shaded = shade_gouraud(batch.faces, batch.at.weights, seen, mapped, frame.wants_lights, out);
      break;
    case Interpolation::phong:
      shaded = shade_phong(batch, seen, mapped, [&](std::size_t l, const Vec3<Float>& part) {
        if (frame.wants_lights) {
          out.put_light(l, part);
        }
      });
      break;
  }
  add_reflection(run.material, maps, shaded);
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
    const Vec3<Float> albedo = vec_cast<Float>(run.material.albedo) * batch.faces.tint(batch.at.weights);
    out.put(TileScratch::albedo, mapped != nullptr ? textured_albedo(run.material.maps, mapped->factors, albedo) : albedo);
    out.put(TileScratch::normal, batch.normal);
    out.put(TileScratch::position, batch.position);
    out.put(TileScratch::weights, Vec3<Float>{batch.at.weights[0], batch.at.weights[1], batch.at.weights[2]});
    out.put(TileScratch::depth, batch.at.depth);
  }
}

/// Parts of pixels: what is known of them goes into the outputs, at their places.
inline void shade_parts(const Run& all) {
  if (all.frame.scene->shading.interpolation != Interpolation::phong || all.frame.wants_all) {
    all.in_strips([](const Run& run) {
      const RunFaces faces(run, wants_of_shading(run));
      for (std::size_t i = 0; i < run.count; i += kLanes) {
        shade_all(run, faces, i);
      }
    });
    return;
  }
  Strip strip;
  all.in_strips([&](const Run& run) {
    const RunFaces faces(run, wants_of_shading(run));
    make_surfaces(run, faces, strip);
    light_parts(run, faces, strip);
  });
}

/// Fragments that are all of their pixels: lit, summed and stored.
inline void shade_whole(const Run& all) {
  Strip strip;
  all.in_strips([&](const Run& run) {
    const RunFaces faces(run, wants_of_shading(run));
    if (run.frame.scene->shading.interpolation == Interpolation::phong) {
      make_surfaces(run, faces, strip);
      light_whole(run, faces, strip);
    } else {
      light_faces(run, faces, strip);
    }
    store_pixels(run, strip);
  });
}

}  // namespace lustro::HWY_NAMESPACE
// NOLINTEND(cppcoreguidelines-pro-type-member-init)
