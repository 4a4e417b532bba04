// Small, fixed pieces of the way from file to picture, each in a function of its own, for tests/instructions/count to count their instructions
// under callgrind. Prints nothing; ends with 1 where a piece fails, so that a count is never the count of an error.
//
// stages FOLDER   writes and reads a mesh there
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "image/png.hpp"
#include "lustro/lustro.hpp"

namespace {

using namespace lustro;

/// A scene of small, middle and large triangles on one thread; every call draws frames as a steady state has them.
class Pieces {
 public:
  explicit Pieces(const std::filesystem::path& folder) : obj_(folder / "torus.obj") {
    scene_.image.width = 256;
    scene_.image.height = 144;
    scene_.image.samples = 1;
    scene_.shading.two_sided = true;
    Result<SourceMesh> source = make_primitive("torus:64");
    Result<BuiltMesh> built = source ? build_mesh(*source) : fail(ErrorKind::empty, "", "");
    works_ = built.has_value();
    if (works_) {
      write_obj(built->mesh);
      Object object;
      object.mesh = std::make_shared<Mesh>(std::move(built->mesh));
      scene_.objects = {object};
    }
    options_.threads = 1;
    options_.store_color = false;
    options_.store_bytes = true;
  }

  [[nodiscard]] bool works() const { return works_; }

  void load() {
    LoadOptions options;
    options.threads = 1;
    Result<SourceMesh> source = load_mesh_file(obj_, options);
    const Result<BuiltMesh> built = source ? build_mesh(std::move(*source), {}, 1) : fail(ErrorKind::empty, "", "");
    works_ = works_ && built && built->mesh.triangles.size() == scene_.objects.front().mesh->triangles.size();
  }

  void draw(Target target, int samples) {
    options_.target = target;
    scene_.image.samples = samples;
    works_ = works_ && renderer_.render(scene_, options_, picture_) && picture_.stats.pixels_covered > 0;
  }

  void pack() { works_ = works_ && encode_png(picture_.bytes, {.threads = 1}); }

 private:
  void write_obj(const Mesh& mesh) const {
    std::ofstream out(obj_);
    for (const Vec3f& p : mesh.positions) {
      out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    }
    for (const auto& [a, b, c] : mesh.triangles) {
      out << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
    }
  }

  std::filesystem::path obj_;
  Scene scene_;
  RenderOptions options_;
  Renderer renderer_;
  Rendering picture_;
  bool works_ = false;
};

}  // namespace

// What is counted: everything inside these. extern "C", so that callgrind knows them by name.
extern "C" {
[[gnu::noinline]] void counted_load(Pieces& p) {
  p.load();
}
[[gnu::noinline]] void counted_first_frame_sse4(Pieces& p) {
  p.draw(Target::sse4, 1);
}
[[gnu::noinline]] void counted_frame_sse4(Pieces& p) {
  p.draw(Target::sse4, 1);
}
[[gnu::noinline]] void counted_frame_4_samples_sse4(Pieces& p) {
  p.draw(Target::sse4, 4);
}
[[gnu::noinline]] void counted_frame_avx2(Pieces& p) {
  p.draw(Target::avx2, 1);
}
[[gnu::noinline]] void counted_png(Pieces& p) {
  p.pack();
}
}

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: stages FOLDER\n");
    return 2;
  }
  Pieces pieces(argv[1]);
  pieces.draw(Target::scalar, 1);  // loads and binds what every first call does
  pieces.pack();
  pieces = Pieces(argv[1]);
  counted_load(pieces);
  counted_first_frame_sse4(pieces);
  counted_frame_sse4(pieces);
  pieces.draw(Target::sse4, 4);  // takes the memory
  counted_frame_4_samples_sse4(pieces);
  pieces.draw(Target::sse4, 1);
  for (const Target target : available_targets()) {
    if (target == Target::avx2) {
      counted_frame_avx2(pieces);
    }
  }
  counted_png(pieces);
  return pieces.works() ? 0 : 1;
}
