// The Radiance reader: lines of text up to an empty one, a line with the size, then scan lines of four bytes a pixel, packed or not.
#include "image/hdr.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "image/decode_bytes.hpp"

namespace lustro {
namespace {

constexpr std::size_t kLongestLine = 4096;

/// One half of the line with the size: `-Y 480`.
struct Axis {
  char name = 'Y';
  bool is_descending = true;
  int length = 0;
};

struct HdrHeader {
  Axis major, minor;  // scan lines follow each other along major, pixels along minor
  std::size_t pixels_at = 0;
};

/// The next line without its end; nothing where the file ends before the line does.
std::optional<std::string_view> next_line(std::string_view text, std::size_t& at) {
  const std::size_t end = text.substr(at, kLongestLine).find('\n');
  if (end == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view line = text.substr(at, end);
  at += end + 1;
  return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

std::string_view next_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
  const std::string_view word = line.substr(0, line.find(' '));
  line.remove_prefix(word.size());
  return word;
}

bool read_axis(std::string_view& line, Axis& axis) {
  const std::string_view name = next_word(line);
  const std::string_view length = next_word(line);
  if (name.size() != 2 || (name[0] != '-' && name[0] != '+') || (name[1] != 'X' && name[1] != 'Y')) {
    return false;
  }
  axis.is_descending = name[0] == '-';
  axis.name = name[1];
  const auto [stop, error] = std::from_chars(length.data(), length.data() + length.size(), axis.length);
  return error == std::errc() && stop == length.data() + length.size();
}

Result<HdrHeader> read_header(std::string_view text, const std::string& where, const ImageLimits& limits) {
  std::size_t at = 0;
  const auto first = next_line(text, at);
  if (!first || !first->starts_with("#?")) {
    return fail(ErrorKind::malformed, at_picture_byte(where, 0), "is no Radiance picture: it does not begin with a line `#?RADIANCE`");
  }
  for (bool is_header = true; is_header;) {
    const std::size_t begin = at;
    const auto line = next_line(text, at);
    if (!line) {
      return fail(ErrorKind::malformed, at_picture_byte(where, begin), "an empty line was expected at the end of the Radiance picture's header");
    }
    if (line->starts_with("FORMAT=") && line->substr(7) != "32-bit_rle_rgbe") {
      const bool is_xyz = line->substr(7) == "32-bit_rle_xyze";
      return fail(is_xyz ? ErrorKind::unsupported : ErrorKind::malformed, at_picture_byte(where, begin),
                  is_xyz ? "the colours of the Radiance picture are XYZ, which are not read: 32-bit_rle_rgbe was expected"
                         : "the format of a Radiance picture is 32-bit_rle_rgbe, and another one was found");
    }
    is_header = !line->empty();
  }
  HdrHeader header;
  const std::size_t begin = at;
  auto line = next_line(text, at);
  if (!line || !read_axis(*line, header.major) || !read_axis(*line, header.minor) || header.major.name == header.minor.name) {
    return fail(ErrorKind::malformed, at_picture_byte(where, begin), "a size like `-Y 480 +X 640` was expected");
  }
  header.pixels_at = at;
  const bool is_usual = header.major.name == 'Y';
  if (auto ok = check_image_size(is_usual ? header.minor.length : header.major.length, is_usual ? header.major.length : header.minor.length,
                                 where, limits);
      !ok) {
    return tl::unexpected(std::move(ok).error());
  }
  return header;
}

/// Scan lines of RGBE, one after the other.
class ScanLines {
 public:
  ScanLines(std::span<const std::byte> bytes, std::size_t at)
      : in_(reinterpret_cast<const std::uint8_t*>(bytes.data())), size_(bytes.size()), at_(at) {}

  /// Fills the line; false where the file is cut or a run is longer than the line.
  bool read(std::vector<std::array<std::uint8_t, 4>>& line) {
    const std::size_t length = line.size();
    const bool is_new = length >= 8 && length < 32768 && size_ - at_ >= 4 && in_[at_] == 2 && in_[at_ + 1] == 2 && in_[at_ + 2] < 128;
    if (!is_new) {
      return read_old(line);
    }
    if (((std::size_t{in_[at_ + 2]} << 8) | in_[at_ + 3]) != length) {
      return false;
    }
    at_ += 4;
    return read_component(line, 0) && read_component(line, 1) && read_component(line, 2) && read_component(line, 3);
  }

  [[nodiscard]] std::size_t at() const { return at_; }

 private:
  /// Radiance since 1991: each component by itself, runs of 1 to 127 and stretches of 1 to 128 bytes.
  bool read_component(std::vector<std::array<std::uint8_t, 4>>& line, std::size_t component) {
    for (std::size_t to = 0; to < line.size();) {
      if (size_ - at_ < 2) {
        return false;
      }
      const std::size_t head = in_[at_++];
      const bool is_run = head > 128;
      const std::size_t count = is_run ? head - 128 : head;
      if (count == 0 || count > line.size() - to || (is_run ? 1 : count) > size_ - at_) {
        return false;
      }
      for (std::size_t i = 0; i < count; ++i) {
        line[to++][component] = in_[at_ + (is_run ? 0 : i)];
      }
      at_ += is_run ? 1 : count;
    }
    return true;
  }

  /// Before: pixels, where (1, 1, 1, n) repeats the last one n times, n << 8 times when it follows another such.
  bool read_old(std::vector<std::array<std::uint8_t, 4>>& line) {
    unsigned shift = 0;
    for (std::size_t to = 0; to < line.size(); at_ += 4) {
      if (size_ - at_ < 4) {
        return false;
      }
      const std::array<std::uint8_t, 4> pixel{in_[at_], in_[at_ + 1], in_[at_ + 2], in_[at_ + 3]};
      if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
        line[to++] = pixel;
        shift = 0;
        continue;
      }
      const std::size_t count = std::size_t{pixel[3]} << shift;
      if (to == 0 || shift > 16 || count > line.size() - to) {
        return false;
      }
      for (std::size_t i = 0; i < count; ++i, ++to) {
        line[to] = line[to - 1];
      }
      shift += 8;
    }
    return true;
  }

  const std::uint8_t* in_;
  std::size_t size_;
  std::size_t at_;
};

void store(const std::array<std::uint8_t, 4>& rgbe, std::span<float> to) {
  // 2^(e - 136), which is a normal number in double precision alone
  const double scale = rgbe[3] == 0 ? 0.0 : std::bit_cast<double>(static_cast<std::uint64_t>(rgbe[3] + 1023 - 136) << 52);
  for (std::size_t c = 0; c < 3; ++c) {
    to[c] = static_cast<float>(rgbe[c] * scale);
  }
}

Result<Image> read_picture(std::span<const std::byte> bytes, const HdrHeader& header, const std::string& where) {
  const bool is_usual = header.major.name == 'Y';
  const Axis& major = header.major;
  const Axis& minor = header.minor;
  const Axis& x_axis = is_usual ? minor : major;
  const Axis& y_axis = is_usual ? major : minor;
  if (bytes.size() - header.pixels_at <
      std::size_t{4} * static_cast<std::size_t>(major.length)) {  // which every scan line takes, however packed
    return fail(ErrorKind::malformed, at_picture_byte(where, bytes.size()),
                fmt::format("the Radiance picture ends here, and its {} scan lines take 4 bytes each or more", major.length));
  }
  Image image(x_axis.length, y_axis.length, 3);
  std::vector<std::array<std::uint8_t, 4>> line(static_cast<std::size_t>(minor.length));
  ScanLines lines(bytes, header.pixels_at);
  for (int i = 0; i < major.length; ++i) {
    if (!lines.read(line)) {
      return fail(ErrorKind::malformed, at_picture_byte(where, lines.at()),
                  fmt::format("scan line {} of the Radiance picture is broken or cut", i));
    }
    for (int j = 0; j < minor.length; ++j) {
      const int x = is_usual ? j : i;
      const int y = is_usual ? i : j;
      // -Y goes from the top down, +X from the left to the right
      const auto pixel = image.at(x_axis.is_descending ? x_axis.length - 1 - x : x, y_axis.is_descending ? y : y_axis.length - 1 - y);
      store(line[static_cast<std::size_t>(j)], pixel);
    }
  }
  return image;
}

}  // namespace

Result<Image> decode_hdr(std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits) {
  const auto header = read_header({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, where, limits);
  if (!header) {
    return tl::unexpected(header.error());
  }
  return within_memory(where, [&] { return read_picture(bytes, *header, where); });
}

}  // namespace lustro
