// The header of PLY files: which elements follow, with which properties, in which encoding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lustro/result.hpp"

namespace lustro {

enum class PlyEncoding : std::uint8_t { ascii, little_endian, big_endian };

/// The scalar types, each under its two names (char and int8, ...).
enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of a scalar.
[[nodiscard]] std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count_type;  ///< stated for a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t body = 0;       ///< byte at which the data begin
  std::size_t body_line = 1;  ///< line at which they begin
};

/// `PLY (ascii)`, ...
[[nodiscard]] std::string ply_format_name(PlyEncoding encoding);

/// True for the list of a face's corners.
[[nodiscard]] bool is_ply_index_list(const PlyProperty& property);

/// The header of a PLY file. Its lines end with LF, CRLF or CR, as its first line does; a binary body begins behind the last one.
/// errors  malformed with the line; unsupported for a version that is not 1.0 or an unknown encoding or type
/// source  Turk, The PLY polygon file format, 1994
[[nodiscard]] Result<PlyHeader> parse_ply_header(std::string_view bytes, const std::string& file);

/// The fewest bytes that one element takes in the body.
[[nodiscard]] std::size_t least_bytes(const PlyElement& element, PlyEncoding encoding);

}  // namespace lustro
