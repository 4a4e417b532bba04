// Talking to ffmpeg: see ffmpeg.hpp. H.264 as every player knows it: 4:2:0, even sizes, BT.709.
#include "ffmpeg.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "image/file.hpp"

namespace lustro::app {

namespace fs = std::filesystem;

struct Film::State {
  fs::path file;
  fs::path temporary;
  FilmOptions options;
  pid_t process = -1;
  int fd = -1;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (process >= 0) {
      ::kill(process, SIGKILL);
      end();
    }
    std::error_code ignored;
    fs::remove(temporary, ignored);
  }

  /// Closes its input, which is where ffmpeg ends by itself; its exit code, or 128 + the signal that ended it.
  int end() {
    ::close(fd);
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    process = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
};

Film::Film(std::unique_ptr<State> state) : state_(std::move(state)) {}
Film::Film(Film&&) noexcept = default;
Film::~Film() = default;

Result<void> check_ffmpeg() {
  const char* const path = std::getenv("PATH");
  for (std::string_view left = path != nullptr ? path : ""; !left.empty();) {
    const std::size_t end = std::min(left.find(':'), left.size());
    if (end > 0 && ::access((fs::path(left.substr(0, end)) / "ffmpeg").c_str(), X_OK) == 0) {
      return {};
    }
    left.remove_prefix(std::min(end + 1, left.size()));
  }
  return fail(ErrorKind::unsupported, "", "an MP4 is made by ffmpeg, which is not installed; .webp, .apng and .gif need no other program");
}

Result<Film> Film::begin(const fs::path& file, const FilmOptions& options) {
  auto state = std::make_unique<State>();
  state->file = file;
  state->options = options;
  state->temporary = file.parent_path() / fmt::format(".lustro-{}-film.tmp.mp4", ::getpid());
  // A socket, not a pipe: writing to it need not end in SIGPIPE when ffmpeg is gone.
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    return fail(ErrorKind::io, file.string(), fmt::format("ffmpeg cannot be reached: {}", std::strerror(errno)));
  }
  std::vector<std::string> words{"ffmpeg",
                                 "-hide_banner",
                                 "-nostdin",
                                 "-loglevel",
                                 "error",
                                 "-f",
                                 "rawvideo",
                                 "-pix_fmt",
                                 "rgb24",
                                 "-s",
                                 fmt::format("{}x{}", options.width, options.height),
                                 "-r",
                                 fmt::format("{}", options.frames_per_second),
                                 "-i",
                                 "pipe:0",
                                 "-vf",
                                 "scale=out_color_matrix=bt709:out_range=tv,pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                 "-c:v",
                                 "libx264",
                                 "-crf",
                                 "18",
                                 "-pix_fmt",
                                 "yuv420p",
                                 "-colorspace",
                                 "bt709",
                                 "-color_primaries",
                                 "bt709",
                                 "-color_trc",
                                 "bt709",
                                 "-movflags",
                                 "+faststart",
                                 "-y",
                                 "file:" + state->temporary.string()};
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);  // standard output is ours
  const int error = ::posix_spawnp(&state->process, "ffmpeg", &actions, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  state->fd = ends[0];
  if (error != 0) {
    state->process = -1;
    ::close(ends[0]);
    return fail(ErrorKind::io, file.string(), fmt::format("ffmpeg cannot be started: {}", std::strerror(error)));
  }
  return Film(std::move(state));
}

Result<void> Film::add(const ByteImage& frame) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height) * 3);
  for (std::size_t i = 0, j = 0; j < bytes.size(); i += 4, j += 3) {
    const unsigned alpha = frame.pixels[i + 3];
    for (std::size_t c = 0; c < 3; ++c) {
      bytes[j + c] = static_cast<std::uint8_t>((frame.pixels[i + c] * alpha + 127) / 255);
    }
  }
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t got = ::send(state_->fd, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got < 0) {
      return fail(ErrorKind::io, state_->file.string(), "ffmpeg failed (its own words stand above)");
    }
    sent += static_cast<std::size_t>(got);
  }
  return {};
}

Result<void> Film::finish() {
  if (const int code = state_->end(); code != 0) {
    return fail(ErrorKind::io, state_->file.string(), fmt::format("ffmpeg ended with code {} (its own words stand above)", code));
  }
  std::error_code error;
  fs::rename(state_->temporary, state_->file, error);
  if (error) {
    return fail(ErrorKind::io, state_->file.string(), fmt::format("cannot be written: {}", error.message()));
  }
  return {};
}

}  // namespace lustro::app
