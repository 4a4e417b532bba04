// The independent judge, part two: the equation of docs/using/scene-file.md at one point, in double precision and with the C library's pow and
// exp. Maps are looked up by tests/texture/sampler_oracle.hpp at coordinates whose slopes are differences between rays. It shares no line with
// src/.
#pragma once

#include "truth/world.hpp"

namespace lustro::truth {

/// What a pixel should show.
struct Seen {
  Vec3d color;  ///< linear, premultiplied
  double alpha = 1;
  Vec3d position;  ///< world
  Vec3d normal;    ///< the normal that was lit; for `gouraud` 0
};

/// What the pixel whose centre is (x, y) shows of `hit`, or the background.
[[nodiscard]] Seen see(const Scene& scene, const World& world, double x, double y, const Hit& hit);

/// A colour as linear light: decoded where it is encoded and the transfer is `srgb`.
[[nodiscard]] Vec3d light_of(const Color& color, Transfer transfer);

/// The value between 0 and 1 that is stored for a linear value.
[[nodiscard]] double stored(double linear, Transfer transfer);

}  // namespace lustro::truth
