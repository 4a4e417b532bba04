// OFF, Geomview's object file format: ascii and binary.
#pragma once

#include <string>
#include <string_view>

#include "lustro/mesh.hpp"
#include "lustro/result.hpp"

namespace lustro {

/// The mesh of an OFF file: [ST][C][N]OFF, the letters in any order, or no keyword at all.
///
/// Vertices    x y z, then as the keyword's letters say: a normal (N), a colour (C), texture coordinates (ST). Numbers are separated by blanks
/// and
///             ends of lines alike; a colour of three numbers in place of four is known by its line.
/// Faces       a count and as many indices, then to the end of the line a colour of three or four numbers, or the index of a colour map, which
///             does not come with the file: it is ignored with a note. Fewer than three corners: dropped with a note.
/// Colours     whole numbers count to 255 unless no colour of the file that is written so exceeds 1; numbers with a point are 0..1 and go
/// through
///             settle_colors(). Faces without one, where others have one, are white. Opacities other than 1 are ignored with a note.
/// Counts      on the keyword's line or the next; also glued to it (`OFF490 518 0`); the number of edges is neither used nor asked for.
/// Binary      `BINARY` behind the keyword: 32-bit integers and floats, the most significant byte first; a face's colour is led by the number of
/// its
///             components.
///
/// errors  malformed with the line or byte: numbers that are none, counts that the file is too short for, indices outside; unsupported for
///         4OFF and nOFF, whose points have other than three coordinates; limit for more than 2^32 - 2 of a kind
/// source  Phillips, Levy, Munzner, Geomview manual, OFF
[[nodiscard]] Result<SourceMesh> parse_off(std::string_view bytes, const std::string& file);

/// True where the text begins with a keyword of the format.
[[nodiscard]] bool is_off(std::string_view bytes);

}  // namespace lustro
