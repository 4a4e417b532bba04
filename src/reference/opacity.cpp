// See opacity.hpp; the equation is shade/opacity.hpp's.
#include "reference/opacity.hpp"

#include "reference/face.hpp"
#include "scene/mapped_surface.hpp"
#include "scene/samples.hpp"
#include "shade/opacity.hpp"

namespace lustro {

float opacity_at(const PreparedScene& scene, const ScreenTriangle& t, std::int32_t px, std::int32_t py) {
  const Face face = face_of(scene, t);
  const Interpolants at = interpolants_at(scene.view, t, px, py);
  const WeightSlopes<float> slopes = face.material.opacity.has_map ? weight_slopes_at(scene.view, t, px, py) : WeightSlopes<float>{};
  const float opacity = opacity_on<TexelReader, float>(face, {at.weights.x, at.weights.y, at.weights.z}, slopes);
  if (!face.material.opacity.has_halo) {
    return opacity;
  }
  const Vec3f normal =
      scene.shading.interpolation == Interpolation::flat ? face.face_normal() : face.normal_at(scene.shading.normals, at.weights);
  return halo(opacity, dot(normal, scene.view.to_eye_at(static_cast<float>(px) / kSubpixelUnits, static_cast<float>(py) / kSubpixelUnits)));
}

}  // namespace lustro
