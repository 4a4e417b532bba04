// `lustro completions SHELL`: completion scripts.
#include "app/completions.hpp"

#include "app/commands.hpp"
#include "app/words.hpp"

namespace lustro::app {

Command make_completions(CommandLine& line, Session& session) {
  CLI::App* app = add_subcommand(line, session, "completions", "Prints the completion script of a shell");
  auto shell = std::make_shared<std::string>();
  one_of(app->add_option("SHELL", *shell, "Which shell: bash, zsh or fish"), {"bash", "zsh", "fish"})->required();
  Command command{app,
                  {{"source <(lustro completions bash)", "completes in this bash"},
                   {"lustro completions fish > ~/.config/fish/completions/lustro.fish", "completes in every fish"}},
                  {}};
  command.run = [&line, shell]() -> Result<ExitCode> {
    const Manual manual = make_manual(line.makers);
    const std::string script = *shell == "bash" ? bash_completion(manual) : *shell == "zsh" ? zsh_completion(manual) : fish_completion(manual);
    return print(script).map([] { return ExitCode::success; });
  };
  return command;
}

}  // namespace lustro::app
