// Completion scripts: see completions.hpp. Each knows that a file in place of a subcommand means `render`.
#include "completions.hpp"

#include <fmt/format.h>

#include <string_view>

namespace lustro::app {
namespace {

std::string replaced(std::string_view text, std::string_view characters, std::string_view escape) {
  std::string result;
  for (const char c : text) {
    if (characters.find(c) != std::string_view::npos) {
      result += escape;
    }
    result += c;
  }
  return result;
}

std::string single_quoted(std::string_view text) {
  std::string result = "'";
  for (const char c : text) {
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return result + "'";
}

bool takes_file(const OptionDoc& option) {
  return option.value.find("FILE") != std::string::npos || option.value == "OUT";
}
bool positional_is_file(const OptionDoc& positional) {
  return positional.value.find("FILE") != std::string::npos;
}

std::string subcommand_names(const Manual& manual) {
  std::string names;
  for (const CommandDoc& command : manual.commands) {
    names += (names.empty() ? "" : " ") + command.name;
  }
  return names;
}

// --- bash ----------------------------------------------------------------------------------------------------------------------

std::string bash_values(const CommandDoc& command) {
  std::string cases;
  for (const OptionDoc& option : command.options) {
    if (option.value.empty()) {
      continue;
    }
    const std::string names = fmt::format("{}", fmt::join(option.names, "|"));
    const std::string action = takes_file(option) ? "COMPREPLY=($(compgen -f -- \"$cur\")); compopt -o filenames 2>/dev/null"
                               : option.choices().empty()
                                   ? std::string("COMPREPLY=()")
                                   : fmt::format("COMPREPLY=($(compgen -W \"{}\" -- \"$cur\"))", fmt::join(option.choices(), " "));
    cases += fmt::format("        {}) {}; return ;;\n", names, action);
  }
  return cases;
}

std::string bash_command(const CommandDoc& command) {
  std::string flags;
  for (const OptionDoc& option : command.options) {
    flags += (flags.empty() ? "" : " ") + fmt::format("{}", fmt::join(option.names, " "));
  }
  std::string words;
  for (const OptionDoc& positional : command.positionals) {
    words += fmt::format("{}{}", words.empty() ? "" : " ", fmt::join(positional.choices(), " "));
  }
  std::string text = fmt::format("    {})\n      case \"$prev\" in\n{}      esac\n", command.name, bash_values(command));
  text += fmt::format("      if [[ \"$cur\" == -* ]]; then COMPREPLY=($(compgen -W \"{}\" -- \"$cur\")); return; fi\n", flags);
  if (!words.empty()) {
    text += fmt::format("      COMPREPLY=($(compgen -W \"{}\" -- \"$cur\")); return\n", words);
  }
  return text + "      ;;\n";
}

// --- zsh -----------------------------------------------------------------------------------------------------------------------

std::string zsh_action(const std::vector<std::string>& choices, bool is_file) {
  if (is_file) {
    return "_files";
  }
  return choices.empty() ? " " : fmt::format("({})", fmt::join(choices, " "));
}

std::string zsh_option(const OptionDoc& option) {
  std::string text;
  for (const std::string& name : option.names) {
    const bool is_long = name.starts_with("--");
    std::string spec = option.repeatable ? "*" : fmt::format("({})", fmt::join(option.names, " "));
    spec += name + (option.value.empty() ? "" : is_long ? "=" : "+");
    spec += fmt::format("[{}]", replaced(option.description, "[]\\", "\\"));
    if (!option.value.empty()) {
      spec += fmt::format(":{}:{}", replaced(option.value, ":\\", "\\"), zsh_action(option.choices(), takes_file(option)));
    }
    text += fmt::format("        {} \\\n", single_quoted(spec));
  }
  return text;
}

std::string zsh_command(const CommandDoc& command) {
  std::string text = fmt::format("    {})\n      _arguments -s \\\n", command.name);
  for (const OptionDoc& option : command.options) {
    text += zsh_option(option);
  }
  for (const OptionDoc& positional : command.positionals) {
    const std::string count = positional.repeatable ? "*" : "";
    text += fmt::format("        {} \\\n", single_quoted(fmt::format("{}:{}:{}", count, replaced(positional.names.front(), ":\\", "\\"),
                                                                     zsh_action(positional.choices(), positional_is_file(positional)))));
  }
  return text + "        && return\n      ;;\n";
}

// --- fish ----------------------------------------------------------------------------------------------------------------------

std::string fish_option(const std::string& condition, const OptionDoc& option) {
  std::string text = "complete -c lustro -n " + single_quoted(condition);
  for (const std::string& name : option.names) {
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  if (!option.value.empty()) {
    text += takes_file(option) ? " -r -F" : " -x";
    if (const auto choices = option.choices(); !choices.empty()) {
      text += " -a " + single_quoted(fmt::format("{}", fmt::join(choices, " ")));
    }
  }
  return text + " -d " + single_quoted(option.description) + "\n";
}

}  // namespace

std::string bash_completion(const Manual& manual) {
  std::string text =
      "# bash completion for lustro; made by `lustro completions bash`\n"
      "_lustro() {\n"
      "  local cur=\"${COMP_WORDS[COMP_CWORD]}\" prev=\"${COMP_WORDS[COMP_CWORD-1]}\" command=\"\" word i\n"
      "  for ((i = 1; i < COMP_CWORD; i++)); do\n"
      "    word=\"${COMP_WORDS[i]}\"\n"
      "    case \"$word\" in\n"
      "      --threads) ((i++)) ;;\n"
      "      -*) ;;\n";
  std::string alternatives = subcommand_names(manual);
  for (std::size_t at = alternatives.find(' '); at != std::string::npos; at = alternatives.find(' ', at + 1)) {
    alternatives[at] = '|';
  }
  text += fmt::format("      {}) command=\"$word\"; break ;;\n", alternatives);
  text +=
      "      *) command=render; break ;;\n"
      "    esac\n"
      "  done\n"
      "  COMPREPLY=()\n"
      "  case \"${command:-none}\" in\n";
  for (const CommandDoc& command : manual.commands) {
    text += bash_command(command);
  }
  std::string flags;
  for (const OptionDoc& option : manual.root.options) {
    flags += (flags.empty() ? "" : " ") + fmt::format("{}", fmt::join(option.names, " "));
  }
  text += fmt::format("    none)\n      if [[ \"$cur\" == -* ]]; then COMPREPLY=($(compgen -W \"{}\" -- \"$cur\")); return; fi\n", flags);
  text += fmt::format("      COMPREPLY=($(compgen -W \"{}\" -- \"$cur\"))\n      ;;\n", subcommand_names(manual));
  return text +
         "  esac\n"
         "  COMPREPLY+=($(compgen -f -- \"$cur\"))\n"
         "  compopt -o filenames 2>/dev/null\n"
         "}\n"
         "complete -F _lustro lustro\n";
}

std::string zsh_completion(const Manual& manual) {
  std::string text =
      "#compdef lustro\n# zsh completion for lustro; made by `lustro completions zsh`\n_lustro() {\n  local -a subcommands\n  subcommands=(\n";
  for (const CommandDoc& command : manual.commands) {
    text += fmt::format("    {}\n", single_quoted(fmt::format("{}:{}", command.name, replaced(command.summary, ":\\", "\\"))));
  }
  text +=
      "  )\n"
      "  local command=\"\" i\n"
      "  for ((i = 2; i < CURRENT; i++)); do\n"
      "    case \"${words[i]}\" in\n"
      "      --threads) ((i++)) ;;\n"
      "      -*) ;;\n"
      "      *) command=\"${words[i]}\"; break ;;\n"
      "    esac\n"
      "  done\n"
      "  if [[ -z \"$command\" ]]; then\n"
      "    if [[ \"${words[CURRENT]}\" == -* ]]; then\n"
      "      _arguments -s \\\n";
  for (const OptionDoc& option : manual.root.options) {
    text += zsh_option(option);
  }
  text +=
      "        && return\n"
      "    fi\n"
      "    _describe -t subcommands subcommand subcommands\n"
      "    _files\n"
      "    return\n"
      "  fi\n"
      "  (( ${subcommands[(I)${command}:*]} )) && { words=(\"${(@)words[i,-1]}\"); (( CURRENT -= i - 1 )) } || command=render\n"
      "  case \"$command\" in\n";
  for (const CommandDoc& command : manual.commands) {
    text += zsh_command(command);
  }
  return text + "  esac\n}\nif [[ \"${funcstack[1]}\" == _lustro ]]; then _lustro \"$@\"; else compdef _lustro lustro; fi\n";
}

std::string fish_completion(const Manual& manual) {
  const std::string names = subcommand_names(manual);
  const std::string none = fmt::format("not __fish_seen_subcommand_from {}", names);
  std::string text = "# fish completion for lustro; made by `lustro completions fish`\n";
  for (const CommandDoc& command : manual.commands) {
    text += fmt::format("complete -c lustro -n '__fish_use_subcommand' -a {} -d {}\n", command.name, single_quoted(command.summary));
  }
  for (const OptionDoc& option : manual.root.options) {
    if (option.names.back() == "--version") {
      text += fish_option("__fish_use_subcommand", option);
    }
  }
  for (const CommandDoc& command : manual.commands) {
    // A file in place of a subcommand means render, so its flags are offered there as well.
    const std::string condition = command.name == "render" ? fmt::format("__fish_seen_subcommand_from render; or {}", none)
                                                           : fmt::format("__fish_seen_subcommand_from {}", command.name);
    bool wants_files = false;
    for (const OptionDoc& positional : command.positionals) {
      wants_files = wants_files || positional_is_file(positional);
      if (const auto choices = positional.choices(); !choices.empty()) {
        text += fmt::format("complete -c lustro -f -n {} -a {}\n", single_quoted(condition),
                            single_quoted(fmt::format("{}", fmt::join(choices, " "))));
      }
    }
    if (!wants_files && command.name != "render") {
      text += fmt::format("complete -c lustro -f -n {}\n", single_quoted(condition));
    }
    for (const OptionDoc& option : command.options) {
      text += fish_option(condition, option);
    }
  }
  return text;
}

}  // namespace lustro::app
