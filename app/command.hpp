// A subcommand: its flags, its examples, and what it does.
#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <string>
#include <vector>

#include "exit_codes.hpp"
#include "lustro/result.hpp"
#include "report.hpp"

namespace lustro::app {

struct Example {
  std::string command;  ///< `lustro render bunny.ply -o bunny.png`
  std::string meaning;
};

struct Command {
  CLI::App* app = nullptr;  ///< the flags; owned by the root
  std::vector<Example> examples;
  std::function<Result<ExitCode>()> run;
};

// Conventions of the flags, on which help, man page and completions rest:
// - an option's type name is what its value looks like: FILE and FOLDER complete as such, `a|b|c` completes and is checked as one of these
// words;
// - an option's group is the heading it stands under;
// - a description is one line without a final full stop; a default stands in it as `(default: 4)`.

}  // namespace lustro::app
