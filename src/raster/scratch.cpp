// A thread's memory grows to what pictures ask for and stays.
#include <algorithm>

#include "raster/frame.hpp"

namespace lustro {

void TileScratch::fit(const Frame& frame) {
  stride = static_cast<std::size_t>(frame.tile_width) + kPadding;
  plane = stride * static_cast<std::size_t>(frame.tile_height);
  const std::size_t samples = plane * frame.pattern.size() + 4 * stride;
  if (depth_key.size() < samples) {
    depth_key.resize(samples);
    winner.resize(samples);
  }
  material_begin.resize(std::max(material_begin.size(), frame.scene->materials.size() + 1));
  blocks_x = static_cast<std::size_t>((frame.tile_width + kBlockWidth - 1) / kBlockWidth);
  const auto blocks_y = static_cast<std::size_t>((frame.tile_height + kBlockHeight - 1) / kBlockHeight);
  block_farthest.resize(std::max(block_farthest.size(), blocks_x * blocks_y));
  if ((frame.alpha_modes & bit_of(AlphaMode::blend)) != 0 && first_sheet.size() < plane) {
    first_sheet.resize(plane);
  }
  reflections.resize(frame.scene->lights.size());
  visibilities.resize(std::max(visibilities.size(), frame.scene->looks_beyond() ? (frame.scene->lights.size() + 1) * kStrip : 0));
  if (frame.wants_lights) {
    light_output.resize(std::max(light_output.size(), frame.scene->lights.size() * 3 * (kFragments + kPadding)));
    light_parts.resize(frame.scene->lights.size());
  }
  visibility_ms = 0;
  shading_ms = 0;
  pixels_covered = 0;
}

void TileScratch::grow_sorted(std::size_t count) {
  sorted_clusters.resize(std::max(count, sorted_clusters.size() * 2));
}

void TileScratch::grow_records() {
  records.resize(std::max<std::size_t>(4096, records.size() * 2));
}

void TileScratch::grow_sheets() {
  sheets.resize(std::max<std::size_t>(4096, sheets.size() * 2));
}

void TileScratch::fit_sheets_of_pixel(std::size_t count) {
  constexpr std::size_t kSamples = 16;  // each may show a triangle of its own behind them
  if (sheet_places.size() < count) {
    sheet_places.resize(std::max(count, sheet_places.size() * 2));
    pixel_parts.resize(sheet_places.size() + kSamples);
  }
}

}  // namespace lustro
