// The threads' memory: one scratch for each that draws at the same time.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "raster/frame.hpp"

namespace lustro {

/// What stays from one picture to the next.
struct Scratches {
  std::vector<std::unique_ptr<TileScratch>> all;
  std::vector<TileScratch*> idle;
};

/// Hands out a scratch to whoever draws a tile.
class ScratchPool {
 public:
  ScratchPool(Scratches& scratches, const Frame& frame) : scratches_(scratches.all), free_(scratches.idle), frame_(frame) { free_.clear(); }
  TileScratch* take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty() && used_ == scratches_.size()) {
      scratches_.push_back(std::make_unique<TileScratch>());
    }
    if (free_.empty()) {
      TileScratch* fresh = scratches_[used_++].get();
      fresh->fit(frame_);
      return fresh;
    }
    TileScratch* scratch = free_.back();
    free_.pop_back();
    return scratch;
  }
  void give_back(TileScratch* scratch) {
    const std::lock_guard lock(mutex_);
    free_.push_back(scratch);
  }
  [[nodiscard]] std::span<const std::unique_ptr<TileScratch>> used() const { return std::span(scratches_).first(used_); }

 private:
  std::vector<std::unique_ptr<TileScratch>>& scratches_;
  std::vector<TileScratch*>& free_;
  const Frame& frame_;
  std::size_t used_ = 0;
  std::mutex mutex_;
};

}  // namespace lustro
