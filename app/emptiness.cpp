// Empty pictures: see emptiness.hpp.
#include "emptiness.hpp"

#include <fmt/format.h>

#include "image/srgb.hpp"

namespace lustro::app {

std::string why_empty(const Scene& scene, const RenderStats& stats) {
  if (scene.objects.empty()) {
    return "the scene has no objects";
  }
  if (stats.triangles == 0) {
    return "there is no triangle in it";
  }
  if (stats.triangles_seen == 0) {
    const std::string who =
        stats.triangles == 1 ? "its one triangle does not lie" : fmt::format("none of the {} triangles lies", stats.triangles);
    return fmt::format("{} before the camera, between near and far, and inside the picture{}", who,
                       scene.camera.eye ? "; without an eye the camera frames everything" : "");
  }
  return stats.triangles_seen == 1 ? "the one triangle that lies in the picture falls between its samples: it is too small or seen edge-on"
                                   : fmt::format(
                                         "the {} triangles that lie in the picture fall between its samples: they are too small or "
                                         "seen edge-on",
                                         stats.triangles_seen);
}

Rendering empty_rendering(const Scene& scene) {
  const ImageSettings& image = scene.image;
  const bool is_encoded = image.background.space == ColorSpace::encoded && image.transfer == Transfer::srgb;
  const float alpha = image.transparent ? 0.0F : image.background_alpha;
  const auto channel = [&](float c) { return (is_encoded ? srgb_decode(c) : c) * alpha; };
  const std::array<float, 4> pixel{channel(image.background.rgb.x), channel(image.background.rgb.y), channel(image.background.rgb.z), alpha};
  Rendering rendering;
  rendering.color = Image(image.width, image.height, 4);
  for (std::size_t i = 0; i < rendering.color.pixels.size(); ++i) {
    rendering.color.pixels[i] = pixel[i % 4];
  }
  return rendering;
}

}  // namespace lustro::app
