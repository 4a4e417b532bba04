// Ascii STL, see stl.hpp.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "lustro/mesh.hpp"
#include "lustro/result.hpp"

namespace lustro {

/// The facets of an ascii STL file.
[[nodiscard]] Result<SourceMesh> parse_stl_text(std::string_view bytes, const std::string& file);

/// True where `word` is `lower` but for the case of its ASCII letters.
[[nodiscard]] inline bool same_word(std::string_view word, std::string_view lower) {
  const auto lower_of = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(), [&](char a, char b) { return lower_of(a) == b; });
}

}  // namespace lustro
