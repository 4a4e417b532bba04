// Wavefront OBJ: polygons, normals, texture coordinates, vertex colours, groups, smoothing groups and materials.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "lustro/mesh.hpp"
#include "lustro/result.hpp"

namespace lustro {

/// How an OBJ comes by its other files. The parser itself opens none.
struct ObjOptions {
  /// The text of an MTL file by its name as written; an error of kind `io` where there is none. Not set: every library is missing.
  std::function<Result<std::string>(const std::string& name)> read_library;
  bool transparency_is_tr = false;  ///< as in LoadOptions
  int threads = 0;                  ///< as in LoadOptions

  /// As much text as one thread reads at a time: what it makes of that stays in its cache until it is taken over.
  std::size_t part_bytes = std::size_t{1} << 18U;
};

/// The mesh of an OBJ text, faithful to it: polygons stay polygons.
///
/// Faces       v, v/vt, v//vn, v/vt/vn, mixed as they come; negative indices count back from the last record so far; indices may point ahead.
///             Fewer than three corners: dropped with a note. Texture coordinates or normals that are named where the file has no such record at
///             all are as not named, with a note.
/// Vertices    x y z [w] [r g b]. w is the weight of rational curves (specification, `v`) and is ignored for polygons, as most readers do.
/// Colours     white where only some vertices have one; see settle_colors().
/// Smoothing   `off`, `0` and what comes before the first `s` is 0; names and large numbers become numbers of their own above 2^31.
/// Objects     one a group (`o` or `g`, and every group anew within each `o`); `default` before the first; those without faces are left out.
/// Materials   of all libraries in their order, then those that no library defines, with the default coefficients and a note.
///
/// errors  malformed with the line: numbers that are none, indices outside; limit for more than 2^32 - 2 of a kind; what parse_mtl() refuses
/// source  Wavefront, The Advanced Visualizer manual, appendix B1 (object files), 1995
[[nodiscard]] Result<SourceMesh> parse_obj(std::string_view bytes, const std::string& file, const ObjOptions& options = {});

/// The same, by one thread and without the shorter way for usual lines (obj_lines.hpp).
[[nodiscard]] Result<SourceMesh> parse_obj_line_by_line(std::string_view bytes, const std::string& file, const ObjOptions& options = {});

}  // namespace lustro
