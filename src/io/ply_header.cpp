// Reads the header line by line.
#include "io/ply_header.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "io/text.hpp"

namespace lustro {

namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypes{{
    {"char", PlyType::int8},
    {"int8", PlyType::int8},
    {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},
    {"short", PlyType::int16},
    {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},
    {"uint16", PlyType::uint16},
    {"int", PlyType::int32},
    {"int32", PlyType::int32},
    {"uint", PlyType::uint32},
    {"uint32", PlyType::uint32},
    {"float", PlyType::float32},
    {"float32", PlyType::float32},
    {"double", PlyType::float64},
    {"float64", PlyType::float64},
}};

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const std::string& file)
      : bytes_(bytes), file_(file), text_(bytes, {.hash_comments = false, .joined_lines = false}) {}

  Result<PlyHeader> read();

 private:
  bool read_line(std::string_view word);
  bool read_format();
  bool read_element();
  bool read_property();
  bool read_type(PlyType& type);
  void end_header();

  bool error(ErrorKind kind, std::string message) {
    error_ = Error{kind, at_line(file_, text_.line()), std::move(message)};
    return false;
  }
  bool expected(std::string_view what, std::string_view found) {
    return error(ErrorKind::malformed, fmt::format("expected {}, found {}", what, found.empty() ? "the end of the line" : shown(found)));
  }

  std::string_view bytes_;
  const std::string& file_;
  TextCursor text_;
  PlyHeader header_;
  bool has_format_ = false;
  bool is_done_ = false;
  std::optional<Error> error_;
};

Result<PlyHeader> HeaderReader::read() {
  if (const std::string_view magic = text_.word(); magic != "ply" || !text_.at_line_end()) {
    return fail(ErrorKind::malformed, at_line(file_, 1), fmt::format("expected the line ply, found {}", shown(magic)));
  }
  text_.next_line();
  while (!is_done_ && !text_.at_end()) {
    const std::string_view word = text_.word();
    if (!word.empty() && !read_line(word)) {
      return tl::unexpected(std::move(*error_));
    }
    if (!is_done_) {
      text_.next_line();
    }
  }
  if (!is_done_ || !has_format_) {
    return fail(ErrorKind::malformed, at_line(file_, text_.line()),
                is_done_ ? "the header states no format" : "the file ends before end_header");
  }
  return std::move(header_);
}

bool HeaderReader::read_line(std::string_view word) {
  if (word == "comment" || word == "obj_info") {
    return true;
  }
  if (word == "format") {
    return read_format();
  }
  if (word == "element") {
    return read_element();
  }
  if (word == "property") {
    return read_property();
  }
  if (word == "end_header") {
    end_header();
    return true;
  }
  return expected("format, element, property, comment, obj_info or end_header", word);
}

bool HeaderReader::read_format() {
  const std::string_view encoding = text_.word();
  if (encoding == "ascii") {
    header_.encoding = PlyEncoding::ascii;
  } else if (encoding == "binary_little_endian") {
    header_.encoding = PlyEncoding::little_endian;
  } else if (encoding == "binary_big_endian") {
    header_.encoding = PlyEncoding::big_endian;
  } else {
    return error(ErrorKind::unsupported, fmt::format("format {}: expected ascii, binary_little_endian or binary_big_endian", shown(encoding)));
  }
  const std::string_view version = text_.word();
  if (version != "1.0") {
    return error(ErrorKind::unsupported, fmt::format("version {}: expected 1.0", shown(version)));
  }
  has_format_ = true;
  return true;
}

bool HeaderReader::read_element() {
  const std::string_view name = text_.word();
  if (name.empty()) {
    return expected("the element's name", name);
  }
  std::int64_t count = 0;
  if (!text_.integer(count) || count < 0) {
    return error(ErrorKind::malformed, fmt::format("expected the number of elements {}", shown(name)));
  }
  header_.elements.push_back({std::string(name), static_cast<std::uint64_t>(count), {}});
  return true;
}

bool HeaderReader::read_property() {
  if (header_.elements.empty()) {
    return error(ErrorKind::malformed, "a property stands before the first element");
  }
  PlyProperty property;
  if (text_.peek_word() == "list") {
    static_cast<void>(text_.word());
    if (!read_type(property.count_type.emplace())) {
      return false;
    }
  }
  if (!read_type(property.type)) {
    return false;
  }
  property.name = text_.word();
  if (property.name.empty()) {
    return expected("the property's name", {});
  }
  header_.elements.back().properties.push_back(std::move(property));
  return true;
}

bool HeaderReader::read_type(PlyType& type) {
  const std::string_view name = text_.word();
  for (const auto& [known, value] : kTypes) {
    if (known == name) {
      type = value;
      return true;
    }
  }
  return error(ErrorKind::unsupported, fmt::format("type {}: expected char, uchar, short, ushort, int, uint, float or double", shown(name)));
}

// The body begins right behind the end of this line, and its first byte may look like one: only an end of line of the kind that the first
// line has is taken.
void HeaderReader::end_header() {
  is_done_ = true;
  const std::size_t first_end = bytes_.find_first_of("\r\n");
  const bool is_lone_cr = bytes_[first_end] == '\r' && (first_end + 1 == bytes_.size() || bytes_[first_end + 1] != '\n');
  const std::size_t at = bytes_.size() - text_.remaining();
  const std::size_t end = bytes_.find(is_lone_cr ? '\r' : '\n', at);
  header_.body = end == std::string_view::npos ? bytes_.size() : end + 1;
  header_.body_line = text_.line() + 1;
}

}  // namespace

std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

std::string ply_format_name(PlyEncoding encoding) {
  constexpr std::array kFormats{"PLY (ascii)", "PLY (binary, little endian)", "PLY (binary, big endian)"};
  return kFormats[static_cast<std::size_t>(encoding)];
}

bool is_ply_index_list(const PlyProperty& property) {
  return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
}

std::size_t least_bytes(const PlyElement& element, PlyEncoding encoding) {
  std::size_t bytes = 0;
  for (const PlyProperty& property : element.properties) {
    // ascii: a digit, and the blank or the line's end behind it (which only the very last may lack)
    bytes += encoding == PlyEncoding::ascii ? 2 : size_of(property.count_type.value_or(property.type));
  }
  return bytes;
}

Result<PlyHeader> parse_ply_header(std::string_view bytes, const std::string& file) {
  return HeaderReader(bytes, file).read();
}

}  // namespace lustro
