// See state.hpp.
#include "path/state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <string_view>
#include <system_error>

#include "image/file.hpp"
#include "image/hash.hpp"

namespace lustro {
namespace {

constexpr std::string_view kMagic = "LUSTROP1";
constexpr std::size_t kHeader = 8 + 3 * 4 + 3 * 8;
constexpr std::size_t kDoubles = 8;
constexpr std::size_t kPixel = kDoubles * 8 + 1;
constexpr int kMostSamples = 1 << 20;

std::size_t size_of(int width, int height) {
  return kHeader + kPixel * static_cast<std::size_t>(width) * static_cast<std::size_t>(height) + 8;
}

std::array<double, kDoubles> numbers_of(const PixelSums& p) {
  return {p.color[0], p.color[1], p.color[2], p.squares[0], p.squares[1], p.squares[2], p.luminance_squares, p.alpha};
}

class Writer {
 public:
  explicit Writer(std::size_t size) { bytes_.reserve(size); }
  void number(std::uint64_t value, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
      bytes_.push_back(static_cast<std::byte>(value >> (8 * i)));
    }
  }
  void text(std::string_view text) {
    for (const char c : text) {
      bytes_.push_back(static_cast<std::byte>(c));
    }
  }
  [[nodiscard]] std::vector<std::byte>& bytes() { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};

// Whoever reads has compared sizes before.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}
  std::uint64_t number(std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      value |= std::to_integer<std::uint64_t>(bytes_[at_ + i]) << (8 * i);
    }
    at_ += size;
    return value;
  }
  [[nodiscard]] std::size_t at() const { return at_; }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
};

std::string at_byte(const std::string& name, std::size_t byte) {
  return fmt::format("{}: byte {}", name, byte);
}

Result<void> check_size(std::span<const std::byte> head, const std::string& name, int width, int height) {
  const auto is_same = [](char a, std::byte b) { return static_cast<std::byte>(a) == b; };
  if (head.size() < kMagic.size() || !std::equal(kMagic.begin(), kMagic.end(), head.begin(), is_same)) {
    return fail(ErrorKind::malformed, name, fmt::format("this is no state of a picture by paths, which begins with {}", kMagic));
  }
  if (head.size() < kHeadBytes) {
    return fail(ErrorKind::malformed, at_byte(name, head.size()), fmt::format("the file ends within its first {} bytes", kHeader));
  }
  Reader in(head.subspan(kMagic.size()));
  const std::uint64_t stated_width = in.number(4);
  const std::uint64_t stated_height = in.number(4);
  if (stated_width != static_cast<std::uint64_t>(width) || stated_height != static_cast<std::uint64_t>(height)) {
    return fail(ErrorKind::usage, name,
                fmt::format("it holds a picture of {} x {} pixels, not {} x {}", stated_width, stated_height, width, height));
  }
  return {};
}

}  // namespace

std::uint64_t path_fingerprint(const Scene& scene, const PathOptions& options) {
  Scene stated = scene;
  stated.image.tone = {};
  stated.image.samples = ImageSettings{}.samples;
  for (Object& object : stated.objects) {
    object.source.clear();  // what the file holds counts (PathState::probe), not from where it is named
  }
  const std::string text = fmt::format("{}\nbounces {} seed {}", scene_json(stated), options.bounces, options.seed);
  return xxh64(std::as_bytes(std::span(text)), 0);
}

std::uint64_t hash_sums(std::span<const PixelSums> pixels) {
  std::uint64_t hash = 0;
  for (const PixelSums& p : pixels) {
    const std::array<double, kDoubles> numbers = numbers_of(p);
    hash = xxh64(std::as_bytes(std::span(numbers)), hash + (p.has_hit ? 1 : 0));
  }
  return hash;
}

std::vector<std::byte> encode_path_state(const PathState& state) {
  Writer out(size_of(state.width, state.height));
  out.text(kMagic);
  out.number(static_cast<std::uint32_t>(state.width), 4);
  out.number(static_cast<std::uint32_t>(state.height), 4);
  out.number(static_cast<std::uint32_t>(state.samples), 4);
  out.number(state.rays, 8);
  out.number(state.fingerprint, 8);
  out.number(state.probe, 8);
  for (const PixelSums& p : state.pixels) {
    for (const double number : numbers_of(p)) {
      out.number(std::bit_cast<std::uint64_t>(number), 8);
    }
  }
  for (const PixelSums& p : state.pixels) {
    out.number(p.has_hit ? 1 : 0, 1);
  }
  out.number(xxh64(out.bytes(), 0), 8);
  return std::move(out.bytes());
}

Result<PathState> decode_path_state(std::span<const std::byte> bytes, const std::string& name, int width, int height) {
  if (const Result<void> checked = check_size(bytes.first(std::min(bytes.size(), kHeadBytes)), name, width, height); !checked) {
    return tl::unexpected(checked.error());
  }
  if (bytes.size() != size_of(width, height)) {
    return fail(ErrorKind::malformed, name,
                fmt::format("{} bytes, expected {} for {} x {} pixels", bytes.size(), size_of(width, height), width, height));
  }
  Reader end(bytes.last(8));
  if (end.number(8) != xxh64(bytes.first(bytes.size() - 8), 0)) {
    return fail(ErrorKind::malformed, name, "the file is damaged: its checksum is not that of its bytes");
  }
  Reader in(bytes.subspan(kHeadBytes));
  const std::uint64_t samples = in.number(4);
  if (samples < 1 || samples > kMostSamples) {
    return fail(ErrorKind::malformed, at_byte(name, kHeadBytes), fmt::format("{} paths a pixel are not 1..{}", samples, kMostSamples));
  }
  PathState state{.width = width, .height = height, .pixels = {}};
  state.samples = static_cast<int>(samples);
  state.rays = in.number(8);
  state.fingerprint = in.number(8);
  state.probe = in.number(8);
  state.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (PixelSums& p : state.pixels) {
    const std::size_t at = kHeadBytes + in.at();
    std::array<double, kDoubles> numbers{};
    for (double& number : numbers) {
      number = std::bit_cast<double>(in.number(8));
    }
    if (!std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number) && number >= 0; })) {
      return fail(ErrorKind::malformed, at_byte(name, at), "a pixel's sums are not finite numbers of 0 or more");
    }
    p = {{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}, numbers[6], numbers[7]};
  }
  for (PixelSums& p : state.pixels) {
    p.has_hit = in.number(1) != 0;
  }
  return state;
}

Result<std::optional<PathState>> read_path_state(const std::filesystem::path& file, int width, int height) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    return std::optional<PathState>{};
  }
  const std::string name = file.string();
  const auto bytes = read_file_bytes(file, [&](std::span<const std::byte> head) -> Result<void> {
    if (Result<void> checked = check_size(head, name, width, height); !checked) {
      return checked;
    }
    const std::uintmax_t size = std::filesystem::is_regular_file(status) ? std::filesystem::file_size(file, error) : 0;
    if (size > size_of(width, height)) {
      return fail(ErrorKind::malformed, name,
                  fmt::format("{} bytes, expected {} for {} x {} pixels", size, size_of(width, height), width, height));
    }
    return {};
  });
  if (!bytes) {
    return tl::unexpected(bytes.error());
  }
  Result<PathState> state = decode_path_state(*bytes, name, width, height);
  if (!state) {
    return tl::unexpected(state.error());
  }
  return std::optional<PathState>(*std::move(state));
}

}  // namespace lustro
