// From a picture of all directions to what surfaces show of it: smooth light for the diffuse term, blurred pictures for highlights.
//
// Pictures are laid out as ReflectionShape::sphere: u = 1/2 + atan2(x, -z) / 2 pi, v = arccos(y) / pi. No libm: the same bits everywhere.
#pragma once

#include "lustro/image.hpp"
#include "lustro/vec.hpp"
#include "shade/environment.hpp"

namespace lustro {

/// The diffuse light of an environment, in classic units: 1 under a white sky.
/// picture  RGB, linear
/// threads  0: one a core; the result is the same for any number
[[nodiscard]] ShadingEnvironment diffuse_light(const Image& picture, int threads);
/// Of a sky of one colour.
[[nodiscard]] ShadingEnvironment diffuse_light(const Vec3f& color);
/// Turned about +y, counter-clockwise seen from above.
[[nodiscard]] ShadingEnvironment turned(const ShadingEnvironment& light, double degrees);

/// The picture as a highlight of exponent n sees it: at each direction R the mean over w of the picture, weighted by max(R.w, 0)^n. As small as
/// the lobe's width allows.
[[nodiscard]] Image blurred_by_lobe(const Image& picture, float n, int threads);

/// The picture made smaller, `width` times `width` / 2 pixels at most: each the mean of what it covers, by solid angles.
[[nodiscard]] Image reduced_sphere(const Image& picture, int width);

}  // namespace lustro
