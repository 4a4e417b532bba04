// A mesh file in the form that costs least.
#pragma once

#include <filesystem>
#include <variant>

#include "io/load_textures.hpp"
#include "lustro/scene.hpp"
#include "mesh/plain_mesh.hpp"

namespace lustro {

using ReadMesh = std::variant<SourceMesh, PlainMesh>;

/// load_mesh_file(), in plain form where the file has it.
/// for_drawing  the vertices may come in another order than that of the file: what build_plain() makes of them is the same mesh
/// textures     what other meshes have read already
[[nodiscard]] Result<ReadMesh> read_mesh_file(const std::filesystem::path& file, const LoadOptions& options, bool for_drawing,
                                              TextureCache& textures);

}  // namespace lustro
