// Reads the keyword letter by letter.
#include "io/off_header.hpp"

namespace lustro {

std::optional<OffKeyword> off_keyword(std::string_view word) {
  OffKeyword keyword;
  std::string_view rest = word;
  const auto take = [&rest](std::string_view mark, bool& is_set) {
    if (is_set || !rest.starts_with(mark)) {
      return false;
    }
    is_set = true;
    rest.remove_prefix(mark.size());
    return true;
  };
  while (take("ST", keyword.has_uvs) || take("C", keyword.has_colors) || take("N", keyword.has_normals) || take("4", keyword.is_four) ||
         take("n", keyword.is_n)) {
  }
  bool is_off = false;
  if (!take("OFF", is_off) || !(rest.empty() || (rest.front() >= '0' && rest.front() <= '9'))) {
    return std::nullopt;
  }
  keyword.length = word.size() - rest.size();
  keyword.letters = word.substr(0, keyword.length);
  return keyword;
}

}  // namespace lustro
