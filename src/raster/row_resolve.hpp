// From what a tile's samples show to its pixels: which fragments there are, how they are sorted for shading, how they sum. Part of a row
// (row.cpp). The sums are the reference's (reference/pixel.cpp), in its order.
#pragma once

#include "raster/frame.hpp"
#include "raster/row_fill.hpp"
#include "raster/row_runs.hpp"
#include "raster/row_shade.hpp"
#include "raster/row_sheets.hpp"
#include "scene/sky.hpp"
#include "simd/lanes.hpp"

// What a kernel fills is not cleared first.
// NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
namespace lustro::HWY_NAMESPACE {

/// A pixel whose parts wait to be shaded; or a piece of one that has more parts than are shaded at a time.
struct WaitingPixel {
  std::uint16_t x, y;  // within the tile
  std::uint16_t first, parts;
  bool is_begin, is_end;  // of the pixel's pieces
  float uncovered;        // samples, each by what of the background it shows
};

/// The sums of a pixel's parts.
struct PixelSums {
  Pixel pixel;
  Sixteen terms;
  float covered = 0;
  float most = 0;
};

struct Shader {
  const Frame& frame;
  TileScratch& s;
  std::size_t pixels = 0;
  std::array<WaitingPixel, TileScratch::kFragments> waiting;
  PixelSums pieces;  // of the pixel of which not all pieces are there

  HWY_INLINE Shader(const Frame& frame_, TileScratch& s_) : frame(frame_), s(s_) {}
};

HWY_INLINE void add_part(TileScratch& s, std::uint32_t record, std::int32_t x, std::int32_t y, float amount) {
  const std::size_t part = s.parts.count++;
  s.parts.record[part] = record;
  s.parts.x[part] = x;
  s.parts.y[part] = y;
  s.part_amount[part] = amount;
}

HWY_INLINE void add_waiting(Shader& shader, int x, int y, std::size_t first, bool is_begin, bool is_end, float uncovered) {
  shader.waiting[shader.pixels++] = {static_cast<std::uint16_t>(x - shader.s.area.left),
                                     static_cast<std::uint16_t>(y - shader.s.area.top),
                                     static_cast<std::uint16_t>(first),
                                     static_cast<std::uint16_t>(shader.s.parts.count - first),
                                     is_begin,
                                     is_end,
                                     uncovered};
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
  std::size_t covered = 0;
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
    const bool at_center = count == samples || covers_point(s.records[record], px, py);
    add_part(s, record, at_center ? px : px + frame.pattern[i].x, at_center ? py : py + frame.pattern[i].y, static_cast<float>(count));
    covered += count;
  }
  add_waiting(shader, x, y, first, true, true, static_cast<float>(samples - covered));
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
    frame.store_pixel8(color, frame.scene->transfer, frame.toning, bytes);
    std::memcpy(frame.bytes + at, bytes.data(), sizeof bytes);
  }
}

/// Adds the parts that wait for a pixel to its sums.
inline void sum_parts(const Shader& shader, const WaitingPixel& waiting, PixelSums& sums) {
  const Frame& frame = shader.frame;
  TileScratch& s = shader.s;
  const auto samples = static_cast<float>(frame.pattern.size());
  const std::size_t lights = frame.wants_lights ? frame.scene->lights.size() : 0;
  Pixel& pixel = sums.pixel;
  for (std::size_t i = waiting.first; i < static_cast<std::size_t>(waiting.first) + waiting.parts; ++i) {
    const std::size_t place = s.part_place[i];
    const float amount = s.part_amount[i];
    const float weight = amount / samples;
    sums.terms.add(&s.part_terms[place * TileScratch::terms], weight);
    sums.covered += amount;
    if (frame.wants_all) {
      pixel.scene_part += output_at(s, TileScratch::scene_part, place) * weight;
      pixel.albedo += output_at(s, TileScratch::albedo, place) * weight;
      const OutputSlot slot{s, place};
      constexpr std::size_t kRow = TileScratch::kFragments + TileScratch::kPadding;
      for (std::size_t l = 0; l < lights; ++l) {
        const float* light = slot.light(l);
        s.light_parts[l] += Vec3f{light[0], light[kRow], light[2 * kRow]} * weight;
      }
      if (amount > sums.most) {
        sums.most = amount;
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
}

/// reference/pixel.cpp: resolve_pixel()
inline void store_sums(const Shader& shader, const WaitingPixel& waiting, PixelSums& sums) {
  const Frame& frame = shader.frame;
  TileScratch& s = shader.s;
  const auto samples = static_cast<float>(frame.pattern.size());
  Pixel& pixel = sums.pixel;
  alignas(64) std::array<float, TileScratch::terms> sum;
  sums.terms.store_to(sum.data());
  const auto sum_of = [&sum](std::size_t term) { return Vec3f{sum[term], sum[term + 1], sum[term + 2]}; };
  pixel.terms = {sum_of(TileScratch::ambient), sum_of(TileScratch::diffuse), sum_of(TileScratch::specular), sum_of(TileScratch::emission)};
  pixel.fog = sum_of(TileScratch::fog);
  pixel.coverage = sums.covered / samples;
  pixel.uncovered = waiting.uncovered / samples;
  const int x = s.area.left + waiting.x;
  const int y = s.area.top + waiting.y;
  pixel.background = background_at(*frame.scene, x, y) * pixel.uncovered;
  pixel.alpha = pixel.coverage + frame.scene->background[3] * pixel.uncovered;
  store_color(frame, x, y, (pixel.terms.sum() + pixel.fog) + pixel.background, pixel.alpha);
  if (frame.wants_all) {
    frame.store_layers(frame, pixel, s.light_parts, x, y);
  }
  s.pixels_covered += sums.covered > 0 ? 1 : 0;
}

inline void resolve(Shader& shader, const WaitingPixel& waiting) {
  TileScratch& s = shader.s;
  if (waiting.is_begin) {
    const std::size_t lights = shader.frame.wants_lights ? shader.frame.scene->lights.size() : 0;
    for (std::size_t l = 0; l < lights; ++l) {
      s.light_parts[l] = {};
    }
  }
  if (HWY_LIKELY(waiting.is_begin && waiting.is_end)) {
    PixelSums sums;
    sum_parts(shader, waiting, sums);
    store_sums(shader, waiting, sums);
    return;
  }
  if (waiting.is_begin) {
    shader.pieces = {};
  }
  sum_parts(shader, waiting, shader.pieces);
  if (waiting.is_end) {
    store_sums(shader, waiting, shader.pieces);
  }
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

/// The opacities of sheets that are not the same everywhere.
inline HWY_NOINLINE void find_opacities(const Frame& frame, TileScratch& s) {
  std::array<std::uint32_t, TileScratch::kFragments> waiting;
  TileScratch::Fragments& fragments = s.whole;  // empty between bands
  const auto flush = [&] {
    shade_runs(frame, s, fragments, s.part_place.data(), [](const Run& all) {
      all.in_strips([](const Run& run) {
        const RunFaces faces(run, wants_of_opacity(run.frame, run.material));
        for (std::size_t i = 0; i < run.count; i += kLanes) {
          const Batch batch = run.batch(faces, i, false);
          store(&run.s.output[0][run.begin + i], opacity_of(batch.faces, batch.at, batch.slopes));
        }
      });
    });
    for (std::size_t i = 0; i < fragments.count; ++i) {
      s.sheets[waiting[i]].opacity = s.output[0][s.part_place[i]];
    }
    fragments.count = 0;
  };
  for (std::size_t i = 0; i < s.sheet_count; ++i) {
    const TileScratch::Sheet& sheet = s.sheets[i];
    if (sheet.opacity >= 0) {
      continue;
    }
    waiting[fragments.count] = static_cast<std::uint32_t>(i);
    fragments.record[fragments.count] = sheet.record;
    fragments.x[fragments.count] = sheet.x;
    fragments.y[fragments.count] = sheet.y;
    if (++fragments.count == TileScratch::kFragments) {
      flush();
    }
  }
  flush();
}

/// A pixel with blended triangles: its parts, as reference/pixel.cpp puts them in order.
inline HWY_NOINLINE void collect_sheets(Shader& shader, int x, int y, std::size_t at) {
  TileScratch& s = shader.s;
  const ArrangedPixel arranged = arrange_pixel(shader.frame, s, x, y, at);
  if (s.parts.count + arranged.parts > TileScratch::kFragments) {
    flush_parts(shader);
  }
  std::size_t first = s.parts.count;
  bool is_begin = true;
  for (std::size_t i = 0; i < arranged.parts; ++i) {
    const TileScratch::PixelPart& part = s.pixel_parts[i];
    if (!(part.amount > 0)) {
      continue;
    }
    if (s.parts.count == TileScratch::kFragments) {
      add_waiting(shader, x, y, first, is_begin, false, 0);
      flush_parts(shader);
      first = 0;
      is_begin = false;
    }
    add_part(s, part.record, part.x, part.y, part.amount);
  }
  add_waiting(shader, x, y, first, is_begin, true, arranged.uncovered);
}

/// Lists what of rows top .. bottom can be seen through; false where that is more than is kept at a time.
inline HWY_NOINLINE bool find_sheets(const Frame& frame, std::size_t tile, TileScratch& s, int top, int bottom) {
  for (int y = top; y < bottom; ++y) {
    for (std::size_t x = 0; x < s.stride; x += kLanes) {
      store(&s.first_sheet[static_cast<std::size_t>(y - s.area.top) * s.stride + x], Int(-1));
    }
  }
  s.sheet_count = 0;
  s.has_too_many_sheets = false;
  fill_mode(Canvas{frame, s, s.area, AlphaMode::blend, top, bottom}, tile);
  if (s.has_too_many_sheets) {
    return false;
  }
  find_opacities(frame, s);
  return true;
}

/// The same where an environment is seen.
inline HWY_NOINLINE void store_sky(const Frame& frame, int x, int y, std::size_t count) {
  const PreparedScene& scene = *frame.scene;
  const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.view.width) + static_cast<std::size_t>(x);
  alignas(64) std::array<std::uint32_t, kLanes> words;
  alignas(64) std::array<std::array<float, kLanes>, 3> rgb;
  for (std::size_t i = 0; i < count; i += kLanes) {
    const Float at_x = to_float(lane_numbers() + Int(x + static_cast<int>(i))) + Float(0.5F);
    const Vec3<Float> color = sky_at<LaneFetch>(scene.view, *scene.sky, at_x, Float(static_cast<float>(y) + 0.5F));
    const std::size_t rest = count - i < kLanes ? count - i : kLanes;
    if (frame.bytes != nullptr) {
      store_words(frame, color, words.data());
      std::memcpy(frame.bytes + 4 * (first + i), words.data(), 4 * rest);
    }
    if (frame.color != nullptr) {
      store(rgb[0].data(), color.x);
      store(rgb[1].data(), color.y);
      store(rgb[2].data(), color.z);
      for (std::size_t lane = 0; lane < rest; ++lane) {
        const std::array<float, 4> pixel{rgb[0][lane], rgb[1][lane], rgb[2][lane], 1};
        std::memcpy(frame.color + 4 * (first + i + lane), pixel.data(), sizeof pixel);
      }
    }
  }
}

/// A pixel's bytes, `count` times.
HWY_INLINE void store_repeated(std::uint8_t* bytes, std::int32_t pixel, std::size_t count) {
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes) {
    alignas(64) std::array<std::int32_t, kLanes> pixels;
    store(pixels.data(), Int(pixel));
    std::memcpy(bytes + 4 * i, pixels.data(), sizeof pixels);
  }
  for (; i < count; ++i) {
    std::memcpy(bytes + 4 * i, &pixel, sizeof pixel);
  }
}

/// Pixels x .. x + count of row y show the background.
HWY_INLINE void store_background(const Frame& frame, int x, int y, std::size_t count) {
  if (HWY_UNLIKELY(frame.scene->sky.has_value())) {
    store_sky(frame, x, y, count);
    return;
  }
  const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.scene->view.width) + static_cast<std::size_t>(x);
  if (frame.bytes != nullptr) {
    store_repeated(frame.bytes + 4 * first, std::bit_cast<std::int32_t>(frame.background.bytes), count);
  }
  if (frame.color != nullptr) {
    for (std::size_t i = 0; i < count; ++i) {
      std::memcpy(frame.color + 4 * (first + i), frame.background.color.data(), sizeof frame.background.color);
    }
  }
}

/// One pixel, whatever it shows.
HWY_INLINE void collect_pixel(Shader& shader, int x, int y, std::size_t at, bool has_sheets) {
  if (HWY_UNLIKELY(has_sheets)) {
    collect_sheets(shader, x, y, at);
  } else {
    collect_parts(shader, x, y, at);
  }
  if (shader.s.parts.count + shader.frame.pattern.size() > TileScratch::kFragments || shader.pixels == TileScratch::kFragments) {
    flush_parts(shader);
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
  std::uint32_t layered = 0;
  if (HWY_UNLIKELY(s.sheet_count > 0)) {
    const Mask has_sheets = in_tile & !(load(&s.first_sheet[at]) < Int(0));
    is_empty = is_empty & !has_sheets;
    is_whole = is_whole & !has_sheets;
    layered = mask_bits(has_sheets);
  }
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
    collect_pixel(shader, x + lane, y, at + static_cast<std::size_t>(lane), (layered >> lane & 1U) != 0);
  }
}

/// Rows top .. bottom of the tile.
inline HWY_NOINLINE void shade_rows(Shader& shader, int top, int bottom) {
  const Frame& frame = shader.frame;
  TileScratch& s = shader.s;
  const TileArea& area = s.area;
  for (int y = top; y < bottom; ++y) {
    const std::size_t row = static_cast<std::size_t>(y - area.top) * s.stride;
    if (frame.bytes != nullptr && y + 4 < area.bottom) {
      const std::uint8_t* ahead = frame.bytes + 4 * (static_cast<std::size_t>(y + 4) * static_cast<std::size_t>(frame.scene->view.width) +
                                                     static_cast<std::size_t>(area.left));
      for (std::size_t i = 0; i < 4 * static_cast<std::size_t>(area.right - area.left); i += 64) {
        __builtin_prefetch(ahead + i, 1, 2);
      }
    }
    if (frame.wants_all) {
      for (int x = area.left; x < area.right; ++x) {
        const std::size_t at = row + static_cast<std::size_t>(x - area.left);
        collect_pixel(shader, x, y, at, s.sheet_count > 0 && s.first_sheet[at] != Record::kNone);
      }
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

HWY_INLINE bool is_empty_tile(const Frame& frame, std::size_t tile) {
  return frame.cluster_lists.of(tile).empty() && frame.loose_lists.of(tile).empty();
}

/// Tiles beside each other that show nothing, by the first of them: the longer a row, the sooner the processor has its lines of memory at hand.
inline HWY_NOINLINE void store_empty_tiles(const Frame& frame, std::size_t tile) {
  const auto tiles_x = static_cast<std::size_t>(frame.tiles_x);
  if (tile % tiles_x != 0 && is_empty_tile(frame, tile - 1)) {
    return;
  }
  std::size_t last = tile;
  while ((last + 1) % tiles_x != 0 && is_empty_tile(frame, last + 1)) {
    ++last;
  }
  const TileArea area = frame.area(tile);
  const auto width = static_cast<std::size_t>(frame.area(last).right - area.left);
  for (int y = area.top; y < area.bottom; ++y) {
    store_background(frame, area.left, y, width);
  }
}

inline void shade_tile(const Frame& frame, std::size_t tile, TileScratch& s) {
  if (!frame.wants_all && is_empty_tile(frame, tile)) {
    store_empty_tiles(frame, tile);
    return;
  }
  s.area = frame.area(tile);
  s.sheet_count = 0;
  Shader shader(frame, s);
  const TileArea& area = s.area;
  if (HWY_LIKELY((frame.alpha_modes & bit_of(AlphaMode::blend)) == 0)) {
    shade_rows(shader, area.top, area.bottom);
    return;
  }
  const std::size_t records = s.record_count;
  int height = area.bottom - area.top;
  for (int top = area.top; top < area.bottom;) {
    const int bottom = top + height < area.bottom ? top + height : area.bottom;
    s.record_count = records;
    if (!find_sheets(frame, tile, s, top, bottom)) {
      height = (bottom - top) / 2;  // a single row keeps all it needs
      continue;
    }
    shade_rows(shader, top, bottom);
    top = bottom;
  }
}

}  // namespace lustro::HWY_NAMESPACE
// NOLINTEND(cppcoreguidelines-pro-type-member-init)
