// Bands of rows, so that threads have something to share out.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "reference/triangle.hpp"

namespace lustro {

inline constexpr int kBandRows = 16;  // a band of rows is one thread's work: it owns its samples and its pixels

/// Triangles that touch each band, in order.
[[nodiscard]] inline std::vector<std::vector<std::uint32_t>> bin_by_band(const View& view, const std::vector<ScreenTriangle>& triangles) {
  const int bands = (view.height + kBandRows - 1) / kBandRows;
  std::vector<std::vector<std::uint32_t>> bins(static_cast<std::size_t>(bands));
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const auto& y = triangles[i].y;
    const auto [top, bottom] = std::minmax({y[0], y[1], y[2]});
    const int first = std::max(0, (top >> 8) / kBandRows);
    const int last = std::min(bands - 1, (bottom >> 8) / kBandRows);
    for (int band = first; band <= last; ++band) {
      bins[static_cast<std::size_t>(band)].push_back(i);
    }
  }
  return bins;
}

}  // namespace lustro
