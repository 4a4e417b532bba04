// The keyword of an OFF file: what its vertices hold.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace lustro {

struct OffKeyword {
  bool has_normals = false;
  bool has_colors = false;
  bool has_uvs = false;
  bool is_four = false;        ///< 4OFF: homogeneous coordinates
  bool is_n = false;           ///< nOFF: any number of coordinates
  std::size_t length = 0;      ///< of the keyword, without digits that are glued to it
  std::string_view letters{};  ///< the keyword itself
};

/// The keyword that a word begins with: the letters ST, C, N, 4 and n, each at most once, then OFF; nothing where it is another word.
[[nodiscard]] std::optional<OffKeyword> off_keyword(std::string_view word);

}  // namespace lustro
