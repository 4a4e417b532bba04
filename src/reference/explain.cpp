// One pixel taken apart: the reference renderer run on that pixel alone, with every number kept.
#include <fmt/format.h>

#include <new>

#include "image/srgb.hpp"
#include "lustro/image.hpp"
#include "lustro/render.hpp"
#include "reference/depth_maps.hpp"
#include "reference/pixel.hpp"
#include "reference/triangle.hpp"
#include "reference/visibility.hpp"
#include "scene/surroundings.hpp"

namespace lustro {
namespace {

Result<Explanation> take_apart(const Scene& scene, int x, int y) {
  if (x < 0 || y < 0 || x >= scene.image.width || y >= scene.image.height) {
    return fail(
        ErrorKind::usage, "",
        fmt::format("pixel {}, {} is outside the picture of {} x {} pixels, counted from 0", x, y, scene.image.width, scene.image.height));
  }
  auto prepared = prepare(scene);
  if (!prepared) {
    return tl::unexpected(prepared.error());
  }
  EnvironmentCache surroundings;
  if (const auto laid = lay_surroundings(scene, surroundings, 0, *prepared); !laid) {
    return tl::unexpected(laid.error());
  }
  draw_depth_maps(*prepared, prepared->shadows, 0);
  draw_occlusion(*prepared, prepared->occlusion, 0);
  const std::vector<ScreenTriangle> triangles = setup_triangles(*prepared, 0);
  Visibility visibility(*prepared, {x, y, x + 1, y + 1});
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    visibility.draw(triangles[i], i);
  }
  Explanation explanation;
  explanation.x = x;
  explanation.y = y;
  explanation.interpolation = scene.shading.interpolation;
  explanation.samples = prepared->view.samples;
  explanation.ambient_light = prepared->ambient;
  explanation.normalized = prepared->shading.normalized;
  const Pixel pixel = resolve_pixel(*prepared, triangles, visibility, x, y, false, &explanation.fragments);
  explanation.ambient = pixel.terms.ambient;
  explanation.diffuse = pixel.terms.diffuse;
  explanation.specular = pixel.terms.specular;
  explanation.emission = pixel.terms.emission;
  explanation.fog = pixel.fog;
  explanation.background = pixel.background;
  explanation.background_weight = pixel.uncovered;
  explanation.color = pixel.color();

  Image one(1, 1, 4);
  std::copy(explanation.color.begin(), explanation.color.end(), one.pixels.begin());
  const ByteImage bytes = to_bytes(one, scene.image.transfer, scene.image.tone);
  std::copy(bytes.pixels.begin(), bytes.pixels.end(), explanation.bytes.begin());
  return explanation;
}

}  // namespace

Result<Explanation> explain(const Scene& scene, int x, int y) {
  try {
    return take_apart(scene, x, y);
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::limit, "", "not enough memory");
  }
}

}  // namespace lustro
