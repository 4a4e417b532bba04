// PLY polygon files: ascii and binary.
#pragma once

#include <string>
#include <string_view>

#include "lustro/mesh.hpp"
#include "lustro/result.hpp"

namespace lustro {

/// The mesh of a PLY file.
///
/// Vertices    x y z of any type; normals nx ny nz; uv under u v, s t, texture_u texture_v (and texture_s texture_t, texcoord_u ...); colours
/// red
///             green blue, r g b, or with diffuse_ before them. 8 and 16 bit unsigned colours and uvs are divided by their type's largest value.
/// Faces       vertex_indices or vertex_index, a list of any types; texcoord, a list of one uv a corner, wins over the vertices' uvs; colours as
/// the
///             vertices' ones. Fewer than three corners: dropped with a note.
/// Tristrips   the same list; -1 starts the next strip; every other triangle is turned, so that all face the same way.
/// Other elements and properties are skipped. In an ascii body lines that begin with `comment` or `obj_info` are skipped, though the format has
/// comments in its header only, and so are values behind the stated ones.
///
/// errors  malformed with the line or byte: a header's own rules, data that end early, indices outside; limit for more than 2^32 - 2 of a kind.
///         Sizes are checked against the bytes that follow before memory is taken.
/// source  Turk, The PLY polygon file format, 1994
[[nodiscard]] Result<SourceMesh> parse_ply(std::string_view bytes, const std::string& file);

/// The same without the shorter way for usual files (ply_direct.hpp).
[[nodiscard]] Result<SourceMesh> parse_any_ply(std::string_view bytes, const std::string& file);

}  // namespace lustro
