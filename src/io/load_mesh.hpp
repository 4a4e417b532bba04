// A mesh file in the form that costs least.
#pragma once

#include <filesystem>
#include <variant>

#include "lustro/scene.hpp"
#include "mesh/plain_mesh.hpp"

namespace lustro {

using ReadMesh = std::variant<SourceMesh, PlainMesh>;

/// load_mesh_file(), in plain form where the file has it.
[[nodiscard]] Result<ReadMesh> read_mesh_file(const std::filesystem::path& file, const LoadOptions& options);

}  // namespace lustro
