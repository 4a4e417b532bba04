// The nearest word: see suggest.hpp.
#include "suggest.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "scene/nearest.hpp"

namespace lustro::app {

std::string nearest_word(std::string_view typed, std::span<const std::string> known) {
  constexpr std::size_t kShortestBeginning = 3;
  if (typed.size() >= kShortestBeginning) {
    const auto longer = std::find_if(known.begin(), known.end(), [&](const std::string& word) { return word.starts_with(typed); });
    if (longer != known.end()) {
      return *longer;
    }
  }
  const std::vector<std::string_view> words(known.begin(), known.end());
  return std::string(nearest_name(typed, words).value_or(std::string_view()));
}

}  // namespace lustro::app
