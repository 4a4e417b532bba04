// `--help`: the manual on a terminal.
#pragma once

#include <string>

#include "manual.hpp"

namespace lustro::app {

[[nodiscard]] std::string root_help(const Manual& manual);
[[nodiscard]] std::string command_help(const CommandDoc& command);

/// Breaks a text into lines of at most `width` columns (UTF-8 counted by code points), at spaces.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, int width);

}  // namespace lustro::app
