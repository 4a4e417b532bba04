// lustro(1) in the man macros of groff_man(7). It holds no date, so that equal sources give equal pages.
#include "man_page.hpp"

#include <fmt/format.h>

#include "exit_codes.hpp"
#include "lustro/version.hpp"

namespace lustro::app {
namespace {

/// Text as roff prints it: backslashes and hyphens escaped, nothing at the line's start that roff would take for a request.
std::string roff(std::string_view text) {
  std::string result;
  if (!text.empty() && (text.front() == '.' || text.front() == '\'')) {
    result = "\\&";
  }
  for (const char c : text) {
    switch (c) {
      case '\\':
        result += "\\e";
        break;
      case '-':
        result += "\\-";
        break;
      case '\'':
        result += "\\(aq";
        break;
      case '`':
        result += "\\(ga";
        break;
      case '^':
        result += "\\(ha";
        break;
      case '~':
        result += "\\(ti";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string term_of(const OptionDoc& option) {
  std::string term;
  for (const std::string& name : option.names) {
    term += fmt::format("{}\\fB{}\\fR", term.empty() ? "" : ", ", roff(name));
  }
  if (!option.value.empty()) {
    term += fmt::format(" \\fI{}\\fR", roff(option.value));
  }
  return term;
}

std::string entry(const std::string& term, const std::string& description) {
  return fmt::format(".TP\n{}\n{}.\n", term, roff(description));
}

std::string options_of(const CommandDoc& command, bool with_globals) {
  std::string text;
  for (const std::string& group : command.groups()) {
    if (group == "Global options" && !with_globals) {
      continue;
    }
    text += fmt::format(".PP\n\\fB{}\\fR\n", roff(group));
    for (const OptionDoc& option : command.options) {
      if (option.group == group) {
        text += entry(term_of(option), option.description + (option.repeatable ? "; may be repeated" : ""));
      }
    }
  }
  return text;
}

std::string examples_of(const CommandDoc& command) {
  std::string text;
  for (const Example& example : command.examples) {
    text += fmt::format(".TP\n\\fB{}\\fR\n{}\n", roff(example.command), roff(example.meaning));
  }
  return text;
}

std::string section_of(const CommandDoc& command) {
  std::string text = fmt::format(".SS {}\n.B {}\n.PP\n{}.\n", roff("lustro " + command.name), roff(command.usage()), roff(command.summary));
  for (const OptionDoc& positional : command.positionals) {
    text += entry(fmt::format("\\fI{}\\fR", roff(positional.names.front())), positional.description);
  }
  return text + options_of(command, false) + (command.examples.empty() ? "" : ".PP\n\\fBExamples\\fR\n") + examples_of(command);
}

}  // namespace

std::string man_page(const Manual& manual) {
  std::string page = fmt::format(".TH LUSTRO 1 \"\" \"lustro {}\" \"User Commands\"\n", LUSTRO_VERSION);
  page += fmt::format(".SH NAME\nlustro \\- {}\n", "lights and shades triangle meshes on the CPU");
  page += ".SH SYNOPSIS\n.B lustro\n.I MESH\\fR|\\fISCENE\n.RI [ OPTIONS ]\n.br\n.B lustro\n.I SUBCOMMAND\n.RI [ OPTIONS ]\n.I ...\n";
  page +=
      ".SH DESCRIPTION\nLustro draws triangle meshes (OBJ, PLY, STL, OFF, 3MF, glTF) with the classic lighting and shading models: Lambert, "
      "Phong and "
      "Blinn\\-Phong "
      "lighting; flat, Gouraud and Phong interpolation. The same input gives the same picture, bit for bit, on every machine and with any "
      "number "
      "of threads.\n.PP\nA scene is one JSON file; \\fBlustro schema\\fR prints its JSON Schema. A mesh file in its place is the scene with "
      "that "
      "one object. The picture goes where \\fB\\-o\\fR says, complete or not at all; nothing else is written to standard output but what was "
      "asked "
      "for.\n";
  page += ".SH SUBCOMMANDS\n";
  for (const CommandDoc& command : manual.commands) {
    page += section_of(command);
  }
  page += ".SH OPTIONS\nThese stand before or after the subcommand.\n" + options_of(manual.root, true);
  page += ".SH EXIT STATUS\n";
  for (const ExitCodeMeaning& code : kExitCodes) {
    page += entry(fmt::format("\\fB{}\\fR", static_cast<int>(code.code)), std::string(code.meaning));
  }
  page += ".SH ENVIRONMENT\n" + entry("\\fBNO_COLOR\\fR", "If set and not empty, nothing is coloured, not even on a terminal");
  page += entry("\\fBLUSTRO_TARGET\\fR", "What --target says where it is not stated");
  page += entry("\\fBCOLUMNS\\fR", "The width of help and tables, 60 to 110");
  return page + ".SH EXAMPLES\n" + examples_of(manual.root);
}

}  // namespace lustro::app
