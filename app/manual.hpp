// The command line as a document: what help, man page and completions are made from, so that the three cannot differ.
#pragma once

#include <string>
#include <vector>

#include "command_line.hpp"

namespace lustro::app {

struct OptionDoc {
  std::vector<std::string> names;  ///< `-o`, `--output`; a positional's one name
  std::string value;               ///< `FILE`, `flat|gouraud|phong`, ...; empty for a switch
  std::string description;
  std::string group;
  bool repeatable = false;
  bool required = false;

  /// The words that the value may be, where it is one of a few.
  [[nodiscard]] std::vector<std::string> choices() const;
};

struct CommandDoc {
  std::string name;     ///< empty: the root
  std::string summary;  ///< one line
  std::vector<OptionDoc> positionals;
  std::vector<OptionDoc> options;  ///< in the order of their groups
  std::vector<Example> examples;

  [[nodiscard]] std::string usage() const;  ///< `lustro render [OPTIONS] SCENE`
  [[nodiscard]] std::vector<std::string> groups() const;
};

struct Manual {
  CommandDoc root;
  std::vector<CommandDoc> commands;

  [[nodiscard]] const CommandDoc* find(const std::string& name) const;
};

/// All subcommands, made for the purpose.
[[nodiscard]] Manual make_manual(std::span<const CommandMaker> makers);

}  // namespace lustro::app
