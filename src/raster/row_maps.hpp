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
  [[nodiscard]] HWY_INLINE Places<Float> places_at(std::size_t i) const {
    const auto quad = [&](std::size_t number) {
      return TexelQuad<Float>{load(&texels[2 * number][i]), load(&texels[2 * number + 1][i]), load(&shares[3 * number][i]),
                              load(&shares[3 * number + 1][i]), load(&shares[3 * number + 2][i])};
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
  const LaneFetch fetch(map.texels);
  for (std::size_t i = 0; i < count; i += kLanes) {
    const Footprint<Float> at = on_map(map, s.footprint_at(map.uv_set, i));
    s.put(i, places_at(map.sampler, fetch, at.u, at.v, size_of_footprint(map.sampler, map.width, map.height, at).lod));
    if (map.leaves_outside) {
      store(&s.applies[i], is_on_picture(at.u, at.v));
    }
  }
}

/// Asks for the texels of all maps from `first` on that find them at the places at hand, before any of them waits. Fragments beside each other
/// share lines of the cache: of each level's rows every kCallStep-th one's are asked for.
HWY_INLINE void call_texels(const ShadingMaps& maps, std::size_t first, std::size_t count, const MapStrip& s) {
  constexpr std::size_t kCallStep = 2;
  for (std::size_t kind = first; kind < kMapKinds; ++kind) {
    if ((maps.present >> kind & 1U) == 0 || !are_alike(maps.maps[first], maps.maps[kind])) {
      continue;
    }
    for (std::size_t i = 0; i < count; i += kCallStep) {
      for (const MapStrip::IntRow& row : s.texels) {
        call_texel(maps.maps[kind].texels, row[i]);
      }
    }
  }
}

/// The map's values at the places that find_places() found.
template <class Fetch, bool kHasAlpha>
HWY_NOINLINE void read_map_by(const ShadingMap& map, std::size_t count, MapStrip& s) {
  const Fetch fetch(map.texels);
  const Float scale(fetch.scale());
  for (std::size_t i = 0; i < count; i += kLanes) {
    Texel<Float> texel = fetch_places(map.sampler, fetch, s.places_at(i));
    for (Float& channel : texel) {
      channel = channel * scale;
    }
    const MapValue<Float> value = value_of(map, texel, Float(1));
    store(&s.value[0][i], value.rgb.x);
    store(&s.value[1][i], value.rgb.y);
    store(&s.value[2][i], value.rgb.z);
    if constexpr (kHasAlpha) {
      store(&s.value[3][i], value.alpha);
    }
  }
}

inline void read_map(const ShadingMap& map, bool has_alpha, std::size_t count, MapStrip& s) {
  if (map.texels.bytes != nullptr) {
    has_alpha ? read_map_by<ByteFetch, true>(map, count, s) : read_map_by<ByteFetch, false>(map, count, s);
  } else {
    has_alpha ? read_map_by<LaneFetch, true>(map, count, s) : read_map_by<LaneFetch, false>(map, count, s);
  }
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
      call_texels(maps, kind, count, s);
      placed = &map;
    }
    const bool is_read = is_placed && read != nullptr && !has_alpha && read->texels.bytes == map.texels.bytes &&
                         read->texels.unorms == map.texels.unorms && read->texels.floats == map.texels.floats && read->gain == map.gain &&
                         read->base == map.base && are_equal(read->sampler.border, map.sampler.border);
    if (!is_read) {
      read_map(map, has_alpha, count, s);
      read = &map;
    }
    take(static_cast<MapKind>(kind), map);
  }
}

/// What a normal map changes: it is worked out only where the map states nothing.
inline HWY_NOINLINE Vec3<Float> interpolated_normal(const Run& run, std::size_t i) {
  return run.batch(i).normal;
}

/// The coefficients, the exponent and the normal of a strip under its material's maps.
inline HWY_NOINLINE void apply_maps(const Run& run, Strip& strip, MapStrip& s) {
  const ShadingMaps& maps = run.material.maps;
  const auto each = [&](auto&& at) {
    for (std::size_t i = 0; i < run.count; i += kLanes) {
      at(i);
    }
  };
  const auto applies_at = [&](const ShadingMap& map, std::size_t i) { return map.leaves_outside ? load(&s.applies[i]) : Float(1); };
  each_map(maps, run.count, s, [&](MapKind kind, const ShadingMap& map) {
    const auto multiply = [&](Strip::Rows& rows) {
      each([&](std::size_t i) {
        Vec3<Float> factor = s.rgb_at(i);
        if (map.leaves_outside) {
          const Mask applies = load(&s.applies[i]) > Float(0);
          factor = {select(applies, factor.x, Float(1)), select(applies, factor.y, Float(1)), select(applies, factor.z, Float(1))};
        }
        Strip::put(rows, i, Strip::get(rows, i) * factor);
      });
    };
    switch (kind) {
      case MapKind::ambient:
        return multiply(strip.ambient);
      case MapKind::diffuse:
        return multiply(strip.diffuse);
      case MapKind::specular:
        return multiply(strip.specular);
      case MapKind::emission:
        return multiply(strip.emission);
      case MapKind::shininess:
        return each([&](std::size_t i) {
          const MapValue<Float> value{s.rgb_at(i), load(&s.value[3][i]), applies_at(map, i)};
          store(&strip.shininess[i], shininess_under(map, value, run.material.coefficients.shininess.n).n);
        });
      case MapKind::decal:
        return each([&](std::size_t i) {
          const Vec3<Float> decal = s.rgb_at(i);
          const Float share = load(&s.value[3][i]) * applies_at(map, i);
          const auto cover = [&](Strip::Rows& rows) {
            const Vec3<Float> k = Strip::get(rows, i);
            Strip::put(rows, i, k + (decal - k) * share);
          };
          if (maps.decal_on_ambient) {
            cover(strip.ambient);
          }
          if (maps.decal_on_diffuse) {
            cover(strip.diffuse);
          }
        });
      case MapKind::normal:
        return each([&](std::size_t i) {
          const Vec3<Float> value = s.rgb_at(i) * Float(2) - Vec3<Float>{Float(1), Float(1), Float(1)};
          const TangentFrame<Float> frame{Strip::get(s.frame_tangent, i), Strip::get(s.frame_normal, i), load(&s.handedness[i])};
          const Float side = load(&s.side[i]);
          const Vec3<Float> stated =
              maps.normal_is_object_space ? run.instance.normal_from_object.turned(value) : frame.turn(run.instance, value);
          const Float applies = applies_at(map, i);
          const bool is_stated = all_of(has_direction(stated * applies));
          const Vec3<Float> unchanged = HWY_LIKELY(is_stated) ? Vec3<Float>{} : interpolated_normal(run, i) * side;
          Strip::put(strip.normal, i, stated_normal(stated, applies, unchanged) * side);
        });
      case MapKind::bump:  // not here: goes_by_maps()
        return;
    }
  });
}

HWY_INLINE void put_coefficients(Strip& strip, std::size_t i, const Coefficients<Float>& k) {
  Strip::put(strip.ambient, i, k.ambient);
  Strip::put(strip.diffuse, i, k.diffuse);
  Strip::put(strip.specular, i, k.specular);
  Strip::put(strip.emission, i, k.emission);
}

HWY_INLINE void put_surface(const Run& run, Strip& strip, std::size_t i, const Batch& batch, bool has_normal = true) {
  Strip::put(strip.position, i, batch.position);
  if (has_normal) {
    Strip::put(strip.normal, i, batch.normal);
  }
  Strip::put(strip.to_eye, i, run.frame.scene->view.to_eye_at(batch.at.x, batch.at.y));
}

/// Fragment by fragment, all maps of a batch at once.
inline HWY_NOINLINE void make_surfaces_by_batches(const Run& run, Strip& strip) {
  const ShadingMaps& maps = run.material.maps;
  for (std::size_t i = 0; i < run.count; i += kLanes) {
    Batch batch = run.batch(i);
    Mapped mapped;
    look_up_maps(batch, mapped);
    put_surface(run, strip, i, batch);
    Coefficients<Float> k = tinted(run.material.coefficients, batch.faces.tint(batch.at.weights));
    apply_factors(maps, mapped.factors, k);
    put_coefficients(strip, i, k);
    if (maps.reflects) {
      Strip::put(strip.reflection, i, reflected_surroundings(run.material.coefficients.specular, mapped.factors, mapped.reflection));
    }
    if (maps.has(MapKind::shininess)) {
      store(&strip.shininess[i], textured_shininess<LaneFetch>(maps, mapped.at, k.shininess.n).n);
    }
  }
}

/// What the equation asks for at each point where maps change the surface.
inline HWY_NOINLINE void make_mapped_surfaces(const Run& run, Strip& strip) {
  const ShadingMaps& maps = run.material.maps;
  if (!goes_by_maps(maps)) {
    make_surfaces_by_batches(run, strip);
    return;
  }
  MapStrip s;
  const bool is_bent = maps.has(MapKind::normal);
  const bool has_frame = is_bent && !maps.normal_is_object_space;
  for (std::size_t i = 0; i < run.count; i += kLanes) {
    const Batch batch = run.batch(i, !is_bent);
    put_surface(run, strip, i, batch, !is_bent);
    put_coefficients(strip, i, tinted(run.material.coefficients, batch.faces.tint(batch.at.weights)));
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
  apply_maps(run, strip, s);
}

}  // namespace lustro::HWY_NAMESPACE
// NOLINTEND(cppcoreguidelines-pro-type-member-init)
