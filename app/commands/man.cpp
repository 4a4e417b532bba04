// `lustro man`: the man page.
#include "app/commands.hpp"
#include "app/man_page.hpp"

namespace lustro::app {

Command make_man(CommandLine& line, Session& session) {
  CLI::App* app = add_subcommand(line, session, "man", "Prints the man page in roff");
  Command command{
      app, {{"lustro man | man -l -", "reads it at once"}, {"lustro man > ~/.local/share/man/man1/lustro.1", "installs it for you"}}, {}};
  command.run = [&line]() -> Result<ExitCode> { return print(man_page(make_manual(line.makers))).map([] { return ExitCode::success; }); };
  return command;
}

}  // namespace lustro::app
