// What the lights see, by the kernels that draw pictures.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "raster/bins.hpp"
#include "raster/frame.hpp"
#include "raster/scratch_pool.hpp"

namespace lustro {

/// What stays from one picture to the next.
class DepthWorkshop {
 public:
  /// What drawing a face works with.
  struct Bench {
    PreparedScene casters;
    Frame frame;
    BinWork bins;
    Scratches scratches;
  };
  /// A bench of which the casters are the scene's.
  Bench* take(const PreparedScene& scene);
  void give_back(Bench* bench);
  /// All benches want the casters of a new scene.
  void forget();

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Bench>> all_;
  std::vector<Bench*> idle_;   ///< with the casters of this picture
  std::vector<Bench*> stale_;  ///< with those of another one
};

/// Draws the maps' keys: where there is nothing they are 0 or less, else those of the reference (reference/depth_maps.hpp). Equal for every row
/// of kernels and every number of threads.
void draw_depth_maps(const PreparedScene& scene, DepthMaps& maps, const Kernels& kernels, int threads, DepthWorkshop& workshop);

}  // namespace lustro
