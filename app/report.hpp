// Everything that the command says. Results go to stdout and nothing else does; errors, warnings and remarks go to stderr, each line led by
// `lustro:`, in colour on a terminal only (https://no-color.org).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "lustro/result.hpp"

namespace lustro::app {

/// What every subcommand knows: the global flags.
struct Session {
  int threads = 0;     ///< 0: one a core
  bool quiet = false;  ///< errors only
  bool json = false;   ///< results as JSON on stdout
};

/// Whether the stream is a terminal that may be coloured: a terminal, TERM is not `dumb`, NO_COLOR is unset or empty.
[[nodiscard]] bool stderr_is_terminal();
[[nodiscard]] bool stdout_is_terminal();
[[nodiscard]] bool stderr_has_color();
[[nodiscard]] bool stdout_has_color();

/// Columns of the terminal on stdout, 60..110; 80 where there is none. COLUMNS overrides.
[[nodiscard]] int terminal_width();

/// `lustro: error: TEXT` on stderr, and a second line `  HINT` where there is one.
void say_error(std::string_view text, std::string_view hint = {});
/// `lustro: warning: TEXT` on stderr, unless quiet.
void say_warning(const Session& session, std::string_view text);
void say_warnings(const Session& session, const Notes& notes);
/// `lustro: TEXT` on stderr, unless quiet.
void say(const Session& session, std::string_view text);

/// Writes a result to stdout.
/// errors  io where stdout is closed or full
[[nodiscard]] Result<void> print(std::string_view text);

/// Text of untrusted origin (file names, names in files) with control characters made visible, so that a file cannot command the terminal.
[[nodiscard]] std::string printable(std::string_view text);

/// 1234567 as 1,234,567.
[[nodiscard]] std::string grouped(std::uint64_t number);
/// `1 triangle`, `1,234 triangles`.
[[nodiscard]] std::string counted(std::uint64_t number, const char* one, const char* many);

}  // namespace lustro::app
