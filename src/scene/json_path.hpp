// Where in a JSON document a value stands: `lights[2].cutoff`. A chain of steps on the stack, made into text only for a message.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lustro {

struct JsonPath {
  const JsonPath* parent = nullptr;  ///< nullptr: the document itself
  std::string_view key{};
  std::size_t index = 0;
  bool is_index = false;

  [[nodiscard]] JsonPath operator/(std::string_view name) const { return {this, name, 0, false}; }
  [[nodiscard]] JsonPath operator[](std::size_t i) const { return {this, {}, i, true}; }

  /// `lights[2].cutoff`, `materials["old gold"].diffuse`; empty for the document itself.
  [[nodiscard]] std::string text() const;
};

/// One step appended to a path's text: `.key`, or `["odd key"]`.
[[nodiscard]] std::string joined_path(const std::string& path, std::string_view key);
[[nodiscard]] std::string joined_path(const std::string& path, std::size_t index);

}  // namespace lustro
