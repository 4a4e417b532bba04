// The words with which OBJ statements begin.
#pragma once

#include <string_view>

namespace lustro {

/// True for every statement of the format, read or skipped.
[[nodiscard]] bool is_obj_statement(std::string_view word);

/// What the note says where a statement is known and left out; empty for the others.
[[nodiscard]] std::string_view note_of_skipped_obj_statement(std::string_view word);

}  // namespace lustro
