// One rendering, taken apart: the picture and its terms, lights, depth and normals as the layers of one EXR file, and one pixel explained.
#include <cstdio>
#include <lustro/lustro.hpp>

namespace {

int complain(const lustro::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return 1;
}

}  // namespace

int main() {
  auto scene = lustro::parse_scene(R"({
    "image":   {"width": 480, "height": 360},
    "lights":  [{"type": "directional", "direction": [-1, -2, -1.5]},
                {"type": "point", "position": [-3, 2, 3], "diffuse": [0.2, 0.4, 0.8], "specular": [0.2, 0.4, 0.8]}],
    "objects": [{"mesh": "primitive:torus", "material": "ruby"}]
  })");
  if (!scene) {
    return complain(scene.error());
  }
  if (const auto notes = lustro::load_meshes(*scene, "."); !notes) {
    return complain(notes.error());
  }

  lustro::RenderOptions options;
  options.aovs = lustro::parse_aovs("ambient,diffuse,specular,light:*,depth,normal").value();
  const auto rendering = lustro::render(*scene, options);
  if (!rendering) {
    return complain(rendering.error());
  }
  if (const auto written = lustro::write_exr_layers("layers.exr", rendering->color, rendering->layers); !written) {
    return complain(written.error());
  }
  for (const lustro::Layer& layer : rendering->layers) {
    std::printf("layer %s: %d channels\n", layer.name.c_str(), layer.image.channels);
  }

  // The pixel's own arithmetic; its sum is the rendered pixel, bit for bit.
  const int x = 300;
  const int y = 230;
  const auto why = lustro::explain(*scene, x, y);
  if (!why) {
    return complain(why.error());
  }
  for (const lustro::FragmentExplanation& fragment : why->fragments) {
    for (const lustro::LightExplanation& light : fragment.shadings.front().lights) {
      std::printf("pixel %d %d: light %d has N.L = %g and gives red %g + %g\n", x, y, light.light, static_cast<double>(light.n_dot_l),
                  static_cast<double>(light.diffuse.x), static_cast<double>(light.specular.x));
    }
  }
  return why->color[0] == rendering->color.at(x, y)[0] ? 0 : 1;
}
