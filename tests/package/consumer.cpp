// What a user's program does with an installed Lustro: makes a mesh, draws it, writes and reads the picture. Ends with 0 when all of that is
// right.
#include <cstdio>
#include <filesystem>
#include <lustro/lustro.hpp>
#include <memory>

int main(int argc, char** argv) {
  if (argc != 2) {
    return 2;
  }
  const auto source = lustro::make_primitive("sphere:24");
  if (!source) {
    std::puts(source.error().text().c_str());
    return 1;
  }
  auto built = lustro::build_mesh(*source);
  if (!built) {
    std::puts(built.error().text().c_str());
    return 1;
  }
  lustro::Scene scene;
  scene.image.width = 32;
  scene.image.height = 24;
  scene.objects.push_back({.name = "ball",
                           .source = {},
                           .mesh = std::make_shared<const lustro::Mesh>(std::move(built->mesh)),
                           .material = lustro::library_material("jade"),
                           .matrix = {}});
  const auto rendering = lustro::render(scene);
  if (!rendering) {
    std::puts(rendering.error().text().c_str());
    return 1;
  }
  const std::filesystem::path file = argv[1];
  if (const auto written = lustro::write_image(file, rendering->color); !written) {
    std::puts(written.error().text().c_str());
    return 1;
  }
  const auto back = lustro::read_image(file);
  if (!back || back->width != 32 || back->height != 24) {
    std::puts("the picture did not come back");
    return 1;
  }
  std::printf("lustro %s: %llu triangles, %llu pixels covered\n", LUSTRO_VERSION, static_cast<unsigned long long>(rendering->stats.triangles),
              static_cast<unsigned long long>(rendering->stats.pixels_covered));
  return rendering->stats.pixels_covered > 100 ? 0 : 1;
}
