// From what a tile's samples show to its pixels: which fragments there are, how they are sorted for shading, how they sum. Part of a row
// (row.cpp). The sums are the reference's (reference/pixel.cpp), in its order.
#pragma once

#include "raster/frame.hpp"
#include "raster/row_shade.hpp"
#include "simd/lanes.hpp"

// What a kernel fills is not cleared first.
// NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
namespace lustro::HWY_NAMESPACE {

/// A pixel whose parts wait to be shaded.
struct WaitingPixel {
  std::uint16_t x, y;  // within the tile
  std::uint16_t first, parts;
};

struct Shader {
  const Frame& frame;
  TileScratch& s;
  std::size_t pixels = 0;
  std::array<WaitingPixel, TileScratch::kFragments> waiting;
};

HWY_INLINE bool covers_center(const Record& t, std::int32_t px, std::int32_t py) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t from = i == 2 ? 0 : i + 1;
    const std::size_t to = i == 0 ? 2 : i - 1;
    const std::int64_t e = edge_function(t.x[from], t.y[from], t.x[to], t.y[to], px, py);
    if (e + edge_bias(t.x[from], t.y[from], t.x[to], t.y[to]) < 0) {
      return false;
    }
  }
  return true;
}

/// A pixel that shows several triangles, or some of the background: its parts, by their first sample.
inline HWY_NOINLINE void collect_parts(Shader& shader, int x, int y, std::size_t at) {
  const Frame& frame = shader.frame;
  TileScratch& s = shader.s;
  const std::int32_t px = x * kSubpixelUnits + kSubpixelUnits / 2;
  const std::int32_t py = y * kSubpixelUnits + kSubpixelUnits / 2;
  const std::size_t samples = frame.pattern.size();
  const std::size_t first = s.parts.count;
  std::array<std::uint32_t, 16> shown;
  for (std::size_t i = 0; i < samples; ++i) {
    shown[i] = s.winner[i * s.plane + at];
  }
  for (std::size_t i = 0; i < samples; ++i) {
    const std::uint32_t record = shown[i];
    if (record == Record::kNone) {
      continue;
    }
    std::size_t count = 1;
    for (std::size_t j = i + 1; j < samples; ++j) {
      if (shown[j] == record) {
        ++count;
        shown[j] = Record::kNone;
      }
    }
    // The centre lies between the samples: where all of them are covered it is, too.
    const bool at_center = count == samples || covers_center(s.records[record], px, py);
    s.parts.record[s.parts.count] = record;
    s.parts.x[s.parts.count] = at_center ? px : px + frame.pattern[i].x;
    s.parts.y[s.parts.count] = at_center ? py : py + frame.pattern[i].y;
    s.part_samples[s.parts.count] = static_cast<std::uint8_t>(count);
    ++s.parts.count;
  }
  shader.waiting[shader.pixels++] = {static_cast<std::uint16_t>(x - shader.s.area.left), static_cast<std::uint16_t>(y - shader.s.area.top),
                                     static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(s.parts.count - first)};
}

/// Sorts fragments by material, so that lanes share one. `place`, if not null, receives where each went.
inline HWY_NOINLINE void sort_by_material(const Frame& frame, TileScratch& s, TileScratch::Fragments& fragments, std::uint32_t* place) {
  std::uint32_t* begin = s.material_begin.data();
  const std::size_t materials = frame.scene->materials.size();
  for (std::size_t m = 0; m <= materials; ++m) {
    begin[m] = 0;
  }
  alignas(64) std::array<std::uint32_t, TileScratch::kFragments> record;
  alignas(64) std::array<std::int32_t, TileScratch::kFragments> x, y;
  for (std::size_t i = 0; i < fragments.count; ++i) {
    record[i] = fragments.record[i];
    x[i] = fragments.x[i];
    y[i] = fragments.y[i];
    ++begin[s.records[record[i]].material + 1];
  }
  for (std::size_t m = 0; m < materials; ++m) {
    begin[m + 1] += begin[m];
  }
  for (std::size_t i = 0; i < fragments.count; ++i) {
    const std::uint32_t to = begin[s.records[record[i]].material]++;
    fragments.record[to] = record[i];
    fragments.x[to] = x[i];
    fragments.y[to] = y[i];
    if (place != nullptr) {
      place[i] = to;
    }
  }
}

/// Shades the fragments in runs of one material.
template <class Shade>
HWY_INLINE void shade_runs(const Frame& frame, TileScratch& s, TileScratch::Fragments& fragments, std::uint32_t* place, Shade&& shade) {
  const auto material_at = [&](std::size_t i) { return s.records[fragments.record[i]].material; };
  bool is_uniform = true;
  if (frame.scene->materials.size() > 1) {
    for (std::size_t i = 1; i < fragments.count && is_uniform; ++i) {
      is_uniform = material_at(i) == material_at(0);
    }
  }
  if (!is_uniform) {
    sort_by_material(frame, s, fragments, place);
  } else if (place != nullptr) {
    for (std::size_t i = 0; i < fragments.count; ++i) {
      place[i] = static_cast<std::uint32_t>(i);
    }
  }
  for (std::size_t i = 0; i < fragments.count;) {
    const std::uint32_t material = material_at(i);
    std::size_t end = is_uniform ? fragments.count : i + 1;
    while (end < fragments.count && material_at(end) == material) {
      ++end;
    }
    const Instance& instance = frame.scene->instances[frame.material_instance[material]];
    shade(Run{frame, s, fragments, instance, frame.scene->materials[material], i, end - i});
    i = end;
  }
}

HWY_INLINE Vec3f output_at(const TileScratch& s, std::size_t which, std::size_t place) {
  return {s.output[which][place], s.output[which + 1][place], s.output[which + 2][place]};
}

inline void store_color(const Frame& frame, int x, int y, const Vec3f& rgb, float alpha) {
  const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.scene->view.width) + static_cast<std::size_t>(x));
  const std::array<float, 4> color{rgb.x, rgb.y, rgb.z, alpha};
  if (frame.color != nullptr) {
    std::memcpy(frame.color + at, color.data(), sizeof color);
  }
  if (frame.bytes != nullptr) {
    std::array<std::uint8_t, 4> bytes;
    frame.store_pixel8(color, frame.scene->transfer, bytes);
    std::memcpy(frame.bytes + at, bytes.data(), sizeof bytes);
  }
}

/// reference/pixel.cpp: resolve_pixel()
inline void resolve(const Shader& shader, const WaitingPixel& waiting) {
  const Frame& frame = shader.frame;
  TileScratch& s = shader.s;
  const auto samples = static_cast<float>(frame.pattern.size());
  const std::array<float, 4>& background = frame.scene->background;
  Pixel pixel;
  const std::size_t lights = frame.wants_lights ? frame.scene->lights.size() : 0;
  for (std::size_t l = 0; l < lights; ++l) {
    s.light_parts[l] = {};
  }
  int covered = 0;
  int most = 0;
  Sixteen sums;
  for (std::size_t i = waiting.first; i < static_cast<std::size_t>(waiting.first) + waiting.parts; ++i) {
    const std::size_t place = s.part_place[i];
    const int count = s.part_samples[i];
    const float weight = static_cast<float>(count) / samples;
    sums.add(&s.part_terms[place * TileScratch::terms], weight);
    covered += count;
    if (frame.wants_all) {
      pixel.scene_part += output_at(s, TileScratch::scene_part, place) * weight;
      pixel.albedo += output_at(s, TileScratch::albedo, place) * weight;
      const OutputSlot slot{s, place};
      constexpr std::size_t kRow = TileScratch::kFragments + TileScratch::kPadding;
      for (std::size_t l = 0; l < lights; ++l) {
        const float* light = slot.light(l);
        s.light_parts[l] += Vec3f{light[0], light[kRow], light[2 * kRow]} * weight;
      }
      if (count > most) {
        most = count;
        const Record& record = s.records[s.parts.record[place]];
        const Instance& instance = frame.scene->instances[frame.material_instance[record.material]];
        Fragment& f = pixel.dominant;
        f.position = output_at(s, TileScratch::position, place);
        f.normal = output_at(s, TileScratch::normal, place);
        f.weights = output_at(s, TileScratch::weights, place);
        f.depth = s.output[TileScratch::depth][place];
        f.instance = frame.material_instance[record.material];
        f.triangle = record.id - instance.first_triangle;
        f.material = record.material;
      }
    }
  }
  alignas(64) std::array<float, TileScratch::terms> sum;
  sums.store_to(sum.data());
  const auto sum_of = [&sum](std::size_t term) { return Vec3f{sum[term], sum[term + 1], sum[term + 2]}; };
  pixel.terms = {sum_of(TileScratch::ambient), sum_of(TileScratch::diffuse), sum_of(TileScratch::specular), sum_of(TileScratch::emission)};
  pixel.fog = sum_of(TileScratch::fog);
  pixel.coverage = static_cast<float>(covered) / samples;
  const float uncovered = (samples - static_cast<float>(covered)) / samples;
  pixel.background = Vec3f{background[0], background[1], background[2]} * uncovered;
  pixel.alpha = pixel.coverage + background[3] * uncovered;
  const int x = shader.s.area.left + waiting.x;
  const int y = shader.s.area.top + waiting.y;
  store_color(frame, x, y, (pixel.terms.sum() + pixel.fog) + pixel.background, pixel.alpha);
  if (frame.wants_all) {
    frame.store_layers(frame, pixel, s.light_parts, x, y);
  }
  s.pixels_covered += waiting.parts > 0 ? 1 : 0;
}

inline HWY_NOINLINE void flush_parts(Shader& shader) {
  TileScratch& s = shader.s;
  shade_runs(shader.frame, s, s.parts, s.part_place.data(), shade_parts);
  for (std::size_t i = 0; i < shader.pixels; ++i) {
    resolve(shader, shader.waiting[i]);
  }
  s.parts.count = 0;
  shader.pixels = 0;
}

inline HWY_NOINLINE void flush_whole(const Frame& frame, TileScratch& s) {
  shade_runs(frame, s, s.whole, nullptr, shade_whole);
  s.pixels_covered += s.whole.count;
  s.whole.count = 0;
}

/// Pixels x .. x + count of row y show the background.
HWY_INLINE void store_background(const Frame& frame, int x, int y, std::size_t count) {
  const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.scene->view.width) + static_cast<std::size_t>(x);
  if (frame.bytes != nullptr) {
    for (std::size_t i = 0; i < count; ++i) {
      std::memcpy(frame.bytes + 4 * (first + i), frame.background.bytes.data(), 4);
    }
  }
  if (frame.color != nullptr) {
    for (std::size_t i = 0; i < count; ++i) {
      std::memcpy(frame.color + 4 * (first + i), frame.background.color.data(), sizeof frame.background.color);
    }
  }
}

/// kLanes pixels of a row from x on, of which `count` lie in the tile.
HWY_INLINE void collect(Shader& shader, int x, int y, std::size_t at, std::size_t count) {
  const Frame& frame = shader.frame;
  TileScratch& s = shader.s;
  const Mask in_tile = first_lanes(count);
  const Int first = load(&s.winner[at]);
  Mask is_empty = first < Int(0);
  Mask is_whole = !is_empty;
  for (std::size_t sample = 1; sample < frame.pattern.size(); ++sample) {
    const Int shown = load(&s.winner[sample * s.plane + at]);
    is_empty = is_empty & (shown < Int(0));
    is_whole = is_whole & (shown == first);
  }
  is_empty = is_empty & in_tile;
  is_whole = is_whole & in_tile;
  if (any_of(is_empty)) {
    store_background(frame, x, y, count);
  }
  if (any_of(is_whole)) {
    TileScratch::Fragments& whole = s.whole;
    const Int px = lane_numbers() * Int(kSubpixelUnits) + Int(x * kSubpixelUnits + kSubpixelUnits / 2);
    store_chosen(is_whole, &whole.record[whole.count], first);
    store_chosen(is_whole, &whole.x[whole.count], px);
    store(&whole.y[whole.count], Int(y * kSubpixelUnits + kSubpixelUnits / 2));
    whole.count += count_true(is_whole);
    if (whole.count + kLanes > TileScratch::kFragments) {
      flush_whole(frame, s);
    }
  }
  for (std::uint32_t left = mask_bits(in_tile & !is_empty & !is_whole); left != 0; left &= left - 1) {
    const int lane = __builtin_ctz(left);
    collect_parts(shader, x + lane, y, at + static_cast<std::size_t>(lane));
    if (s.parts.count + frame.pattern.size() > TileScratch::kFragments) {
      flush_parts(shader);
    }
  }
}

inline void shade_tile(const Frame& frame, std::size_t tile, TileScratch& s) {
  s.area = frame.area(tile);
  Shader shader{frame, s, 0, {}};
  const TileArea& area = s.area;
  const bool is_empty = frame.cluster_lists.of(tile).empty() && frame.loose_lists.of(tile).empty();
  for (int y = area.top; y < area.bottom; ++y) {
    const std::size_t row = static_cast<std::size_t>(y - area.top) * s.stride;
    if (frame.wants_all) {
      for (int x = area.left; x < area.right; ++x) {
        collect_parts(shader, x, y, row + static_cast<std::size_t>(x - area.left));
        if (s.parts.count + frame.pattern.size() > TileScratch::kFragments || shader.pixels == TileScratch::kFragments) {
          flush_parts(shader);
        }
      }
    } else if (is_empty) {
      store_background(frame, area.left, y, static_cast<std::size_t>(area.right - area.left));
    } else {
      for (int x = area.left; x < area.right; x += static_cast<int>(kLanes)) {
        const auto rest = static_cast<std::size_t>(area.right - x);
        collect(shader, x, y, row + static_cast<std::size_t>(x - area.left), rest < kLanes ? rest : kLanes);
      }
    }
  }
  flush_whole(frame, s);
  flush_parts(shader);
}

}  // namespace lustro::HWY_NAMESPACE
// NOLINTEND(cppcoreguidelines-pro-type-member-init)
