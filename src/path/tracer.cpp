// A path from the eye: at each surface it meets, light is asked for directly, from every light without a size and from one emitter that is
// chosen by power; then the path goes on where the surface may scatter light from, and what it meets there is weighted against what was asked
// for.
//
// source  Kajiya 1986, The rendering equation; Veach 1997, chapters 8 to 10 (next-event estimation, multiple importance sampling, Russian
// roulette)
#include "path/tracer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "path/bsdf.hpp"
#include "shade/fog.hpp"
#include "shade/reflection.hpp"

namespace lustro {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kSureBounces = 3;  // before Russian roulette
constexpr float kMostSurvival = 0.95F;

// Pairs of dimensions: the pixel's, then so many a bounce.
constexpr std::uint32_t kPixelPair = 0, kDirectionPair = 1, kLightPair = 2, kChoicePair = 3, kRoulettePair = 4, kPairsOfBounce = 4;
constexpr std::uint32_t kOpacityPairs = 0x10000;  // beyond any bounce: one for every surface that is passed through

Vec3f moved_off(const SurfacePlace& place, const Vec3f& direction) {
  const float side = dot(place.geometric_normal, direction) < 0 ? -place.offset : place.offset;
  return place.position + place.geometric_normal * side;
}

float largest(const Vec3f& v) {
  return std::max({v.x, v.y, v.z});
}

}  // namespace

// The state of a path between two surfaces.
struct PathTracer::Walk {  // NOLINT(cppcoreguidelines-pro-type-member-init): an aggregate, made with its random numbers
  PathRandom random;
  std::uint64_t& rays;
  Vec3f radiance{};
  Vec3f diffuse{1, 1, 1}, specular{};   // what of light reaches the eye: of the colour that diffuse surfaces see, that highlights see
  Vec3f origin{}, direction{};          // of the last ray; unit
  std::optional<SurfacePlace> place{};  // where it ended
  float density = 0;                    // with which its direction was chosen
  bool is_direct = true;                // no light was asked for at its begin: the camera's, or a mirror's
  bool is_camera = true;                // the eye sees it, if through surfaces that let it pass
  bool sees_background = true;          // through surfaces that let it pass or refract it
  int bounce = 0;
  std::uint32_t passed = 0;

  [[nodiscard]] std::uint32_t pair(std::uint32_t which) const { return static_cast<std::uint32_t>(bounce) * kPairsOfBounce + which; }
  [[nodiscard]] Vec3f both() const { return diffuse + specular; }
};

PathTracer::PathTracer(const PreparedScene& scene, const RayScene& rays, PathOptions options)
    : scene_(&scene), rays_(&rays), options_(std::move(options)), emitters_(scene) {
  for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
    if (!is_area(scene.stated_lights[i].type)) {
      delta_lights_.push_back(i);
    }
  }
  is_solid_ = std::all_of(scene.materials.begin(), scene.materials.end(), is_solid);
}

// Direction unit; between the near and the far plane.
Ray PathTracer::camera_ray(float x, float y) const {
  const View& view = scene_->view;
  if (view.projection == Projection::orthographic) {
    return {view.point_at(x, y, 0.0F), view.ray_center, view.depth_near, view.depth_far};
  }
  const Vec3f at_one = view.point_at(x, y, 1.0F);
  const float size = length(at_one);
  return {{}, at_one * (1.0F / size), view.depth_near * size, view.depth_far * size};
}

// The next surface that is really there: sides that are left out and shares that are seen through are passed. Leaves it in walk.place.
bool PathTracer::find_surface(Walk& walk, Ray ray) const {
  walk.origin = ray.origin;
  walk.direction = ray.direction;
  RayHit hit;
  while (true) {
    ++walk.rays;
    if (!rays_->closest(ray, hit)) {
      walk.place.reset();
      return false;
    }
    const bool lights_back = !walk.is_camera || scene_->shading.two_sided;
    const SurfacePlace& place = walk.place.emplace(place_of(*scene_, hit, rays_->met(hit), ray.direction, lights_back));
    if (is_solid_ || is_solid(place.face.material)) {
      return true;
    }
    if (!is_culled(place)) {
      const float opacity = opacity_at(place, -ray.direction);
      if (opacity >= 1 || (opacity > 0 && walk.random.one(kOpacityPairs + walk.passed++) < opacity)) {
        return true;
      }
    }
    const float cosine = std::abs(dot(place.geometric_normal, ray.direction));
    ray.nearest = hit.distance + place.offset / std::max(cosine, 0.01F);
  }
}

// What of light from `distance` away along `direction` arrives at the walk's place. Where nothing can be seen through, a triangle that shines is
// asked for by a place just before it, so that at no angle it stands in its own way. Else it is met by the ray itself, and since rounding puts
// it a little nearer or farther than it is, it is known by its number, its neighbours by their distance.
float PathTracer::transmittance(Walk& walk, const Vec3f& direction, float distance, const EmitterSample* light) const {
  const bool to_triangle = light != nullptr && light->triangle != TriangleId{};
  Ray ray{moved_off(*walk.place, direction), direction, 0, distance};
  if (is_solid_) {
    ++walk.rays;
    if (to_triangle) {
      ray.direction = light->end - ray.origin;
      ray.farthest = 1;
    }
    return rays_->is_blocked(ray) ? 0.0F : 1.0F;
  }
  constexpr float kNeighbor = 1.0F - 0x1p-13F;
  float clear = 1;
  RayHit hit;
  while (clear > 0) {
    ++walk.rays;
    if (!rays_->closest(ray, hit) ||
        (to_triangle && (light->triangle == TriangleId{hit.instance, hit.triangle} || hit.distance > distance * kNeighbor))) {
      return clear;
    }
    const SurfacePlace place = place_of(*scene_, hit, rays_->met(hit), direction, true);
    clear *= is_culled(place) ? 1.0F : 1.0F - opacity_at(place, -direction);
    const float cosine = std::abs(dot(place.geometric_normal, direction));
    ray.nearest = hit.distance + place.offset / std::max(cosine, 0.01F);
  }
  return 0;
}

void PathTracer::add_sky(Walk& walk, PathResult& result) const {
  const Sky* const sky = emitters_.sky();
  const std::array<float, 4>& background = scene_->background;
  const bool shows_sky = sky != nullptr && (!walk.is_camera || scene_->environment->visible);
  if (walk.is_camera) {
    result.alpha = shows_sky && background[3] > 0 ? 1.0F : background[3];
    if (shows_sky && !(background[3] > 0)) {
      return;  // a transparent background shows nothing
    }
  }
  if (shows_sky) {
    const Vec3f radiance = sky->radiance(walk.direction);
    const float weight = walk.is_direct ? 1.0F : power_heuristic(walk.density, emitters_.density_of_sky(walk.direction));
    walk.radiance += walk.both() * radiance * weight;
  } else if (walk.sees_background) {
    walk.radiance += walk.both() * Vec3f{background[0], background[1], background[2]};
  }
}

// Those that the last ray met before its surface; they hide nothing.
void PathTracer::add_area_lights(Walk& walk, float farthest) const {
  for (std::size_t i = 0; i < emitters_.area_count(); ++i) {
    if (const auto met = emitters_.meets_area(i, walk.origin, walk.direction, farthest)) {
      const float weight = walk.is_direct ? 1.0F : power_heuristic(walk.density, met->density);
      walk.radiance += (walk.diffuse * met->light->diffuse + walk.specular * met->light->specular) * weight;
    }
  }
}

void PathTracer::add_emission(Walk& walk, const SurfacePoint& point) const {
  if (point.emission == Vec3f{}) {
    return;
  }
  const float weight = walk.is_direct ? 1.0F : power_heuristic(walk.density, emitters_.density_of(*walk.place, walk.origin));
  walk.radiance += walk.both() * point.emission * weight;
}

// Exactly as shade/lighting.hpp lights a surface, where nothing stands between.
void PathTracer::add_delta_lights(Walk& walk, const SurfacePoint& point) const {
  const Surface<float>& s = point.surface;
  const Vec3f seen = walk.both();
  for (const std::uint32_t i : delta_lights_) {
    const ShadingLight& light = scene_->lights[i];
    const std::span<const ShadingLight> only(&light, 1);
    const Incident<float> in = incident_light(light, s.position);
    if (!(dot(s.normal, in.to_light) > 0) || !(in.attenuation * in.spot > 0)) {
      continue;
    }
    const Terms<float> terms = light_surface(walk.place->face.material.lighting, s, point.k, Vec3f{}, only, scene_->shading.normalized,
                                             [](std::size_t, const Incident<float>&, const LightTerms<float>&) {});
    const Vec3f light_seen = seen * (terms.diffuse + terms.specular);
    if (!(largest(light_seen) > 0)) {
      continue;
    }
    const float distance = light.type == LightType::directional ? kInfinity : in.distance;
    const bool throws_shadows = scene_->stated_lights[i].shadow;
    walk.radiance += throws_shadows ? light_seen * transmittance(walk, in.to_light, distance, nullptr) : light_seen;
  }
}

// What stands for light from all around where no second surface is asked: the ambient terms and the reflection map.
void PathTracer::add_local_terms(Walk& walk, const SurfacePoint& point) const {
  const ShadingMaterial& material = walk.place->face.material;
  const Terms<float> terms = light_surface(material.lighting, point.surface, point.k, scene_->ambient, scene_->lights,
                                           scene_->shading.normalized, [](std::size_t, const Incident<float>&, const LightTerms<float>&) {});
  walk.radiance += walk.both() * terms.ambient;
  if (material.maps.reflects) {
    const DirectionSlopes<float> mirrored{reflect_about(point.surface.normal, point.surface.to_eye), {}, {}};
    walk.radiance += walk.both() * (point.k.specular * look_up_reflection<TexelReader>(material.reflection, mirrored));
  }
}

void PathTracer::add_emitter(Walk& walk, const SurfacePoint& point, const Bsdf& bsdf, const Vec2f& u) const {
  const EmitterSample light = emitters_.sample(point.surface.position, u);
  if (!(light.density > 0)) {
    return;
  }
  const Reflected reflected = bsdf.reflected(light.to_light);
  const Vec3f arriving = walk.both() * (reflected.diffuse * light.diffuse + reflected.specular * light.specular);
  if (!(largest(arriving) > 0)) {
    return;
  }
  const float weight = power_heuristic(light.density, bsdf.density(light.to_light)) * (kInversePiF / light.density);
  walk.radiance += arriving * (weight * transmittance(walk, light.to_light, light.distance, &light));
}

PathResult PathTracer::follow(int x, int y, std::uint32_t sample, std::uint64_t& rays) const {
  const std::uint32_t pixel = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(scene_->view.width) + static_cast<std::uint32_t>(x);
  Walk walk{.random = PathRandom(pixel, sample, options_.seed), .rays = rays};
  const Vec2f jitter = walk.random.pair(kPixelPair);
  Ray ray = camera_ray(static_cast<float>(x) + jitter.x, static_cast<float>(y) + jitter.y);
  PathResult result;
  bool is_fogged = scene_->fog.has_value();
  while (true) {
    const bool found = find_surface(walk, ray);
    if (!walk.is_camera && emitters_.area_count() > 0) {
      add_area_lights(walk, found ? dot(walk.place->position - walk.origin, walk.direction) : kInfinity);
    }
    if (!found) {
      add_sky(walk, result);
      break;
    }
    const SurfacePoint point = point_of(*walk.place, -walk.direction);
    if (walk.is_camera) {
      result.has_hit = true;
      result.alpha = 1;
    }
    if (is_fogged) {
      const Vec3f way = walk.is_camera ? point.surface.position : point.surface.position - walk.origin;
      const float clear = fog_factor(*scene_->fog, length(way));
      walk.radiance += walk.both() * (scene_->fog->color * (1.0F - clear));
      walk.diffuse = walk.diffuse * clear;
      walk.specular = walk.specular * clear;
    }
    add_emission(walk, point);
    const ShadingMaterial& material = walk.place->face.material;
    if (walk.bounce == options_.bounces || material.lighting == Lighting::constant) {
      break;
    }
    add_delta_lights(walk, point);
    if (options_.bounces == 1) {
      add_local_terms(walk, point);
    }
    const Bsdf bsdf(point, material, scene_->shading, walk.place->is_front);
    if (!emitters_.is_empty() && bsdf.is_rough()) {
      add_emitter(walk, point, bsdf, walk.random.pair(walk.pair(kLightPair)));
    }
    const float lobe = bsdf.has_choice() ? walk.random.one(walk.pair(kChoicePair)) : 0.0F;
    const ScatterSample next = bsdf.sample(lobe, walk.random.pair(walk.pair(kDirectionPair)));
    if (!(next.density > 0)) {
      break;
    }
    const Vec3f seen = walk.both();
    walk.diffuse = seen * next.weight.diffuse;
    walk.specular = seen * next.weight.specular;
    const float most = largest(walk.both());
    if (!(most > 0)) {
      break;
    }
    if (walk.bounce >= kSureBounces) {
      const float survival = std::min(most, kMostSurvival);
      if (!(walk.random.one(walk.pair(kRoulettePair)) < survival)) {
        break;
      }
      walk.diffuse = walk.diffuse * (1.0F / survival);
      walk.specular = walk.specular * (1.0F / survival);
    }
    walk.density = next.density;
    walk.is_direct = next.is_delta;
    walk.is_camera = false;
    walk.sees_background = walk.sees_background && next.passes;
    is_fogged = is_fogged && next.is_delta;
    ++walk.bounce;
    ray = {moved_off(*walk.place, next.direction), next.direction};
  }
  result.radiance = walk.radiance;
  return result;
}

}  // namespace lustro
