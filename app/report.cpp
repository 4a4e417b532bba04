// Output of the command: see report.hpp.
#include "report.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <set>

namespace lustro::app {
namespace {

bool has_color(int descriptor) {
  const char* no_color = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return ::isatty(descriptor) == 1 && (no_color == nullptr || *no_color == '\0') && terminal != nullptr && std::strcmp(terminal, "dumb") != 0;
}

/// One write for one line, so that lines of parallel processes do not mix.
void write_line(const std::string& line) {
  std::fwrite(line.data(), 1, line.size(), stderr);
}

std::string led_line(std::string_view word, std::string_view color, std::string_view text) {
  if (stderr_has_color()) {
    return fmt::format("lustro: \x1b[{}m{}:\x1b[0m {}\n", color, word, printable(text));
  }
  return fmt::format("lustro: {}: {}\n", word, printable(text));
}

}  // namespace

bool stderr_is_terminal() {
  return ::isatty(STDERR_FILENO) == 1;
}
bool stdout_is_terminal() {
  return ::isatty(STDOUT_FILENO) == 1;
}
bool stderr_has_color() {
  return has_color(STDERR_FILENO);
}
bool stdout_has_color() {
  return has_color(STDOUT_FILENO);
}

int terminal_width() {
  int columns = 80;
  if (const char* text = std::getenv("COLUMNS"); text != nullptr) {
    std::from_chars(text, text + std::strlen(text), columns);
  } else if (winsize size{}; ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    columns = size.ws_col;
  }
  return std::clamp(columns, 60, 110);
}

void say_error(std::string_view text, std::string_view hint) {
  std::string lines = led_line("error", "1;31", text);
  if (!hint.empty()) {
    lines += fmt::format("  {}\n", printable(hint));
  }
  write_line(lines);
}

void say_warning(const Session& session, std::string_view text) {
  if (!session.quiet) {
    write_line(led_line("warning", "1;35", text));
  }
}

void say_warnings(const Session& session, const Notes& notes) {
  std::set<std::string> said;  // two objects of one file bring its notes twice
  for (const Note& note : notes) {
    if (std::string text = note.text(); said.insert(text).second) {
      say_warning(session, text);
    }
  }
}

void say(const Session& session, std::string_view text) {
  if (!session.quiet) {
    write_line(fmt::format("lustro: {}\n", printable(text)));
  }
}

Result<void> print(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    return fail(ErrorKind::io, "standard output", fmt::format("cannot be written: {}", std::strerror(errno)));
  }
  return {};
}

std::string printable(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 0x20 && c != '\n') || byte == 0x7F) {
      result += fmt::format("\\x{:02x}", byte);
    } else {
      result += c;
    }
  }
  return result;
}

std::string grouped(std::uint64_t number) {
  std::string digits = fmt::format("{}", number);
  for (std::size_t at = digits.size(); at > 3;) {
    at -= 3;
    digits.insert(at, ",");
  }
  return digits;
}

std::string counted(std::uint64_t number, const char* one, const char* many) {
  return fmt::format("{} {}", grouped(number), number == 1 ? one : many);
}

}  // namespace lustro::app
