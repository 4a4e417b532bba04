// The line itself: help, typos, exit codes, completions and man page.
#include <gmock/gmock.h>

#include "app/run_command.hpp"

namespace {

using lustro::testing::CommandTest;
using lustro::testing::Outcome;
using lustro::testing::write_text;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

class CommandLine : public CommandTest {};

TEST_F(CommandLine, VersionIsOneLineOnStdout) {
  const Outcome outcome = lustro({"--version"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, ::testing::MatchesRegex("lustro [0-9]+\\.[0-9]+\\.[0-9]+\n"));
  EXPECT_THAT(outcome.err, IsEmpty());
}

TEST_F(CommandLine, HelpNamesEverySubcommandAndEveryExitCode) {
  const Outcome outcome = lustro({"--help"});
  EXPECT_EQ(outcome.code, 0);
  for (const char* name :
       {"render", "batch", "turntable", "hash", "bench", "info", "explain", "compare", "materials", "schema", "glsl", "completions", "man"}) {
    EXPECT_THAT(outcome.out, HasSubstr(std::string("\n  ") + name)) << name;
  }
  EXPECT_THAT(outcome.out, HasSubstr("Exit codes:"));
  EXPECT_THAT(outcome.out, HasSubstr("nothing was drawn"));
  EXPECT_THAT(outcome.err, IsEmpty());
}

TEST_F(CommandLine, HelpKeepsToTheWidth) {
  for (const char* name :
       {"render", "batch", "turntable", "hash", "bench", "info", "explain", "compare", "materials", "schema", "glsl", "completions", "man"}) {
    const Outcome outcome = run_program({"env", "COLUMNS=70", LUSTRO_COMMAND, name, "--help"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.out, HasSubstr("Examples:")) << name;
    std::size_t begin = 0;
    for (std::size_t end; (end = outcome.out.find('\n', begin)) != std::string::npos; begin = end + 1) {
      const std::string line = outcome.out.substr(begin, end - begin);
      if (line.find("lustro") == std::string::npos) {  // an example is not broken
        EXPECT_LE(line.size(), 70U) << line;
      }
    }
  }
}

TEST_F(CommandLine, NothingAtAllIsAnErrorOfUse) {
  const Outcome outcome = lustro({});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(outcome.err, StartsWith("lustro: error: "));
}

TEST_F(CommandLine, AMistypedFlagBringsTheNearest) {
  const Outcome outcome = lustro({"man", "--quite"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("there is no flag --quite; did you mean --quiet?"));
  EXPECT_THAT(outcome.err, HasSubstr("lustro man --help"));
}

TEST_F(CommandLine, AMistypedSubcommandBringsTheNearest) {
  const Outcome outcome = lustro({"completoins", "bash"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean `lustro completions`?"));
}

TEST_F(CommandLine, AWordWithoutLikenessBringsNoSuggestion) {
  const Outcome outcome = lustro({"xyzzy"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("neither a subcommand nor a file"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("did you mean")));
}

TEST_F(CommandLine, WordsOfAChoiceAreChecked) {
  const Outcome outcome = lustro({"completions", "fisch"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("`fisch` is not one of bash, zsh, fish; did you mean fish?"));
}

TEST_F(CommandLine, ThreadsAreANumberInRangeBeforeAndAfterTheSubcommand) {
  EXPECT_EQ(lustro({"--threads", "2", "man"}).code, 0);
  EXPECT_EQ(lustro({"man", "--threads=2"}).code, 0);
  for (const char* wrong : {"-1", "1025", "2x", "", "99999999999999"}) {
    const Outcome outcome = lustro({"--threads", wrong, "man"});
    EXPECT_EQ(outcome.code, 2) << wrong;
    EXPECT_THAT(outcome.out, IsEmpty());
  }
}

TEST_F(CommandLine, ControlCharactersOfAnArgumentDoNotReachTheTerminal) {
  const Outcome outcome = lustro({"man", "\x1b[31mred\a"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.err.find('\x1b'), std::string::npos);
  EXPECT_THAT(outcome.err, HasSubstr("\\x1b[31mred\\x07"));
}

TEST_F(CommandLine, AFullStandardOutputIsAnErrorOfInputAndOutput) {
  if (!std::filesystem::exists("/dev/full")) {
    GTEST_SKIP() << "there is no /dev/full";
  }
  const Outcome outcome = run_program({LUSTRO_COMMAND, "man"}, "/dev/full");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("standard output: cannot be written"));
}

TEST_F(CommandLine, ColourIsForTerminalsThatWantIt) {
  if (!has_program("script")) {
    GTEST_SKIP() << "needs script(1) for a pseudo-terminal";
  }
  const std::string wrong = std::string(LUSTRO_COMMAND) + " xyzzy";
  EXPECT_THAT(run_program({"env", "-u", "NO_COLOR", "TERM=xterm", "script", "-qec", wrong, "/dev/null"}).out, HasSubstr("\x1b[1;31merror:"));
  EXPECT_THAT(run_program({"env", "NO_COLOR=1", "TERM=xterm", "script", "-qec", wrong, "/dev/null"}).out, Not(HasSubstr("\x1b[")));
  EXPECT_THAT(lustro({"xyzzy"}).err, Not(HasSubstr("\x1b")));
}

class Completions : public CommandTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(Completions, AreAcceptedByTheirShell) {
  const std::string shell = GetParam();
  const Outcome outcome = lustro({"completions", shell});
  ASSERT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("completions"));
  if (!has_program(shell)) {
    GTEST_SKIP() << shell << " is not installed";
  }
  write_text(work() / "script", outcome.out);
  const Outcome checked = run_program({shell, "-n", "script"});
  EXPECT_EQ(checked.code, 0) << checked.err;
}

INSTANTIATE_TEST_SUITE_P(Shells, Completions, ::testing::Values("bash", "zsh", "fish"),
                         [](const auto& shell) { return std::string(shell.param); });

class BashCompletion : public CommandTest {
 protected:
  /// What bash offers after that line; the last word is being typed.
  std::string offered(const std::vector<std::string>& words) {
    std::string script = "source <('" LUSTRO_COMMAND "' completions bash)\nCOMP_WORDS=(";
    for (const std::string& word : words) {
      script += "'" + word + "' ";
    }
    script += ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_lustro 2>/dev/null\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
    return run_program({"bash", "-c", script}).out;
  }
};

TEST_F(BashCompletion, OffersSubcommandsFlagsAndWords) {
  EXPECT_THAT(offered({"lustro", "comp"}), HasSubstr("completions\n"));
  EXPECT_EQ(offered({"lustro", "completions", "z"}), "zsh\n");
  EXPECT_EQ(offered({"lustro", "man", "--th"}), "--threads\n");
  EXPECT_EQ(offered({"lustro", "--threads", "4", "man", "--qu"}), "--quiet\n");
}

TEST_F(BashCompletion, AFileInPlaceOfASubcommandMeansRender) {
  EXPECT_THAT(offered({"lustro", "bunny.ply", "--inter"}), HasSubstr("--interpolation\n"));
  EXPECT_EQ(offered({"lustro", "bunny.ply", "--interpolation", "g"}), "gouraud\n");
  EXPECT_THAT(offered({"lustro", "render", "--material", "polished_"}), HasSubstr("polished_gold\n"));
}

TEST_F(CommandLine, FishOffersSubcommandsAndWords) {
  if (!has_program("fish")) {
    GTEST_SKIP() << "fish is not installed";
  }
  write_text(work() / "lustro.fish", lustro({"completions", "fish"}).out);
  const auto offered = [&](const std::string& line) {
    return run_program({"env", "HOME=" + work().string(), "fish", "--no-config", "-c", "source lustro.fish; complete -C '" + line + "'"}).out;
  };
  EXPECT_THAT(offered("lustro comp"), HasSubstr("completions\t"));
  EXPECT_THAT(offered("lustro completions z"), StartsWith("zsh"));
  EXPECT_THAT(offered("lustro render --inter"), HasSubstr("--interpolation\t"));
  EXPECT_THAT(offered("lustro render --interpolation g"), HasSubstr("gouraud"));
  EXPECT_THAT(offered("lustro bunny.ply --inter"), HasSubstr("--interpolation\t"));
}

TEST_F(CommandLine, ZshLoadsItsCompletion) {
  if (!has_program("zsh")) {
    GTEST_SKIP() << "zsh is not installed";
  }
  write_text(work() / "_lustro", lustro({"completions", "zsh"}).out);
  const Outcome outcome = run_program({"env", "HOME=" + work().string(), "zsh", "-f", "-c",
                                       "fpath=($PWD $fpath); autoload -U compinit; compinit -D -u; print $_comps[lustro]; autoload +X _lustro"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "_lustro\n");
  EXPECT_THAT(outcome.err, IsEmpty());
}

TEST_F(CommandLine, TheManPageIsGoodRoff) {
  const Outcome page = lustro({"man"});
  ASSERT_EQ(page.code, 0);
  EXPECT_THAT(page.out, StartsWith(".TH LUSTRO 1 "));
  EXPECT_THAT(page.out, HasSubstr(".SH EXIT STATUS"));
  write_text(work() / "lustro.1", page.out);
  if (!has_program("groff")) {
    GTEST_SKIP() << "groff is not installed";
  }
  const Outcome checked = run_program({"groff", "-man", "-ww", "-Tutf8", "lustro.1"});
  EXPECT_EQ(checked.code, 0);
  EXPECT_THAT(checked.err, IsEmpty());
}

}  // namespace
