// Help text: usage, grouped options in two columns, examples: see help.hpp.
#include "help.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "exit_codes.hpp"
#include "report.hpp"

namespace lustro::app {
namespace {

constexpr int kIndent = 2;
constexpr int kColumn = 28;  // where descriptions begin

std::string heading(const std::string& text) {
  return stdout_has_color() ? fmt::format("\x1b[1m{}\x1b[0m\n", text) : text + "\n";
}

int columns_of(std::string_view text) {
  return static_cast<int>(std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string row(const std::string& term, const std::string& description) {
  std::string text(kIndent, ' ');
  text += term;
  int column = kIndent + columns_of(term);
  bool first = true;
  for (const std::string& line : wrapped(description, terminal_width() - kColumn)) {
    if (!first || column + 2 > kColumn) {
      text += '\n';
      column = 0;
    }
    text.append(static_cast<std::size_t>(kColumn - column), ' ');
    text += line;
    first = false;
  }
  return text + "\n";
}

std::string term_of(const OptionDoc& option) {
  const bool has_short = option.names.front().size() == 2 && option.names.front().front() == '-';
  std::string term = has_short ? "" : "    ";
  term += fmt::format("{}", fmt::join(option.names, ", "));
  if (!option.value.empty()) {
    term += " " + option.value;
  }
  return term;
}

std::string options_of(const CommandDoc& command) {
  std::string text;
  for (const std::string& group : command.groups()) {
    text += "\n" + heading(group + ":");
    for (const OptionDoc& option : command.options) {
      if (option.group == group) {
        text += row(term_of(option), option.description + (option.repeatable ? " (repeatable)" : ""));
      }
    }
  }
  return text;
}

std::string examples_of(const CommandDoc& command) {
  std::string text;
  if (!command.examples.empty()) {
    text += "\n" + heading("Examples:");
    for (const Example& example : command.examples) {
      text += fmt::format("  {}\n", example.command);
      for (const std::string& line : wrapped(example.meaning, terminal_width() - 6)) {
        text += fmt::format("      {}\n", line);
      }
    }
  }
  return text;
}

}  // namespace

std::vector<std::string> wrapped(std::string_view text, int width) {
  std::vector<std::string> lines(1);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    if (!lines.back().empty() && columns_of(lines.back()) + 1 + columns_of(word) > width) {
      lines.emplace_back();
    }
    lines.back() += (lines.back().empty() ? "" : " ") + std::string(word);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string root_help(const Manual& manual) {
  std::string text = fmt::format("{}.\n\n", manual.root.summary);
  text += heading("Usage:");
  text += "  lustro MESH|SCENE [OPTIONS]     the same as `lustro render`\n  lustro SUBCOMMAND [OPTIONS] ...\n";
  text += "\n" + heading("Subcommands:");
  for (const CommandDoc& command : manual.commands) {
    text += row(command.name, command.summary);
  }
  text += options_of(manual.root);
  text += "\n" + heading("Exit codes:");
  for (const ExitCodeMeaning& code : kExitCodes) {
    text += row(fmt::format("{:>2}", static_cast<int>(code.code)), std::string(code.meaning));
  }
  text += examples_of(manual.root);
  return text + "\n`lustro SUBCOMMAND --help` tells more of each; `man lustro` tells it all.\n";
}

std::string command_help(const CommandDoc& command) {
  std::string text;
  for (const std::string& line : wrapped(command.summary + ".", terminal_width())) {
    text += line + "\n";
  }
  text += "\n" + heading("Usage:") + fmt::format("  {}\n", command.usage());
  if (!command.positionals.empty()) {
    text += "\n" + heading("Arguments:");
    for (const OptionDoc& positional : command.positionals) {
      text += row(positional.names.front(), positional.description);
    }
  }
  return text + options_of(command) + examples_of(command);
}

}  // namespace lustro::app
