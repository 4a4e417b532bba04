// A scene that turns about a vertical axis: the axis, the matrices, and a camera that stands still and sees all of it.
#pragma once

#include <span>

#include "lustro/result.hpp"
#include "lustro/scene.hpp"
#include "scene/view.hpp"

namespace lustro::app {

/// The cylinder that holds every vertex while the scene turns.
struct SweptBody {
  Vec3d center;       ///< on the axis, world
  double radius = 0;  ///< of the vertex that is farthest from the axis
  double half_height = 0;
};

/// The body about the vertical axis through the camera's stated target, else through the middle of the scene's bounds.
[[nodiscard]] SweptBody swept_body(const Scene& scene);

[[nodiscard]] Extent extent_of(const SweptBody& body);

/// The matrices of the objects after a turn about the axis, counter-clockwise seen from above.
///
/// matrices  of the scene at rest, one an object
void turn_objects(Scene& scene, std::span<const Mat4> matrices, const SweptBody& body, double sine, double cosine);

/// The matrices of the scene as it stands.
[[nodiscard]] std::vector<Mat4> matrices_of(const Scene& scene);

/// What every frame would choose by the box of its own: the radius of occlusion, the ground's height. One for the whole turn.
void settle_for_turn(Scene& scene, const SweptBody& body);

/// The camera that `view` is, with nothing left open, and with near and far planes (where the camera does not state them) that hold the body.
/// errors  as make_view()
[[nodiscard]] Result<Camera> definite_camera(const Camera& camera, const ImageSettings& image, const View& view, const SweptBody& body);

/// A point turned about the axis like the objects.
[[nodiscard]] Vec3d turned(const Vec3d& point, const SweptBody& body, double sine, double cosine);

}  // namespace lustro::app
