// glTF bytes, as JSON or as GLB, with a small file beside them that every external URI names: as one mesh, as a scene, at a moment of an
// animation.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "check_mesh.hpp"
#include "io/gltf_scene.hpp"
#include "parallel/big_memory.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lustro;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  GltfOptions gltf;
  gltf.spare_values = 1U << 18U;
  gltf.image_limits = {.side = 512, .pixels = 1 << 16, .chunk_bytes = 1 << 20};
  gltf.read = [](const std::string& path) -> Result<FileBytes> {
    require(!path.empty() && path.front() != '/' && path != ".." && !path.starts_with("../"), "files are read beside the document alone");
    FileBytes beside;
    beside.size = 840;
    beside.data = make_big_array<char>(beside.size);
    for (std::size_t i = 0; i < beside.size; ++i) {
      beside.data[i] = static_cast<char>(i % 7 * (i / 64));
    }
    return beside;
  };
  for (const bool is_animated : {false, true}) {
    LoadOptions options;
    options.threads = 1;
    if (is_animated) {
      options.time = 0.7;
    }
    Result<GltfModel> model = parse_gltf(bytes, "fuzz.gltf", gltf, options);
    if (!model) {
      require(model.error().where.starts_with("fuzz.gltf") && !model.error().message.empty(), "an error says where and what");
      continue;
    }
    if (const Result<LoadedScene> scene = gltf_scene(*model, "fuzz.gltf", options)) {
      for (const Object& object : scene->scene.objects) {
        for (const double number : object.matrix.m) {
          require(number - number == 0, "matrices are finite");
        }
      }
    }
    check_mesh(gltf_whole_mesh(*model, options));
  }
  return 0;
}
