// Loading what the command line names: see scene_input.hpp. Flags come between reading the scene and loading its meshes, because some of them
// (--crease, --vertex-normals) shape the meshes.
#include "scene_input.hpp"

#include <fstream>

#include "io/read_file.hpp"

namespace lustro::app {
namespace {

/// A mesh in the place of a scene is the scene with that one object, lit on both sides.
Scene bare_scene(const std::string& source) {
  Scene scene;
  scene.shading.two_sided = true;
  Object object;
  object.source = source;
  scene.objects.push_back(std::move(object));
  return scene;
}

}  // namespace

bool is_scene_file(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".gltf" || extension == ".glb") {
    return false;
  }
  std::ifstream stream(file, std::ios::binary);
  char c = ' ';
  while (stream.get(c) && (c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\xEF' || c == '\xBB' || c == '\xBF')) {
  }
  return stream && c == '{';
}

Result<LoadedScene> load_scene_argument(const std::string& argument, const SceneFlags& flags, const LoadOptions& options) {
  LoadedScene loaded;
  std::filesystem::path folder;
  if (!is_primitive(argument) && is_scene_file(argument)) {
    const Result<FileBytes> bytes = read_file(argument);
    if (!bytes) {
      return tl::unexpected(bytes.error());
    }
    Result<Scene> scene = parse_scene(bytes->view(), argument);
    if (!scene) {
      return tl::unexpected(scene.error());
    }
    loaded.scene = std::move(*scene);
    folder = std::filesystem::path(argument).parent_path();
  } else {
    loaded.scene = bare_scene(argument);
  }
  if (const Result<void> applied = apply_scene_flags(flags, loaded.scene); !applied) {
    return tl::unexpected(applied.error());
  }
  Result<Notes> notes = load_meshes(loaded.scene, folder, options);
  if (!notes) {
    return tl::unexpected(notes.error());
  }
  loaded.notes = std::move(*notes);
  return loaded;
}

}  // namespace lustro::app
