// Loading what the command line names: see scene_input.hpp. Flags come between reading the scene and loading its meshes, because some of them
// (--crease, --vertex-normals) shape the meshes.
#include "scene_input.hpp"

#include <fstream>

#include "scene/words.hpp"
#include "words.hpp"

namespace lustro::app {
namespace {

/// A primitive in the place of a scene is the scene with that one object, lit on both sides, as a bare mesh is.
Result<LoadedScene> load_primitive(const std::string& source, const LoadOptions& options) {
  Scene scene;
  scene.shading.two_sided = true;
  Object object;
  object.source = source;
  scene.objects.push_back(std::move(object));
  if (const Result<void> adjusted = options.adjust(scene); !adjusted) {
    return tl::unexpected(adjusted.error());
  }
  Result<Notes> notes = load_meshes(scene, {}, options);
  if (!notes) {
    return tl::unexpected(notes.error());
  }
  return LoadedScene{std::move(scene), std::move(*notes)};
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
  return extension == ".json" || (stream && c == '{');
}

void add_input_flags(CLI::App& app, InputFlags& flags) {
  const std::string group = "Input";
  app.add_flag("--mtl-tr", flags.mtl_tr, "A lone Tr in an MTL file is the opacity, as 3ds Max writes it, not 1 - opacity")
      ->disable_flag_override()
      ->group(group);
  app.add_flag("--strict", flags.strict, "A texture that is missing or broken is an error; else it is left out with a warning")
      ->disable_flag_override()
      ->group(group);
  app.add_option("--gltf-camera", flags.gltf_camera, "Looks through a camera of a glTF file, by its number or name (default: frames everything)")
      ->type_name("CAMERA")
      ->group(group);
  one_of(app.add_option("--gltf-shading", flags.gltf_shading, "How a glTF file's materials are lit (default: classic; ggx where --lighting is)"),
         strings_of(words_of<GltfShading>()))
      ->group(group);
  app.add_option("--time", flags.time, "Shows a glTF file at this moment of its animation (seconds; default: as it stands without it)")
      ->type_name("SECONDS")
      ->group(group);
  app.add_option("--animation", flags.animation, "Which animation of a glTF file, by its number or name (default: the first)")
      ->type_name("ANIMATION")
      ->group(group);
}

LoadOptions load_options(const Session& session, const InputFlags& flags) {
  LoadOptions options;
  options.transparency_is_tr = flags.mtl_tr;
  options.strict = flags.strict;
  options.threads = session.threads;
  options.gltf_camera = flags.gltf_camera;
  options.gltf_shading = parse_word<GltfShading>(flags.gltf_shading).value_or(GltfShading::classic);  // the words are checked already
  options.time = flags.time;
  options.animation = flags.animation;
  return options;
}

Result<LoadedScene> load_input(const std::string& argument, const LoadOptions& options) {
  return is_primitive(argument) ? load_primitive(argument, options) : load_scene(argument, options);
}

Result<LoadedScene> load_scene_argument(const std::string& argument, const SceneFlags& flags, LoadOptions options) {
  options.adjust = [&flags](Scene& scene) { return apply_scene_flags(flags, scene); };
  return load_input(argument, options);
}

}  // namespace lustro::app
