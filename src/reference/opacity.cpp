// See opacity.hpp; the equation is shade/opacity.hpp's.
#include "reference/opacity.hpp"

#include "reference/face.hpp"
#include "reference/visibilities.hpp"
#include "scene/mapped_surface.hpp"
#include "scene/samples.hpp"
#include "shade/opacity.hpp"
#include "shade/shadow_catcher.hpp"

namespace lustro {

float opacity_at(const PreparedScene& scene, const ScreenTriangle& t, std::int32_t px, std::int32_t py) {
  const Face face = face_of(scene, t);
  const Interpolants at = interpolants_at(scene.view, t, px, py);
  const WeightSlopes<float> slopes = face.material.opacity.has_map ? weight_slopes_at(scene.view, t, px, py) : WeightSlopes<float>{};
  const float opacity = opacity_on<TexelReader, float>(face, {at.weights.x, at.weights.y, at.weights.z}, slopes);
  const ShadingOpacity& stated = face.material.opacity;
  if (!stated.has_halo && !(stated.catches > 0)) {
    return opacity;
  }
  const Vec3f normal =
      scene.shading.interpolation == Interpolation::flat ? face.face_normal() : face.normal_at(scene.shading.normals, at.weights);
  const float x = static_cast<float>(px) / kSubpixelUnits;
  const float y = static_cast<float>(py) / kSubpixelUnits;
  if (stated.catches > 0) {
    const Vec3f position = scene.view.point_at(x, y, depth_of(scene.view, at.depth_key));
    const std::vector<float> seen = visibilities_at(face, position, normal);
    return stated.catches * caught_shadow(scene.surrounding_light(), scene.lights, position, normal, [&seen](std::size_t i) { return seen[i]; });
  }
  return halo(opacity, dot(normal, scene.view.to_eye_at(x, y)));
}

}  // namespace lustro
