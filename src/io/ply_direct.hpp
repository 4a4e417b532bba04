// The usual binary PLY at the speed of its bytes: vertices of scalars, then triangles.
#pragma once

#include <optional>

#include "io/read_file.hpp"
#include "mesh/plain_mesh.hpp"

namespace lustro {

/// The mesh of a PLY file that holds nothing but an element `vertex` of scalars and an element `face` whose lists have three entries each, and
/// whose every byte is as its header says. Read by several threads, straight into its arrays: the file is never in memory as a whole.
/// Nothing where the file is any other, damaged ones among them: parse_ply() says what they hold or what is wrong with them.
/// is_sorted  the vertices come in the order of their first use (PlainMesh::used), for drawing; else in that of the file
[[nodiscard]] std::optional<PlainMesh> read_plain_ply(const ByteSource& source, bool is_sorted, int threads);

}  // namespace lustro
