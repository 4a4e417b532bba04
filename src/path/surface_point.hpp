// What a ray meets: the place on a triangle with its normals and the coefficients under the maps, by the functions that the reference uses.
#pragma once

#include <cstdint>

#include "path/rays.hpp"
#include "reference/face.hpp"
#include "scene/prepare.hpp"

namespace lustro {

/// A triangle where a ray meets it.
struct SurfacePlace {  // NOLINT(cppcoreguidelines-pro-type-member-init): an aggregate, made with its face
  Face face;
  Vec3f weights;             ///< of the triangle's vertices
  Vec3f position;            ///< relative to the eye
  Vec3f geometric_normal{};  ///< unit, on the front
  float offset = 0;          ///< how far from the surface a ray must begin so that rounding does not let it meet the surface again
  bool is_front = true;      ///< the ray meets the front
};

/// placed       the triangle that was met
/// lights_back  the back is lit with its normals turned round
[[nodiscard]] SurfacePlace place_of(const PreparedScene& scene, const RayHit& hit, const PlacedTriangle& placed, const Vec3f& direction,
                                    bool lights_back);

/// Whether the side that is met is left out (Culling).
[[nodiscard]] bool is_culled(const SurfacePlace& place);

/// The opacity there; to_eye: unit, where the ray came from.
[[nodiscard]] float opacity_at(const SurfacePlace& place, const Vec3f& to_eye);

/// Whether anything can be seen through the material: its opacity counts, or a side is left out.
[[nodiscard]] inline bool is_solid(const ShadingMaterial& material) {
  return material.cull == Culling::none && material.opacity.mode == AlphaMode::opaque;
}

/// The place lit: what the equation needs.
struct SurfacePoint {
  Surface<float> surface;
  Vec3f geometric_normal{};  ///< unit, on the side of the surface's normal
  Coefficients<float, LaneExponent<float>> k{};
  Vec3f emission{};                ///< what it sends to the eye by itself: k_e; where the lighting is constant k_d
  Vec3f specular_factor{1, 1, 1};  ///< what maps make of k_s
};

/// to_eye  unit
[[nodiscard]] SurfacePoint point_of(const SurfacePlace& place, const Vec3f& to_eye);

/// The emission alone.
[[nodiscard]] Vec3f emission_of(const SurfacePlace& place);

}  // namespace lustro
