// The maps of depths that shadows are looked up in: where each light's map looks from, and which texels show what. A renderer draws them
// (reference/depth_maps.cpp, raster/depth_maps.cpp); shade/depth_map.hpp looks them up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "lustro/result.hpp"
#include "lustro/scene.hpp"
#include "scene/view.hpp"
#include "shade/depth_map.hpp"
#include "shade/lighting.hpp"

namespace lustro {

struct PreparedScene;

/// One picture of depths.
struct DepthFace {
  View view;
  std::size_t first = 0;  ///< of its keys
};

/// Maps and the pictures that they are made of.
struct DepthMaps {
  std::vector<DepthMap> maps;
  std::vector<DepthFace> faces;
  std::vector<float> keys;  ///< of all faces; drawn, not prepared

  [[nodiscard]] bool empty() const { return faces.empty(); }
  void clear() {
    maps.clear();
    faces.clear();
  }
};

/// Of all faces.
[[nodiscard]] std::size_t texel_count(const DepthMaps& maps);

/// Lets the maps know where their keys lie.
void bind_keys(DepthMaps& maps);

/// The maps of the lights that have a shadow; of the others there is an empty entry.
///
/// eye  world: what the lights' positions and the looked-up points are relative to
/// errors  limit where the maps are too large together
[[nodiscard]] Result<void> plan_shadows(const ShadowSettings& settings, std::span<const ShadingLight> lights, const Extent& extent,
                                        const Vec3d& eye, DepthMaps& shadows);

/// What throws shadows, as it is seen from somewhere: both sides of every opaque surface and of every mask where it is not cut out; blended
/// surfaces where they hide at least half of what lies behind them, and there wholly.
void make_casters(const PreparedScene& scene, PreparedScene& casters);

/// Turns the casters to a face.
void look_from(PreparedScene& casters, const View& view);

}  // namespace lustro
