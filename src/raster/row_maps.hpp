// What maps make of a strip of fragments, a stage and a map at a time: short loops, as in row_strip.hpp. Part of a row (row.cpp).
//
// The numbers are those of shade/texturing.hpp and scene/mapped_surface.hpp. Maps of one size that are looked up alike find their texels at the
// same places, which are worked out once.
#pragma once

#include "raster/row_strip.hpp"

// What a kernel fills is not cleared first.
// NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
namespace lustro::HWY_NAMESPACE {

/// A strip's way through the maps.
struct MapStrip {
  using Row = std::array<float, kStrip>;
  using IntRow = std::array<std::int32_t, kStrip>;

  alignas(64) std::array<std::array<Row, 6>, 2> footprint;  // of both sets of coordinates
  alignas(64) Strip::Rows frame_tangent, frame_normal;      // TangentFrame, where a normal map speaks in it
  alignas(64) Row handedness, side;

  alignas(64) std::array<IntRow, 4> texels;  // of the larger level's upper and lower row, and of the smaller one's
  alignas(64) std::array<Row, 7> shares;     // across, down, inside of each level; of the smaller level
  alignas(64) std::array<Row, 4> value;      // of the map at hand: rgb and alpha
  alignas(64) Row applies;

  HWY_INLINE void put(std::size_t set, std::size_t i, const Footprint<Float>& at) {
    std::size_t row = 0;
    for (const Float& part : {at.u, at.v, at.u_dx, at.v_dx, at.u_dy, at.v_dy}) {
      store(&footprint[set][row++][i], part);
    }
  }
  [[nodiscard]] HWY_INLINE Footprint<Float> footprint_at(std::size_t set, std::size_t i) const {
    const auto part = [&](std::size_t row) { return load(&footprint[set][row][i]); };
    return {part(0), part(1), part(2), part(3), part(4), part(5)};
  }
  HWY_INLINE void put(std::size_t i, const Places<Float>& places) {
    std::size_t number = 0;
    for (const TexelQuad<Float>* quad : {&places.near, &places.far}) {
      store(&texels[2 * number][i], quad->upper);
      store(&texels[2 * number + 1][i], quad->lower);
      store(&shares[3 * number][i], quad->across);
      store(&shares[3 * number + 1][i], quad->down);
      store(&shares[3 * number + 2][i], quad->inside);
      ++number;
    }
    store(&shares[6][i], places.blend);
  }
  struct StoredPlaces {
    StoredQuad near, far;
    Float blend;
  };
  [[nodiscard]] HWY_INLINE StoredPlaces places_at(std::size_t i) const {
    const auto quad = [&](std::size_t number) {
      return StoredQuad{&texels[2 * number][i], &texels[2 * number + 1][i], load(&shares[3 * number][i]), load(&shares[3 * number + 1][i]),
                        load(&shares[3 * number + 2][i])};
    };
    return {quad(0), quad(1), load(&shares[6][i])};
  }
  [[nodiscard]] HWY_INLINE Vec3<Float> rgb_at(std::size_t i) const { return {load(&value[0][i]), load(&value[1][i]), load(&value[2][i])}; }
};

/// Whether a strip goes map by map. Several looks along a footprint, heights, of which a slope takes four, and reflections, which follow from
/// the other maps' normal, go fragment by fragment.
HWY_INLINE bool goes_by_maps(const ShadingMaps& maps) {
  for (std::size_t kind = 0; kind < kMapKinds; ++kind) {
    if ((maps.present >> kind & 1U) != 0 && maps.maps[kind].sampler.anisotropy > 1) {
      return false;
    }
  }
  return !maps.has(MapKind::bump) && !maps.reflects;
}

template <std::size_t kSize>
HWY_INLINE bool are_equal(const std::array<float, kSize>& a, const std::array<float, kSize>& b) {
  for (std::size_t i = 0; i < kSize; ++i) {
    if (!(a[i] == b[i])) {
      return false;
    }
  }
  return true;
}

/// Whether two maps find their texels at the same places.
HWY_INLINE bool are_alike(const ShadingMap& a, const ShadingMap& b) {
  const Sampler& s = a.sampler;
  const Sampler& t = b.sampler;
  return a.width == b.width && a.height == b.height && a.uv_set == b.uv_set && s.wrap_u == t.wrap_u && s.wrap_v == t.wrap_v &&
         s.magnify == t.magnify && s.minify == t.minify && s.mip == t.mip && s.lod_bias == t.lod_bias && s.blend_u == t.blend_u &&
         s.blend_v == t.blend_v && are_equal(a.uv_matrix, b.uv_matrix);
}

__attribute__((flatten)) inline HWY_NOINLINE void find_places(const ShadingMap& map, std::size_t count, MapStrip& s) {
  const LevelTable fetch(map.texels);
  for (std::size_t i = 0; i < count; i += kLanes) {
    const Footprint<Float> at = on_map(map, s.footprint_at(map.uv_set, i));
    s.put(i, places_at(map.sampler, fetch, at.u, at.v, size_of_footprint(map.sampler, map.width, map.height, at).lod));
    if (map.leaves_outside) {
      store(&s.applies[i], is_on_picture(at.u, at.v));
    }
  }
}

/// Asks for a texture's texels at the places of the batch from i on, before anyone waits for them. Fragments beside each other share lines of
/// the cache: every kCallStep-th one's are asked for, and of each level the upper row's alone, for the lower one mostly is the upper one of the
/// fragments above or below.
HWY_INLINE void call_texels(const TextureLayout& texels, std::size_t i, const MapStrip& s) {
  constexpr std::size_t kCallStep = 2;
  for (std::size_t lane = 0; lane < kLanes; lane += kCallStep) {
    call_texel(texels, s.texels[0][i + lane]);
    call_texel(texels, s.texels[2][i + lane]);
  }
}

/// The map's values at the places that find_places() found. Meanwhile the texels of the one that is read `next`, if any, come nearer.
template <class Fetch, bool kHasAlpha>
HWY_NOINLINE void read_map_by(const ShadingMap& map, const ShadingMap* next, std::size_t count, MapStrip& s) {
  const Fetch fetch(map.texels);
  const Float scale(fetch.scale());
  const bool is_stretched = map.is_stretched() || map.texels.floats != nullptr;  // floats may be -0, of which -0 * 1 + 0 makes 0
  for (std::size_t i = 0; i < count; i += kLanes) {
    if (next != nullptr) {
      call_texels(next->texels, i, s);
    }
    Texel<Float> texel = fetch_places<Float>(map.sampler, fetch, s.places_at(i));
    for (Float& channel : texel) {
      channel = channel * scale;
    }
    const MapValue<Float> value =
        is_stretched ? value_of(map, texel, Float(1)) : MapValue<Float>{{texel[0], texel[1], texel[2]}, texel[3], Float(1)};
    store(&s.value[0][i], value.rgb.x);
    store(&s.value[1][i], value.rgb.y);
    store(&s.value[2][i], value.rgb.z);
    if constexpr (kHasAlpha) {
      store(&s.value[3][i], value.alpha);
    }
  }
}

template <class Fetch>
HWY_INLINE void read_map_by(const ShadingMap& map, const ShadingMap* next, bool has_alpha, std::size_t count, MapStrip& s) {
  has_alpha ? read_map_by<Fetch, true>(map, next, count, s) : read_map_by<Fetch, false>(map, next, count, s);
}

inline void read_map(const ShadingMap& map, const ShadingMap* next, bool has_alpha, std::size_t count, MapStrip& s) {
  const bool is_gray = map.texels.is_gray;
  if (map.texels.bytes != nullptr) {
    is_gray ? read_map_by<ByteFetch<true>>(map, next, has_alpha, count, s) : read_map_by<ByteFetch<false>>(map, next, has_alpha, count, s);
  } else {
    is_gray ? read_map_by<AnyFetch<true>>(map, next, has_alpha, count, s) : read_map_by<AnyFetch<false>>(map, next, has_alpha, count, s);
  }
}

/// The map after `kind` that finds its texels at the same places; null where there is none.
HWY_INLINE const ShadingMap* next_alike(const ShadingMaps& maps, std::size_t kind) {
  for (std::size_t next = kind + 1; next < kMapKinds; ++next) {
    if ((maps.present >> next & 1U) != 0 && are_alike(maps.maps[kind], maps.maps[next])) {
      return &maps.maps[next];
    }
  }
  return nullptr;
}

/// Looks one map up after the other; take(kind) sees its values.
template <class Take>
inline void each_map(const ShadingMaps& maps, std::size_t count, MapStrip& s, Take&& take) {
  const ShadingMap* placed = nullptr;
  const ShadingMap* read = nullptr;
  for (std::size_t kind = 0; kind < kMapKinds; ++kind) {
    if ((maps.present >> kind & 1U) == 0) {
      continue;
    }
    const ShadingMap& map = maps.maps[kind];
    const bool has_alpha = static_cast<MapKind>(kind) == MapKind::decal || static_cast<MapKind>(kind) == MapKind::shininess;
    const bool is_placed = placed != nullptr && are_alike(*placed, map) && (!map.leaves_outside || placed->leaves_outside);
    if (!is_placed) {
      find_places(map, count, s);
      for (std::size_t i = 0; i < count; i += kLanes) {
        call_texels(map.texels, i, s);
      }
      placed = &map;
    }
    const bool is_read = is_placed && read != nullptr && !has_alpha && read->texels.bytes == map.texels.bytes &&
                         read->texels.unorms == map.texels.unorms && read->texels.floats == map.texels.floats && read->gain == map.gain &&
                         read->base == map.base && are_equal(read->sampler.border, map.sampler.border);
    if (!is_read) {
      read_map(map, next_alike(maps, kind), has_alpha, count, s);
      read = &map;
    }
    take(static_cast<MapKind>(kind), map);
  }
}

/// What a normal map changes: it is worked out only where the map states nothing.
inline HWY_NOINLINE Vec3<Float> interpolated_normal(const Run& run, const FaceTable& faces, std::size_t i) {
  return run.batch(faces, i).normal;
}

/// The coefficients, the exponent and the normal of a strip under its material's maps.
inline HWY_NOINLINE void apply_maps(const Run& run, const FaceTable& faces, Strip& strip, MapStrip& s) {
  const ShadingMaps& maps = run.material.maps;
  const Coefficients<float>& stated = run.material.coefficients;
  const auto each = [&](auto&& at) {
    for (std::size_t i = 0; i < run.count; i += kLanes) {
      at(i);
    }
  };
  const auto applies_at = [&](const ShadingMap& map, std::size_t i) { return map.leaves_outside ? load(&s.applies[i]) : Float(1); };
  each_map(maps, run.count, s, [&](MapKind kind, const ShadingMap& map) {
    const auto multiply = [&](Strip::Coefficient which, const Vec3f& of_material) {
      each([&](std::size_t i) {
        Vec3<Float> factor = s.rgb_at(i);
        if (map.leaves_outside) {
          const Mask applies = load(&s.applies[i]) > Float(0);
          factor = {select(applies, factor.x, Float(1)), select(applies, factor.y, Float(1)), select(applies, factor.z, Float(1))};
        }
        strip.put_coefficient(which, i, strip.coefficient(which, i, of_material) * factor);
      });
      strip.differing |= 1U << which;
    };
    const auto cover = [&](Strip::Coefficient which, const Vec3f& of_material) {
      each([&](std::size_t i) {
        const Vec3<Float> k = strip.coefficient(which, i, of_material);
        strip.put_coefficient(which, i, k + (s.rgb_at(i) - k) * (load(&s.value[3][i]) * applies_at(map, i)));
      });
      strip.differing |= 1U << which;
    };
    switch (kind) {
      case MapKind::ambient:
        return multiply(Strip::ambient, stated.ambient);
      case MapKind::diffuse:
        return multiply(Strip::diffuse, stated.diffuse);
      case MapKind::specular:
        return multiply(Strip::specular, stated.specular);
      case MapKind::emission:
        return multiply(Strip::emission, stated.emission);
      case MapKind::shininess:
        return each([&](std::size_t i) {
          const MapValue<Float> value{s.rgb_at(i), load(&s.value[3][i]), applies_at(map, i)};
          store(&strip.shininess[i], shininess_under(map, value, stated.shininess.n).n);
        });
      case MapKind::decal:
        if (maps.decal_on_ambient) {
          cover(Strip::ambient, stated.ambient);
        }
        if (maps.decal_on_diffuse) {
          cover(Strip::diffuse, stated.diffuse);
        }
        return;
      case MapKind::normal:
        return each([&](std::size_t i) {
          const Vec3<Float> value = s.rgb_at(i) * Float(2) - Vec3<Float>{Float(1), Float(1), Float(1)};
          const TangentFrame<Float> frame{Strip::get(s.frame_tangent, i), Strip::get(s.frame_normal, i), load(&s.handedness[i])};
          const Float side = load(&s.side[i]);
          const Vec3<Float> bent = maps.normal_is_object_space ? run.instance.normal_from_object.turned(value) : frame.turn(run.instance, value);
          const Float applies = applies_at(map, i);
          const bool is_stated = all_of(has_direction(bent * applies));
          const Vec3<Float> unchanged = HWY_LIKELY(is_stated) ? Vec3<Float>{} : interpolated_normal(run, faces, i) * side;
          Strip::put(strip.normal, i, stated_normal(bent, applies, unchanged) * side);
        });
      case MapKind::bump:  // not here: goes_by_maps()
        return;
    }
  });
}

HWY_INLINE void put_surface(const Run& run, Strip& strip, std::size_t i, const Batch& batch, bool has_normal = true) {
  Strip::put(strip.position, i, batch.position);
  if (has_normal) {
    Strip::put(strip.normal, i, batch.normal);
  }
  Strip::put(strip.to_eye, i, run.frame.scene->view.to_eye_at(batch.at.x, batch.at.y));
}

/// Fragment by fragment, all maps of a batch at once.
inline HWY_NOINLINE void make_surfaces_by_batches(const Run& run, const FaceTable& faces, Strip& strip) {
  const ShadingMaps& maps = run.material.maps;
  strip.differing = (1U << Strip::coefficient_count) - 1;
  for (std::size_t i = 0; i < run.count; i += kLanes) {
    Batch batch = run.batch(faces, i);
    Mapped mapped;
    look_up_maps(batch, mapped);
    put_surface(run, strip, i, batch);
    Coefficients<Float> k = tinted(run.material.coefficients, batch.faces.tint(batch.at.weights));
    apply_factors(maps, mapped.factors, k);
    strip.put_coefficient(Strip::ambient, i, k.ambient);
    strip.put_coefficient(Strip::diffuse, i, k.diffuse);
    strip.put_coefficient(Strip::specular, i, k.specular);
    strip.put_coefficient(Strip::emission, i, k.emission);
    if (maps.reflects) {
      Strip::put(strip.reflection, i, reflected_surroundings(run.material.coefficients.specular, mapped.factors, mapped.reflection));
    }
    if (maps.has(MapKind::shininess)) {
      store(&strip.shininess[i], textured_shininess<LaneFetch>(maps, mapped.at, k.shininess.n).n);
    }
  }
}

/// What the equation asks for at each point where maps change the surface.
inline HWY_NOINLINE void make_mapped_surfaces(const Run& run, const FaceTable& faces, Strip& strip) {
  const ShadingMaps& maps = run.material.maps;
  if (!goes_by_maps(maps)) {
    make_surfaces_by_batches(run, faces, strip);
    return;
  }
  MapStrip s;
  const bool is_bent = maps.has(MapKind::normal);
  const bool has_frame = is_bent && !maps.normal_is_object_space;
  const bool has_tint = !run.instance.drawable->colors.empty();
  strip.differing = has_tint ? 1U << Strip::ambient | 1U << Strip::diffuse : 0U;
  for (std::size_t i = 0; i < run.count; i += kLanes) {
    const Batch batch = run.batch(faces, i, !is_bent);
    put_surface(run, strip, i, batch, !is_bent);
    if (has_tint) {
      const Coefficients<Float> k = tinted(run.material.coefficients, batch.faces.tint(batch.at.weights));
      strip.put_coefficient(Strip::ambient, i, k.ambient);
      strip.put_coefficient(Strip::diffuse, i, k.diffuse);
    }
    const std::array<Footprint<Float>, 2> at = footprints_on<Float>(batch.faces, batch.at.weights, batch.slopes);
    for (std::size_t set = 0; set < 2; ++set) {
      if ((maps.uv_sets >> set & 1U) != 0) {
        s.put(set, i, at[set]);
      }
    }
    store(&s.side[i], batch.faces.side);
    if (has_frame) {
      const TangentFrame<Float> frame = tangent_frame_on(batch.faces, run.frame.scene->shading.normals, batch.at.weights);
      Strip::put(s.frame_tangent, i, frame.tangent);
      Strip::put(s.frame_normal, i, frame.normal);
      store(&s.handedness[i], frame.handedness);
    }
  }
  apply_maps(run, faces, strip, s);
}

}  // namespace lustro::HWY_NAMESPACE
// NOLINTEND(cppcoreguidelines-pro-type-member-init)
