// The command line as a whole: the root with its global flags, the subcommands, and the words with which a wrong line is refused.
#pragma once

#include <CLI/App.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"
#include "report.hpp"

namespace lustro::app {

struct CommandLine;

/// A subcommand that there is. Some have a hundred flags, so those that nobody names are not made.
struct CommandMaker {
  std::string_view name;
  Command (*make)(CommandLine& line, Session& session);
};

struct CommandLine {
  std::unique_ptr<CLI::App> root;
  std::span<const CommandMaker> makers;  ///< in the order of the help
  std::vector<Command> commands;         ///< those that were made
};

/// The root without subcommands. Global flags write into `session`, which must outlive the result, as must `makers`.
[[nodiscard]] CommandLine make_command_line(Session& session, std::span<const CommandMaker> makers);

/// Adds an empty subcommand with help and the global flags, which may stand before and after its name.
[[nodiscard]] CLI::App* add_subcommand(CommandLine& line, Session& session, const std::string& name, const std::string& summary);

/// Parses the arguments (without the program's name), and makes and runs the subcommand that they name. `lustro FILE ...` is
/// `lustro render FILE ...`.
[[nodiscard]] ExitCode run_command_line(std::span<const CommandMaker> makers, std::vector<std::string> arguments);

}  // namespace lustro::app
