// Meshes written to files. Reading is load_mesh_file() and load_scene().
#pragma once

#include <filesystem>

#include "lustro/mesh.hpp"
#include "lustro/result.hpp"
#include "lustro/scene.hpp"

namespace lustro {

struct MeshWriteOptions {
  bool ascii = false;  ///< PLY and STL as text; the other formats have one form

  /// The folder that TextureMap::file of the materials is relative to. A map that is there is named so that it is found from the written file.
  std::filesystem::path texture_folder{};
};

/// Writes a mesh by its file's extension, under a temporary name that is then renamed: an existing file is replaced whole or not at all.
///
///   .obj   positions, normals, uvs, colours, and a .mtl of the same name beside it: materials with the map statements they came with
///   .ply   positions, normals, uvs (s, t), colours and opacities in 8 bits; binary, little endian, or ascii
///   .stl   triangles; binary or ascii
///   .glb   all attributes; materials as metal-rough ones, the pictures of their diffuse maps inside
///
/// Floats are written so that they are read back to the same bits (text: the shortest such number).
/// returns  what the format cannot hold, each kind once
/// errors   unsupported for another extension; usage for arrays that do not fit each other or indices outside; limit for more than the
///          format can count; io where a file cannot be written
[[nodiscard]] Result<Notes> write_mesh(const std::filesystem::path& file, const Mesh& mesh, const MeshWriteOptions& options = {});

/// All objects of a scene as one mesh in world space: positions by their matrices, normals by the inverse transposes, triangles of mirrored
/// objects turned round; an object's own material replaces its mesh's. What only some objects have is filled up: colours and opacities with 1,
/// uvs with 0; normals and tangents are left out unless all have them. One object that is not moved keeps its bits.
/// errors  usage where an object has no mesh (load_meshes() fills them) or a matrix flattens it; limit beyond 2^32 - 2 vertices
[[nodiscard]] Result<Mesh> flatten_scene(const Scene& scene);

}  // namespace lustro
