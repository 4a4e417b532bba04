// One path: from a pixel to light.
#pragma once

#include <cstdint>

#include "lustro/render.hpp"
#include "path/emitters.hpp"
#include "path/random.hpp"
#include "path/rays.hpp"
#include "scene/prepare.hpp"

namespace lustro {

/// What a path brings.
struct PathResult {
  Vec3f radiance;
  float alpha = 0;       ///< of what the pixel shows
  bool has_hit = false;  ///< the camera sees a surface
};

/// A scene ready for paths. Any number of threads may follow some.
class PathTracer {
 public:
  /// `scene` and `rays` must outlive it.
  PathTracer(const PreparedScene& scene, const RayScene& rays, PathOptions options);

  /// One path through pixel (x, y). rays: is increased by those that were shot.
  [[nodiscard]] PathResult follow(int x, int y, std::uint32_t sample, std::uint64_t& rays) const;

 private:
  struct Walk;
  [[nodiscard]] Ray camera_ray(float x, float y) const;
  [[nodiscard]] bool find_surface(Walk& walk, Ray ray) const;
  [[nodiscard]] float transmittance(Walk& walk, const Vec3f& direction, float distance, const EmitterSample* light) const;
  void add_sky(Walk& walk, PathResult& result) const;
  void add_area_lights(Walk& walk, float farthest) const;
  void add_emission(Walk& walk, const SurfacePoint& point) const;
  void add_delta_lights(Walk& walk, const SurfacePoint& point) const;
  void add_local_terms(Walk& walk, const SurfacePoint& point) const;
  void add_emitter(Walk& walk, const SurfacePoint& point, const class Bsdf& bsdf, const Vec2f& u) const;

  const PreparedScene* scene_;
  const RayScene* rays_;
  PathOptions options_;
  Emitters emitters_;
  std::vector<std::uint32_t> delta_lights_;  // indices of lights without a size
  bool is_solid_ = true;                     // nothing can be seen through
};

}  // namespace lustro
