// Options of a few words: see words.hpp.
#include "words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "suggest.hpp"

namespace lustro::app {

std::vector<std::string> strings_of(std::span<const Word> words) {
  std::vector<std::string> strings;
  for (const Word& word : words) {
    strings.emplace_back(word.word);
  }
  return strings;
}

CLI::Option* one_of(CLI::Option* option, std::vector<std::string> words) {
  option->type_name(fmt::format("{}", fmt::join(words, "|")));
  CLI::Validator is_known(
      [words = std::move(words)](std::string& value) -> std::string {
        if (std::find(words.begin(), words.end(), value) != words.end()) {
          return {};
        }
        const std::string nearest = nearest_word(value, words);
        return fmt::format("`{}` is not one of {}{}", value, fmt::join(words, ", "),
                           nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest));
      },
      std::string());
  return option->check(is_known);
}

}  // namespace lustro::app
