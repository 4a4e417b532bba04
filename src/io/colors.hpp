// Vertex and face colours, brought into 0..1.
#pragma once

#include <string_view>
#include <vector>

#include "io/note_book.hpp"
#include "lustro/vec.hpp"

namespace lustro {

/// Colours as a file holds them become `encoded` colours in 0..1: where a channel exceeds 2 the file counts to 255 (or to 65535), and all are
/// divided by that; what is then outside is clamped; what is not a number becomes 1, which leaves the material as it is. A note for each.
void settle_colors(std::vector<Vec3f>& colors, std::string_view what, NoteBook& notes);

}  // namespace lustro
