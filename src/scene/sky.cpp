// The background of one pixel.
#include "scene/sky.hpp"

namespace lustro {

Vec3f background_at(const PreparedScene& scene, int x, int y) {
  if (scene.sky) {
    return sky_at<TexelReader>(scene.view, *scene.sky, static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
  }
  return {scene.background[0], scene.background[1], scene.background[2]};
}

}  // namespace lustro
