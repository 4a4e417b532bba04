// Parsing the command line and refusing a wrong one in words that help: see command_line.hpp.
#include "command_line.hpp"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Error.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>

#include "help.hpp"
#include "lustro/version.hpp"
#include "manual.hpp"
#include "suggest.hpp"

namespace lustro::app {
namespace {

constexpr int kMaxThreads = 1024;

void add_global_flags(CLI::App& app, Session& session) {
  const std::string group = "Global options";
  app.add_option_function<std::string>(
         "--threads",
         [&session](const std::string& text) {
           const char* end = text.data() + text.size();
           const auto [stop, fault] = std::from_chars(text.data(), end, session.threads);
           if (fault != std::errc() || stop != end || session.threads < 0 || session.threads > kMaxThreads) {
             throw CLI::ValidationError("--threads", fmt::format("`{}` is not a number in 0..{}", text, kMaxThreads));
           }
         },
         fmt::format("Threads to draw with, 0..{}; 0 is one a core. The picture does not depend on it (default: 0)", kMaxThreads))
      ->type_name("N")
      ->group(group);
  app.add_flag("-q,--quiet", session.quiet, "No warnings, no remarks, no progress bar: errors only")->group(group);
  app.add_flag("--json", session.json, "The result as JSON on standard output")->group(group);
  app.set_help_flag("-h,--help", "This text")->group(group);
}

bool looks_like_file(const std::string& word) {
  std::error_code ignored;
  return word.find_first_of("./\\:") != std::string::npos || std::filesystem::exists(word, ignored);
}

/// The position of the first argument that is neither a global flag nor its value.
std::size_t first_own_argument(const std::vector<std::string>& arguments) {
  std::size_t i = 0;
  while (i < arguments.size()) {
    const std::string& word = arguments[i];
    if (word == "--threads") {
      i += 2;
    } else if (word == "-q" || word == "--quiet" || word == "--json" || word.starts_with("--threads=")) {
      ++i;
    } else {
      break;
    }
  }
  return i;
}

const CommandMaker* find_maker(std::span<const CommandMaker> makers, std::string_view name) {
  const auto found = std::find_if(makers.begin(), makers.end(), [&](const CommandMaker& maker) { return maker.name == name; });
  return found == makers.end() ? nullptr : &*found;
}

/// `lustro bunny.ply --size 800x600` and `lustro --size 800x600 bunny.ply` mean render.
void insert_default_subcommand(std::span<const CommandMaker> makers, std::vector<std::string>& arguments) {
  const std::size_t i = first_own_argument(arguments);
  if (i >= arguments.size() || find_maker(makers, arguments[i]) != nullptr) {
    return;
  }
  const std::string& word = arguments[i];
  const bool is_flag = word.size() > 1 && word.front() == '-';
  const bool is_root_flag = word == "-h" || word == "--help" || word == "--version" || word == "--";
  const bool means_render = is_flag ? !is_root_flag && std::any_of(arguments.begin(), arguments.end(),
                                                                   [](const std::string& a) { return a.front() != '-' && looks_like_file(a); })
                                    : looks_like_file(word);
  if (means_render) {
    arguments.insert(arguments.begin() + static_cast<std::ptrdiff_t>(i), "render");
  }
}

/// The first word that names a subcommand, or null. It need not come first: `lustro --help render` asks about render.
const CommandMaker* named_command(std::span<const CommandMaker> makers, const std::vector<std::string>& arguments) {
  for (const std::string& word : arguments) {
    if (const CommandMaker* const maker = find_maker(makers, word); maker != nullptr) {
      return maker;
    }
  }
  return nullptr;
}

/// The subcommand that the arguments named, or null.
const Command* chosen_command(const CommandLine& line) {
  for (const Command& command : line.commands) {
    if (command.app->parsed()) {
      return &command;
    }
  }
  return nullptr;
}

std::string without_dashes(std::string_view flag) {
  flag.remove_prefix(std::min(flag.find_first_not_of('-'), flag.size()));
  return std::string(flag.substr(0, flag.find('=')));
}

ExitCode refuse(const std::string& message, const std::string& help_of) {
  say_error(message, fmt::format("`lustro{}{} --help` lists what there is", help_of.empty() ? "" : " ", help_of));
  return ExitCode::usage;
}

ExitCode refuse_unknown_flag(const std::string& flag, const CLI::App& app, const std::string& name) {
  std::vector<std::string> known;
  for (const CLI::Option* option : app.get_options()) {
    known.insert(known.end(), option->get_lnames().begin(), option->get_lnames().end());
  }
  const std::string nearest = nearest_word(without_dashes(flag), known);
  return refuse(
      nearest.empty() ? fmt::format("there is no flag {}", flag) : fmt::format("there is no flag {}; did you mean --{}?", flag, nearest), name);
}

ExitCode refuse_unknown_subcommand(const std::string& word, const CommandLine& line) {
  std::vector<std::string> known;
  for (const CommandMaker& maker : line.makers) {
    known.emplace_back(maker.name);
  }
  const std::string nearest = nearest_word(word, known);
  return refuse(nearest.empty()
                    ? fmt::format("{}: there is neither a subcommand nor a file of that name", word)
                    : fmt::format("{}: there is neither a subcommand nor a file of that name; did you mean `lustro {}`?", word, nearest),
                "");
}

/// `--fov: its value is missing` for `--fov: 1 required N missing`, and so on.
std::string plainly_said(const CLI::ParseError& error) {
  const std::string text = error.what();
  const std::string option = text.substr(0, text.find(':'));
  if (const std::size_t end = text.find(" was given a disallowed flag override"); end != std::string::npos) {
    return fmt::format("--{}: is a switch and takes no value", text.substr(0, end));
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    return text.ends_with("missing") ? option + ": its value is missing" : option + ": may be stated only once";
  }
  if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr && text.starts_with("Could not convert: ")) {
    const std::size_t equals = text.find(" = ");
    const std::size_t begin = std::string("Could not convert: ").size();
    if (equals != std::string::npos) {
      return fmt::format("{}: `{}` is not a number", text.substr(begin, equals - begin), text.substr(equals + 3));
    }
  }
  return text;
}

/// What CLI11 found wrong, in our words.
ExitCode refuse_parse(const CommandLine& line, const CLI::ParseError& error) {
  const Command* command = chosen_command(line);
  const CLI::App& app = command != nullptr ? *command->app : *line.root;
  const std::string name = command != nullptr ? command->app->get_name() : std::string();
  for (const std::string& word : app.remaining(true)) {  // an unknown flag first: its value may be what CLI11 stumbled over
    if (word.size() > 1 && word.front() == '-' && word != "--") {
      return refuse_unknown_flag(word, app, name);
    }
  }
  for (const std::string& word : app.remaining(true)) {
    if (word == "--") {
      continue;
    }
    if (command == nullptr) {
      return refuse_unknown_subcommand(word, line);
    }
    const bool takes_output = command->app->get_option_no_throw("--output") != nullptr;
    return refuse(fmt::format("`{}` is one argument too many{}", word, takes_output ? "; -o names the output" : ""), name);
  }
  return refuse(plainly_said(error), name);
}

ExitCode run_command(const Command& command) {
  const Result<ExitCode> code = command.run();
  if (!code) {
    say_error(code.error().text());
    return exit_code_of(code.error().kind);
  }
  return *code;
}

}  // namespace

CommandLine make_command_line(Session& session, std::span<const CommandMaker> makers) {
  CommandLine line;
  line.makers = makers;
  line.root = std::make_unique<CLI::App>("Lights and shades triangle meshes on the CPU", "lustro");
  line.root->require_subcommand(0, 1);
  line.root->allow_windows_style_options(false);
  add_global_flags(*line.root, session);
  line.root->set_version_flag("--version", fmt::format("lustro {}", LUSTRO_VERSION), "The version")->group("Global options");
  return line;
}

CLI::App* add_subcommand(CommandLine& line, Session& session, const std::string& name, const std::string& summary) {
  CLI::App* app = line.root->add_subcommand(name, summary);
  app->allow_windows_style_options(false);
  add_global_flags(*app, session);
  return app;
}

ExitCode run_command_line(std::span<const CommandMaker> makers, std::vector<std::string> arguments) {
  insert_default_subcommand(makers, arguments);
  Session session;
  CommandLine line = make_command_line(session, makers);
  if (const CommandMaker* const named = named_command(makers, arguments); named != nullptr) {
    line.commands.push_back(named->make(line, session));
  }
  try {
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
    line.root->parse(std::move(reversed));
  } catch (const CLI::CallForHelp&) {
    const Manual manual = make_manual(makers);
    const Command* command = chosen_command(line);
    const std::string text = command == nullptr ? root_help(manual) : command_help(*manual.find(command->app->get_name()));
    const Result<void> printed = print(text);
    return printed ? ExitCode::success : exit_code_of(printed.error().kind);
  } catch (const CLI::CallForVersion& version) {
    const Result<void> printed = print(fmt::format("{}\n", version.what()));
    return printed ? ExitCode::success : exit_code_of(printed.error().kind);
  } catch (const CLI::ParseError& error) {
    return refuse_parse(line, error);
  }
  const Command* command = chosen_command(line);
  if (command == nullptr) {
    return refuse("what to do? Name a mesh, a scene, or a subcommand", "");
  }
  return run_command(*command);
}

}  // namespace lustro::app
