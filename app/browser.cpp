// A shell starts the browser in the background, so that nothing waits for it and its end leaves nothing behind.
#include "browser.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>

extern char** environ;  // NOLINT(readability-redundant-declaration): of POSIX, in no header of macOS

namespace lustro::app {
namespace {

bool is_set(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

}  // namespace

bool has_display() {
#if defined(__APPLE__)
  return true;
#else
  return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
#endif
}

void open_browser(const std::string& url) {
#if defined(__APPLE__)
  std::string opener = "open";
#else
  std::string opener = "xdg-open";
#endif
  if (is_set("BROWSER")) {
    opener = std::getenv("BROWSER");
    opener.resize(std::min(opener.find(':'), opener.size()));  // the first of several
  }
  std::string script = "exec < /dev/null > /dev/null 2>&1; command -v \"$1\" && { \"$1\" \"$2\" & }";
  std::string shell = "sh", flag = "-c", name = "lustro", address = url;
  std::array<char*, 7> words{shell.data(), flag.data(), script.data(), name.data(), opener.data(), address.data(), nullptr};
  posix_spawnattr_t attributes;
  if (::posix_spawnattr_init(&attributes) != 0) {
    return;
  }
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);  // Ctrl-C ends the server, not the browser
  ::posix_spawnattr_setpgroup(&attributes, 0);
  pid_t child = 0;
  const bool is_started = ::posix_spawnp(&child, shell.c_str(), nullptr, &attributes, words.data(), environ) == 0;
  ::posix_spawnattr_destroy(&attributes);
  while (is_started && ::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace lustro::app
