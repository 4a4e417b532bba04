// From what a tile's samples show to its pixels: which fragments there are, how they are sorted for shading, how they sum. Part of a row
// (row.cpp). The sums are the reference's (reference/pixel.cpp), in its order.
#pragma once

#include "raster/frame.hpp"
#include "raster/row_shade.hpp"
#include "reference/aov.hpp"
#include "simd/lanes.hpp"

namespace lustro::HWY_NAMESPACE {

/// A pixel with fragments waiting to be shaded.
struct WaitingPixel {
  std::uint16_t x, y;  // within the tile
  std::uint16_t first, fragments;
};

struct Shader {
  const Frame& frame;
  TileScratch& s;
  TileArea area;
  std::size_t fragments = 0;
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

HWY_INLINE void add_fragment(Shader& shader, std::uint32_t record, std::int32_t px, std::int32_t py, std::size_t samples) {
  TileScratch& s = shader.s;
  s.fragment_record[shader.fragments] = record;
  s.fragment_x[shader.fragments] = px;
  s.fragment_y[shader.fragments] = py;
  s.fragment_samples[shader.fragments] = static_cast<std::uint8_t>(samples);
  ++shader.fragments;
}

/// The pixel's fragments, by their first sample.
inline void collect(Shader& shader, int x, int y, std::size_t at) {
  const Frame& frame = shader.frame;
  TileScratch& s = shader.s;
  const std::int32_t px = x * kSubpixelUnits + kSubpixelUnits / 2;
  const std::int32_t py = y * kSubpixelUnits + kSubpixelUnits / 2;
  const std::size_t samples = frame.pattern.size();
  const std::size_t first = shader.fragments;
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
    add_fragment(shader, record, at_center ? px : px + frame.pattern[i].x, at_center ? py : py + frame.pattern[i].y, count);
  }
  shader.waiting[shader.pixels++] = {static_cast<std::uint16_t>(x - shader.area.left), static_cast<std::uint16_t>(y - shader.area.top),
                                     static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(shader.fragments - first)};
}

inline void shade_run(Shader& shader, std::uint32_t material, std::size_t begin, std::size_t end) {
  const Frame& frame = shader.frame;
  const Instance& instance = frame.scene->instances[frame.material_instance[material]];
  for (std::size_t i = begin; i < end; i += kLanes) {
    shade_batch(frame, shader.s, instance, frame.scene->materials[material], i, end - i < kLanes ? end - i : kLanes);
  }
}

/// Sorts the fragments by material, so that lanes share one; fragment_order says where each went.
inline void sort_by_material(Shader& shader) {
  TileScratch& s = shader.s;
  std::uint32_t* begin = s.class_begin.data();
  const std::size_t materials = shader.frame.scene->materials.size();
  for (std::size_t m = 0; m <= materials; ++m) {
    begin[m] = 0;
  }
  for (std::size_t i = 0; i < shader.fragments; ++i) {
    ++begin[s.records[s.fragment_record[i]].material + 1];
  }
  for (std::size_t m = 0; m < materials; ++m) {
    begin[m + 1] += begin[m];
  }
  alignas(64) std::array<std::uint32_t, TileScratch::kFragments> record;
  alignas(64) std::array<std::int32_t, TileScratch::kFragments> x, y;
  for (std::size_t i = 0; i < shader.fragments; ++i) {
    record[i] = s.fragment_record[i];
    x[i] = s.fragment_x[i];
    y[i] = s.fragment_y[i];
  }
  for (std::size_t i = 0; i < shader.fragments; ++i) {
    const std::uint32_t place = begin[s.records[record[i]].material]++;
    s.fragment_order[i] = place;
    s.fragment_record[place] = record[i];
    s.fragment_x[place] = x[i];
    s.fragment_y[place] = y[i];
  }
}

inline void shade_all(Shader& shader) {
  TileScratch& s = shader.s;
  const std::size_t count = shader.fragments;
  if (count == 0) {
    return;
  }
  bool is_uniform = shader.frame.scene->materials.size() == 1;
  if (!is_uniform) {
    const std::uint32_t material = s.records[s.fragment_record[0]].material;
    is_uniform = true;
    for (std::size_t i = 1; i < count && is_uniform; ++i) {
      is_uniform = s.records[s.fragment_record[i]].material == material;
    }
  }
  if (is_uniform) {
    for (std::size_t i = 0; i < count; ++i) {
      s.fragment_order[i] = static_cast<std::uint32_t>(i);
    }
    shade_run(shader, s.records[s.fragment_record[0]].material, 0, count);
    return;
  }
  sort_by_material(shader);
  for (std::size_t i = 0; i < count;) {
    const std::uint32_t material = s.records[s.fragment_record[i]].material;
    std::size_t end = i + 1;
    while (end < count && s.records[s.fragment_record[end]].material == material) {
      ++end;
    }
    shade_run(shader, material, i, end);
    i = end;
  }
}

HWY_INLINE Vec3f output_at(const TileScratch& s, std::size_t which, std::size_t place) {
  return {s.output[which][place], s.output[which + 1][place], s.output[which + 2][place]};
}

HWY_INLINE void store_color(const Frame& frame, int x, int y, const Vec3f& rgb, float alpha) {
  const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.scene->view.width) + static_cast<std::size_t>(x));
  if (frame.color != nullptr) {
    float* to = frame.color + at;
    to[0] = rgb.x;
    to[1] = rgb.y;
    to[2] = rgb.z;
    to[3] = alpha;
  }
  if (frame.bytes != nullptr) {  // image/store.cpp
    const float divisor = alpha < 1.0F ? alpha : 1.0F;
    const auto stored = [&](float c) {
      const float color = alpha > 0.0F ? c / divisor : 0.0F;
      return frame.srgb != nullptr ? srgb_byte(*frame.srgb, color) : quantize8(color);
    };
    std::uint8_t* to = frame.bytes + at;
    to[0] = stored(rgb.x);
    to[1] = stored(rgb.y);
    to[2] = stored(rgb.z);
    to[3] = quantize8(alpha);
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
  for (std::size_t i = waiting.first; i < static_cast<std::size_t>(waiting.first) + waiting.fragments; ++i) {
    const std::size_t place = s.fragment_order[i];
    const int count = s.fragment_samples[i];
    const float weight = static_cast<float>(count) / samples;
    pixel.terms.ambient += output_at(s, TileScratch::ambient, place) * weight;
    pixel.terms.diffuse += output_at(s, TileScratch::diffuse, place) * weight;
    pixel.terms.specular += output_at(s, TileScratch::specular, place) * weight;
    pixel.terms.emission += output_at(s, TileScratch::emission, place) * weight;
    pixel.fog += output_at(s, TileScratch::fog, place) * weight;
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
        const Record& record = s.records[s.fragment_record[place]];
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
  pixel.coverage = static_cast<float>(covered) / samples;
  const float uncovered = (samples - static_cast<float>(covered)) / samples;
  pixel.background = Vec3f{background[0], background[1], background[2]} * uncovered;
  pixel.alpha = pixel.coverage + background[3] * uncovered;
  const int x = shader.area.left + waiting.x;
  const int y = shader.area.top + waiting.y;
  store_color(frame, x, y, (pixel.terms.sum() + pixel.fog) + pixel.background, pixel.alpha);
  if (frame.wants_all) {
    frame.store_layers(frame, pixel, s.light_parts, x, y);
  }
  s.pixels_covered += waiting.fragments > 0 ? 1 : 0;
}

inline void flush(Shader& shader) {
  shade_all(shader);
  for (std::size_t i = 0; i < shader.pixels; ++i) {
    resolve(shader, shader.waiting[i]);
  }
  shader.fragments = 0;
  shader.pixels = 0;
}

inline void shade_tile(const Frame& frame, std::size_t tile, TileScratch& s) {
  Shader shader{frame, s, frame.area(tile), 0, 0, {}};
  for (int y = shader.area.top; y < shader.area.bottom; ++y) {
    for (int x = shader.area.left; x < shader.area.right; ++x) {
      const std::size_t at = static_cast<std::size_t>(y - shader.area.top) * s.stride + static_cast<std::size_t>(x - shader.area.left);
      collect(shader, x, y, at);
      if (shader.fragments + frame.pattern.size() > TileScratch::kFragments || shader.pixels == TileScratch::kFragments) {
        flush(shader);
      }
    }
  }
  flush(shader);
}

}  // namespace lustro::HWY_NAMESPACE
