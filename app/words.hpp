// Options whose value is one of a few words.
#pragma once

#include <CLI/Option.hpp>
#include <span>
#include <string>
#include <vector>

#include "scene/words.hpp"

namespace lustro::app {

/// The words of an enum, for one_of().
[[nodiscard]] std::vector<std::string> strings_of(std::span<const Word> words);

/// Checks the option's value against the words, and shows them as its value `a|b|c`; a mistyped word brings the nearest one.
CLI::Option* one_of(CLI::Option* option, std::vector<std::string> words);

}  // namespace lustro::app
