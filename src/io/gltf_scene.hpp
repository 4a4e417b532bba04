// A glTF file as a scene, and its meshes one by one or all in one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/gltf_file.hpp"
#include "io/gltf_pose.hpp"
#include "io/gltf_textures.hpp"
#include "lustro/scene.hpp"

namespace lustro {

/// A file in a pose.
struct GltfModel {
  GltfFile file;
  GltfPose pose;
  GltfTextures textures{};
};

/// A glTF file from the disk; files that it names are read from its folder.
/// errors  as open_gltf() and pose_of()
[[nodiscard]] Result<GltfModel> load_gltf(const std::filesystem::path& file, const LoadOptions& options);

/// The same from memory.
[[nodiscard]] Result<GltfModel> parse_gltf(std::string_view bytes, const std::string& name, const GltfOptions& gltf, const LoadOptions& options);

/// Objects, without their meshes, camera and lights (KHR_lights_punctual) of the default scene; without lights the scene states none. Notes of
/// the document go along. source  what the objects' `source` begins with: the file's name errors  usage for a camera that is not there; limit
[[nodiscard]] Result<LoadedScene> gltf_scene(GltfModel& model, const std::string& source, const LoadOptions& options);

/// Reads the pictures of all these nodes' meshes together, which is faster than mesh by mesh.
/// errors  as gltf_materials()
[[nodiscard]] Result<void> read_gltf_textures(GltfModel& model, std::span<const std::size_t> nodes, const LoadOptions& options);

/// The mesh of one node, in its own space, or in world space where it has a skin.
/// errors  usage for a node without a mesh; malformed, limit; as gltf_materials()
[[nodiscard]] Result<SourceMesh> gltf_node_mesh(GltfModel& model, std::size_t node, const LoadOptions& options = {});

/// All that the default scene draws as one mesh in world space.
[[nodiscard]] Result<SourceMesh> gltf_whole_mesh(GltfModel& model, const LoadOptions& options = {});

/// Equal for nodes whose meshes are the same: the same mesh, neither skinned nor differently morphed.
[[nodiscard]] std::string gltf_mesh_key(const GltfModel& model, std::size_t index);

}  // namespace lustro
