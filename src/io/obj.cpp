// Reads an OBJ in one pass over its bytes: usual lines by many threads, part by part; the others, and what depends on them, in order. Indices
// are checked where they stand; what points ahead is checked at the end, by its line.
#include "io/obj.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "io/colors.hpp"
#include "io/limits.hpp"
#include "io/note_book.hpp"
#include "io/obj_lines.hpp"
#include "io/obj_materials.hpp"
#include "io/obj_statements.hpp"
#include "io/text.hpp"
#include "parallel/parallel_for.hpp"

namespace lustro {

namespace {

constexpr std::uint32_t kNone = SourceMesh::kNone;

// The corners' indices into one kind of record (v, vt or vn).
struct IndexStream {
  std::string_view name;
  // Indices that point ahead, each larger than all before it: the first index outside is among them.
  struct Ahead {
    std::int64_t index;
    std::size_t line;
  };
  std::vector<Ahead> ahead{};
  std::int64_t farthest = 0;
  std::size_t first_line = 0;             // where a corner names such a record first
  std::optional<Ahead> back_into_none{};  // a negative index before the first record
};

class ObjReader {
 public:
  ObjReader(std::string_view bytes, const std::string& file, const ObjOptions& options)
      : bytes_(bytes), text_(bytes, {.hash_comments = true, .joined_lines = true}), file_(file), notes_(file), materials_(options) {}

  Result<SourceMesh> read(int threads, std::size_t part_bytes);
  Result<SourceMesh> read_line_by_line();

 private:
  bool read_lines(const char* begin, const char* end, std::size_t line);
  void reserve();
  bool take_part(const ObjPart& part);
  [[nodiscard]] std::array<std::int64_t, 3> records_before(const ObjPiece& piece) const;
  [[nodiscard]] bool can_take(const ObjPiece& piece) const;
  bool take_piece(const ObjPart& part, const ObjPiece& piece);
  bool read_statement(std::string_view word);
  bool read_vertex();
  bool read_vector(std::string_view word, int most, int least, std::array<float, 3>& numbers);
  bool read_face();
  bool read_corner();
  bool read_index(IndexStream& stream, std::size_t count, std::uint32_t& index);
  void describe_faces(std::size_t face);
  void begin_group(std::size_t face);
  void read_group(bool is_object);
  void read_smoothing();
  bool read_use_material();
  void skip_statement(std::string_view word);
  bool check_ahead(IndexStream& stream, std::size_t count);
  bool settle_optional(IndexStream& stream, std::size_t count, std::vector<std::uint32_t>& corners, std::string_view what);
  bool finish();

  bool error(ErrorKind kind, std::size_t line, std::string message) {
    error_ = Error{kind, at_line(file_, line), std::move(message)};
    return false;
  }
  bool malformed(std::string message) { return error(ErrorKind::malformed, text_.line(), std::move(message)); }
  bool expected(std::string_view what) {
    const std::string_view found = text_.word();
    return malformed(fmt::format("expected {}, found {}", what, found.empty() ? "the end of the line" : shown(found)));
  }
  template <class T>
  bool has_room(const std::vector<T>& list, std::string_view what) {
    return list.size() < kMostElements || error(ErrorKind::limit, text_.line(), fmt::format("more than {} {}", kMostElements, what));
  }

  std::string_view bytes_;
  TextCursor text_;
  std::size_t lines_ = 1;  // the first line of the part at hand
  const std::string& file_;
  NoteBook notes_;
  ObjMaterials materials_;
  SourceMesh mesh_;
  std::optional<Error> error_;

  IndexStream vertex_{.name = "vertex"};
  IndexStream uv_{.name = "texture coordinate"};
  IndexStream normal_{.name = "normal"};

  bool has_smoothing_ = false;
  std::uint32_t smoothing_ = 0;
  std::map<std::string, std::uint32_t, std::less<>> smoothing_names_;
  bool has_materials_ = false;
  std::uint32_t material_ = kNone;
  std::map<std::string, std::uint32_t, std::less<>> object_numbers_;
  std::uint32_t object_ = 0;                                               // of the last o; 0 before the first
  std::map<std::pair<std::uint32_t, std::string>, std::uint32_t> groups_;  // object and name to index into mesh_.objects
  std::string group_name_;                                                 // of the last o or g
  bool group_is_new_ = false;
  std::uint32_t group_ = 0;

  bool has_known_statement_ = false;
  std::size_t first_unknown_line_ = 0;
  std::string first_unknown_;
};

Result<SourceMesh> ObjReader::read(int threads, std::size_t part_bytes) {
  reserve();
  if (bytes_.size() <= part_bytes) {
    threads = 1;  // to start others takes longer
  }
  // While some threads read a batch of parts, one takes over the batch before it.
  const std::size_t batch = std::min(bytes_.size() / part_bytes, 4 * thread_count(threads)) + 1;
  std::vector<ObjPart> parts(batch);
  std::vector<ObjPart> read_parts(batch);
  std::vector<const char*> ends(batch);
  const char* const end = bytes_.data() + bytes_.size();
  const char* begin = text_.here();  // behind a byte order mark
  std::size_t read_count = 0;
  bool is_good = true;
  while (is_good && (begin != end || read_count != 0)) {
    std::size_t count = 0;
    for (const char* at = begin; at != end && count < batch; ++count) {
      at = ends[count] = end_of_obj_part(bytes_, at, part_bytes);
    }
    parallel_for(count + 1, threads, [&](std::size_t i) {
      if (i == 0) {
        for (std::size_t k = 0; k < read_count && is_good; ++k) {
          is_good = take_part(read_parts[k]);
        }
      } else {
        read_obj_part(bytes_, i == 1 ? begin : ends[i - 2], ends[i - 1], parts[i - 1]);
      }
    });
    std::swap(parts, read_parts);
    begin = count == 0 ? end : ends[count - 1];
    read_count = count;
  }
  if (!is_good) {
    return tl::unexpected(std::move(*error_));
  }
  std::vector<ObjPart>().swap(parts);
  std::vector<ObjPart>().swap(read_parts);
  if (!finish()) {
    return tl::unexpected(std::move(*error_));
  }
  return std::move(mesh_);
}

void ObjReader::reserve() {
  const ObjEstimate estimate = estimate_obj(bytes_);
  reserve_big(mesh_.positions, estimate.positions);
  reserve_big(mesh_.uvs, estimate.uvs);
  reserve_big(mesh_.normals, estimate.normals);
  reserve_big(mesh_.face_begin, estimate.faces);
  reserve_big(mesh_.corner_position, estimate.corners);
  reserve_big(mesh_.corner_uv, estimate.names_uvs ? estimate.corners : 0);
  reserve_big(mesh_.corner_normal, estimate.names_normals ? estimate.corners : 0);
}

Result<SourceMesh> ObjReader::read_line_by_line() {
  if (!read_lines(text_.here(), bytes_.data() + bytes_.size(), 1) || !finish()) {
    return tl::unexpected(std::move(*error_));
  }
  return std::move(mesh_);
}

// Every statement, one by one, from `begin` to `end`.
bool ObjReader::read_lines(const char* begin, const char* end, std::size_t line) {
  for (text_.go_to(begin, line); text_.here() != end; text_.next_line()) {
    const std::string_view word = text_.word();
    if (!word.empty() && !read_statement(word)) {
      return false;
    }
  }
  return true;
}

bool ObjReader::take_part(const ObjPart& part) {
  for (const ObjPiece& piece : part.pieces) {
    const bool is_good = can_take(piece) ? take_piece(part, piece) : read_lines(piece.begin, piece.end, lines_ + piece.first_line);
    if (!is_good) {
      return false;
    }
  }
  lines_ += part.lines;
  return true;
}

// How many records stand before the part as far as its arrays hold them.
std::array<std::int64_t, 3> ObjReader::records_before(const ObjPiece& piece) const {
  const std::array<std::size_t, 3> now{mesh_.positions.size(), mesh_.uvs.size(), mesh_.normals.size()};
  std::array<std::int64_t, 3> before{};
  for (std::size_t kind = 0; kind < 3; ++kind) {
    before[kind] = static_cast<std::int64_t>(now[kind]) - static_cast<std::int64_t>(piece.first_record[kind]);
  }
  return before;
}

// Whether all is well with a piece, here where it stands: what is not is read again, statement by statement, to be said as it is.
bool ObjReader::can_take(const ObjPiece& piece) const {
  if (!piece.is_usual) {
    return false;
  }
  const std::array<std::int64_t, 3> before = records_before(piece);
  const auto is_inside = [&](ObjPiece::Kind kind) { return piece.needed[kind] <= before[kind]; };
  const auto has_room = [&](const auto& list, std::size_t more) { return more <= kMostElements - list.size(); };
  return is_inside(ObjPiece::vertex) && is_inside(ObjPiece::uv) && is_inside(ObjPiece::normal) &&
         has_room(mesh_.positions, piece.records[ObjPiece::vertex]) && has_room(mesh_.uvs, piece.records[ObjPiece::uv]) &&
         has_room(mesh_.normals, piece.records[ObjPiece::normal]) && has_room(mesh_.corner_position, piece.corners) &&
         has_room(mesh_.face_begin, piece.faces);
}

bool ObjReader::take_piece(const ObjPart& part, const ObjPiece& piece) {
  const std::array<std::int64_t, 3> before = records_before(piece);
  const auto append = [](auto& to, const auto& from, std::size_t first, std::size_t count) {
    to.insert(to.end(), from.data.get() + first, from.data.get() + first + count);
  };
  append(mesh_.positions, part.positions, piece.first_record[ObjPiece::vertex], piece.records[ObjPiece::vertex]);
  append(mesh_.uvs, part.uvs, piece.first_record[ObjPiece::uv], piece.records[ObjPiece::uv]);
  append(mesh_.normals, part.normals, piece.first_record[ObjPiece::normal], piece.records[ObjPiece::normal]);
  if (piece.faces == 0) {
    return true;
  }
  const std::size_t corner = mesh_.corner_position.size();
  const std::size_t face = mesh_.face_count();
  const auto append_corners = [&](std::vector<std::uint32_t>& to, IndexStream& stream, ObjPiece::Kind kind, std::size_t first) {
    to.resize(corner, kNone);
    append(to, part.corners[kind], first, piece.corners);
    const std::uint32_t base = piece.is_relative ? static_cast<std::uint32_t>(before[kind]) : 0;
    for (std::size_t i = corner; base != 0 && i < to.size(); ++i) {
      to[i] += base;
    }
    stream.first_line = stream.first_line == 0 ? lines_ + piece.first_face_line : stream.first_line;
  };
  append_corners(mesh_.corner_position, vertex_, ObjPiece::vertex, piece.first_corner);
  if (piece.names_uvs) {
    append_corners(mesh_.corner_uv, uv_, ObjPiece::uv, piece.first_uv_corner);
  }
  if (piece.names_normals) {
    append_corners(mesh_.corner_normal, normal_, ObjPiece::normal, piece.first_normal_corner);
  }
  append(mesh_.face_begin, part.face_end, piece.first_face, piece.faces);
  const auto shift = static_cast<std::uint32_t>(corner) - static_cast<std::uint32_t>(piece.first_corner);
  for (std::size_t f = face + 1; f < mesh_.face_begin.size(); ++f) {
    mesh_.face_begin[f] += shift;
  }
  describe_faces(face);
  return true;
}

bool ObjReader::read_statement(std::string_view word) {
  if (word == "v") {
    return read_vertex();
  }
  if (word == "f" || word == "fo") {  // fo: a face outline of old versions, now the same
    return read_face();
  }
  if (word == "vn") {
    std::array<float, 3> n{};
    if (!has_room(mesh_.normals, "normals") || !read_vector(word, 3, 3, n)) {
      return false;
    }
    mesh_.normals.push_back({n[0], n[1], n[2]});
    return true;
  }
  if (word == "vt") {
    std::array<float, 3> t{};
    if (!has_room(mesh_.uvs, "texture coordinates") || !read_vector(word, 3, 1, t)) {
      return false;
    }
    mesh_.uvs.push_back({t[0], t[1]});
    return true;
  }
  has_known_statement_ |= is_obj_statement(word);
  if (word == "o" || word == "g") {
    read_group(word == "o");
    return true;
  }
  if (word == "s") {
    read_smoothing();
    return true;
  }
  if (word == "usemtl") {
    return read_use_material();
  }
  if (word == "mtllib") {
    const std::size_t line = text_.line();
    if (Result<void> done = materials_.read_libraries(text_.rest_of_line(), line, notes_); !done) {
      error_ = std::move(done.error());
      return false;
    }
    return true;
  }
  skip_statement(word);
  return true;
}

bool ObjReader::read_vertex() {
  std::array<float, 7> numbers{};
  std::size_t count = 0;
  while (count < numbers.size() && !text_.at_line_end()) {
    if (!text_.number(numbers[count])) {
      return expected("a number of the vertex");
    }
    ++count;
  }
  if (count < 3) {
    return malformed(fmt::format("a vertex has {} numbers, and 3 are needed", count));
  }
  if (!has_room(mesh_.positions, "vertices")) {
    return false;
  }
  if (count == 5 || !text_.at_line_end()) {
    notes_.add(text_.line(), "numbers of a vertex behind x y z [w] [r g b] are ignored");
  }
  if ((count == 4 || count == 5 || count == 7) && numbers[3] != 1) {
    notes_.add(text_.line(), "the weight w of a vertex is ignored: it has a meaning for rational curves only");
  }
  if (count >= 6) {
    const std::size_t first = count - 3;
    mesh_.colors.resize(mesh_.positions.size(), Vec3f{1, 1, 1});
    mesh_.colors.push_back({numbers[first], numbers[first + 1], numbers[first + 2]});
  }
  mesh_.positions.push_back({numbers[0], numbers[1], numbers[2]});
  return true;
}

bool ObjReader::read_vector(std::string_view word, int most, int least, std::array<float, 3>& numbers) {
  int count = 0;
  for (; count < most && !text_.at_line_end(); ++count) {
    if (!text_.number(numbers[static_cast<std::size_t>(count)])) {
      return expected(fmt::format("a number of {}", word));
    }
  }
  if (count < least) {
    return malformed(fmt::format("{} has {} numbers, and {} are needed", word, count, least));
  }
  if (!text_.at_line_end()) {
    notes_.add(text_.line(), fmt::format("numbers of {} behind the third are ignored", word));
  }
  return true;
}

bool ObjReader::read_face() {
  if (!has_room(mesh_.face_begin, "faces")) {
    return false;
  }
  const std::size_t line = text_.line();
  const std::size_t begin = mesh_.corner_position.size();
  while (!text_.at_line_end()) {
    if (!has_room(mesh_.corner_position, "corners of faces") || !read_corner()) {
      return false;
    }
  }
  if (mesh_.corner_position.size() - begin >= 3) {
    mesh_.face_begin.push_back(static_cast<std::uint32_t>(mesh_.corner_position.size()));
    describe_faces(mesh_.face_count() - 1);
    return true;
  }
  mesh_.corner_position.resize(begin);
  mesh_.corner_uv.resize(std::min(mesh_.corner_uv.size(), begin));
  mesh_.corner_normal.resize(std::min(mesh_.corner_normal.size(), begin));
  notes_.add(line, "faces with fewer than three corners are dropped");
  return true;
}

// v, v/vt, v//vn, v/vt/vn; exporters also write v/, v// and v/vt/.
bool ObjReader::read_corner() {
  const std::size_t corner = mesh_.corner_position.size();
  std::uint32_t index = 0;
  if (!read_index(vertex_, mesh_.positions.size(), index)) {
    return false;
  }
  mesh_.corner_position.push_back(index);
  for (const bool is_normal : {false, true}) {
    if (!text_.take('/')) {
      break;
    }
    if (text_.at_word_end() || (!is_normal && text_.next_is('/'))) {
      continue;
    }
    if (!read_index(is_normal ? normal_ : uv_, is_normal ? mesh_.normals.size() : mesh_.uvs.size(), index)) {
      return false;
    }
    std::vector<std::uint32_t>& corners = is_normal ? mesh_.corner_normal : mesh_.corner_uv;
    corners.resize(corner, kNone);
    corners.push_back(index);
  }
  return text_.at_word_end() || text_.at_line_end() || expected("v, v/vt, v//vn or v/vt/vn");
}

// An index of OBJ (from 1; negative: back from the last record) becomes one of ours.
bool ObjReader::read_index(IndexStream& stream, std::size_t count, std::uint32_t& index) {
  std::int64_t written = 0;
  if (!text_.integer(written, '/')) {
    return expected(fmt::format("a {} index", stream.name));
  }
  stream.first_line = stream.first_line == 0 ? text_.line() : stream.first_line;
  const auto records = static_cast<std::int64_t>(count);
  if (written > 0) {
    if (written > records && written > stream.farthest) {
      stream.farthest = written;
      stream.ahead.push_back({written, text_.line()});
    }
    index = static_cast<std::uint32_t>(std::min(written - 1, std::int64_t{kNone} - 1));
    return true;
  }
  if (written < 0 && -written <= records) {
    index = static_cast<std::uint32_t>(records + written);
    return true;
  }
  if (written < 0 && records == 0 && &stream != &vertex_) {  // right only if there is no such record at all
    stream.back_into_none = stream.back_into_none.value_or(IndexStream::Ahead{written, text_.line()});
    index = kNone;
    return true;
  }
  if (written == 0) {
    return malformed(fmt::format("{} index 0: indices count from 1", stream.name));
  }
  return malformed(records == 0 ? fmt::format("{} index {} counts back from the first record", stream.name, written)
                                : fmt::format("{} index {} is outside -{}..-1", stream.name, written, records));
}

// What the statements before the last faces, from `face` on, say about them.
void ObjReader::describe_faces(std::size_t face) {
  const std::size_t faces = mesh_.face_count();
  if (has_smoothing_) {
    mesh_.face_smoothing.resize(face, 0);
    mesh_.face_smoothing.resize(faces, smoothing_);
  }
  if (has_materials_) {
    mesh_.face_material.resize(face, kNone);
    mesh_.face_material.resize(faces, material_);
  }
  if (group_is_new_) {
    begin_group(face);
  }
  if (!groups_.empty()) {
    mesh_.face_object.resize(faces, group_);
  }
}

// Groups are listed with their first face, so that empty ones are not.
void ObjReader::begin_group(std::size_t face) {
  if (groups_.empty() && face > 0) {
    groups_.emplace(std::pair(0U, std::string("default")), 0U);
    mesh_.objects.emplace_back("default");
    mesh_.face_object.resize(face, 0);
  }
  const auto [known, is_new] = groups_.emplace(std::pair(object_, group_name_), static_cast<std::uint32_t>(mesh_.objects.size()));
  if (is_new) {
    mesh_.objects.push_back(group_name_);
  }
  group_ = known->second;
  group_is_new_ = false;
}

void ObjReader::read_group(bool is_object) {
  group_name_ = to_utf8(text_.rest_of_line());
  group_name_ = group_name_.empty() ? "default" : std::move(group_name_);
  group_is_new_ = true;
  if (is_object) {
    object_ = object_numbers_.emplace(group_name_, static_cast<std::uint32_t>(object_numbers_.size() + 1)).first->second;
  }
}

void ObjReader::read_smoothing() {
  constexpr std::uint32_t kFirstNamed = 0x80000000U;
  const std::size_t line = text_.line();
  std::int64_t number = 0;
  const bool is_number = text_.integer(number);
  if (is_number && number >= 0 && number < kFirstNamed) {
    smoothing_ = static_cast<std::uint32_t>(number);
  } else {
    const std::string name = is_number ? std::to_string(number) : text_.rest_of_line();
    if (name.empty()) {
      notes_.add(line, "s names no smoothing group and is ignored");
      return;
    }
    const auto next = kFirstNamed + static_cast<std::uint32_t>(smoothing_names_.size());
    smoothing_ = name == "off" ? 0 : smoothing_names_.emplace(name, next).first->second;
  }
  has_smoothing_ = true;
}

bool ObjReader::read_use_material() {
  const std::size_t line = text_.line();
  std::string name = to_utf8(text_.rest_of_line());
  has_materials_ = true;
  if (name.empty()) {
    material_ = kNone;
    notes_.add(line, "usemtl names no material: the default one is used");
    return true;
  }
  material_ = materials_.number(std::move(name), line);
  return materials_.size() <= kMostMaterials || error(ErrorKind::limit, line, fmt::format("more than {} materials", kMostMaterials));
}

void ObjReader::skip_statement(std::string_view word) {
  const std::string_view note = note_of_skipped_obj_statement(word);
  if (!note.empty()) {
    notes_.add(text_.line(), note);
    return;
  }
  if (first_unknown_line_ == 0) {
    first_unknown_line_ = text_.line();
    first_unknown_ = shown(word);
  }
  notes_.add(text_.line(), fmt::format("unknown statement {} is skipped", shown(word)));
}

bool ObjReader::check_ahead(IndexStream& stream, std::size_t count) {
  const auto records = static_cast<std::int64_t>(count);
  for (const IndexStream::Ahead& ahead : stream.ahead) {
    if (ahead.index > records) {
      return error(ErrorKind::malformed, ahead.line,
                   records == 0 ? fmt::format("{} index {}, but the file has no such record", stream.name, ahead.index)
                                : fmt::format("{} index {} is outside 1..{}", stream.name, ahead.index, records));
    }
  }
  if (stream.back_into_none) {
    return error(ErrorKind::malformed, stream.back_into_none->line,
                 fmt::format("{} index {} counts back from the first record", stream.name, stream.back_into_none->index));
  }
  return true;
}

// Exporters that were told to leave normals out still name them in their faces.
bool ObjReader::settle_optional(IndexStream& stream, std::size_t count, std::vector<std::uint32_t>& corners, std::string_view what) {
  if (count == 0 && stream.first_line != 0) {
    corners.clear();
    notes_.add(stream.first_line, fmt::format("faces name {}s, but the file has no {} record: they are as not named", stream.name, what));
    return true;
  }
  if (!corners.empty()) {
    corners.resize(mesh_.corner_position.size(), kNone);
  }
  return check_ahead(stream, count);
}

bool ObjReader::finish() {
  const bool is_bare = mesh_.positions.empty() && mesh_.normals.empty() && mesh_.uvs.empty() && !has_known_statement_;
  if (is_bare && first_unknown_line_ != 0) {  // not a mesh without faces, but something else under the name of one
    return error(ErrorKind::malformed, first_unknown_line_, fmt::format("expected an OBJ statement, found {}", first_unknown_));
  }
  if (!check_ahead(vertex_, mesh_.positions.size()) || !settle_optional(uv_, mesh_.uvs.size(), mesh_.corner_uv, "vt") ||
      !settle_optional(normal_, mesh_.normals.size(), mesh_.corner_normal, "vn")) {
    return false;
  }
  if (!mesh_.colors.empty()) {
    mesh_.colors.resize(mesh_.positions.size(), Vec3f{1, 1, 1});
    settle_colors(mesh_.colors, "vertex", notes_);
  }
  Notes library_notes;
  mesh_.materials = materials_.take(notes_, library_notes);
  mesh_.format = "OBJ";
  mesh_.notes = notes_.notes();
  mesh_.notes.insert(mesh_.notes.end(), library_notes.begin(), library_notes.end());
  return true;
}

bool is_utf16(std::string_view bytes) {
  return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
}

}  // namespace

Result<SourceMesh> parse_obj(std::string_view bytes, const std::string& file, const ObjOptions& options) {
  if (is_utf16(bytes)) {
    return fail(ErrorKind::unsupported, file, "is UTF-16 text: expected UTF-8 or ASCII");
  }
  return ObjReader(bytes, file, options).read(options.threads, options.part_bytes);
}

Result<SourceMesh> parse_obj_line_by_line(std::string_view bytes, const std::string& file, const ObjOptions& options) {
  if (is_utf16(bytes)) {
    return fail(ErrorKind::unsupported, file, "is UTF-16 text: expected UTF-8 or ASCII");
  }
  return ObjReader(bytes, file, options).read_line_by_line();
}

}  // namespace lustro
