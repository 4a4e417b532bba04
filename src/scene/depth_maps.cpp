// See depth_maps.hpp. A parallel map is fitted around all that is drawn, the other ones look from the light's place.
#include "scene/depth_maps.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/prepare.hpp"

namespace lustro {
namespace {

constexpr double kWidestCone = 0.5;                         // cosine: what a wider spot sees does not fit one picture well
constexpr std::size_t kMostTexels = std::size_t{1} << 30U;  // 4 GiB

View face_view(Projection projection, int size) {
  View view;
  view.width = view.height = size;
  view.samples = 1;
  view.projection = projection;
  return view;
}

// Any axes at right angles to a direction.
void choose_axes(View& view, const Vec3d& forward) {
  const Vec3d aside = std::abs(forward.y) < 0.9 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
  view.forward = forward;
  view.right = normalize(cross(forward, aside));
  view.up = cross(view.right, forward);
}

// A face's share of a map: from points relative to the eye to the face's image coordinates from its centre, and depth.
AffineRows place_on(const View& view, const Vec3d& eye) {
  return image_rows({.m = {1, 0, 0, eye.x, 0, 1, 0, eye.y, 0, 0, 1, eye.z, 0, 0, 0, 1}}, view);
}

// Texels at a face's edges that show nothing but what a look-up reaches beyond what the map is for.
int margin_of(const ShadowSettings& settings, int size) {
  return std::min(2 * settings.softness + 3, size / 4);
}

void add_face(View view, DepthMaps& shadows, std::size_t& texels) {
  complete_view(view);
  shadows.faces.push_back({view, texels});
  texels += static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.width);
}

void plan_parallel(const ShadowSettings& settings, const ShadingLight& light, const Extent& extent, const Vec3d& eye, DepthMap& map,
                   DepthMaps& shadows, std::size_t& texels) {
  View view = face_view(Projection::orthographic, map.size);
  choose_axes(view, normalize(vec_cast<double>(light.travel)));
  const std::array directions{view.right, -view.right, view.up, -view.up, view.forward, -view.forward};
  std::array<double, 6> reach{};
  extent.reach(directions, reach);
  const auto middle = [&](std::size_t i) { return (reach[i] - reach[i + 1]) / 2; };
  const double depth = reach[4] + reach[5];
  double side = std::max(reach[0] + reach[1], reach[2] + reach[3]);
  side = std::max({side, 1e-6 * depth, 1e-6 * (std::abs(middle(0)) + std::abs(middle(2)))});  // a scene may be a point, seen from the light
  side = side > 0 ? side : 1;
  const double slack = 0.125 * std::max(depth, side);  // boxes around parts of what is drawn stick out of it, and are to be before the eye
  view.eye = ((view.right * middle(0) + view.up * middle(2)) + view.forward * (-reach[5] - 2 * slack));
  view.target = view.eye + view.forward;
  view.near = slack;
  view.far = depth + 3 * slack;
  view.pixels_per_unit = (map.size - 2 * margin_of(settings, map.size)) / side;
  map.texels = static_cast<float>(view.pixels_per_unit);
  map.nearest = static_cast<float>(view.near);
  map.farthest = static_cast<float>(view.far);
  map.key_scale = 1 / (map.farthest - map.nearest);
  map.place = place_on(view, eye);
  add_face(view, shadows, texels);
}

// The distance to what is farthest, at most.
double farthest_from(const Vec3d& place, const Bounds& bounds) {
  const auto most = [](double p, double lower, double upper) { return std::max(std::abs(p - lower), std::abs(upper - p)); };
  const double farthest = length(Vec3d{most(place.x, bounds.lower.x, bounds.upper.x), most(place.y, bounds.lower.y, bounds.upper.y),
                                       most(place.z, bounds.lower.z, bounds.upper.z)});
  return farthest > 0 ? farthest : 1;
}

void plan_pyramids(const ShadowSettings& settings, const ShadingLight& light, const Extent& extent, const Vec3d& eye, DepthMap& map,
                   DepthMaps& shadows, std::size_t& texels) {
  View view = face_view(Projection::perspective, map.size);
  view.eye = vec_cast<double>(light.position) + eye;
  view.far = 1.001 * farthest_from(view.eye, extent.bounds);
  view.near = 1e-5 * view.far;  // keys have the same relative precision at every depth
  const bool is_cone = map.shape == DepthShape::cone;
  const auto cosine = static_cast<double>(light.cos_cutoff);
  const double slope = is_cone ? std::sqrt(std::max(0.0, 1 - cosine * cosine)) / cosine : 1;
  view.pixels_per_unit = (0.5 * map.size - margin_of(settings, map.size)) / std::max(slope, 1e-3);
  map.texels = static_cast<float>(view.pixels_per_unit);
  map.nearest = static_cast<float>(view.near);
  map.farthest = static_cast<float>(view.far);
  if (is_cone) {
    choose_axes(view, normalize(vec_cast<double>(light.travel)));
    view.target = view.eye + view.forward;
    map.place = place_on(view, eye);
    add_face(view, shadows, texels);
    return;
  }
  const Vec3f to_light = -light.position;
  map.place.m = {1, 0, 0, to_light.x, 0, 1, 0, to_light.y, 0, 0, 1, to_light.z};
  constexpr std::array kAxes{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {  // as depth_plane() numbers them
      view.forward = kAxes[axis] * side;
      view.right = kAxes[(axis + 1) % 3];
      view.up = -kAxes[(axis + 2) % 3];
      view.target = view.eye + view.forward;
      add_face(view, shadows, texels);
    }
  }
}

}  // namespace

Result<void> plan_shadows(const ShadowSettings& settings, std::span<const ShadingLight> lights, const Extent& extent, const Vec3d& eye,
                          DepthMaps& shadows) {
  shadows.clear();
  std::size_t texels = 0;
  for (const ShadingLight& light : lights) {
    DepthMap& map = shadows.maps.emplace_back();
    if (!light.has_shadow) {
      continue;
    }
    map.softness = settings.softness;
    if (light.type == LightType::directional) {
      map.shape = DepthShape::parallel;
    } else {
      const bool is_narrow = light.type == LightType::spot && static_cast<double>(light.cos_cutoff) >= kWidestCone;
      map.shape = is_narrow ? DepthShape::cone : DepthShape::cube;
    }
    // Room for a look-up, whatever is asked for.
    map.size = std::max(map.shape == DepthShape::cube ? settings.size / 2 : settings.size, 4 * (2 * settings.softness + 3));
    if (map.shape == DepthShape::parallel) {
      plan_parallel(settings, light, extent, eye, map, shadows, texels);
    } else {
      plan_pyramids(settings, light, extent, eye, map, shadows, texels);
    }
    if (texels > kMostTexels) {
      return fail(ErrorKind::limit, "shadow.size", "the maps of all lights together have more than 2^30 texels");
    }
  }
  return {};
}

std::size_t texel_count(const DepthMaps& maps) {
  if (maps.faces.empty()) {
    return 0;
  }
  const DepthFace& last = maps.faces.back();
  return last.first + static_cast<std::size_t>(last.view.width) * static_cast<std::size_t>(last.view.height);
}

void bind_keys(DepthMaps& maps) {
  auto face = maps.faces.begin();
  for (DepthMap& map : maps.maps) {
    if (map.shape != DepthShape::none) {
      map.keys = &maps.keys[face->first];
      face += map.shape == DepthShape::cube ? 6 : 1;
    }
  }
}

void make_casters(const PreparedScene& scene, PreparedScene& casters) {
  constexpr float kHalf = 0.5F;
  casters.shading = scene.shading;
  casters.transfer = scene.transfer;
  casters.triangle_count = scene.triangle_count;
  casters.instances = scene.instances;
  for (Instance& instance : casters.instances) {
    instance.cull = Culling::none;
    instance.has_mixed_culling = false;
    if ((instance.alpha_modes & bit_of(AlphaMode::blend)) != 0) {
      instance.alpha_modes = static_cast<AlphaModes>((instance.alpha_modes & ~bit_of(AlphaMode::blend)) | bit_of(AlphaMode::mask));
    }
  }
  casters.materials.resize(scene.materials.size());
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    ShadingMaterial& material = casters.materials[i];
    material.cull = Culling::none;
    material.opacity = scene.materials[i].opacity;
    material.opacity.catches = 0;  // nor does it throw any
    if (material.opacity.mode == AlphaMode::blend) {
      material.opacity.mode = AlphaMode::mask;
      material.opacity.cutoff = kHalf;
    }
  }
}

void look_from(PreparedScene& casters, const View& view) {
  casters.view = view;
  for (Instance& instance : casters.instances) {
    instance.image_from_object = image_rows(instance.world_from_object, view);
  }
}

}  // namespace lustro
