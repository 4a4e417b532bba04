// What `lustro info` says of a mesh and of a scene, as text and as JSON.
#pragma once

#include <string>

#include "json_out.hpp"
#include "lustro/mesh.hpp"
#include "lustro/scene.hpp"
#include "mesh_stats.hpp"

namespace lustro::app {

/// One mesh file: as stated, as built, as a surface.
struct MeshReport {
  std::string file;
  const SourceMesh* source = nullptr;
  const BuiltMesh* built = nullptr;
  MeshStats stats;
  const LoadedScene* scene = nullptr;  ///< what a glTF file says beyond its meshes
};

[[nodiscard]] MeshReport make_mesh_report(const std::string& file, const SourceMesh& source, const BuiltMesh& built);
[[nodiscard]] std::string mesh_text(const MeshReport& report);
[[nodiscard]] Json mesh_json(const MeshReport& report);

[[nodiscard]] std::string scene_info_text(const std::string& file, const LoadedScene& loaded);
[[nodiscard]] Json scene_info_json(const std::string& file, const LoadedScene& loaded);

}  // namespace lustro::app
