// Fragments sorted into runs of one material, which lanes share. Part of a row (row.cpp).
#pragma once

#include "raster/row_strip.hpp"

// What a kernel fills is not cleared first.
// NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
namespace lustro::HWY_NAMESPACE {

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

}  // namespace lustro::HWY_NAMESPACE
// NOLINTEND(cppcoreguidelines-pro-type-member-init)
