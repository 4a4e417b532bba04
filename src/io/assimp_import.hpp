// Everything that Lustro has no importer of its own for (FBX, COLLADA, 3DS, ...), by assimp: an option of the build, LUSTRO_WITH_ASSIMP.
#pragma once

#include <filesystem>

#include "lustro/mesh.hpp"
#include "lustro/result.hpp"

namespace lustro {

/// Whether assimp reads files of that extension; never in a build without it.
[[nodiscard]] bool assimp_reads(const std::filesystem::path& file);

/// The meshes of a file, where its nodes place them, as polygons with normals, the first uvs and colours, and classic materials, whose maps are
/// stated as an MTL file would (Material::maps). The coefficient of a colour that has a map is 1, as it is in FBX and COLLADA.
///
/// Files that it names are opened for reading only, and only inside of the file's own folder. Points and lines are dropped with a note, and so
/// are pictures inside of the file; animations, skins, cameras and lights are not taken over.
///
/// errors  unsupported where assimp knows no such format; malformed with assimp's message; limit, also for files of more than 1 GiB
[[nodiscard]] Result<SourceMesh> import_by_assimp(const std::filesystem::path& file);

}  // namespace lustro
