// See emitters.hpp. Powers are luminances times areas times pi; they decide how often an emitter is chosen, and nothing else.
#include "path/emitters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "path/bsdf.hpp"

namespace lustro {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

float area_of(const AreaLight& light) {
  switch (light.type) {
    case LightType::rectangle:
      return 4.0F * light.half_width * light.half_height;
    case LightType::sphere:
      return 4.0F * kPiF * light.radius * light.radius;
    default:
      return kPiF * light.radius * light.radius;
  }
}

float brightest(const AreaLight& light) {
  return std::max(luminance_of(light.diffuse), luminance_of(light.specular));
}

// What a triangle's material emits before maps and vertex colours, which vary over it.
float luminance_of_emission(const ShadingMaterial& material) {
  const Coefficients<float>& k = material.coefficients;
  return luminance_of(material.lighting == Lighting::constant ? k.diffuse : k.emission);
}

float area_of(const PlacedTriangle& triangle) {
  return 0.5F * length(cross(triangle.b - triangle.a, triangle.c - triangle.a));
}

// Of a square unit, from both sides.
float power_of(const ShadingMaterial& material) {
  return luminance_of_emission(material) * (2 * kPiF);
}

// The square of the radius of a ball around all vertices.
float squared_radius(const PreparedScene& scene) {
  Vec3f lower{kInfinity, kInfinity, kInfinity};
  Vec3f upper{-kInfinity, -kInfinity, -kInfinity};
  for (const Instance& instance : scene.instances) {
    for (const Vec3f& stated : instance.mesh->positions) {
      const Vec3f p = instance.relative_from_object(stated);
      lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
      upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
    }
  }
  const Vec3f half = (upper - lower) * 0.5F;
  return dot(half, half);
}

// 1 - cos of the half angle under which a ball of squared radius r2 is seen over the squared distance d2 > r2; exact for small ones.
float cap_of(float r2, float d2) {
  const float sine2 = r2 / d2;
  return sine2 / (1.0F + safe_root(1.0F - sine2));
}

EmitterSample sample_area(const AreaLight& light, const Vec3f& position, const Vec2f& u) {
  EmitterSample sample{.diffuse = light.diffuse, .specular = light.specular};
  if (light.type == LightType::sphere) {
    const Vec3f to_center = light.center - position;
    const float d2 = dot(to_center, to_center);
    const float r2 = light.radius * light.radius;
    if (!(d2 > r2)) {
      return sample;  // inside, where it is dark
    }
    const float cap = cap_of(r2, d2);
    const Vec3f local = sample_cone(cap, u);
    sample.to_light = Frame3(to_center * (1.0F / std::sqrt(d2))).world(local);
    const float along = std::sqrt(d2) * local.z;
    sample.distance = along - safe_root(r2 - d2 * (local.x * local.x + local.y * local.y));
    sample.density = 1.0F / (2 * kPiF * cap);
    return sample;
  }
  Vec2f at{(2.0F * u.x - 1.0F) * light.half_width, (2.0F * u.y - 1.0F) * light.half_height};
  if (light.type == LightType::disk) {
    const Vec2f disk = sample_disk(u);
    at = {disk.x * light.radius, disk.y * light.radius};
  }
  const Vec3f way = (light.center + (light.x_axis * at.x + light.y_axis * at.y)) - position;
  const float d2 = dot(way, way);
  if (!(d2 > 0)) {
    return sample;
  }
  sample.distance = std::sqrt(d2);
  sample.to_light = way * (1.0F / sample.distance);
  const float cosine = -dot(light.normal, sample.to_light);
  sample.density = cosine > 0 ? d2 / (cosine * area_of(light)) : 0.0F;
  return sample;
}

}  // namespace

Emitters::Emitters(const PreparedScene& scene) : scene_(&scene) {
  std::vector<float> powers;
  for (const AreaLight& light : scene.area_lights) {
    powers.push_back(brightest(light) * area_of(light) * kPiF);
  }
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const auto count = static_cast<std::uint32_t>(instance.mesh->triangles.size());
    for (std::uint32_t t = 0; t < count; ++t) {
      const ShadingMaterial& material = scene.materials[instance.material_of(t)];
      if (luminance_of_emission(material) > 0) {
        Shining shining{.id = {i, t}, .placed = placed_triangle(scene, i, t)};
        shining.area = area_of(shining.placed);
        shining.is_plain = is_solid(material) && material.maps.present == 0 && instance.drawable->colors.empty();
        shining.emission = material.lighting == Lighting::constant ? material.coefficients.diffuse : material.coefficients.emission;
        powers.push_back(power_of(material) * shining.area);
        triangles_.push_back(shining);
      }
    }
  }
  if (scene.environment) {
    sky_.emplace(*scene.environment);
    powers.push_back(sky_->power() * kPiF * squared_radius(scene));
  }
  choice_ = Choice(powers);
  all_power_ = choice_.total();
  inverse_power_ = all_power_ > 0 ? static_cast<float>(1 / all_power_) : 0.0F;
}

EmitterSample Emitters::sample(const Vec3f& position, const Vec2f& u) const {
  const Choice::Chosen chosen = choice_.choose(u.x);
  const Vec2f rest{chosen.rest, u.y};
  EmitterSample sample;
  std::size_t i = chosen.index;
  if (i < scene_->area_lights.size()) {
    sample = sample_area(scene_->area_lights[i], position, rest);
  } else if (i -= scene_->area_lights.size(); i < triangles_.size()) {
    sample = sample_triangle_of(triangles_[i], position, rest);
  } else {
    const SkySample sky = sky_->sample(rest);
    const Vec3f radiance = sky.density > 0 ? sky_->radiance(sky.direction) : Vec3f{};
    sample = {sky.direction, kInfinity, radiance, radiance, sky.density, {}, {}};
  }
  sample.density *= chosen.probability;
  return sample;
}

EmitterSample Emitters::sample_triangle_of(const Shining& triangle, const Vec3f& position, const Vec2f& u) const {
  const Vec3f w = sample_triangle(u);
  const PlacedTriangle& placed = triangle.placed;
  EmitterSample sample;
  const Vec3f on_it = (placed.a + (placed.b - placed.a) * w.y) + (placed.c - placed.a) * w.z;
  const Vec3f way = on_it - position;
  const float d2 = dot(way, way);
  if (!(d2 > 0)) {
    return sample;
  }
  sample.distance = std::sqrt(d2);
  sample.triangle = triangle.id;
  sample.to_light = way * (1.0F / sample.distance);
  const float slope = dot(placed.normal, sample.to_light);
  const float cosine = std::abs(slope);
  if (!(cosine > 0)) {
    return sample;
  }
  sample.end = on_it + placed.normal * (slope < 0 ? placed.offset : -placed.offset);
  if (triangle.is_plain) {
    sample.diffuse = triangle.emission;
  } else {
    const SurfacePlace place = place_of(*scene_, {0, triangle.id.instance, triangle.id.triangle, w.y, w.z}, placed, sample.to_light, false);
    if (is_culled(place)) {
      return sample;
    }
    sample.diffuse = emission_of(place) * opacity_at(place, -sample.to_light);
  }
  sample.specular = sample.diffuse;
  sample.density = d2 / (cosine * triangle.area);
  return sample;
}

// The area of the triangle, by which it is chosen and by which its points are, cancels.
float Emitters::density_of(const SurfacePlace& place, const Vec3f& position) const {
  const float power = power_of(place.face.material);
  const Vec3f way = place.position - position;
  const float d2 = dot(way, way);
  const float across = std::abs(dot(place.geometric_normal, way));
  return power > 0 && all_power_ > 0 && across > 0 ? power * inverse_power_ * (d2 * std::sqrt(d2) / across) : 0.0F;
}

std::optional<Emitters::Met> Emitters::meets_area(std::size_t i, const Vec3f& position, const Vec3f& direction, float farthest) const {
  const AreaLight& light = scene_->area_lights[i];
  const float chosen = choice_.probability(static_cast<std::uint32_t>(i));
  const Vec3f to_center = light.center - position;
  if (light.type == LightType::sphere) {
    const float d2 = dot(to_center, to_center);
    const float r2 = light.radius * light.radius;
    const float along = dot(to_center, direction);
    const Vec3f across = to_center - direction * along;
    const float missed2 = dot(across, across);
    if (!(d2 > r2) || !(along > 0) || !(missed2 < r2) || along - std::sqrt(r2 - missed2) > farthest) {
      return std::nullopt;
    }
    return Met{&light, chosen / (2 * kPiF * cap_of(r2, d2))};
  }
  const float cosine = -dot(light.normal, direction);
  const float height = -dot(light.normal, to_center);
  if (!(cosine > 0) || !(height > 0) || height > farthest * cosine) {
    return std::nullopt;
  }
  const float distance = height / cosine;
  const Vec3f at = direction * distance - to_center;
  const float x = dot(at, light.x_axis);
  const float y = dot(at, light.y_axis);
  const bool is_inside = light.type == LightType::disk ? x * x + y * y <= light.radius * light.radius
                                                       : std::abs(x) <= light.half_width && std::abs(y) <= light.half_height;
  if (!is_inside) {
    return std::nullopt;
  }
  return Met{&light, chosen * distance * distance / (cosine * area_of(light))};
}

float Emitters::density_of_sky(const Vec3f& direction) const {
  const auto index = static_cast<std::uint32_t>(scene_->area_lights.size() + triangles_.size());
  return sky_ && !choice_.is_empty() ? choice_.probability(index) * sky_->density(direction) : 0.0F;
}

}  // namespace lustro
