// What the command's exit code says. The numbers are a promise: scripts branch on them, so none is ever given another meaning.
#pragma once

#include <array>
#include <string_view>

#include "lustro/result.hpp"

namespace lustro::app {

enum class ExitCode : int {
  success = 0,
  different = 1,    ///< `compare`: more pixels than allowed differ by more than the tolerance; `render --expect-hash`: another hash
  usage = 2,        ///< flags or arguments that do not exist or do not fit together
  io = 3,           ///< a file cannot be opened, read or written
  malformed = 4,    ///< an input breaks the rules of its format
  unsupported = 5,  ///< an input asks for something that Lustro does not do
  limit = 6,        ///< an input asks for more than a stated limit, or memory ran out
  empty = 7,        ///< nothing was drawn
  incomplete = 8,   ///< `batch`: some models could not be drawn, the others were
  internal = 70,    ///< a fault of Lustro itself
};

struct ExitCodeMeaning {
  ExitCode code;
  std::string_view meaning;
};

/// Every code with its meaning, as the help, the man page and the completions print them.
inline constexpr std::array<ExitCodeMeaning, 10> kExitCodes{{
    {ExitCode::success, "done"},
    {ExitCode::different, "compare: the pictures differ by more than the tolerance; render --expect-hash: the picture has another hash"},
    {ExitCode::usage, "unknown or contradictory flags and arguments"},
    {ExitCode::io, "a file cannot be opened, read or written"},
    {ExitCode::malformed, "an input breaks the rules of its format"},
    {ExitCode::unsupported, "an input asks for something that Lustro does not do"},
    {ExitCode::limit, "an input asks for more than a stated limit, or memory ran out"},
    {ExitCode::empty, "nothing was drawn (--allow-empty writes the picture all the same)"},
    {ExitCode::incomplete, "batch: some models could not be drawn, the others were"},
    {ExitCode::internal, "a fault of Lustro itself"},
}};

/// The exit code of an error of the library.
[[nodiscard]] constexpr ExitCode exit_code_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::usage:
      return ExitCode::usage;
    case ErrorKind::io:
      return ExitCode::io;
    case ErrorKind::malformed:
      return ExitCode::malformed;
    case ErrorKind::unsupported:
      return ExitCode::unsupported;
    case ErrorKind::limit:
      return ExitCode::limit;
    case ErrorKind::empty:
      return ExitCode::empty;
  }
  return ExitCode::internal;
}

}  // namespace lustro::app
