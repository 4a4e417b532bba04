// Which mesh format a file has: by its content first, then by its name's extension.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace lustro {

enum class MeshFormat : std::uint8_t { unknown, obj, ply, stl, off, threemf, gltf, glb };

/// The format that the content shows. OBJ has no mark: its first statement must be one of the format's.
[[nodiscard]] MeshFormat mesh_format_of_content(std::string_view bytes);

/// The format that the extension names, in any case.
[[nodiscard]] MeshFormat mesh_format_of_name(const std::filesystem::path& file);

/// Whether the extension is one of the better-known of those that are read through assimp, where it is built in.
[[nodiscard]] bool is_read_by_assimp_alone(const std::filesystem::path& file);

/// The formats that are read, for messages: `OBJ, PLY, STL, OFF, 3MF or glTF`.
[[nodiscard]] std::string readable_formats();

/// What an unknown file seems to be, for a message: `a PNG image`, or its first bytes.
[[nodiscard]] std::string describe_content(std::string_view bytes);

}  // namespace lustro
