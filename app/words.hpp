// Options whose value is one of a few words.
#pragma once

#include <CLI/Option.hpp>
#include <string>
#include <vector>

namespace lustro::app {

/// Checks the option's value against the words, and shows them as its value `a|b|c`; a mistyped word brings the nearest one.
CLI::Option* one_of(CLI::Option* option, std::vector<std::string> words);

}  // namespace lustro::app
