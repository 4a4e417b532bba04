// The command line as a whole: the root with its global flags, the subcommands, and the words with which a wrong line is refused.
#pragma once

#include <CLI/App.hpp>
#include <memory>
#include <string>
#include <vector>

#include "command.hpp"
#include "report.hpp"

namespace lustro::app {

struct CommandLine {
  std::unique_ptr<CLI::App> root;
  std::vector<Command> commands;  ///< in the order of the help

  [[nodiscard]] const Command* find(const std::string& name) const;
};

/// The root without subcommands. Global flags write into `session`, which must outlive the result.
[[nodiscard]] CommandLine make_command_line(Session& session);

/// Adds an empty subcommand with help and the global flags, which may stand before and after its name.
[[nodiscard]] CLI::App* add_subcommand(CommandLine& line, Session& session, const std::string& name, const std::string& summary);

/// Parses the arguments (without the program's name) and runs the subcommand that they name. `lustro FILE ...` is `lustro render FILE ...`.
[[nodiscard]] ExitCode run_command_line(CommandLine& line, std::vector<std::string> arguments);

}  // namespace lustro::app
