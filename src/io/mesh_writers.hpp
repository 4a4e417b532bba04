// Meshes as the bytes of files: one function a format, one source file each. write_mesh() checks the mesh before.
#pragma once

#include <functional>
#include <string>

#include "lustro/mesh.hpp"
#include "lustro/result.hpp"

namespace lustro {

/// The bytes of a file and what it could not hold.
struct MeshBytes {
  std::string bytes;
  Notes notes;
};

/// PLY: see write_ply.cpp.
[[nodiscard]] MeshBytes ply_bytes(const Mesh& mesh, bool ascii);

/// STL, its facets' normals by their corners.
/// errors  limit for more than 2^32 - 1 triangles, which binary files cannot count
[[nodiscard]] Result<MeshBytes> stl_bytes(const Mesh& mesh, bool ascii);

/// The bytes of a picture file that a material names; empty where there are none.
using ReadFile = std::function<std::string(const std::string& file)>;

/// Binary glTF 2.0: see write_glb.cpp.
/// errors  limit for more than 4 GiB, which the format cannot count
[[nodiscard]] Result<MeshBytes> glb_bytes(const Mesh& mesh, const ReadFile& read_map);

/// A file that another one is to name, from the name that it had: the result is what is written.
using NameFile = std::function<std::string(const std::string& file)>;

/// OBJ; with materials, faces name them by material_names().
/// library  the file name of the material library, where the mesh has materials
[[nodiscard]] MeshBytes obj_bytes(const Mesh& mesh, const std::string& library);

/// The materials as an MTL file.
[[nodiscard]] MeshBytes mtl_bytes(const Mesh& mesh, const NameFile& name_map);

/// A name for each material that an MTL file can hold: on one line, none twice, none empty.
[[nodiscard]] std::vector<std::string> material_names(const std::vector<Material>& materials);

/// Whether the mesh needs a library: it has materials, and triangles that use them.
[[nodiscard]] inline bool has_materials(const Mesh& mesh) {
  return !mesh.materials.empty() && !mesh.triangles.empty();
}

}  // namespace lustro
