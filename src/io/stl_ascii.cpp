// Reads ascii STL word by word: line ends are blanks but for the solids' names.
#include "io/stl_ascii.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "io/limits.hpp"
#include "io/note_book.hpp"
#include "io/text.hpp"

namespace lustro {

namespace {

class StlReader {
 public:
  StlReader(std::string_view bytes, const std::string& file) : text_(bytes, {}), file_(file), notes_(file) {}

  Result<SourceMesh> read();

 private:
  bool read_solid();
  bool read_facet();
  bool read_vertex();
  void end_facet(std::size_t begin, std::size_t line);
  std::string_view next_word() {
    text_.skip_space();
    return text_.word();
  }
  bool take_word(std::string_view expected) {
    const std::string_view found = next_word();
    return same_word(found, expected) || expected_word(expected, found);
  }
  bool expected_word(std::string_view expected, std::string_view found) {
    error_ = Error{ErrorKind::malformed, at_line(file_, text_.line()),
                   fmt::format("expected {}, found {}", expected, found.empty() ? "the end of the file" : shown(found))};
    return false;
  }

  TextCursor text_;
  const std::string& file_;
  NoteBook notes_;
  SourceMesh mesh_;
  std::string solid_name_;
  bool solid_is_listed_ = false;
  std::optional<Error> error_;
};

Result<SourceMesh> StlReader::read() {
  for (text_.skip_space(); !text_.at_end(); text_.skip_space()) {
    if (!read_solid()) {
      return tl::unexpected(std::move(*error_));
    }
  }
  mesh_.format = "STL (ascii)";
  mesh_.weld_first = true;
  mesh_.notes = notes_.notes();
  return std::move(mesh_);
}

bool StlReader::read_solid() {
  if (!take_word("solid")) {
    return false;
  }
  solid_name_ = to_utf8(text_.rest_of_line());
  solid_is_listed_ = false;
  for (;;) {
    const std::string_view word = next_word();
    if (same_word(word, "endsolid")) {
      text_.next_line();  // the name once more
      return true;
    }
    if (word.empty() && solid_is_listed_) {
      notes_.add(text_.line(), "the file ends without endsolid");
      return true;
    }
    if (!same_word(word, "facet")) {
      return expected_word("facet or endsolid", word);
    }
    if (!read_facet()) {
      return false;
    }
  }
}

// facet [normal x y z] outer loop, vertices, endloop endfacet
bool StlReader::read_facet() {
  const std::size_t line = text_.line();
  std::string_view word = next_word();
  if (same_word(word, "normal")) {
    word = next_word();
    for (int i = 0; i < 3 && !same_word(word, "outer"); ++i) {  // whatever they are: nan, 1.#QNAN, nothing
      word = next_word();
    }
  }
  if (!same_word(word, "outer")) {
    return expected_word("outer loop", word);
  }
  if (!take_word("loop")) {
    return false;
  }
  const std::size_t begin = mesh_.positions.size();
  for (word = next_word(); same_word(word, "vertex"); word = next_word()) {
    if (!read_vertex()) {
      return false;
    }
  }
  if (!same_word(word, "endloop")) {
    return expected_word("vertex or endloop", word);
  }
  if (!take_word("endfacet")) {
    return false;
  }
  end_facet(begin, line);
  return true;
}

bool StlReader::read_vertex() {
  if (mesh_.positions.size() == kMostElements) {
    error_ = Error{ErrorKind::limit, at_line(file_, text_.line()), fmt::format("more than {} vertices", kMostElements)};
    return false;
  }
  std::array<float, 3> numbers{};
  for (float& number : numbers) {
    text_.skip_space();
    if (!text_.number(number)) {
      return expected_word("a number of the vertex", text_.word());
    }
  }
  mesh_.corner_position.push_back(static_cast<std::uint32_t>(mesh_.positions.size()));
  mesh_.positions.push_back({numbers[0], numbers[1], numbers[2]});
  return true;
}

void StlReader::end_facet(std::size_t begin, std::size_t line) {
  const std::size_t corners = mesh_.positions.size() - begin;
  if (corners < 3) {
    mesh_.positions.resize(begin);
    mesh_.corner_position.resize(begin);
    notes_.add(line, "facets with fewer than three vertices are dropped");
    return;
  }
  if (corners > 3) {
    notes_.add(line, "facets with more than three vertices are taken as polygons");
  }
  if (!solid_is_listed_) {
    mesh_.objects.push_back(solid_name_);
    solid_is_listed_ = true;
  }
  mesh_.face_begin.push_back(static_cast<std::uint32_t>(mesh_.corner_position.size()));
  mesh_.face_object.push_back(static_cast<std::uint32_t>(mesh_.objects.size() - 1));
}

}  // namespace

Result<SourceMesh> parse_stl_text(std::string_view bytes, const std::string& file) {
  return StlReader(bytes, file).read();
}

}  // namespace lustro
