// Empty pictures: see emptiness.hpp.
#include "emptiness.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "image/srgb.hpp"

namespace lustro::app {

namespace {

bool lets_light_through(const Material& material) {
  return material.opacity < 1 || material.textures.opacity || material.halo;
}

bool lets_light_through(const Scene& scene) {
  return std::ranges::any_of(scene.objects, [](const Object& object) {
    if (object.mesh != nullptr && !object.mesh->alphas.empty()) {
      return true;
    }
    if (object.material) {
      return lets_light_through(*object.material);
    }
    return object.mesh != nullptr &&
           std::ranges::any_of(object.mesh->materials, [](const Material& material) { return lets_light_through(material); });
  });
}

}  // namespace

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
  if (lets_light_through(scene)) {
    return fmt::format("wherever samples meet {}, it is fully transparent (or none meets it: too small, or seen edge-on)",
                       stats.triangles_seen == 1 ? std::string("the one triangle that lies in the picture")
                                                 : fmt::format("one of the {} triangles that lie in the picture", stats.triangles_seen));
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
