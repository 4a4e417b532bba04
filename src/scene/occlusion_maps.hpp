// The lines that occlusion is looked up along: which there are, and the depths at which they meet surfaces. Every renderer uses the same.
// shade/occlusion.hpp looks them up.
#pragma once

#include <cstdint>
#include <vector>

#include "lustro/result.hpp"
#include "lustro/scene.hpp"
#include "scene/view.hpp"
#include "shade/occlusion.hpp"

namespace lustro {

struct PreparedScene;

/// What shade/occlusion.hpp looks up, and where it lies.
struct OcclusionMaps {
  ShadingOcclusion shading;
  std::vector<OcclusionLines> directions;  ///< evenly over a hemisphere
  std::vector<std::int32_t> layers;

  [[nodiscard]] bool empty() const { return directions.empty(); }
  void clear() { directions.clear(); }
};

/// Lays the lines through the scene.
///
/// eye  world: what positions are relative to
/// errors  limit where there are too many
[[nodiscard]] Result<void> plan_occlusion(const OcclusionSettings& settings, const Extent& extent, const Vec3d& eye, OcclusionMaps& maps);

/// Finds where the lines meet surfaces. Masks count where they are cut out, too; blended surfaces where their material's opacity is at least a
/// half. The same for any number of threads.
void draw_occlusion(const PreparedScene& scene, OcclusionMaps& maps, int threads);

}  // namespace lustro
