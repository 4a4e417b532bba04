// Everything with an extent that shines: area lights, triangles that emit, the sky. One of them is chosen by its power, then a point of it.
#pragma once

#include <optional>
#include <vector>

#include "path/environment.hpp"
#include "path/surface_point.hpp"

namespace lustro {

/// A triangle of an instance.
struct TriangleId {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  std::uint32_t instance = kNone, triangle = kNone;
  friend bool operator==(const TriangleId&, const TriangleId&) = default;
};

/// A way to an emitter, chosen for a point.
struct EmitterSample {
  Vec3f to_light{};             ///< unit
  float distance = 0;           ///< infinite for the sky
  Vec3f diffuse{}, specular{};  ///< the radiance that diffuse surfaces and highlights see
  float density = 0;            ///< by solid angle; 0: nothing comes from there
  TriangleId triangle{};        ///< the emitter, where it is one: it does not stand in its own way
  Vec3f end{};                  ///< of a triangle: a place just before it, on the way
};

class Emitters {
 public:
  /// `scene` must outlive it.
  explicit Emitters(const PreparedScene& scene);

  [[nodiscard]] bool is_empty() const { return choice_.is_empty(); }

  /// u  which emitter, and which point of it
  [[nodiscard]] EmitterSample sample(const Vec3f& position, const Vec2f& u) const;

  /// The density with which sample() finds, from `position`, a place on an emitting triangle.
  [[nodiscard]] float density_of(const SurfacePlace& place, const Vec3f& position) const;

  /// An area light that a ray meets, and the density with which sample() finds that place.
  struct Met {
    const AreaLight* light;
    float density;
  };
  /// Light i, or nothing where the ray does not meet its front before `farthest`. direction: unit.
  [[nodiscard]] std::optional<Met> meets_area(std::size_t i, const Vec3f& position, const Vec3f& direction, float farthest) const;
  [[nodiscard]] std::size_t area_count() const { return scene_->area_lights.size(); }

  /// The sky, or null.
  [[nodiscard]] const Sky* sky() const { return sky_ ? &*sky_ : nullptr; }
  [[nodiscard]] float density_of_sky(const Vec3f& direction) const;

 private:
  // A triangle that shines.
  struct Shining {
    TriangleId id;
    PlacedTriangle placed;
    float area = 0;
    Vec3f emission{};       // where it is plain
    bool is_plain = false;  // the same everywhere, from both sides
  };
  [[nodiscard]] EmitterSample sample_triangle_of(const Shining& triangle, const Vec3f& position, const Vec2f& u) const;

  const PreparedScene* scene_;
  std::vector<Shining> triangles_;
  std::optional<Sky> sky_;
  Choice choice_;  // area lights, triangles, the sky
  double all_power_ = 0;
  float inverse_power_ = 0;
};

}  // namespace lustro
