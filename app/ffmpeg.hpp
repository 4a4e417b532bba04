// MP4 by the program ffmpeg, where it is installed: frames go to its standard input, the film comes out under a temporary name and is renamed.
#pragma once

#include <filesystem>
#include <memory>

#include "lustro/image.hpp"

namespace lustro::app {

struct FilmOptions {
  int width = 0, height = 0;
  double frames_per_second = 30;
};

/// Whether there is an ffmpeg in PATH.
/// errors  unsupported
[[nodiscard]] Result<void> check_ffmpeg();

class Film {
 public:
  /// errors  io where ffmpeg cannot be started
  [[nodiscard]] static Result<Film> begin(const std::filesystem::path& file, const FilmOptions& options);

  Film(Film&&) noexcept;
  Film& operator=(Film&&) = delete;
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;
  ~Film();  ///< ends ffmpeg and leaves nothing, unless finish() was there before

  /// Four channels; what is not opaque is shown over black.
  [[nodiscard]] Result<void> add(const ByteImage& frame);
  /// errors  io where ffmpeg failed; what it said stands on stderr
  [[nodiscard]] Result<void> finish();

 private:
  struct State;
  explicit Film(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace lustro::app
