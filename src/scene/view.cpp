// Camera, framing and the default light rig.
#include "scene/view.hpp"

#include <algorithm>
#include <array>

#include "math/trig.hpp"

namespace lustro {
namespace {

constexpr double kMargin = 1.04;  // the framed object leaves 2 % of the image free on each side

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

std::array<Vec3d, 8> corners(const Bounds& bounds) {
  std::array<Vec3d, 8> result;
  for (std::size_t i = 0; i < 8; ++i) {
    result[i] = {(i & 1U) != 0 ? bounds.upper.x : bounds.lower.x, (i & 2U) != 0 ? bounds.upper.y : bounds.lower.y,
                 (i & 4U) != 0 ? bounds.upper.z : bounds.lower.z};
  }
  return result;
}

// The smallest and largest distance of the bounds along the view direction.
struct DepthRange {
  double nearest, farthest;
};
DepthRange depth_range(const View& view, const Bounds& bounds) {
  DepthRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Vec3d& corner : corners(bounds)) {
    const double depth = dot(corner - view.eye, view.forward);
    range.nearest = std::min(range.nearest, depth);
    range.farthest = std::max(range.farthest, depth);
  }
  return range;
}

// Near and far planes that hold the bounds, unless the camera states them.
Result<void> choose_depths(View& view, const Camera& camera, const Bounds& bounds) {
  const DepthRange range = depth_range(view, bounds);
  const double size = std::max(range.farthest - range.nearest, 1e-6 * std::max(std::abs(range.farthest), std::abs(range.nearest)));
  const double slack = size > 0 ? 0.01 * size : 1;
  view.far = camera.far.value_or(std::max(range.farthest + slack, camera.near.value_or(0) + slack));
  if (view.projection == Projection::perspective) {
    // Depth is kept as a float 1/w, whose relative precision is the same at every distance: a small near plane costs nothing.
    view.far = std::max(view.far, camera.far ? 0.0 : slack);
    view.near = camera.near.value_or(std::max(range.nearest - slack, 1e-5 * view.far));
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

// How far the eye must stand from the target (perspective), or how high the image must be (orthographic), to show the bounds.
double distance_to_frame(const View& view, const Bounds& bounds, double tan_x, double tan_y) {
  double distance = 0;
  for (const Vec3d& corner : corners(bounds)) {
    const Vec3d p = corner - view.target;
    const double toward_eye = -dot(p, view.forward);
    distance = std::max(distance, toward_eye + kMargin * std::max(std::abs(dot(p, view.right)) / tan_x, std::abs(dot(p, view.up)) / tan_y));
  }
  return distance > 0 ? distance : 1;
}
double height_to_frame(const View& view, const Bounds& bounds, double aspect) {
  double height = 0;
  for (const Vec3d& corner : corners(bounds)) {
    const Vec3d p = corner - view.target;
    height = std::max(height, 2 * kMargin * std::max(std::abs(dot(p, view.right)) / aspect, std::abs(dot(p, view.up))));
  }
  return height > 0 ? height : 1;
}

Result<void> choose_axes(View& view, const Camera& camera, const Vec3d& to_target, const Vec3d& default_up) {
  const double distance = length(to_target);
  if (!(distance > 0) || !std::isfinite(distance)) {
    return fail(ErrorKind::usage, "camera.eye", "the eye is at the target, so there is no direction to look in");
  }
  view.forward = to_target * (1 / distance);
  Vec3d up = camera.up.value_or(default_up);
  const double up_length = length(up);
  Vec3d right = cross(view.forward, up);
  if (!camera.up && length(right) <= 1e-9 * up_length) {  // looking straight up or down: any fixed choice
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

Result<View> make_view(const Camera& camera, const ImageSettings& image, const Bounds& world_bounds) {
  Bounds bounds = world_bounds;
  if (bounds.is_empty()) {
    bounds.include({0, 0, 0});
  }
  View view;
  view.width = image.width;
  view.height = image.height;
  view.samples = image.samples;
  view.projection = camera.projection;
  const double aspect = static_cast<double>(image.width) / image.height;
  const double tan_y = tangent(radians(camera.fov) / 2);

  view.target = camera.target.value_or(bounds.center());
  const Direction direction = preset(camera.view);
  const Vec3d to_target = camera.eye ? view.target - *camera.eye : -direction.to_eye;
  if (auto axes = choose_axes(view, camera, to_target, camera.eye ? Vec3d{0, 1, 0} : direction.up); !axes) {
    return tl::unexpected(axes.error());
  }

  double height = camera.height.value_or(0);
  if (!camera.height) {
    height = height_to_frame(view, bounds, aspect);
  }
  if (camera.eye) {
    view.eye = *camera.eye;
  } else {
    // An orthographic eye may stand anywhere on its axis; outside the bounds it serves point-light distances and fog like a perspective one.
    const double distance = distance_to_frame(view, bounds, view.projection == Projection::perspective ? tan_y * aspect : 0.5 * aspect,
                                              view.projection == Projection::perspective ? tan_y : 0.5);
    view.eye = view.target - view.forward * distance;
  }
  if (auto depths = choose_depths(view, camera, bounds); !depths) {
    return tl::unexpected(depths.error());
  }

  view.pixels_per_unit = view.projection == Projection::perspective ? image.height / (2 * tan_y) : image.height / height;
  view.center_x = static_cast<float>(image.width) * 0.5F;
  view.center_y = static_cast<float>(image.height) * 0.5F;
  view.ray_center = vec_cast<float>(view.forward);
  view.ray_dx = vec_cast<float>(view.right * (1 / view.pixels_per_unit));
  view.ray_dy = vec_cast<float>(view.up * (-1 / view.pixels_per_unit));
  view.depth_near = static_cast<float>(view.near);
  view.depth_far = static_cast<float>(view.far);
  return view;
}

std::vector<Light> default_rig(const View& view) {
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
