// Reads OFF in one pass, once written for ascii and for binary.
#include "io/off.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

#include "io/limits.hpp"
#include "io/note_book.hpp"
#include "io/off_colors.hpp"
#include "io/off_header.hpp"
#include "io/text.hpp"

namespace lustro {

namespace {

constexpr std::size_t kMostColorNumbers = 4;

/// Numbers of a colour as they stand in the file: more than four are counted only.
struct ColorNumbers {
  std::array<float, kMostColorNumbers> values{};
  std::size_t count = 0;
  bool is_whole = true;
};

/// Values of an ascii file: words between blanks and ends of lines.
class OffWords {
 public:
  OffWords(TextCursor text, const std::string& file) : text_(text), file_(file) {}

  static constexpr std::size_t kLeastBytes = 2;  // of a number: a digit and what parts it from the next

  bool read(float& value) {
    text_.skip_space();
    return text_.number(value);
  }
  bool read(std::int64_t& value) {
    text_.skip_space();
    return text_.integer(value);
  }
  /// A vertex's colour, which `behind` more numbers of the line follow.
  bool read_vertex_color(ColorNumbers& color, std::size_t behind) {
    text_.skip_space();
    TextCursor ahead = text_;
    std::size_t words = 0;
    while (words <= kMostColorNumbers + behind && !ahead.word().empty()) {
      ++words;
    }
    return read_numbers(color, words == 3 + behind ? 3 : 4);
  }
  /// A face's colour: what its line still holds.
  bool read_face_color(ColorNumbers& color) {
    while (color.count < kMostColorNumbers && !text_.at_line_end()) {
      if (!read_number(color)) {
        return false;
      }
    }
    return true;
  }
  void end_face() { text_.next_line(); }
  /// The number of edges, where the line goes on.
  bool read_over_edges() {
    std::int64_t edges = 0;
    return text_.at_line_end() || text_.integer(edges);
  }
  [[nodiscard]] bool has_more() {
    text_.skip_space();
    return !text_.at_end();
  }
  [[nodiscard]] std::size_t remaining() const { return text_.remaining() + 1; }  // the last number needs nothing behind it
  [[nodiscard]] std::size_t line() const { return text_.line(); }
  [[nodiscard]] std::string place() const { return at_line(file_, text_.line()); }
  [[nodiscard]] std::string found() {
    const std::string_view word = text_.word();
    return word.empty() ? text_.at_end() ? "the end of the file" : "the end of the line" : shown(word);
  }

 private:
  bool read_number(ColorNumbers& color) {
    const std::string_view word = text_.peek_word();
    color.is_whole = color.is_whole && word.find_first_not_of("+-0123456789") == std::string_view::npos;
    return text_.number(color.values[color.count++]);
  }
  bool read_numbers(ColorNumbers& color, std::size_t count) {
    while (color.count < count) {
      text_.skip_space();
      if (!read_number(color)) {
        return false;
      }
    }
    return true;
  }

  TextCursor text_;
  const std::string& file_;
};

/// Values of a binary file: 32 bits each, the most significant byte first.
class OffBytes {
 public:
  OffBytes(std::string_view bytes, std::size_t begin, const std::string& file) : bytes_(bytes), at_(begin), file_(file) {}

  static constexpr std::size_t kLeastBytes = 4;

  bool read(float& value) {
    std::uint32_t bits = 0;
    const bool is_read = read_bits(bits);
    value = std::bit_cast<float>(bits);
    return is_read;
  }
  bool read(std::int64_t& value) {
    std::uint32_t bits = 0;
    const bool is_read = read_bits(bits);
    value = static_cast<std::int32_t>(bits);
    return is_read;
  }
  bool read_vertex_color(ColorNumbers& color, std::size_t /*behind*/) { return read_numbers(color, 4); }
  bool read_face_color(ColorNumbers& color) {
    std::int64_t count = 0;
    return read(count) && count >= 0 && count <= static_cast<std::int64_t>(kMostColorNumbers) &&
           read_numbers(color, static_cast<std::size_t>(count));
  }
  void end_face() {}
  bool read_over_edges() {
    std::int64_t edges = 0;
    return read(edges);
  }
  [[nodiscard]] bool has_more() const { return at_ < bytes_.size(); }
  [[nodiscard]] std::size_t remaining() const { return bytes_.size() - at_; }
  [[nodiscard]] static std::size_t line() { return 0; }
  [[nodiscard]] std::string place() const { return at_byte(file_, at_); }
  [[nodiscard]] std::string found() const {
    return remaining() < 4 ? std::string("the end of the file") : fmt::format("{}", static_cast<std::int32_t>(bits_at(at_)));
  }

 private:
  [[nodiscard]] std::uint32_t bits_at(std::size_t at) const {
    std::uint32_t bits = 0;
    std::memcpy(&bits, bytes_.data() + at, sizeof bits);
    return std::endian::native == std::endian::big ? bits : __builtin_bswap32(bits);
  }
  bool read_bits(std::uint32_t& bits) {
    if (remaining() < 4) {
      return false;
    }
    bits = bits_at(at_);
    at_ += 4;
    return true;
  }
  bool read_numbers(ColorNumbers& color, std::size_t count) {
    color.is_whole = false;
    while (color.count < count) {
      if (!read(color.values[color.count++])) {
        return false;
      }
    }
    return true;
  }

  std::string_view bytes_;
  std::size_t at_;
  const std::string& file_;
};

template <class Values>
class OffReader {
 public:
  OffReader(Values values, const OffKeyword& keyword, const std::string& file)
      : values_(std::move(values)), keyword_(keyword), file_(file), notes_(file) {}

  Result<SourceMesh> read(std::int64_t vertices, std::int64_t faces);

 private:
  bool check_count(std::int64_t count, const char* what, std::size_t least_numbers);
  bool read_vertex();
  bool read_face();
  bool read_face_color();
  bool error(ErrorKind kind, std::string place, std::string message) {
    error_ = Error{kind, std::move(place), std::move(message)};
    return false;
  }
  bool expected(const char* what) {
    std::string place = values_.place();
    return error(ErrorKind::malformed, std::move(place), fmt::format("expected {}, found {}", what, values_.found()));
  }
  bool read_vector(Vec3f& v) { return values_.read(v.x) && values_.read(v.y) && values_.read(v.z); }

  Values values_;
  OffKeyword keyword_;
  const std::string& file_;
  NoteBook notes_;
  SourceMesh mesh_;
  OffColors vertex_colors_;
  OffColors face_colors_;
  std::optional<Error> error_;
};

template <class Values>
Result<SourceMesh> OffReader<Values>::read(std::int64_t vertices, std::int64_t faces) {
  const std::size_t vertex_numbers = 3U + (keyword_.has_normals ? 3U : 0U) + (keyword_.has_colors ? 3U : 0U) + (keyword_.has_uvs ? 2U : 0U);
  bool is_good = check_count(vertices, "vertices", vertex_numbers) && check_count(faces, "faces", 1);
  if (is_good) {
    mesh_.positions.reserve(static_cast<std::size_t>(vertices));
    mesh_.face_begin.reserve(static_cast<std::size_t>(faces) + 1);
  }
  for (std::int64_t i = 0; is_good && i < vertices; ++i) {
    is_good = read_vertex();
  }
  for (std::int64_t i = 0; is_good && i < faces; ++i) {
    is_good = read_face();
  }
  if (!is_good) {
    return tl::unexpected(std::move(*error_));
  }
  if (values_.has_more()) {
    notes_.add(values_.line(), "data behind the last face are skipped");
  }
  if (keyword_.has_normals) {
    mesh_.corner_normal = mesh_.corner_position;
  }
  if (keyword_.has_uvs) {
    mesh_.corner_uv = mesh_.corner_position;
  }
  mesh_.colors = vertex_colors_.settle("vertex", notes_);
  mesh_.face_colors = face_colors_.settle("face", notes_);
  mesh_.notes = notes_.notes();
  return std::move(mesh_);
}

template <class Values>
bool OffReader<Values>::check_count(std::int64_t count, const char* what, std::size_t least_numbers) {
  if (count < 0) {
    return error(ErrorKind::malformed, values_.place(), fmt::format("{} {}", count, what));
  }
  const auto stated = static_cast<std::uint64_t>(count);
  if (stated > kMostElements) {
    return error(ErrorKind::limit, values_.place(), fmt::format("the header states {} {}, and at most {} are read", count, what, kMostElements));
  }
  const std::size_t least = least_numbers * Values::kLeastBytes;
  if (stated > values_.remaining() / least) {
    return error(ErrorKind::malformed, values_.place(),
                 fmt::format("the header states {} {}, which need {} bytes or more, and {} follow", count, what, stated * least,
                             values_.remaining() - (Values::kLeastBytes == 2 ? 1 : 0)));
  }
  return true;
}

template <class Values>
bool OffReader<Values>::read_vertex() {
  Vec3f vector;
  if (!read_vector(vector)) {
    return expected("a number of the vertex");
  }
  mesh_.positions.push_back(vector);
  if (keyword_.has_normals) {
    if (!read_vector(vector)) {
      return expected("a number of the vertex's normal");
    }
    mesh_.normals.push_back(vector);
  }
  if (keyword_.has_colors) {
    ColorNumbers color;
    if (!values_.read_vertex_color(color, keyword_.has_uvs ? 2 : 0)) {
      return expected("a number of the vertex's colour");
    }
    vertex_colors_.add(color.values, color.count, color.is_whole);
  }
  if (keyword_.has_uvs) {
    Vec2f uv;
    if (!(values_.read(uv.x) && values_.read(uv.y))) {
      return expected("a texture coordinate of the vertex");
    }
    mesh_.uvs.push_back(uv);
  }
  return true;
}

template <class Values>
bool OffReader<Values>::read_face() {
  std::int64_t corners = 0;
  if (!values_.read(corners)) {
    return expected("a face's number of corners");
  }
  if (corners < 0 || static_cast<std::uint64_t>(corners) > values_.remaining() / Values::kLeastBytes) {
    return error(ErrorKind::malformed, values_.place(), fmt::format("a face of {} corners", corners));
  }
  const std::size_t first = mesh_.corner_position.size();
  if (static_cast<std::size_t>(corners) > kMostElements - first) {
    return error(ErrorKind::limit, values_.place(), fmt::format("more than {} corners of faces", kMostElements));
  }
  const std::size_t line = values_.line();
  for (std::int64_t i = 0; i < corners; ++i) {
    std::int64_t index = 0;
    if (!values_.read(index)) {
      return expected("a vertex index");
    }
    if (index < 0 || static_cast<std::size_t>(index) >= mesh_.positions.size()) {
      return error(ErrorKind::malformed, values_.place(),
                   mesh_.positions.empty() ? fmt::format("vertex index {}, but the header states no vertices", index)
                                           : fmt::format("vertex index {} is outside 0..{}", index, mesh_.positions.size() - 1));
    }
    mesh_.corner_position.push_back(static_cast<std::uint32_t>(index));
  }
  if (corners >= 3) {
    mesh_.face_begin.push_back(static_cast<std::uint32_t>(mesh_.corner_position.size()));
    return read_face_color();
  }
  mesh_.corner_position.resize(first);
  notes_.add(line, "faces with fewer than three corners are dropped");
  ColorNumbers dropped;
  if (!values_.read_face_color(dropped)) {
    return expected("a number of the face's colour");
  }
  values_.end_face();
  return true;
}

template <class Values>
bool OffReader<Values>::read_face_color() {
  ColorNumbers color;
  const std::size_t line = values_.line();
  if (!values_.read_face_color(color)) {
    return expected("a number of the face's colour");
  }
  values_.end_face();
  if (color.count >= 3) {
    face_colors_.add(color.values, color.count, color.is_whole);
    return true;
  }
  face_colors_.add_none();
  if (color.count == 1) {
    notes_.add(line, "indices of a colour map, which does not come with the file, are ignored");
  } else if (color.count == 2) {
    notes_.add(line, "colours of two numbers are ignored");
  }
  return true;
}

/// Reads the counts of a header, then the mesh.
template <class Values>
Result<SourceMesh> read_counted(Values values, const OffKeyword& keyword, const std::string& file, std::string format) {
  std::int64_t vertices = 0;
  std::int64_t faces = 0;
  if (!values.read(vertices) || !values.read(faces) || !values.read_over_edges()) {
    std::string place = values.place();
    return fail(ErrorKind::malformed, std::move(place), fmt::format("expected the numbers of vertices and faces, found {}", values.found()));
  }
  Result<SourceMesh> mesh = OffReader<Values>(std::move(values), keyword, file).read(vertices, faces);
  if (mesh) {
    mesh->format = std::move(format);
  }
  return mesh;
}

}  // namespace

bool is_off(std::string_view bytes) {
  TextCursor text(bytes, {});
  text.skip_space();
  return off_keyword(text.word()).has_value();
}

Result<SourceMesh> parse_off(std::string_view bytes, const std::string& file) {
  TextCursor text(bytes, {});
  text.skip_space();
  const char* const begin = text.here();
  const std::size_t line = text.line();
  const OffKeyword keyword = off_keyword(text.word()).value_or(OffKeyword{});
  if (keyword.is_four || keyword.is_n) {
    return fail(ErrorKind::unsupported, at_line(file, line),
                fmt::format("{} holds points of other than three coordinates: expected OFF, or OFF led by ST, C or N", keyword.letters));
  }
  const std::string name = keyword.length == 0 ? "OFF" : std::string(keyword.letters);
  text.go_to(begin + keyword.length, line);  // counts may be glued to the keyword
  if (text.peek_word() != "BINARY") {
    return read_counted(OffWords(text, file), keyword, file, fmt::format("{} (ascii)", name));
  }
  const std::size_t end = bytes.find('\n', static_cast<std::size_t>(text.here() - bytes.data()));
  if (end == std::string_view::npos) {
    return fail(ErrorKind::malformed, at_line(file, line), "expected binary data behind the line, found the end of the file");
  }
  return read_counted(OffBytes(bytes, end + 1, file), keyword, file, fmt::format("{} (binary)", name));
}

}  // namespace lustro
