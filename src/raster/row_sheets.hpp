// Triangles that can be seen through, one after the other: masks are merged with what samples show where they cover it; blended ones are listed,
// pixel by pixel, where they lie in front of what samples show. Part of a row (row.cpp).
//
// Every number is the reference's (reference/visibility.cpp, reference/opacity.cpp).
#pragma once

#include <bit>

#include "raster/row_canvas.hpp"
#include "raster/row_strip.hpp"
#include "simd/lanes.hpp"

// What a kernel fills is not cleared first.
// NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
namespace lustro::HWY_NAMESPACE {

/// The samples of kLanes pixels of a row against a triangle: visit(at, sample, inside, key, px, py) for each sample that it covers anywhere.
template <bool kSmall, class Visit>
HWY_INLINE void each_sample(const Canvas& c, const Record& t, int x, int y, Mask in_range, Visit&& visit) {
  constexpr std::array<std::size_t, 3> kFrom{1, 2, 0};
  constexpr std::array<std::size_t, 3> kTo{2, 0, 1};
  const Float slope1((t.key[1] - t.key[0]) * t.inverse_area);
  const Float slope2((t.key[2] - t.key[0]) * t.inverse_area);
  const Int center_x = lane_numbers() * Int(kSubpixelUnits) + Int(x * kSubpixelUnits + kSubpixelUnits / 2);
  const Int center_y(y * kSubpixelUnits + kSubpixelUnits / 2);
  for (std::size_t sample = 0; sample < c.frame.pattern.size(); ++sample) {
    const Int px = center_x + Int(c.frame.pattern[sample].x);
    const Int py = center_y + Int(c.frame.pattern[sample].y);
    std::array<Float, 3> e;
    Mask inside = in_range;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t from = kFrom[i], to = kTo[i];
      e[i] = edge_along<kSmall>(Int(t.x[to] - t.x[from]), Int(t.y[to] - t.y[from]), px - Int(t.x[from]), py - Int(t.y[from]));
      const bool has_edge = edge_bias(t.x[kFrom[i]], t.y[kFrom[i]], t.x[kTo[i]], t.y[kTo[i]]) == 0;
      inside = inside & (has_edge ? e[i] >= Float(0) : e[i] > Float(0));  // rounding keeps the sign of a whole number
    }
    const Float key = (Float(t.key[0]) + slope1 * e[1]) + slope2 * e[2];
    inside = inside & (key >= Float(c.frame.farthest));
    if (any_of(inside)) {
      visit(sample * c.scratch.plane + c.at(x, y), sample, inside, key, px, py);
    }
  }
}

/// One triangle's opacity, wherever it is asked for. What the mesh says is fetched for the first point: most masks hide many that have none.
class OpacityOfTriangle {
 public:
  HWY_INLINE OpacityOfTriangle(const Frame& frame, const Record& t)
      : faces_(frame, &t, frame.scene->instances[frame.material_instance[t.material]], frame.scene->materials[t.material]) {}

  /// At those of kLanes points that lie inside; the others calculate the first of them again.
  HWY_NOINLINE Float operator()(Mask inside, Int px, Int py) {
    if (!is_found_) {
      is_found_ = true;
      faces_.list(std::array<std::uint32_t, 2 * kLanes>{}.data(), 1);
      faces_.find(wants_of_opacity(faces_.frame, faces_.material));
    }
    alignas(64) std::array<std::int32_t, kLanes> x, y;
    store(x.data(), px);
    store(y.data(), py);
    const auto first = static_cast<std::size_t>(__builtin_ctz(mask_bits(inside)));
    const Batch batch(faces_, 0, select(inside, px, Int(x[first])), select(inside, py, Int(y[first])), false);
    return opacity_of(batch.faces, batch.at, batch.slopes);
  }

 private:
  FaceTable faces_;
  bool is_found_ = false;
};

/// Samples of a mask: those where it is dense enough.
template <bool kSmall>
HWY_INLINE bool fill_mask(const Canvas& c, const Record& t, OpacityOfTriangle& opacity, std::uint32_t record, int x, int y, Mask in_range) {
  const Float cutoff(c.frame.scene->materials[t.material].opacity.cutoff);
  bool has_won = false;
  each_sample<kSmall>(c, t, x, y, in_range, [&](std::size_t at, std::size_t, Mask inside, const Float& key, const Int& px, const Int& py) {
    const Mask is_near = inside & (key >= load(&c.scratch.depth_key[at]));
    if (!any_of(is_near)) {
      return;
    }
    const Mask is_dense = is_near & (opacity(is_near, px, py) >= cutoff);
    if (any_of(is_dense)) {
      has_won |= merge(c, is_dense, key, Float(c.frame.farthest), at, record);
    }
  });
  return has_won;
}

inline HWY_NOINLINE void list_sheet(const Canvas& c, const Record& t, std::uint32_t record, int x, int y, std::uint32_t samples) {
  TileScratch& s = c.scratch;
  if (s.sheet_count >= TileScratch::kSheets && c.bottom - c.top > 1) {
    s.has_too_many_sheets = true;
    return;
  }
  if (HWY_UNLIKELY(s.sheet_count == s.sheets.size())) {
    s.grow_sheets();
  }
  const std::int32_t px = x * kSubpixelUnits + kSubpixelUnits / 2;
  const std::int32_t py = y * kSubpixelUnits + kSubpixelUnits / 2;
  const SampleOffset offset = covers_point(t, px, py) ? SampleOffset{0, 0} : c.frame.pattern[static_cast<std::size_t>(__builtin_ctz(samples))];
  const ShadingOpacity& stated = c.frame.scene->materials[t.material].opacity;
  std::uint32_t& first = s.first_sheet[c.at(x, y)];
  TileScratch::Sheet& sheet = s.sheets[s.sheet_count];
  sheet = {record, first, samples, px + offset.x, py + offset.y, stated.is_uniform() ? stated.opacity : -1.0F, Record::kNone};
  first = static_cast<std::uint32_t>(s.sheet_count++);
}

/// Pixels of which samples show a blended triangle.
template <bool kSmall>
HWY_INLINE bool list_sheets(const Canvas& c, const Record& t, std::uint32_t record, int x, int y, Mask in_range) {
  TileScratch& s = c.scratch;
  std::array<std::uint32_t, kLanes> samples{};
  std::uint32_t lanes = 0;
  each_sample<kSmall>(c, t, x, y, in_range, [&](std::size_t at, std::size_t sample, Mask inside, const Float& key, const Int&, const Int&) {
    const Float old = load(&s.depth_key[at]);
    std::uint32_t shown = mask_bits(inside & (key > old));
    for (std::uint32_t ties = mask_bits(inside & (key == old)); ties != 0; ties &= ties - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(ties));
      shown |= t.id < s.records[s.winner[at + lane]].id ? 1U << lane : 0U;
    }
    lanes |= shown;
    for (; shown != 0; shown &= shown - 1) {
      samples[static_cast<std::size_t>(__builtin_ctz(shown))] |= 1U << sample;
    }
  });
  for (std::uint32_t left = lanes; left != 0; left &= left - 1) {
    const int lane = __builtin_ctz(left);
    list_sheet(c, t, record, x + lane, y, samples[static_cast<std::size_t>(lane)]);
  }
  return lanes != 0;
}

/// One triangle that can be seen through.
inline HWY_NOINLINE bool fill_seen_through(const Canvas& c, const Record& t, std::uint32_t record, const PixelRange& range) {
  const bool is_small = (t.flags & Record::kSmall) != 0;
  const int top = range.top < c.top ? c.top : range.top;
  const int bottom = range.bottom < c.bottom ? range.bottom : c.bottom - 1;
  bool is_seen = false;
  const auto each = [&](auto&& look) {
    for (int y = top; y <= bottom; ++y) {
      for (int x = range.left; x <= range.right; x += static_cast<int>(kLanes)) {
        is_seen |= look(x, y, first_lanes(static_cast<std::size_t>(range.right - x + 1)));
      }
    }
  };
  if (c.mode == AlphaMode::mask) {
    OpacityOfTriangle opacity(c.frame, t);
    each([&](int x, int y, Mask in_range) {
      return is_small ? fill_mask<true>(c, t, opacity, record, x, y, in_range) : fill_mask<false>(c, t, opacity, record, x, y, in_range);
    });
  } else {
    each([&](int x, int y, Mask in_range) {
      return is_small ? list_sheets<true>(c, t, record, x, y, in_range) : list_sheets<false>(c, t, record, x, y, in_range);
    });
  }
  return is_seen;
}

/// A triangle's key at a sample, as reference/visibility.cpp: key_at().
HWY_INLINE std::uint64_t key_at(const Record& t, std::int32_t px, std::int32_t py) {
  const auto e1 = static_cast<float>(edge_function(t.x[2], t.y[2], t.x[0], t.y[0], px, py));
  const auto e2 = static_cast<float>(edge_function(t.x[0], t.y[0], t.x[1], t.y[1], px, py));
  const float slope1 = (t.key[1] - t.key[0]) * t.inverse_area;
  const float slope2 = (t.key[2] - t.key[0]) * t.inverse_area;
  return (std::uint64_t{std::bit_cast<std::uint32_t>((t.key[0] + slope1 * e1) + slope2 * e2)} << 32) | (~t.id & 0xFFFFFFFFU);
}

/// The nearest first. Gaps as Ciura 2001 found them.
inline void sort_places(TileScratch::SheetPlace* places, std::size_t count) {
  for (const std::size_t gap : {std::size_t{701}, std::size_t{301}, std::size_t{132}, std::size_t{57}, std::size_t{23}, std::size_t{10},
                                std::size_t{4}, std::size_t{1}}) {
    for (std::size_t i = gap; i < count; ++i) {
      const TileScratch::SheetPlace place = places[i];
      std::size_t to = i;
      for (; to >= gap && places[to - gap].key < place.key; to -= gap) {
        places[to] = places[to - gap];
      }
      places[to] = place;
    }
  }
}

/// What a pixel with sheets shows: reference/pixel.cpp, parts_of().
struct ArrangedPixel {
  std::size_t parts;  // entries of TileScratch::pixel_parts
  float uncovered;
};
inline HWY_NOINLINE ArrangedPixel arrange_pixel(const Frame& frame, TileScratch& s, int x, int y, std::size_t at) {
  const std::int32_t px = x * kSubpixelUnits + kSubpixelUnits / 2;
  const std::int32_t py = y * kSubpixelUnits + kSubpixelUnits / 2;
  std::size_t sheets = 0;
  for (std::uint32_t i = s.first_sheet[at]; i != Record::kNone; i = s.sheets[i].next) {
    ++sheets;
  }
  if (s.sheet_places.size() < sheets) {
    s.fit_sheets_of_pixel(sheets);
  }
  std::array<std::size_t, 16> winner_parts;
  std::size_t winners = 0;
  ArrangedPixel pixel{0, 0};
  for (std::size_t sample = 0; sample < frame.pattern.size(); ++sample) {
    const SampleOffset offset = frame.pattern[sample];
    std::size_t count = 0;
    for (std::uint32_t i = s.first_sheet[at]; i != Record::kNone; i = s.sheets[i].next) {
      if ((s.sheets[i].samples >> sample & 1U) != 0) {
        s.sheet_places[count++] = {key_at(s.records[s.sheets[i].record], px + offset.x, py + offset.y), i};
      }
    }
    sort_places(s.sheet_places.data(), count);
    float let_through = 1;
    for (std::size_t i = 0; i < count; ++i) {
      TileScratch::Sheet& sheet = s.sheets[s.sheet_places[i].sheet];
      if (sheet.part == Record::kNone) {
        sheet.part = static_cast<std::uint32_t>(pixel.parts);
        s.pixel_parts[pixel.parts++] = {sheet.record, sheet.x, sheet.y, 0};
      }
      s.pixel_parts[sheet.part].amount += let_through * sheet.opacity;
      let_through = let_through * (1.0F - sheet.opacity);
    }
    const std::uint32_t winner = s.winner[sample * s.plane + at];
    if (winner == Record::kNone) {
      pixel.uncovered += let_through;
      continue;
    }
    std::size_t known = 0;
    while (known < winners && s.pixel_parts[winner_parts[known]].record != winner) {
      ++known;
    }
    if (known == winners) {
      const bool at_center = covers_point(s.records[winner], px, py);
      winner_parts[winners++] = pixel.parts;
      s.pixel_parts[pixel.parts++] = {winner, at_center ? px : px + offset.x, at_center ? py : py + offset.y, 0};
    }
    s.pixel_parts[winner_parts[known]].amount += let_through;
  }
  return pixel;
}

}  // namespace lustro::HWY_NAMESPACE
// NOLINTEND(cppcoreguidelines-pro-type-member-init)
