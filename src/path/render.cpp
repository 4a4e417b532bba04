// See render.hpp. A pixel's samples are summed in their order by whoever draws its tile, in double precision: neither threads nor the length of
// passes change its bits.
#include "path/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "lustro/image.hpp"
#include "parallel/parallel_for.hpp"
#include "path/bsdf.hpp"
#include "path/state.hpp"
#include "path/tracer.hpp"

namespace lustro {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

constexpr int kTile = 16;             // pixels
constexpr int kLongestPass = 16;      // samples a pixel
constexpr int kLeastForAnError = 16;  // samples a pixel before the error is believed
constexpr int kMostSamples = 1 << 20;
constexpr int kMostBounces = 10000;

Result<void> check(const PathOptions& options) {
  const auto outside = [](const char* flag, auto value, const char* range) {
    return fail(ErrorKind::usage, flag, fmt::format("{} is not {}", value, range));
  };
  if (options.samples < 1 || options.samples > kMostSamples) {
    return outside("--spp", options.samples, "1..1048576");
  }
  if (!(options.seconds >= 0) || !std::isfinite(options.seconds)) {
    return outside("--seconds", options.seconds, "0 or more");
  }
  if (!(options.target_error >= 0) || !std::isfinite(options.target_error)) {
    return outside("--target-error", options.target_error, "0 or more");
  }
  if (options.bounces < 0 || options.bounces > kMostBounces) {
    return outside("--bounces", options.bounces, "0..10000");
  }
  return {};
}

void add(PixelSums& sums, const PathResult& path) {
  const std::array<float, 3> seen{path.radiance.x, path.radiance.y, path.radiance.z};
  sums.has_hit = sums.has_hit || path.has_hit;
  sums.alpha += static_cast<double>(path.alpha);
  if (!is_finite(path.radiance)) {
    return;  // the square of a huge light: it counts as dark
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const auto value = static_cast<double>(seen[c]);
    sums.color[c] += value;
    sums.squares[c] += value * value;
  }
  const auto luminance = static_cast<double>(luminance_of(path.radiance));
  sums.luminance_squares += luminance * luminance;
}

// Of the mean of n samples with this sum and sum of squares. Samples that are stratified vary less than this says, never more on the average.
double variance_of_mean(double sum, double squares, int n) {
  const double count = n;
  return n > 1 ? std::max(squares - sum * (sum / count), 0.0) / (count * (count - 1)) : 0;
}

// The root mean square of the standard errors over the mean, of luminance.
double error_of(std::span<const PixelSums> pixels, int samples) {
  double variance = 0;
  double sum = 0;
  for (const PixelSums& pixel : pixels) {
    const double luminance = (pixel.color[0] * 0.2126 + pixel.color[1] * 0.7152) + pixel.color[2] * 0.0722;
    variance += variance_of_mean(luminance, pixel.luminance_squares, samples);
    sum += luminance;
  }
  const auto count = static_cast<double>(pixels.size());
  return sum > 0 ? std::sqrt(variance / count) / (sum / samples / count) : 0;
}

// What share of the work is done, told by whoever draws.
class Meter {
 public:
  Meter(const RenderOptions& options, std::size_t tiles, Clock::time_point begin) : options_(options), tiles_(tiles), begin_(begin) {}

  /// What was there before it began is no work of this time.
  void resume(int done, double error) { resumed_ = share(done, error); }
  void begin_pass(int done, int samples, double error) {
    before_ = share(done, error);
    after_ = std::max(share(done + samples, 0), before_);
    tiles_done_ = 0;
  }
  void step() {
    if (!options_.progress) {
      return;
    }
    const std::lock_guard lock(mutex_);
    const double part = static_cast<double>(++tiles_done_) / static_cast<double>(tiles_);
    double told = (before_ + (after_ - before_) * part - resumed_) / std::max(1 - resumed_, 1e-9);
    if (options_.path.seconds > 0) {
      told = std::max(told, std::chrono::duration<double>(Clock::now() - begin_).count() / options_.path.seconds);
    }
    last_ = std::max(last_, std::min(told, 1.0));
    options_.progress(last_);
  }

 private:
  // The error falls with the root of the number of samples.
  [[nodiscard]] double share(int samples, double error) const {
    const double of_samples = static_cast<double>(samples) / options_.path.samples;
    const double wanted = options_.path.target_error;
    return std::min(1.0, wanted > 0 && error > 0 ? std::max(of_samples, wanted * wanted / (error * error)) : of_samples);
  }

  const RenderOptions& options_;
  std::size_t tiles_;
  Clock::time_point begin_;
  double resumed_ = 0, before_ = 0, after_ = 0, last_ = 0;
  std::size_t tiles_done_ = 0;
  std::mutex mutex_;
};

// One pass: samples first..first+count-1 of every pixel. Returns the rays that were shot.
std::uint64_t draw_pass(const PathTracer& tracer, const View& view, int threads, int first, int count, std::span<PixelSums> pixels,
                        Meter& meter) {
  const auto tiles_x = static_cast<std::size_t>((view.width + kTile - 1) / kTile);
  const auto tiles_y = static_cast<std::size_t>((view.height + kTile - 1) / kTile);
  std::vector<std::uint64_t> rays(tiles_x * tiles_y);
  parallel_for(rays.size(), threads, [&](std::size_t tile) {
    const int left = static_cast<int>(tile % tiles_x) * kTile;
    const int top = static_cast<int>(tile / tiles_x) * kTile;
    std::uint64_t shot = 0;
    for (int y = top; y < std::min(top + kTile, view.height); ++y) {
      for (int x = left; x < std::min(left + kTile, view.width); ++x) {
        PixelSums& sums = pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width) + static_cast<std::size_t>(x)];
        for (int s = first; s < first + count; ++s) {
          add(sums, tracer.follow(x, y, static_cast<std::uint32_t>(s), shot));
        }
      }
    }
    rays[tile] = shot;
    meter.step();
  });
  std::uint64_t all = 0;
  for (const std::uint64_t shot : rays) {
    all += shot;
  }
  return all;
}

// Keeps the sums in a file, and takes them from there.
class Keeper {
 public:
  Keeper(const PathTracer& tracer, const View& view, const RenderOptions& options, std::uint64_t fingerprint)
      : tracer_(tracer), view_(view), options_(options), fingerprint_(fingerprint) {}

  /// What the file holds; where there is none, the first path of each pixel.
  Result<PathState> begin() {
    const std::filesystem::path& file = options_.path.resume;
    auto kept = read_path_state(file, view_.width, view_.height);  // path/state.cpp
    if (!kept) {
      return tl::unexpected(kept.error());
    }
    if (*kept && (*kept)->fingerprint != fingerprint_) {
      return fail(ErrorKind::usage, file.string(), "it belongs to another scene, or to other flags: name another file, or remove this one");
    }
    PathState first{.width = view_.width, .height = view_.height, .samples = 1, .fingerprint = fingerprint_, .pixels = {}};
    first.pixels.resize(static_cast<std::size_t>(view_.width) * static_cast<std::size_t>(view_.height));
    RenderOptions silent;
    Meter meter(silent, 1, Clock::now());
    first.rays = draw_pass(tracer_, view_, options_.threads, 0, 1, first.pixels, meter);
    probe_ = first.probe = hash_sums(first.pixels);
    if (*kept && (*kept)->probe != probe_) {
      return fail(
          ErrorKind::usage, file.string(),
          "its first paths saw another picture: files that the scene names have changed, or another program or machine drew it; name another "
          "file, or remove this one");
    }
    saved_ = Clock::now();
    if (*kept) {
      kept_ = found_ = (*kept)->samples;
      return **std::move(kept);
    }
    // At once: what cannot be written is better known now than in an hour.
    if (auto written = keep(first.samples, first.rays, first.pixels, true); !written) {
      return tl::unexpected(written.error());
    }
    return first;
  }

  /// Of how many paths a pixel the file was there.
  [[nodiscard]] int found() const { return found_; }

  /// Writes what is new, unless that was done a short while ago. A large file is written less often.
  Result<void> keep(int samples, std::uint64_t rays, std::vector<PixelSums>& pixels, bool now) {
    const auto start = Clock::now();
    const double since = std::chrono::duration<double>(start - saved_).count();
    if (samples == kept_ || (!now && since < std::max(kSecondsBetween, kShareOfWriting * last_took_))) {
      return {};
    }
    PathState state{view_.width, view_.height, samples, rays, fingerprint_, probe_, std::move(pixels)};
    const std::vector<std::byte> bytes = encode_path_state(state);  // path/state.cpp
    pixels = std::move(state.pixels);
    auto written = write_file_atomically(options_.path.resume, bytes);
    saved_ = Clock::now();
    last_took_ = std::chrono::duration<double>(saved_ - start).count();
    kept_ = samples;
    return written;
  }

 private:
  static constexpr double kSecondsBetween = 10, kShareOfWriting = 20;
  const PathTracer& tracer_;
  const View& view_;
  const RenderOptions& options_;
  std::uint64_t fingerprint_;
  std::uint64_t probe_ = 0;
  int found_ = 0, kept_ = 0;  // paths a pixel in the file: at first, now
  Clock::time_point saved_{};
  double last_took_ = 0;
};

// The picture of so many samples, as render() returns it.
void store(std::span<const PixelSums> pixels, int samples, const PreparedScene& scene, std::span<const Aov> aovs, bool wants_bytes,
           Rendering& result) {
  const double scale = 1.0 / samples;
  result.stats.samples = samples;
  result.stats.error = error_of(pixels, samples);
  result.stats.pixels_covered = 0;
  result.color.width = scene.view.width;
  result.color.height = scene.view.height;
  result.color.channels = 4;
  result.color.pixels.resize(pixels.size() * 4);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const PixelSums& sums = pixels[i];
    float* const out = result.color.pixels.data() + 4 * i;
    for (std::size_t c = 0; c < 3; ++c) {
      out[c] = static_cast<float>(sums.color[c] * scale);
    }
    out[3] = static_cast<float>(sums.alpha * scale);
    result.stats.pixels_covered += sums.has_hit ? 1 : 0;
  }
  for (std::size_t a = 0; a < aovs.size(); ++a) {
    if (aovs[a].kind != AovKind::variance) {
      continue;
    }
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        result.layers[a].image.pixels[3 * i + c] = static_cast<float>(variance_of_mean(pixels[i].color[c], pixels[i].squares[c], samples));
      }
    }
  }
  if (wants_bytes) {
    result.bytes = to_bytes(result.color, scene.transfer, scene.tone);
  }
}

// Shows the picture so far, from time to time.
class Previewer {
 public:
  explicit Previewer(const PathOptions& options) : options_(options) {}

  [[nodiscard]] bool is_wanted() const { return static_cast<bool>(options_.preview); }
  [[nodiscard]] bool is_due() const {
    return is_wanted() && (!is_first_shown_ || seconds_since(shown_) >= std::max(options_.preview_seconds, kShareOfShowing * last_took_));
  }
  Result<void> show(const Rendering& picture) {
    const auto start = Clock::now();
    auto shown = options_.preview(picture);
    shown_ = Clock::now();
    last_took_ = std::chrono::duration<double>(shown_ - start).count();
    is_first_shown_ = true;
    return shown;
  }

 private:
  static constexpr double kShareOfShowing = 20;
  const PathOptions& options_;
  bool is_first_shown_ = false;
  Clock::time_point shown_{};
  double last_took_ = 0;
};

}  // namespace

Result<void> render_path(const PreparedScene& scene, std::span<const Aov> aovs, const RenderOptions& options, std::uint64_t fingerprint,
                         Rendering& result) {
  const auto begin = Clock::now();
  const PathOptions& path = options.path;
  if (auto checked = check(path); !checked) {
    return checked;
  }
  auto rays = RayScene::make(scene);  // path/rays.cpp
  if (!rays) {
    return tl::unexpected(rays.error());
  }
  const PathTracer tracer(scene, *rays, path);  // path/tracer.cpp
  const View& view = scene.view;
  std::vector<PixelSums> pixels(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
  const auto tiles = static_cast<std::size_t>((view.width + kTile - 1) / kTile) * static_cast<std::size_t>((view.height + kTile - 1) / kTile);
  Meter meter(options, tiles, begin);
  result.stats = {.triangles = scene.triangle_count};
  const auto drawing = Clock::now();

  int done = 0;
  double error = 0;
  const auto error_so_far = [&] { return done >= kLeastForAnError || done >= path.samples ? error_of(pixels, done) : 0; };
  std::optional<Keeper> keeper;
  if (!path.resume.empty()) {
    keeper.emplace(tracer, view, options, fingerprint);
    auto kept = keeper->begin();
    if (!kept) {
      return tl::unexpected(kept.error());
    }
    done = kept->samples;
    result.stats.rays = kept->rays;
    result.stats.samples_resumed = keeper->found();
    pixels = std::move(kept->pixels);
    error = error_so_far();
    meter.resume(done, error);
  }
  const int done_before = done;
  const auto is_done = [&] {
    return done >= path.samples || (path.seconds > 0 && done > 0 && seconds_since(begin) >= path.seconds) ||
           (path.target_error > 0 && done >= kLeastForAnError && error <= path.target_error);
  };
  Previewer previewer(path);
  while (!is_done()) {
    int count = std::min(path.samples - done, kLongestPass);
    if (previewer.is_wanted()) {  // a first look soon; then twice as many each time
      count = std::min(count, std::max(done - done_before, 1));
    }
    if (path.seconds > 0) {  // what still fits, after a first look at one sample
      const double each = done > done_before ? seconds_since(drawing) / (done - done_before) : 0;
      const double left = path.seconds - seconds_since(begin);
      count = done == done_before ? 1 : std::clamp(static_cast<int>(std::min(left / std::max(each, 1e-9), 1e6)), 1, count);
    }
    meter.begin_pass(done, count, error);
    result.stats.rays += draw_pass(tracer, view, options.threads, done, count, pixels, meter);
    done += count;
    error = error_so_far();
    if (keeper) {
      if (auto kept = keeper->keep(done, result.stats.rays, pixels, is_done()); !kept) {
        return kept;
      }
    }
    if (previewer.is_due() && !is_done()) {
      store(pixels, done, scene, aovs, options.store_bytes, result);
      if (auto shown = previewer.show(result); !shown) {
        return shown;
      }
    }
  }
  result.times.visibility = 0;
  result.times.shading = seconds_since(drawing) * 1000;
  store(pixels, done, scene, aovs, options.store_bytes, result);
  return {};
}

}  // namespace lustro
