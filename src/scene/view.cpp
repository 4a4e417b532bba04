// Camera, framing and the default light rig.
#include "scene/view.hpp"

#include <algorithm>
#include <array>

#include "math/trig.hpp"

namespace lustro {
namespace {

constexpr double kMargin = 1.08;  // the framed scene leaves 4 % of the image free on each side

// The way from the target to the eye, and which way is up, for a named view.
struct Direction {
  Vec3d to_eye, up;
};
Direction preset(ViewPreset view) {
  const Vec3d y{0, 1, 0};
  switch (view) {
    case ViewPreset::three_quarter:
      return {{0.55, 0.38, 1.0}, y};
    case ViewPreset::iso:
      return {{1, 1, 1}, y};
    case ViewPreset::front:
      return {{0, 0, 1}, y};
    case ViewPreset::back:
      return {{0, 0, -1}, y};
    case ViewPreset::left:
      return {{-1, 0, 0}, y};
    case ViewPreset::right:
      return {{1, 0, 0}, y};
    case ViewPreset::top:
      return {{0, 1, 0}, {0, 0, -1}};
    case ViewPreset::bottom:
      return {{0, -1, 0}, {0, 0, 1}};
  }
  return {{0, 0, 1}, y};
}

// v turned as y is turned onto `up`, by the smallest rotation (Rodrigues): with z up, front looks along +y, as in CAD.
Vec3d turn_up(const Vec3d& v, const Vec3d& up) {
  const Vec3d axis = cross(Vec3d{0, 1, 0}, up);
  if (up.y < -1 + 1e-9) {
    return {v.x, -v.y, -v.z};
  }
  return (v * up.y + cross(axis, v)) + axis * (dot(axis, v) / (1 + up.y));
}

// The smallest and largest distance of the scene along the view direction.
struct DepthRange {
  double nearest, farthest;
};
DepthRange depth_range(const View& view, const Extent& extent) {
  const std::array directions{-view.forward, view.forward};
  std::array<double, 2> reach{};
  extent.reach(directions, reach);
  const double eye = dot(view.eye, view.forward);
  return {-reach[0] - eye, reach[1] - eye};
}

// Near and far planes that hold the bounds, unless the camera states them.
Result<void> choose_depths(View& view, const Camera& camera, const Extent& extent) {
  const DepthRange range = depth_range(view, extent);
  // A flat scene seen straight on has no size in depth: the planes must still be many floats apart.
  const double size = std::max(range.farthest - range.nearest, 1e-3 * std::max(std::abs(range.farthest), std::abs(range.nearest)));
  const double slack = size > 0 ? 0.01 * size : 1;
  view.far = camera.far.value_or(std::max(range.farthest + slack, camera.near.value_or(0) + slack));
  if (view.projection == Projection::perspective) {
    // Depth is kept as a float 1/w, whose relative precision is the same at every distance: a small near plane costs nothing.
    view.far = std::max(view.far, camera.far ? 0.0 : slack);
    // Half the way leaves room before the first triangle, so that renderers which cull by boxes need not clip there.
    view.near = camera.near.value_or(std::max(range.nearest * 0.5, 1e-5 * view.far));
    if (!camera.near && view.near >= view.far) {
      view.near = 1e-5 * view.far;
    }
  } else {
    view.near = camera.near.value_or(std::min(range.nearest - slack, view.far - slack));
  }
  if (!(view.near < view.far)) {
    return fail(ErrorKind::usage, "camera.near", "the near plane must lie before the far plane");
  }
  if (view.projection == Projection::perspective && !(view.near > 0)) {
    return fail(ErrorKind::usage, "camera.near", "a perspective camera needs a near plane greater than 0");
  }
  return {};
}

// The smallest pyramid (perspective) or prism (orthographic) along the view axes that holds the scene: with slope t, a point is inside where
// |x - cx| <= t (d - z), z towards the eye. So d and cx follow from the reach of x + t z and of -x + t z. Exact for every set of points.
struct Framing {
  Vec3d shift;      // of the target, to the middle
  double distance;  // of the eye from the shifted target, perspective
  double height;    // of the image, orthographic
};
Framing frame(const View& view, const Extent& extent, double tan_x, double tan_y, double aspect, bool may_shift) {
  const bool is_perspective = view.projection == Projection::perspective;
  const double tx = is_perspective ? tan_x / kMargin : 0;
  const double ty = is_perspective ? tan_y / kMargin : 0;
  const Vec3d toward_eye = -view.forward;
  const std::array directions{view.right + toward_eye * tx, -view.right + toward_eye * tx, view.up + toward_eye * ty, -view.up + toward_eye * ty,
                              toward_eye};
  std::array<double, 5> reach{};
  extent.reach(directions, reach);
  for (std::size_t i = 0; i < 5; ++i) {
    reach[i] -= dot(directions[i], view.target);
  }
  Framing framing{};
  if (may_shift) {
    framing.shift = view.right * ((reach[0] - reach[1]) / 2) + view.up * ((reach[2] - reach[3]) / 2);
    reach[0] = reach[1] = (reach[0] + reach[1]) / 2;
    reach[2] = reach[3] = (reach[2] + reach[3]) / 2;
  }
  const double half_width = std::max(reach[0], reach[1]);
  const double half_height = std::max(reach[2], reach[3]);
  if (is_perspective) {
    framing.distance = std::max({half_width / tx, half_height / ty, reach[4] * 1.02});
  } else {
    framing.height = 2 * kMargin * std::max(half_width / aspect, half_height);
    framing.distance = reach[4] + framing.height;  // outside the scene, so that point lights' V and fog look as one expects
  }
  framing.distance = framing.distance > 0 ? framing.distance : 1;
  framing.height = framing.height > 0 ? framing.height : 1;
  return framing;
}

Result<void> choose_axes(View& view, const std::optional<Vec3d>& stated_up, const Vec3d& to_target, const Vec3d& default_up) {
  const double distance = length(to_target);
  if (!(distance > 0) || !std::isfinite(distance)) {
    return fail(ErrorKind::usage, "camera.eye", "the eye is at the target, so there is no direction to look in");
  }
  view.forward = to_target * (1 / distance);
  Vec3d up = stated_up.value_or(default_up);
  const double up_length = length(up);
  Vec3d right = cross(view.forward, up);
  if (!stated_up && length(right) <= 1e-9 * up_length) {  // looking straight up or down: any fixed choice
    up = {0, 0, view.forward.y > 0 ? 1.0 : -1.0};
    right = cross(view.forward, up);
  }
  if (!(length(right) > 1e-9 * up_length)) {
    return fail(ErrorKind::usage, "camera.up", "up is zero or parallel to the view direction");
  }
  view.right = normalize(right);
  view.up = cross(view.right, view.forward);
  return {};
}

}  // namespace

Extent extent_of(const Bounds& bounds) {
  return {bounds, [bounds](std::span<const Vec3d> directions, std::span<double> reach) {
            for (std::size_t i = 0; i < directions.size(); ++i) {
              const Vec3d& d = directions[i];
              reach[i] = dot(d, Vec3d{d.x > 0 ? bounds.upper.x : bounds.lower.x, d.y > 0 ? bounds.upper.y : bounds.lower.y,
                                      d.z > 0 ? bounds.upper.z : bounds.lower.z});
            }
          }};
}

Result<View> make_view(const Camera& camera, const ImageSettings& image, const Extent& scene_extent) {
  Bounds origin;
  origin.include({0, 0, 0});
  const Extent extent = scene_extent.bounds.is_empty() ? extent_of(origin) : scene_extent;

  View view;
  view.width = image.width;
  view.height = image.height;
  view.samples = image.samples;
  view.projection = camera.projection;
  const double aspect = static_cast<double>(image.width) / image.height;
  const double tan_y = tangent(radians(camera.fov) / 2);

  view.target = camera.target.value_or(extent.bounds.center());
  Direction direction = preset(camera.view);
  if (camera.up && length(*camera.up) > 0) {  // named views mean the sides of the scene as it stands upright
    const Vec3d up = normalize(*camera.up);
    direction = {turn_up(direction.to_eye, up), turn_up(direction.up, up)};
  }
  const Vec3d to_target = camera.eye ? view.target - *camera.eye : -direction.to_eye;
  if (auto axes = choose_axes(view, camera.eye ? camera.up : std::nullopt, to_target, camera.eye ? Vec3d{0, 1, 0} : direction.up); !axes) {
    return tl::unexpected(axes.error());
  }
  const Framing framing = frame(view, extent, tan_y * aspect, tan_y, aspect, !camera.eye && !camera.target);
  view.target = view.target + framing.shift;
  view.eye = camera.eye ? *camera.eye : view.target - view.forward * framing.distance;
  const double height = camera.height.value_or(framing.height);
  if (auto depths = choose_depths(view, camera, extent); !depths) {
    return tl::unexpected(depths.error());
  }

  view.pixels_per_unit = view.projection == Projection::perspective ? image.height / (2 * tan_y) : image.height / height;
  complete_view(view);
  return view;
}

void complete_view(View& view) {
  view.center_x = static_cast<float>(view.width) * 0.5F;
  view.center_y = static_cast<float>(view.height) * 0.5F;
  view.ray_center = vec_cast<float>(view.forward);
  view.ray_dx = vec_cast<float>(view.right * (1 / view.pixels_per_unit));
  view.ray_dy = vec_cast<float>(view.up * (-1 / view.pixels_per_unit));
  view.depth_near = static_cast<float>(view.near);
  view.depth_far = static_cast<float>(view.far);
}

AffineRows image_rows(const Mat4& world_from_object, const View& view) {
  const Mat4& m = world_from_object;
  const std::array<Vec3d, 3> rows{Vec3d{m(0, 0), m(0, 1), m(0, 2)}, Vec3d{m(1, 0), m(1, 1), m(1, 2)}, Vec3d{m(2, 0), m(2, 1), m(2, 2)}};
  const Vec3d translation = Vec3d{m(0, 3), m(1, 3), m(2, 3)} - view.eye;
  const std::array<Vec3d, 3> axes{view.right * view.pixels_per_unit, view.up * -view.pixels_per_unit, view.forward};
  std::array<Vec3d, 3> image;
  std::array<double, 3> offset{};
  for (std::size_t i = 0; i < 3; ++i) {
    image[i] = (rows[0] * axes[i].x + rows[1] * axes[i].y) + rows[2] * axes[i].z;
    offset[i] = dot(axes[i], translation);
  }
  return to_rows(image, {offset[0], offset[1], offset[2]});
}

std::array<Light, 3> default_rig(const View& view) {
  const auto directional = [&view](const char* name, Vec3d from, Vec3f color, float specular) {
    Light light;
    light.name = name;
    light.direction = -(view.right * from.x + view.up * from.y - view.forward * from.z);
    light.diffuse = {color};
    light.specular = {color * specular};
    return light;
  };
  return {
      directional("key", {-0.55, 0.75, 1.0}, {0.88F, 0.86F, 0.82F}, 1.0F),
      directional("fill", {1.0, 0.1, 0.5}, {0.16F, 0.18F, 0.22F}, 0.3F),
      directional("rim", {0.45, 0.6, -1.0}, {0.35F, 0.36F, 0.40F}, 0.6F),
  };
}

}  // namespace lustro
