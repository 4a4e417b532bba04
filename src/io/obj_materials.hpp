// The materials of an OBJ: what its libraries define and what its faces use, under one number a name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "io/note_book.hpp"
#include "io/obj.hpp"
#include "lustro/material.hpp"
#include "lustro/result.hpp"

namespace lustro {

/// Numbers materials by name. `usemtl` may come before the library that defines the material.
class ObjMaterials {
 public:
  explicit ObjMaterials(const ObjOptions& options) : options_(options) {}

  /// Reads what a `mtllib` line names: the whole line as one name (it may hold spaces), else the names on it one by one. A missing library is a
  /// note, once.
  /// errors  what parse_mtl() refuses
  Result<void> read_libraries(const std::string& line_text, std::size_t line, NoteBook& notes);

  /// The number of the material of that name.
  std::uint32_t number(std::string name, std::size_t line);

  [[nodiscard]] std::size_t size() const { return slots_.size(); }

  /// All materials, by number, and the libraries' notes behind `notes`.
  std::vector<Material> take(NoteBook& notes, Notes& library_notes);

 private:
  enum class Outcome { read, missing, failed };
  Outcome read_library(const std::string& name);
  void note_missing(const std::string& name, std::size_t line, NoteBook& notes) const;

  struct Slot {
    Material material;
    bool is_defined = false;
    std::size_t first_line = 0;
  };
  const ObjOptions& options_;
  std::vector<Slot> slots_;
  std::map<std::string, std::uint32_t, std::less<>> numbers_;
  std::set<std::string, std::less<>> read_;
  std::map<std::string, std::string, std::less<>> missing_;  // name to reason
  Notes library_notes_;
  std::optional<Error> error_;
};

/// The names on a `mtllib` line that is not one name: cut behind each `.mtl`, else at blanks.
[[nodiscard]] std::vector<std::string> split_library_names(const std::string& line_text);

}  // namespace lustro
