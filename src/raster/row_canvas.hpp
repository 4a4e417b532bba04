// The tile that is being filled, and how what covers its samples is merged with what they show. Part of a row (row.cpp).
#pragma once

#include "raster/frame.hpp"
#include "simd/lanes.hpp"

// What a kernel fills is not cleared first.
// NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
namespace lustro::HWY_NAMESPACE {

/// The tile that is being filled.
struct Canvas {
  static constexpr bool kKeepsWinners = true;

  const Frame& frame;
  TileScratch& scratch;
  TileArea area;
  AlphaMode mode;   // of the triangles that are filled
  int top, bottom;  // rows in which blended triangles are listed; the lower bound is excluded

  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y - area.top) * scratch.stride + static_cast<std::size_t>(x - area.left);
  }
};

/// A tile of a map of depths: which triangle is the nearest is not asked, and all of them are opaque.
struct KeyCanvas : Canvas {
  static constexpr bool kKeepsWinners = false;
};

/// Pixels that may have a sample inside a triangle's box; bounds included.
struct PixelRange {
  int left, top, right, bottom;
};

/// An equally near triangle is seen where it comes first in the scene. Rare, so lane by lane; `columns` of them lie in a row.
inline HWY_NOINLINE bool settle_ties(TileScratch& s, std::uint32_t ties, std::size_t at, std::size_t columns, std::uint32_t record) {
  bool has_won = false;
  for (; ties != 0; ties &= ties - 1) {
    const auto lane = static_cast<std::size_t>(__builtin_ctz(ties));
    std::uint32_t& winner = s.winner[at + lane / columns * s.stride + lane % columns];
    if (s.records[record].id < s.records[winner].id) {
      winner = record;
      has_won = true;
    }
  }
  return has_won;
}

/// Lanes of one row against what the samples show so far.
HWY_INLINE bool merge(const Canvas& c, Mask inside, Float key, Float farthest, std::size_t at, std::uint32_t record) {
  TileScratch& s = c.scratch;
  const Float old = load(&s.depth_key[at]);
  const Mask is_near = inside & (key >= farthest);
  const Mask wins = is_near & (key > old);
  const Mask ties = is_near & (key == old);
  bool has_won = false;
  if (HWY_UNLIKELY(any_of(ties))) {
    has_won = settle_ties(s, mask_bits(ties), at, kLanes, record);
  }
  if (any_of(wins)) {
    store_where(wins, &s.depth_key[at], key);
    store_where(wins, &s.winner[at], Int(static_cast<std::int32_t>(record)));
    has_won = true;
  }
  return has_won;
}

/// The same of keys alone. A branch would be foreseen less often than it spares a store.
HWY_INLINE bool merge(const KeyCanvas& c, Mask inside, Float key, Float farthest, std::size_t at, std::uint32_t) {
  float* keys = &c.scratch.depth_key[at];
  const Float old = load(keys);
  store(keys, select(inside & (key >= farthest) & (key > old), key, old));
  return true;
}

#if HWY_TARGET != HWY_SCALAR
/// A patch of 4 columns against what the samples show so far.
HWY_INLINE bool merge_patch(const Canvas& c, Mask inside, Float key, Float farthest, std::size_t at, std::uint32_t record) {
  TileScratch& s = c.scratch;
  const Float old = load_patch(&s.depth_key[at], s.stride);
  const Mask is_near = inside & (key >= farthest);
  const Mask wins = is_near & (key > old);
  const Mask ties = is_near & (key == old);
  bool has_won = false;
  if (HWY_UNLIKELY(any_of(ties))) {
    has_won = settle_ties(s, mask_bits(ties), at, 4, record);
  }
  if (any_of(wins)) {
    store_patch(&s.depth_key[at], s.stride, select(wins, key, old));
    store_patch(&s.winner[at], s.stride, select(wins, Int(static_cast<std::int32_t>(record)), load_patch(&s.winner[at], s.stride)));
    has_won = true;
  }
  return has_won;
}

HWY_INLINE bool merge_patch(const KeyCanvas& c, Mask inside, Float key, Float farthest, std::size_t at, std::uint32_t) {
  TileScratch& s = c.scratch;
  const Float old = load_patch(&s.depth_key[at], s.stride);
  store_patch(&s.depth_key[at], s.stride, select(inside & (key >= farthest) & (key > old), key, old));
  return true;
}
#endif

/// 0 on a top or left edge, whose points are inside, else -1.
HWY_INLINE std::int32_t edge_bias(std::int32_t from_x, std::int32_t from_y, std::int32_t to_x, std::int32_t to_y) {
  return to_y < from_y || (to_y == from_y && to_x > from_x) ? 0 : -1;
}

/// Whether a point of the image lies in a triangle.
HWY_INLINE bool covers_point(const Record& t, std::int32_t px, std::int32_t py) {
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

}  // namespace lustro::HWY_NAMESPACE
// NOLINTEND(cppcoreguidelines-pro-type-member-init)
