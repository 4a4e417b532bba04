// The engine behind the page: one scene at a time, its meshes kept from call to call, drawn, explained and handed to WebGL. Every answer is the
// JSON text that web/src/engine/types.ts describes; pixels and vertices are read from memory.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "answers.hpp"
#include "lustro/render.hpp"
#include "scene/mesh_cache.hpp"
#include "scene/prepare.hpp"

namespace lustro::web {

/// What is to be drawn of a scene.
struct PictureRequest {
  std::string scene;  ///< a scene file's text
  int width = 0;      ///< 0: the scene's own
  int height = 0;
  int samples = 0;
};

/// What is made of it beside the bytes.
struct PictureWants {
  bool floats = false;  ///< Rendering::color
  bool hash = false;
};

/// Vertices as WebGL takes them.
struct Geometry {
  std::vector<float> positions, normals, centers;
  std::vector<std::uint32_t> indices;
};

class Lab {
 public:
  /// Where files are opened.
  static constexpr const char* kFiles = "/files";

  /// Opens the file `entry` below kFiles: Opened.
  [[nodiscard]] std::string open(const std::string& entry);

  /// Picture, but for its pixels.
  [[nodiscard]] std::string render(const PictureRequest& request, const PictureWants& wants, int share, int shares);
  [[nodiscard]] const Rendering& rendering() const { return rendering_; }

  /// Explanation.
  [[nodiscard]] std::string explain(const PictureRequest& request, int x, int y);

  /// What the objects' meshes are.
  [[nodiscard]] std::string meshes(const std::string& scene);

  /// GpuScene, and the geometry by its key.
  /// linear  of several samples a pixel: shaders do not encode, so that samples are averaged as light, as the engine does it
  [[nodiscard]] std::string gpu_scene(const PictureRequest& request, bool linear);
  [[nodiscard]] std::string gpu_geometry(const std::string& key);
  [[nodiscard]] const Geometry& geometry() const { return geometry_; }

  /// The scene as the library writes it.
  [[nodiscard]] std::string scene_file(const std::string& scene);
  [[nodiscard]] std::string command_line(const PictureRequest& request);
  [[nodiscard]] std::string glsl(const std::string& scene);

 private:
  /// The scene with its meshes, which are loaded again only where something that shapes them has changed.
  [[nodiscard]] Result<const Scene*> scene_of(const std::string& text);
  [[nodiscard]] Result<Scene> scene_of(const PictureRequest& request);
  [[nodiscard]] Result<void> prepare_for_gpu(const PictureRequest& request);
  /// What follows from the scene that was loaded: scene_, stated by `json`.
  void note_load(const Json& json);

  std::string folder_ = kFiles;  ///< that the objects' sources are relative to
  std::string entry_;
  std::optional<Scene> opened_;  ///< as it was opened

  std::string text_;      ///< of scene_
  std::string load_key_;  ///< what its meshes and maps were loaded by
  std::string mesh_key_;  ///< what of it shapes the meshes
  Scene scene_;
  Notes load_notes_;
  std::uint64_t generation_ = 0;  ///< counts loads: geometry of another one is another
  Bounds bounds_;                 ///< of the load: of all objects where they stand

  Renderer renderer_;
  Rendering rendering_;

  MeshCache gpu_meshes_{ClusterUse::once};
  PreparedScene gpu_scene_;
  std::map<std::string, const Instance*> gpu_instances_;  ///< by their geometry's key
  Geometry geometry_;
};

}  // namespace lustro::web
