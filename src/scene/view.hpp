// The view: where the camera stands and which pixel sees which ray. Everything is computed in double and relative to the eye, so that a scene
// far from the origin loses no digits; the renderers read the float members.
#pragma once

#include <array>
#include <functional>
#include <span>

#include "lustro/mesh.hpp"
#include "lustro/result.hpp"
#include "lustro/scene.hpp"
#include "math/affine_rows.hpp"
#include "math/lane.hpp"

namespace lustro {

/// A camera made definite. Image coordinates are pixels, x to the right, y down, (0, 0) the upper left corner of the upper left pixel.
struct View {
  int width = 0, height = 0, samples = 1;
  Projection projection = Projection::perspective;

  Vec3d eye;                   ///< world
  Vec3d target;                ///< world
  Vec3d right, up, forward;    ///< world, unit, orthogonal
  double near = 0, far = 0;    ///< distances along forward, near < far
  double pixels_per_unit = 0;  ///< at distance 1 (perspective), everywhere (orthographic)

  float center_x = 0, center_y = 0;  ///< the image's centre, pixels
  Vec3f ray_center;                  ///< perspective: the eye-relative point at distance 1 that the image's centre shows (forward)
  Vec3f ray_dx, ray_dy;              ///< its change a pixel to the right, a pixel down
  float depth_near = 0, depth_far = 0;

  /// The eye-relative point that image position (x, y) shows at `depth` along the view direction.
  template <class F>
  [[nodiscard]] Vec3<F> point_at(const F& x, const F& y, const F& depth) const {
    const Vec3<F> across = across_at(x, y);
    return projection == Projection::perspective ? (vec_cast<F>(ray_center) + across) * depth : across + vec_cast<F>(ray_center) * depth;
  }
  /// V at image position (x, y): unit, towards the eye.
  template <class F>
  [[nodiscard]] Vec3<F> to_eye_at(const F& x, const F& y) const {
    if (projection == Projection::orthographic) {
      return vec_cast<F>(-ray_center);
    }
    return -normalize(vec_cast<F>(ray_center) + across_at(x, y));
  }
  /// How V changes on the image at (x, y): a pixel to the right, a pixel down.
  template <class F>
  [[nodiscard]] std::array<Vec3<F>, 2> to_eye_slopes_at(const F& x, const F& y) const {
    if (projection == Projection::orthographic) {
      return {};
    }
    const Vec3<F> ray = vec_cast<F>(ray_center) + across_at(x, y);
    const F scale = F(1) / length(ray);
    const Vec3<F> unit = ray * scale;
    const auto slope = [&](const Vec3f& step) { return (unit * dot(unit, vec_cast<F>(step)) - vec_cast<F>(step)) * scale; };
    return {slope(ray_dx), slope(ray_dy)};
  }
  /// V at an eye-relative point that is not on a pixel's ray (a vertex, a face's centre).
  template <class F>
  [[nodiscard]] Vec3<F> to_eye_from(const Vec3<F>& position) const {
    const Vec3<F> backward = vec_cast<F>(-ray_center);
    if (projection == Projection::orthographic) {
      return backward;
    }
    const F distance2 = dot(position, position);
    const auto is_away = distance2 > F(0);
    const Vec3<F> to_eye = -position * (F(1) / square_root(select(is_away, distance2, F(1))));
    return {select(is_away, to_eye.x, backward.x), select(is_away, to_eye.y, backward.y), select(is_away, to_eye.z, backward.z)};
  }

 private:
  template <class F>
  [[nodiscard]] Vec3<F> across_at(const F& x, const F& y) const {
    return vec_cast<F>(ray_dx) * (x - F(center_x)) + vec_cast<F>(ray_dy) * (y - F(center_y));
  }
};

/// The matrix from an object to the image: Instance::image_from_object. All in double, rounded once.
[[nodiscard]] AffineRows image_rows(const Mat4& world_from_object, const View& view);

/// What a camera frames: the scene's reach, the largest dot(direction, p) over all its points p (world), for several directions at once. A
/// maximum does not depend on the order of points.
struct Extent {
  Bounds bounds;  ///< world; empty: there is nothing to frame
  std::function<void(std::span<const Vec3d> directions, std::span<double> reach)> reach;
};

/// The extent of a box.
[[nodiscard]] Extent extent_of(const Bounds& bounds);

/// The camera with all that it leaves open chosen so that the scene fills the image with a small margin.
/// errors  usage where eye and target coincide, up is parallel to the view, near >= far, or a number is out of range
[[nodiscard]] Result<View> make_view(const Camera& camera, const ImageSettings& image, const Extent& extent);

/// The members that renderers read, from those that say where the camera stands and what it sees.
void complete_view(View& view);

/// The light of a scene without `lights`: key, fill and rim, fixed to the camera.
[[nodiscard]] std::array<Light, 3> default_rig(const View& view);

}  // namespace lustro
