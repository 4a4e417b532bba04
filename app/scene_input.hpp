// From the word on the command line to a scene with its meshes: a scene file, a mesh file or a primitive, with the flags laid over it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "lustro/scene.hpp"
#include "report.hpp"
#include "scene_flags.hpp"

namespace lustro::app {

/// Whether the argument names a primitive (`primitive:teapot`), not a file.
[[nodiscard]] inline bool is_primitive(const std::string& argument) {
  return argument.starts_with("primitive:");
}

/// Whether the file is a scene: JSON by its first character, and not named as glTF. A file that cannot be read is none.
[[nodiscard]] bool is_scene_file(const std::filesystem::path& file);

/// What SCENE may be, for help.
inline constexpr const char* kSceneHelp =
    "A scene file, a mesh (OBJ, PLY, STL, OFF, 3MF, glTF), or primitive:NAME (plane, cube, sphere, torus, teapot)";

/// What a command says about reading files.
struct InputFlags {
  bool mtl_tr = false;
  bool strict = false;
  std::string gltf_camera;
  std::string gltf_shading = "classic";
  std::string animation;
  std::optional<double> time;
};

/// `--mtl-tr`, `--strict`, `--gltf-camera`, `--gltf-shading`, `--time`, `--animation`, of every command that loads.
void add_input_flags(CLI::App& app, InputFlags& flags);

/// How the command loads.
[[nodiscard]] LoadOptions load_options(const Session& session, const InputFlags& flags);

/// A scene file, a mesh file or a primitive.
/// options  `adjust` must be set
/// errors   as load_scene()
[[nodiscard]] Result<LoadedScene> load_input(const std::string& argument, const LoadOptions& options);

/// The scene that the argument names, with the flags laid over it.
/// errors  as load_scene(); usage for a flag
[[nodiscard]] Result<LoadedScene> load_scene_argument(const std::string& argument, const SceneFlags& flags, LoadOptions options);

}  // namespace lustro::app
