// Reader and writer of portable float maps. The reader takes memory only after it has seen that the file is long enough.
#include "image/pfm.hpp"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string_view>

namespace lustro {
namespace {

bool is_space(char c) {
  return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '\v' || c == '\f';
}

/// The next word of the header, at most 32 characters; empty where there is none.
std::string_view next_word(std::string_view text, std::size_t& position) {
  while (position < text.size() && is_space(text[position])) {
    ++position;
  }
  const std::size_t begin = position;
  while (position < text.size() && position - begin < 32 && !is_space(text[position])) {
    ++position;
  }
  return text.substr(begin, position - begin);
}

template <class T>
bool parse_whole(std::string_view word, T& value) {
  const char* end = word.data() + word.size();
  if constexpr (std::is_floating_point_v<T>) {
    const auto [stop, error] = fast_float::from_chars(word.data(), end, value);
    return error == std::errc() && stop == end;
  } else {
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    return error == std::errc() && stop == end;
  }
}

std::uint32_t swap_bytes(std::uint32_t v) {
  return (v >> 24) | ((v >> 8) & 0xFF00U) | ((v << 8) & 0xFF0000U) | (v << 24);
}

}  // namespace

std::vector<std::byte> encode_pfm(const Image& image) {
  const std::size_t kept = image.channels >= 3 ? 3 : 1;
  const std::string header = fmt::format("{}\n{} {}\n-1.0\n", kept == 3 ? "PF" : "Pf", image.width, image.height);
  const auto width = static_cast<std::size_t>(image.width);
  const auto height = static_cast<std::size_t>(image.height);
  std::vector<std::byte> bytes(header.size() + width * height * kept * sizeof(float));
  std::memcpy(bytes.data(), header.data(), header.size());
  std::byte* out = bytes.data() + header.size();
  for (int y = image.height - 1; y >= 0; --y) {
    for (int x = 0; x < image.width; ++x) {
      for (std::size_t c = 0; c < kept; ++c) {
        auto bits = std::bit_cast<std::uint32_t>(image.at(x, y)[c]);
        if constexpr (std::endian::native == std::endian::big) {
          bits = swap_bytes(bits);
        }
        std::memcpy(out, &bits, sizeof bits);
        out += sizeof bits;
      }
    }
  }
  return bytes;
}

Result<Image> decode_pfm(std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits) {
  const auto at = [&](std::size_t offset) { return fmt::format("{}: byte {}", where, offset); };
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::size_t position = 0;
  const std::string_view magic = text.substr(0, 2);
  if ((magic != "PF" && magic != "Pf") || text.size() < 3 || !is_space(text[2])) {
    return fail(ErrorKind::malformed, at(0), "is no PFM file: `PF` or `Pf` and a space or line end were expected");
  }
  position = 2;
  std::int64_t size[2] = {0, 0};
  for (int i = 0; i < 2; ++i) {
    const std::string_view word = next_word(text, position);
    if (!parse_whole(word, size[i])) {
      return fail(ErrorKind::malformed, at(position - word.size()),
                  fmt::format("{} was expected, and `{}` was found", i == 0 ? "the width" : "the height", word));
    }
  }
  if (auto ok = check_image_size(size[0], size[1], where, limits); !ok) {
    return tl::unexpected(std::move(ok).error());
  }
  const std::string_view word = next_word(text, position);
  float scale = 0;
  if (!parse_whole(word, scale) || !std::isfinite(scale) || scale == 0) {
    return fail(ErrorKind::malformed, at(position - word.size()),
                fmt::format("the scale, a number other than 0, was expected, and `{}` was found", word));
  }
  if (position == text.size() || !is_space(text[position])) {
    return fail(ErrorKind::malformed, at(position), "a line end was expected after the scale");
  }
  ++position;  // exactly one: the next byte may already be a float

  const std::size_t channels = magic == "PF" ? 3 : 1;
  const std::size_t row_length = static_cast<std::size_t>(size[0]) * channels;
  const std::size_t needed = row_length * static_cast<std::size_t>(size[1]) * sizeof(float);
  if (bytes.size() - position < needed) {
    return fail(ErrorKind::malformed, at(bytes.size()),
                fmt::format("the file ends after {} of the {} bytes of its pixels", bytes.size() - position, needed));
  }
  Image image(static_cast<int>(size[0]), static_cast<int>(size[1]), static_cast<int>(channels));
  const bool swapped = (scale < 0) != (std::endian::native == std::endian::little);
  const float factor = std::abs(scale);
  const std::byte* in = bytes.data() + position;
  for (int y = image.height - 1; y >= 0; --y) {
    float* row = image.at(0, y).data();
    for (std::size_t i = 0; i < row_length; ++i, in += sizeof(float)) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, in, sizeof bits);
      row[i] = std::bit_cast<float>(swapped ? swap_bytes(bits) : bits) * factor;
    }
  }
  return image;
}

}  // namespace lustro
