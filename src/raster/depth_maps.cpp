// A face is a picture of the casters with one sample a texel: its tiles are filled, not shaded, and their keys are kept.
#include "raster/depth_maps.hpp"

#include <algorithm>
#include <cstring>

#include "parallel/big_memory.hpp"
#include "parallel/parallel_for.hpp"

namespace lustro {

DepthWorkshop::Bench* DepthWorkshop::take(const PreparedScene& scene) {
  const std::unique_lock lock(mutex_);
  if (!idle_.empty()) {
    Bench* bench = idle_.back();
    idle_.pop_back();
    return bench;
  }
  if (stale_.empty()) {
    stale_.push_back(all_.emplace_back(std::make_unique<Bench>()).get());
  }
  Bench* bench = stale_.back();
  stale_.pop_back();
  make_casters(scene, bench->casters);
  return bench;
}

void DepthWorkshop::give_back(Bench* bench) {
  const std::lock_guard lock(mutex_);
  idle_.push_back(bench);
}

void DepthWorkshop::forget() {
  const std::lock_guard lock(mutex_);
  stale_.insert(stale_.end(), idle_.begin(), idle_.end());
  idle_.clear();
}

namespace {

constexpr int kTile = 256;  // texels: their keys stay in the cache, and few clusters lie in several

void draw_face(const DepthFace& face, float* keys, const Kernels& kernels, int threads, DepthWorkshop::Bench& bench) {
  look_from(bench.casters, face.view);
  Frame& frame = bench.frame;
  lay_out_geometry(frame, bench.casters, kTile);
  sort_into_tiles(frame, bench.bins, threads);
  ScratchPool pool(bench.scratches, frame);
  const auto tiles = static_cast<std::size_t>(frame.tiles_x) * static_cast<std::size_t>(frame.tiles_y);
  const auto stride = static_cast<std::size_t>(face.view.width);
  parallel_for(tiles, threads, [&](std::size_t tile) {
    const TileArea area = frame.area(tile);
    const std::size_t width = static_cast<std::size_t>(area.right - area.left) * sizeof(float);
    float* to = keys + static_cast<std::size_t>(area.top) * stride + static_cast<std::size_t>(area.left);
    if (frame.cluster_lists.of(tile).empty() && frame.loose_lists.of(tile).empty()) {
      for (int y = area.top; y < area.bottom; ++y, to += stride) {
        std::memset(to, 0, width);
      }
      return;
    }
    TileScratch* scratch = pool.take();
    kernels.fill_keys(frame, tile, *scratch);
    const float* from = scratch->depth_key.data();
    for (int y = area.top; y < area.bottom; ++y, to += stride, from += scratch->stride) {
      std::memcpy(to, from, width);
    }
    pool.give_back(scratch);
  });
}

}  // namespace

void draw_depth_maps(const PreparedScene& scene, DepthMaps& maps, const Kernels& kernels, int threads, DepthWorkshop& workshop) {
  if (maps.empty()) {
    return;
  }
  workshop.forget();
  resize_big(maps.keys, texel_count(maps));
  const auto draw = [&](std::size_t i, int threads_of_face) {
    DepthWorkshop::Bench* bench = workshop.take(scene);
    draw_face(maps.faces[i], &maps.keys[maps.faces[i].first], kernels, threads_of_face, *bench);
    workshop.give_back(bench);
  };
  if (maps.faces.size() < 4 * thread_count(threads)) {  // too few to be shared out evenly
    for (std::size_t i = 0; i < maps.faces.size(); ++i) {
      draw(i, threads);
    }
  } else {
    parallel_jobs(maps.faces.size(), threads, draw);
  }
  bind_keys(maps);
}

}  // namespace lustro
