// Maps are looked up at their finest level: a pixel's many rays are what averages them.
#include "path/surface_point.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "scene/mapped_surface.hpp"
#include "shade/opacity.hpp"
#include "shade/texturing.hpp"

namespace lustro {
namespace {

// A footprint that is smaller than any texel, but has two directions: bumps are slopes.
constexpr float kTiny = 0x1p-20F;
constexpr WeightSlopes<float> kPoint{{-kTiny, kTiny, 0}, {-kTiny, 0, kTiny}};

Weights<float> weights_of(const Vec3f& w) {
  return {w.x, w.y, w.z};
}

// What the maps make of the coefficients.
Coefficients<float, LaneExponent<float>> coefficients_at(const SurfacePlace& place, const std::array<Footprint<float>, 2>& at,
                                                         MapFactors<float>& factors) {
  const ShadingMaterial& material = place.face.material;
  const Coefficients<float>& stated = material.coefficients;
  const Vec3f tint = place.face.tint(place.weights);
  Coefficients<float, LaneExponent<float>> k{
      stated.ambient * tint, stated.diffuse * tint, stated.specular, stated.emission, {stated.shininess.n}};
  if (material.maps.present != 0) {
    factors = map_factors<TexelReader>(material.maps, at);
    apply_factors(material.maps, factors, k);
    if (material.maps.has(MapKind::shininess)) {
      k.shininess = textured_shininess<TexelReader>(material.maps, at, stated.shininess.n);
    }
  }
  return k;
}

Vec3f emitted(const ShadingMaterial& material, const Coefficients<float, LaneExponent<float>>& k) {
  return material.lighting == Lighting::constant ? k.diffuse : k.emission;
}

}  // namespace

SurfacePlace place_of(const PreparedScene& scene, const RayHit& hit, const PlacedTriangle& placed, const Vec3f& direction, bool lights_back) {
  const Instance& instance = scene.instances[hit.instance];
  const bool is_front = dot(placed.normal, direction) < 0;
  return {.face = {scene, instance, scene.materials[instance.material_of(hit.triangle)], instance.mesh->triangles[hit.triangle],
                   !is_front && lights_back ? -1.0F : 1.0F},
          .weights = {(1.0F - hit.u) - hit.v, hit.u, hit.v},
          .position = (placed.a + (placed.b - placed.a) * hit.u) + (placed.c - placed.a) * hit.v,
          .geometric_normal = placed.normal,
          .offset = placed.offset,
          .is_front = is_front};
}

bool is_culled(const SurfacePlace& place) {
  return place.face.material.cull == (place.is_front ? Culling::front : Culling::back);
}

float opacity_at(const SurfacePlace& place, const Vec3f& to_eye) {
  const ShadingOpacity& stated = place.face.material.opacity;
  if (stated.mode == AlphaMode::opaque) {
    return 1;
  }
  const float opacity = opacity_on<TexelReader, float>(place.face, weights_of(place.weights), kPoint);
  if (stated.mode == AlphaMode::mask) {
    return opacity >= stated.cutoff ? 1.0F : 0.0F;
  }
  if (!stated.has_halo) {
    return opacity;
  }
  const Face& face = place.face;
  const Shading& shading = face.scene.shading;
  const Vec3f normal = shading.interpolation == Interpolation::flat ? face.face_normal() : face.normal_at(shading.normals, place.weights);
  return halo(opacity, dot(normal, to_eye));
}

SurfacePoint point_of(const SurfacePlace& place, const Vec3f& to_eye) {
  const Face& face = place.face;
  const Shading& shading = face.scene.shading;
  const ShadingMaps& maps = face.material.maps;
  const Weights<float> w = weights_of(place.weights);
  std::array<Footprint<float>, 2> at{};
  if (maps.present != 0) {
    at = footprints_on<float>(face, w, kPoint);
  }
  const Vec3f face_normal = place.geometric_normal * face.side;
  Vec3f normal = shading.interpolation == Interpolation::flat ? face_normal : face.normal_at(shading.normals, place.weights);
  if (maps.changes_normal()) {
    normal = mapped_normal<TexelReader>(face, shading.normals, w, kPoint, at, normal);
  }
  SurfacePoint point{.surface = {place.position, normal, to_eye}, .geometric_normal = face_normal};
  MapFactors<float> factors;
  point.k = coefficients_at(place, at, factors);
  point.emission = emitted(face.material, point.k);
  point.specular_factor = factors.specular;
  return point;
}

Vec3f emission_of(const SurfacePlace& place) {
  std::array<Footprint<float>, 2> at{};
  if (place.face.material.maps.present != 0) {
    at = footprints_on<float>(place.face, weights_of(place.weights), kPoint);
  }
  MapFactors<float> factors;
  return emitted(place.face.material, coefficients_at(place, at, factors));
}

}  // namespace lustro
