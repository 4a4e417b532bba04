// From the CLI11 tree to a document: see manual.hpp.
#include "manual.hpp"

#include <algorithm>
#include <cctype>

#include "lustro/material.hpp"

namespace lustro::app {
namespace {

OptionDoc option_doc(const CLI::Option& option) {
  OptionDoc doc;
  if (option.get_positional()) {
    doc.names.push_back(option.get_name(true));
  } else {
    for (const std::string& name : option.get_snames()) {
      doc.names.push_back("-" + name);
    }
    for (const std::string& name : option.get_lnames()) {
      doc.names.push_back("--" + name);
    }
  }
  doc.value = option.get_items_expected_max() == 0 ? std::string() : option.get_type_name();
  doc.description = option.get_description();
  doc.group = option.get_group();
  doc.repeatable = option.get_expected_max() > 1;
  doc.required = option.get_required();
  return doc;
}

CommandDoc command_doc(const CLI::App& app, const std::string& name, std::vector<Example> examples) {
  CommandDoc doc;
  doc.name = name;
  doc.summary = app.get_description();
  doc.examples = std::move(examples);
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) {
      continue;  // hidden
    }
    (option->get_positional() ? doc.positionals : doc.options).push_back(option_doc(*option));
  }
  // Global options come last, the help flag last of all.
  std::stable_partition(doc.options.begin(), doc.options.end(), [](const OptionDoc& o) { return o.group != "Global options"; });
  std::stable_partition(doc.options.begin(), doc.options.end(), [](const OptionDoc& o) { return o.names.back() != "--help"; });
  return doc;
}

}  // namespace

std::vector<std::string> OptionDoc::choices() const {
  std::vector<std::string> words;
  if (value == "MATERIAL") {  // the library's names, which are most of what is typed here
    for (const Material& material : material_library()) {
      words.push_back(material.name);
    }
    return words;
  }
  // A part with capitals or commas stands for something: `X,Y,Z|auto|avx2`.
  const auto is_word = [](const std::string& part) {
    return std::none_of(part.begin(), part.end(), [](unsigned char c) { return std::isupper(c) != 0 || c == ' ' || c == '[' || c == ','; });
  };
  const bool is_list = value.find('|') != std::string::npos;
  for (std::size_t begin = 0; is_list && begin <= value.size();) {
    const std::size_t end = std::min(value.find('|', begin), value.size());
    if (std::string part = value.substr(begin, end - begin); is_word(part)) {
      words.push_back(std::move(part));
    }
    begin = end + 1;
  }
  return words;
}

std::string CommandDoc::usage() const {
  std::string line = name.empty() ? "lustro" : "lustro " + name;
  line += " [OPTIONS]";
  for (const OptionDoc& positional : positionals) {
    const std::string shown = positional.names.front() + (positional.repeatable ? "..." : "");
    line += positional.required ? " " + shown : " [" + shown + "]";
  }
  return line;
}

std::vector<std::string> CommandDoc::groups() const {
  std::vector<std::string> names;
  for (const OptionDoc& option : options) {
    if (std::find(names.begin(), names.end(), option.group) == names.end()) {
      names.push_back(option.group);
    }
  }
  return names;
}

const CommandDoc* Manual::find(const std::string& name) const {
  const auto found = std::find_if(commands.begin(), commands.end(), [&](const CommandDoc& command) { return command.name == name; });
  return found == commands.end() ? nullptr : &*found;
}

Manual make_manual(std::span<const CommandMaker> makers) {
  Session session;
  CommandLine line = make_command_line(session, makers);
  Manual manual;
  manual.root = command_doc(*line.root, "",
                            {{"lustro bunny.ply", "draws the mesh from a pleasant side into bunny.png, beside it"},
                             {"lustro render scene.json -o scene.png", "draws a scene file"},
                             {"lustro primitive:teapot --material jade -o teapot.png", "needs no file at all"}});
  for (const CommandMaker& maker : makers) {
    const Command command = maker.make(line, session);
    manual.commands.push_back(command_doc(*command.app, command.app->get_name(), command.examples));
  }
  return manual;
}

}  // namespace lustro::app
