// What is seen behind everything else.
#pragma once

#include <array>

#include "scene/prepare.hpp"
#include "shade/reflection.hpp"
#include "shade/texturing.hpp"

namespace lustro {

/// The environment's light at image point (x, y), pixels, averaged over a pixel.
template <class Fetch, class F>
Vec3<F> sky_at(const View& view, const ShadingMap& sky, const F& x, const F& y) {
  const Vec3<F> to_eye = view.to_eye_at(x, y);
  const std::array<Vec3<F>, 2> change = view.to_eye_slopes_at(x, y);
  return look_up<Fetch>(sky, on_sphere(DirectionSlopes<F>{-to_eye, -change[0], -change[1]})).rgb;
}

/// What pixel (x, y) shows where nothing covers it, premultiplied. Not a template, and not in the header: the rows' instructions stay in the
/// rows.
[[nodiscard]] Vec3f background_at(const PreparedScene& scene, int x, int y);

}  // namespace lustro
