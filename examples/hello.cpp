// Ten lines from nothing to a picture: a teapot of jade, lit by the default lights, in hello.png.
#include <cstdio>
#include <lustro/lustro.hpp>

int main() {
  lustro::Scene scene;
  lustro::Object& teapot = scene.objects.emplace_back();
  teapot.source = "primitive:teapot";  // or a file: model.obj, bunny.ply, part.stl
  teapot.material = lustro::library_material("jade");

  const auto picture = lustro::load_meshes(scene, ".")
                           .and_then([&](const lustro::Notes&) { return lustro::render(scene); })
                           .and_then([](const lustro::Rendering& r) { return lustro::write_image("hello.png", r.color); });
  if (!picture) {
    std::fprintf(stderr, "%s\n", picture.error().text().c_str());
  }
  return picture ? 0 : 1;
}
