// The engine for JavaScript (Embind). Text in, JSON text out; pixels and vertices as views of the memory, good until the next call.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <memory>
#include <new>

#include "answers.hpp"
#include "lab.hpp"
#include "lustro/version.hpp"

namespace lustro::web {
namespace {

/// What is thrown across the engine (no memory, mostly), as an answer.
template <class F>
std::string answered(F&& f) {
  try {
    return f();
  } catch (const std::bad_alloc&) {
    return error_answer({ErrorKind::limit, "", "needs more memory than the page has"});
  } catch (const std::exception& problem) {
    return error_answer({ErrorKind::limit, "", problem.what()});
  }
}

template <class T>
emscripten::val view_of(const std::vector<T>& values) {
  return emscripten::val(emscripten::typed_memory_view(values.size(), values.data()));
}

/// Lab with what is thrown caught, and memory as views.
class Binding {
 public:
  std::string open(const std::string& entry) {
    return answered([&] { return lab_.open(entry); });
  }
  std::string render(const std::string& scene, int width, int height, int samples, bool floats, bool hash, int share, int shares) {
    return answered([&] { return lab_.render({scene, width, height, samples}, {.floats = floats, .hash = hash}, share, shares); });
  }
  std::string explain(const std::string& scene, int width, int height, int samples, int x, int y) {
    return answered([&] { return lab_.explain({scene, width, height, samples}, x, y); });
  }
  std::string meshes(const std::string& scene) {
    return answered([&] { return lab_.meshes(scene); });
  }
  std::string gpu_scene(const std::string& scene, int width, int height, int samples, bool linear) {
    return answered([&] { return lab_.gpu_scene({scene, width, height, samples}, linear); });
  }
  std::string gpu_geometry(const std::string& key) {
    return answered([&] { return lab_.gpu_geometry(key); });
  }
  std::string scene_file(const std::string& scene) {
    return answered([&] { return lab_.scene_file(scene); });
  }
  std::string command_line(const std::string& scene, int width, int height, int samples) {
    return answered([&] { return lab_.command_line({scene, width, height, samples}); });
  }
  std::string glsl(const std::string& scene) {
    return answered([&] { return lab_.glsl(scene); });
  }
  [[nodiscard]] emscripten::val bytes() const { return view_of(lab_.rendering().bytes.pixels); }
  [[nodiscard]] emscripten::val floats() const { return view_of(lab_.rendering().color.pixels); }
  [[nodiscard]] emscripten::val positions() const { return view_of(lab_.geometry().positions); }
  [[nodiscard]] emscripten::val normals() const { return view_of(lab_.geometry().normals); }
  [[nodiscard]] emscripten::val centers() const { return view_of(lab_.geometry().centers); }
  [[nodiscard]] emscripten::val indices() const { return view_of(lab_.geometry().indices); }

 private:
  Lab lab_;
};

std::string engine_info() {
  return answer({{"version", LUSTRO_VERSION}, {"target", target_name(available_targets().front())}});
}
std::string options() {
  return answer(option_groups());
}
std::string materials() {
  return answer(material_list());
}

}  // namespace

EMSCRIPTEN_BINDINGS(lustro) {  // NOLINT
  emscripten::class_<Binding>("Lab")
      .constructor<>()
      .function("open", &Binding::open)
      .function("render", &Binding::render)
      .function("explain", &Binding::explain)
      .function("meshes", &Binding::meshes)
      .function("gpuScene", &Binding::gpu_scene)
      .function("gpuGeometry", &Binding::gpu_geometry)
      .function("sceneFile", &Binding::scene_file)
      .function("commandLine", &Binding::command_line)
      .function("glsl", &Binding::glsl)
      .function("bytes", &Binding::bytes)
      .function("floats", &Binding::floats)
      .function("positions", &Binding::positions)
      .function("normals", &Binding::normals)
      .function("centers", &Binding::centers)
      .function("indices", &Binding::indices);
  emscripten::function("engineInfo", &engine_info);
  emscripten::function("options", &options);
  emscripten::function("materials", &materials);
}

}  // namespace lustro::web
