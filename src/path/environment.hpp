// The sky as a light: its radiance in every direction, and directions chosen in proportion to its brightness.
#pragma once

#include <memory>
#include <vector>

#include "path/sampling.hpp"
#include "scene/prepare.hpp"

namespace lustro {

/// A direction to the sky.
struct SkySample {
  Vec3f direction;  ///< unit
  float density = 0;
};

class Sky {
 public:
  /// Must be outlived by `environment`.
  explicit Sky(const PreparedEnvironment& environment);

  /// What comes from there (unit): the picture blended between its pixels.
  [[nodiscard]] Vec3f radiance(const Vec3f& direction) const;
  [[nodiscard]] SkySample sample(const Vec2f& u) const;
  [[nodiscard]] float density(const Vec3f& direction) const;
  /// The luminance that arrives from all directions, integrated over the sphere.
  [[nodiscard]] float power() const { return power_; }

 private:
  [[nodiscard]] Vec2f place_of(const Vec3f& direction) const;

  const PreparedEnvironment* environment_;
  int width_ = 0, height_ = 0;
  Choice rows_;
  std::vector<Choice> columns_;  // one a row
  float power_ = 0;
};

}  // namespace lustro
