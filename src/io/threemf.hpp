// 3MF, the printers' format: a ZIP package with XML.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "lustro/mesh.hpp"
#include "lustro/result.hpp"

namespace lustro {

/// How much a package may make of its bytes: it can name the same mesh again and again.
struct ThreeMfLimits {
  std::uint64_t bytes = std::uint64_t{1} << 31U;      ///< of all parts that are read, unpacked
  std::uint64_t uses = std::uint64_t{1} << 20U;       ///< meshes that are placed
  std::uint64_t triangles = std::uint64_t{1} << 27U;  ///< all of them together
};

/// The mesh of a 3MF package: the items of its build with all their components, where they stand, in millimetres.
///
/// Units       one unit of the mesh is a millimetre, as in other printers' files; another unit is converted, with a note.
/// Placing     transforms of items and components; an object that is mirrored is turned round. Objects are named as in the file, one a placed
/// mesh. Materials   base materials: diffuse and a quarter of it (in linear light) ambient from the display colour, opacity from its alpha.
/// Colours     of the materials extension: a triangle of one colour has it as its face's, one of several has them at its corners. Opacities are
///             ignored with a note. Textures and mixtures are ignored with a note.
/// Production  components and items in other model parts of the package.
///
/// errors  malformed with part and line: broken XML or ZIP, entities, indices outside, objects that are missing or hold themselves; limit;
///         unsupported for extensions that the file requires and that are not read
/// source  3MF Consortium: Core Specification 1.3, Materials and Properties Extension 1.2, Production Extension 1.1; ECMA-376-2 for the package
[[nodiscard]] Result<SourceMesh> parse_threemf(std::string_view bytes, const std::string& file, const ThreeMfLimits& limits = {});

}  // namespace lustro
