// Wavefront MTL material libraries.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lustro/material.hpp"
#include "lustro/result.hpp"

namespace lustro {

struct MtlOptions {
  bool transparency_is_tr = false;  ///< a lone `Tr` is the opacity, not 1 - opacity
};

/// What an MTL file holds.
struct MtlFile {
  std::vector<Material> materials;  ///< in the file's order; a name that comes twice is there once, as stated last
  Notes notes;
};

/// The materials of an MTL text. Colours are `encoded`; what a material does not state keeps OpenGL's defaults,
/// but a colour beside its map, which is 1 then. illum 0 and 1 set the material's
/// own lighting, the others leave it to the scene. Map statements are kept in Material::maps.
/// errors  malformed where a statement's numbers are missing or none, with the line; unsupported for `spectral` and `xyz` colours
/// source  Ramey, Rose, Tyerman, MTL material format (Wavefront, 1995); `Ke`, `Tr`, `norm` and the PBR statements are common extensions
[[nodiscard]] Result<MtlFile> parse_mtl(std::string_view bytes, const std::string& file, const MtlOptions& options = {});

}  // namespace lustro
