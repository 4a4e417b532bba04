// The nearest word by edit distance: see suggest.hpp.
#include "suggest.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lustro::app {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    above[j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before = above;
    above = row;
  }
  return above[b.size()];
}

}  // namespace

std::string nearest_word(std::string_view typed, std::span<const std::string> known) {
  constexpr std::size_t kLongest = 64;  // nobody mistypes a word of that length; an endless argument costs nothing
  if (typed.empty() || typed.size() > kLongest) {
    return {};
  }
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(1, typed.size() / 3) + 1;
  for (const std::string& word : known) {
    // A word of which the beginning was typed is meant whatever its length: `--inter` for `--interpolation`.
    const bool is_beginning = typed.size() >= 3 && word.starts_with(typed);
    const std::size_t distance = is_beginning ? 1 : edit_distance(typed, word);
    if (distance < best_distance) {
      best = word;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace lustro::app
