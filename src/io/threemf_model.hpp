// One model part of a 3MF package: its XML as data, nothing resolved yet.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/note_book.hpp"
#include "lustro/result.hpp"
#include "lustro/vec.hpp"

namespace lustro {

/// A group of properties that triangles name by its id and an index.
struct ThreeMfGroup {
  enum class Kind : std::uint8_t { base, color, other };
  Kind kind = Kind::other;
  std::vector<std::string> names;  ///< of base materials
  std::vector<Vec3f> colors;       ///< `encoded`
  std::vector<float> alphas;
};

struct ThreeMfTriangle {
  std::array<std::uint32_t, 3> corner{};
  std::uint32_t group = 0;  ///< the group's id; 0: none
  std::array<std::uint32_t, 3> property{};
};

/// An object that is placed: by a component or by the build.
struct ThreeMfUse {
  std::string part;  ///< of another model part; empty: this one
  std::uint32_t object = 0;
  Mat4 matrix{};
  std::size_t line = 0;
};

struct ThreeMfObject {
  std::string name;
  std::vector<Vec3f> positions;
  std::vector<ThreeMfTriangle> triangles;
  std::vector<ThreeMfUse> components;
  std::uint32_t group = 0;  ///< of triangles without one of their own; 0: none
  std::uint32_t property = 0;
};

struct ThreeMfModel {
  double millimetres = 1;  ///< of a unit
  std::string unit = "millimeter";
  std::map<std::uint32_t, ThreeMfObject> objects;
  std::map<std::uint32_t, ThreeMfGroup> groups;
  std::vector<ThreeMfUse> build;
};

/// Reads a model part. Indices of vertices and properties are checked, ids are not.
/// part    its name, for messages: `file: part:line`
/// errors  malformed with the line for broken XML, a document type declaration (entities are not part of 3MF), missing or wrong attributes;
///         unsupported for a required extension that is not known; limit
/// source  3MF Consortium: Core Specification 1.3, Materials and Properties Extension 1.2, Production Extension 1.1
[[nodiscard]] Result<ThreeMfModel> parse_threemf_model(std::string_view xml, const std::string& part, NoteBook& notes);

/// The target of the package's relationship to its model (_rels/.rels), without a slash at its start; empty where there is none.
[[nodiscard]] Result<std::string> parse_threemf_relationships(std::string_view xml, const std::string& part);

}  // namespace lustro
