// The places for frames: see frame_sink.hpp.
#include "frame_sink.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "ffmpeg.hpp"
#include "image/lower_case.hpp"

namespace lustro::app {
namespace {

namespace fs = std::filesystem;

std::string extension_of(const fs::path& file) {
  return lower_case(file.extension().string());
}

/// The error at the place of the output.
Error at(const std::string& output, const Error& error) {
  return error.where.empty() ? Error{error.kind, output, error.message} : error;
}

Result<FrameSink> folder_sink(const std::string& output, const AnimationOptions& options, const PngFlags& png) {
  std::error_code error;
  fs::create_directories(output, error);
  if (error) {
    return fail(ErrorKind::io, output, fmt::format("cannot be made: {}", error.message()));
  }
  const Result<WriteOptions> write = write_options(png, options.transfer, options.threads);
  if (!write) {
    return tl::unexpected(write.error());
  }
  const auto written = std::make_shared<std::vector<std::string>>();
  const std::size_t digits = std::max<std::size_t>(4, std::to_string(options.frames).size());
  return FrameSink{[=, write = *write](const ByteImage& frame) {
                     const std::string file = (fs::path(output) / fmt::format("frame_{:0{}}.png", written->size() + 1, digits)).string();
                     return write_image(file, frame, write).map([&] { written->push_back(file); });
                   },
                   [=]() -> Result<std::vector<std::string>> { return *written; }};
}

Result<FrameSink> film_sink(const std::string& output, const AnimationOptions& options) {
  if (const Result<void> checked = check_ffmpeg(); !checked) {
    return tl::unexpected(at(output, checked.error()));
  }
  Result<Film> begun = Film::begin(output, {options.width, options.height, options.frames_per_second});
  if (!begun) {
    return tl::unexpected(begun.error());
  }
  const auto film = std::make_shared<Film>(*std::move(begun));
  return FrameSink{[film](const ByteImage& frame) { return film->add(frame); },
                   [film, output] { return film->finish().map([&] { return std::vector<std::string>{output}; }); }};
}

FrameSink file_sink(const std::string& output, AnimationEncoder encoder) {
  const auto shared = std::make_shared<AnimationEncoder>(std::move(encoder));
  return FrameSink{[=](const ByteImage& frame) { return shared->add(frame).map_error([&](const Error& e) { return at(output, e); }); },
                   [=]() -> Result<std::vector<std::string>> {
                     const auto bytes = shared->finish();
                     if (!bytes) {
                       return tl::unexpected(at(output, bytes.error()));
                     }
                     return write_file_atomically(output, *bytes).map([&] { return std::vector<std::string>{output}; });
                   }};
}

}  // namespace

Result<FrameSink> make_frame_sink(const std::string& output, const AnimationOptions& options, const PngFlags& png) {
  std::error_code ignored;
  const std::string extension = extension_of(output);
  if (extension.empty() || fs::is_directory(output, ignored)) {
    return folder_sink(output, options, png);
  }
  if (extension != ".apng" && extension != ".png" && extension != ".webp" && extension != ".gif" && extension != ".mp4") {
    return fail(ErrorKind::unsupported, output,
                "turntables are written as .apng (or .png), .webp, .gif, .mp4, or to a folder, whose name ends in none of them");
  }
  if (const Result<void> checked = check_place(output); !checked) {
    return tl::unexpected(checked.error());
  }
  if (extension == ".mp4") {
    return film_sink(output, options);
  }
  Result<AnimationEncoder> encoder = extension == ".webp"  ? make_webp_encoder(options)
                                     : extension == ".gif" ? make_gif_encoder(options)
                                                           : make_apng_encoder(options);
  if (!encoder) {
    return tl::unexpected(at(output, encoder.error()));
  }
  return file_sink(output, *std::move(encoder));
}

}  // namespace lustro::app
