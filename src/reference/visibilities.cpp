// See visibilities.hpp; the equations are shade/depth_map.hpp's and shade/occlusion.hpp's.
#include "reference/visibilities.hpp"

#include "shade/depth_map.hpp"
#include "shade/occlusion.hpp"

namespace lustro {

std::vector<float> visibilities_at(const Face& face, const Vec3f& position, const Vec3f& normal) {
  const PreparedScene& scene = face.scene;
  std::vector<float> visibilities(scene.lights.size() + 1, 1.0F);
  for (std::size_t l = 0; l < scene.shadows.maps.size(); ++l) {
    if (scene.shadows.maps[l].shape != DepthShape::none) {
      visibilities[l] = visibility_of(scene.lights[l], scene.shadows.maps[l], position, face.face_normal(), normal);
    }
  }
  if (!scene.occlusion.empty()) {
    visibilities.back() = openness_at(scene.occlusion.shading, position, normal, face.face_normal());
  }
  return visibilities;
}

}  // namespace lustro
