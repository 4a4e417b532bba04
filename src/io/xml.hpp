// XML read element by element, with the line of each.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lustro/result.hpp"

namespace lustro {

/// What begins: names are `namespace|local`, or `local` where there is no namespace. The texts live as long as the call.
struct XmlElement {
  std::string_view name;
  const char* const* attributes = nullptr;  ///< name and value in turn, then null
  std::size_t line = 0;

  [[nodiscard]] std::optional<std::string_view> attribute(std::string_view wanted) const {
    for (const char* const* a = attributes; *a != nullptr; a += 2) {
      if (wanted == *a) {
        return a[1];
      }
    }
    return std::nullopt;
  }
};

/// What is called while the text is read. An Error ends the reading; its place is the line.
struct XmlHandlers {
  std::function<std::optional<Error>(const XmlElement& element)> begin;
  std::function<void(std::string_view name)> end;
  std::function<void(std::string_view prefix, std::string_view name)> name_space;  ///< before the element that declares it; may be empty
};

/// Reads a document. Nothing outside of it is opened, and a document type declaration, the only source of entities, is an error.
/// where   for messages
/// errors  malformed with the line; limit for elements nested deeper than 256; what the handlers say
[[nodiscard]] Result<void> read_xml(std::string_view text, const std::string& where, const XmlHandlers& handlers);

}  // namespace lustro
