// How Lustro reports: a value or an Error, and Notes beside a value. The library never prints and never exits.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

namespace lustro {

/// What kind of thing went wrong. The command's exit codes follow these kinds (app/exit_codes.hpp).
enum class ErrorKind {
  usage,        ///< the caller asked for something that does not exist or does not fit together
  io,           ///< a file cannot be opened, read or written
  malformed,    ///< the input breaks the rules of its format
  unsupported,  ///< the input is legitimate, but asks for something that Lustro does not do
  limit,        ///< the input asks for more than a stated limit (sizes are checked before memory is taken)
  empty,        ///< there was nothing to draw, or nothing was drawn
};

/// One clear failure.
///
/// where    file and place: `model.obj:17`, `model.ply: byte 4096`, `scene.json: lights[2].cutoff`; may be empty
/// message  what was found and what was expected, one sentence without a final full stop
struct Error {
  ErrorKind kind = ErrorKind::malformed;
  std::string where;
  std::string message;

  /// `where: message`, as the command prints it.
  [[nodiscard]] std::string text() const { return where.empty() ? message : where + ": " + message; }
};

/// A value, or the Error that stands in its place.
template <class T>
using Result = tl::expected<T, Error>;

/// The unexpected side of a Result: `return fail(ErrorKind::io, path, "cannot be opened");`
[[nodiscard]] inline tl::unexpected<Error> fail(ErrorKind kind, std::string where, std::string message) {
  return tl::unexpected<Error>(Error{kind, std::move(where), std::move(message)});
}

/// Something that was repaired, skipped or ignored, said once. The result is still right as far as it goes.
struct Note {
  std::string where;
  std::string message;

  [[nodiscard]] std::string text() const { return where.empty() ? message : where + ": " + message; }
  friend bool operator==(const Note&, const Note&) = default;
};

using Notes = std::vector<Note>;

}  // namespace lustro
