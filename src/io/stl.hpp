// STL (stereolithography) triangles: ascii and binary.
#pragma once

#include <string>
#include <string_view>

#include "lustro/mesh.hpp"
#include "lustro/result.hpp"

namespace lustro {

/// The facets of an STL file, three positions each; SourceMesh::weld_first is set, as the format repeats a vertex in every facet around it.
///
/// Facet normals are read over: they are of the facet alone, often 0 or wrong, and follow from the corners' order. Attribute bytes and the
/// colours that some programs hide there are ignored. Solids become objects, a solid without facets none.
///
/// Binary      bytes behind the stated facets are ignored with a note; fewer than stated are an error.
/// Ascii       keywords in any case, values on any line, comments (`# ...`), facets without a normal; a missing endsolid and a loop of other
/// than
///             three vertices are a note (more than three: a polygon; fewer: dropped).
///
/// errors  malformed with the line or byte; limit for more than 2^32 - 2 vertices
/// source  3D Systems, StereoLithography Interface Specification, 1989
/// threads  0: one a core, for binary files
[[nodiscard]] Result<SourceMesh> parse_stl(std::string_view bytes, const std::string& file, int threads = 0);

/// True for binary STL: by the size that the stated number of facets asks for; else whatever does not look like text that begins with `solid`,
/// as binary headers may begin with that word too.
[[nodiscard]] bool is_binary_stl(std::string_view bytes);

/// True where the size is exactly what the stated number of facets asks for, which no other format meets by chance.
[[nodiscard]] bool has_binary_stl_size(std::string_view bytes);

/// True for text whose first word is `solid` and that goes on with a facet or the solid's end.
[[nodiscard]] bool is_ascii_stl(std::string_view bytes);

}  // namespace lustro
