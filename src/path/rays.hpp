// Which triangle a ray meets: Embree's bounding volume hierarchy (Wald et al. 2014) over all instances, in the space of light: world
// orientation, relative to the eye.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "lustro/result.hpp"
#include "scene/prepare.hpp"

namespace lustro {

struct Ray {
  Vec3f origin;
  Vec3f direction;
  float nearest = 0;  ///< only what lies beyond, in lengths of the direction
  float farthest = std::numeric_limits<float>::infinity();
};

struct RayHit {
  float distance = 0;  ///< in lengths of the direction
  std::uint32_t instance = 0;
  std::uint32_t triangle = 0;  ///< of the instance's mesh
  float u = 0, v = 0;          ///< weights of the triangle's vertices 1 and 2
};

/// A triangle in the space of rays.
struct PlacedTriangle {
  Vec3f a, b, c;     ///< relative to the eye
  Vec3f normal{};    ///< unit, on the front
  float offset = 0;  ///< how far from it a ray must begin so that rounding does not let it meet the triangle again
};

/// Triangle `triangle` of an instance, from the mesh.
[[nodiscard]] PlacedTriangle placed_triangle(const PreparedScene& scene, std::uint32_t instance, std::uint32_t triangle);

/// The triangles of a prepared scene, ready for rays. It refers to their meshes.
class RayScene {
 public:
  /// errors  unsupported in a build without Embree; limit where there is no memory
  [[nodiscard]] static Result<RayScene> make(const PreparedScene& scene);
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;
  ~RayScene();

  /// The nearest triangle that the ray meets, from either side. Any number of threads may ask.
  [[nodiscard]] bool closest(const Ray& ray, RayHit& hit) const;
  /// Whether the ray meets any.
  [[nodiscard]] bool is_blocked(const Ray& ray) const;
  /// What placed_triangle() says of what was met, from tables.
  [[nodiscard]] PlacedTriangle met(const RayHit& hit) const;

 private:
  struct State;
  explicit RayScene(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace lustro
