// The map statements of MTL files: options in any order before or behind the file's name.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/note_book.hpp"
#include "lustro/material.hpp"

namespace lustro {

/// True for map_Kd, bump, disp, decal, refl, norm and their like, in the spellings that exporters write.
[[nodiscard]] bool is_map_statement(std::string_view word);

/// What follows a map statement: its options and the file's name, which may hold spaces. Nothing, and a note, where there is no name.
[[nodiscard]] std::optional<TextureMap> parse_map(std::string_view statement, const std::string& rest, std::size_t line, NoteBook& notes);

}  // namespace lustro
