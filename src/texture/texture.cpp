// From a picture to texels and mip levels. A level is the average of the one before by area, in both directions: where a size is odd the
// smaller texel covers two whole texels and a share of a third (the polyphase box filter), so that every level has the picture's mean. Colours
// are averaged straight, whatever their alpha, as graphics hardware does. Levels are computed in float from the float level before, not from
// its rounded texels: a chain costs a third of the picture's own work, and rounding does not add up.
#include "texture/texture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <new>

#include "parallel/big_memory.hpp"
#include "parallel/slices.hpp"

namespace lustro {
namespace {

constexpr int kMostPixels = 16384;  // along a side
constexpr float kMostValue = 1e30F;

using Rgba = std::array<float, 4>;

// What a texel of a smaller level takes of the larger one's, along one axis: texels first .. first + 2.
struct Share {
  std::int32_t first;
  std::array<float, 3> weights;
};

// Texel i covers [i from / to, (i + 1) from / to) of the larger level; to = max(from / 2, 1).
Share share_of(std::int32_t i, std::int32_t from, std::int32_t to) {
  if (from == 1) {
    return {0, {1, 0, 0}};
  }
  const auto over = [from](std::int32_t part) { return static_cast<float>(part) / static_cast<float>(from); };
  if (from % 2 == 0) {
    return {2 * i, {0.5F, 0.5F, 0}};
  }
  return {2 * i, {over(to - i), over(to), over(i + 1)}};
}

// Not finite is 0, huge is limited, and there is no negative zero: what is looked up needs no care.
float sound(float x) {
  return std::isnan(x) ? 0.0F : std::clamp(x, -kMostValue, kMostValue) + 0.0F;
}

/// One row of a picture as RGBA.
template <int kChannels, bool kIsSound>
void read_row(const float* from, std::size_t width, Rgba* to) {
  const auto value = [](float x) { return kIsSound ? x : sound(x); };
  for (std::size_t x = 0; x < width; ++x, from += kChannels) {
    if constexpr (kChannels < 3) {
      const float gray = value(from[0]);
      to[x] = {gray, gray, gray, kChannels == 2 ? value(from[1]) : 1};
    } else {
      to[x] = {value(from[0]), value(from[1]), value(from[2]), kChannels == 4 ? value(from[3]) : 1};
    }
  }
}

template <bool kIsSound>
void read_row(const Image& pixels, std::int32_t y, Rgba* to) {
  const auto width = static_cast<std::size_t>(pixels.width);
  const float* const from = pixels.pixels.data() + static_cast<std::size_t>(y) * width * static_cast<std::size_t>(pixels.channels);
  switch (pixels.channels) {
    case 1:
      return read_row<1, kIsSound>(from, width, to);
    case 2:
      return read_row<2, kIsSound>(from, width, to);
    case 3:
      return read_row<3, kIsSound>(from, width, to);
    default:
      return read_row<4, kIsSound>(from, width, to);
  }
}

// Whether no value is broken. In blocks: a loop that may end anywhere is no loop of vectors.
template <class IsBroken>
bool has_none(const std::vector<float>& values, const IsBroken& is_broken) {
  constexpr std::size_t kBlock = 4096;
  for (std::size_t begin = 0; begin < values.size(); begin += kBlock) {
    int broken = 0;
    for (std::size_t i = begin; i < std::min(begin + kBlock, values.size()); ++i) {
      broken |= is_broken(values[i]);
    }
    if (broken != 0) {
      return false;
    }
  }
  return true;
}

// Whether every value is one of 0..1.
bool is_all_unit(const std::vector<float>& values) {
  return has_none(values, [](float x) { return static_cast<int>(!(x >= 0.0F)) | static_cast<int>(!(x <= 1.0F)); });
}

// Whether every value, of 0..1, is a whole 255th, up to what writing it as a float rounds.
bool is_all_whole(const std::vector<float>& values) {
  return has_none(values, [](float x) {
    const float scaled = x * 255;
    return static_cast<int>(std::abs(scaled - static_cast<float>(static_cast<std::int32_t>(scaled + 0.5F))) > 1e-4F);
  });
}

// The smallest format that does for the picture: see texture.hpp.
Texture::Format format_of(const Image& pixels) {
  if (!is_all_unit(pixels.pixels)) {
    return Texture::Format::float32;
  }
  return pixels.channels > 1 && is_all_whole(pixels.pixels) ? Texture::Format::unorm8 : Texture::Format::unorm16;
}

// A level in float, rows without padding.
struct FloatLevel {
  std::int32_t width = 0, height = 0;
  std::vector<Rgba> texels;

  [[nodiscard]] const Rgba* row(std::int32_t y) const { return texels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
  [[nodiscard]] Rgba* row(std::int32_t y) { return texels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
};

/// The rows of the larger level that one row of the smaller one takes.
struct SourceRows {
  Share down{};
  std::array<const Rgba*, 3> rows{};
};

// How many of a share's texels count.
std::size_t count_of(const Share& share) {
  return share.weights[1] > 0 ? (share.weights[2] > 0 ? 3 : 2) : 1;
}

/// The order of the sums is the same on every way: along the row first, from left to right.
void halve_row(const SourceRows& source, std::int32_t from_width, std::int32_t to_width, Rgba* to) {
  const std::size_t rows = count_of(source.down);
  if (from_width % 2 == 0 && rows == 2) {  // most rows by far
    const Rgba* upper = source.rows[0];
    const Rgba* lower = source.rows[1];
    const float first = source.down.weights[0], second = source.down.weights[1];
    for (std::int32_t x = 0; x < to_width; ++x, upper += 2, lower += 2) {
      for (std::size_t c = 0; c < 4; ++c) {
        const float above = upper[0][c] * 0.5F + upper[1][c] * 0.5F;
        const float below = lower[0][c] * 0.5F + lower[1][c] * 0.5F;
        to[x][c] = above * first + below * second + 0.0F;
      }
    }
    return;
  }
  for (std::int32_t x = 0; x < to_width; ++x) {
    const Share across = share_of(x, from_width, to_width);
    const std::size_t columns = count_of(across);
    Rgba sum{};
    for (std::size_t j = 0; j < rows; ++j) {
      Rgba row{};
      for (std::size_t i = 0; i < columns; ++i) {
        const Rgba& texel = source.rows[j][static_cast<std::size_t>(across.first) + i];
        for (std::size_t c = 0; c < 4; ++c) {
          row[c] = row[c] + texel[c] * across.weights[i];
        }
      }
      for (std::size_t c = 0; c < 4; ++c) {
        sum[c] = sum[c] + row[c] * source.down.weights[j];
      }
    }
    to[x] = sum;
  }
}

}  // namespace

class TextureMaker {
 public:
  TextureMaker(const Image& pixels, int threads) : pixels_(pixels), threads_(threads), texture_(new Texture) {}

  std::shared_ptr<const Texture> make() {
    texture_->channels_ = pixels_.channels;
    lay_out();
    format_ = format_of(pixels_);
    const auto& last = texture_->levels_.back();
    const std::size_t texels = static_cast<std::size_t>(last.first) + static_cast<std::size_t>(last.row) * static_cast<std::size_t>(last.height);
    switch (format_) {
      case Texture::Format::unorm8:
        resize_for(texture_->bytes_, texels);
        break;
      case Texture::Format::unorm16:
        resize_for(texture_->unorms_, texels);
        break;
      case Texture::Format::float32:
        resize_for(texture_->floats_, texels);
        break;
    }
    if (texture_->levels_.size() == 1) {
      Rgba texel{};
      read(0, &texel);
      store_row(texture_->levels_[0], 0, &texel);
      return texture_;
    }
    FloatLevel before = picture_and_first_level();
    for (std::size_t i = 2; i < texture_->levels_.size(); ++i) {
      before = next_level(before, texture_->levels_[i]);
    }
    texture_->is_gray_ = pixels_.channels < 3 ? format_ != Texture::Format::float32 : is_gray(texture_->bytes_) || is_gray(texture_->unorms_);
    return texture_;
  }

 private:
  // At most 16384 x 16385 texels and a third of them: places fit 31 bits.
  void lay_out() {
    TextureLevel level{pixels_.width, pixels_.height, pixels_.width + 1, 0};
    texture_->levels_.push_back(level);
    while (level.width > 1 || level.height > 1) {
      level.first += level.row * level.height;
      level.width = std::max(level.width / 2, 1);
      level.height = std::max(level.height / 2, 1);
      level.row = level.width + 1;
      texture_->levels_.push_back(level);
    }
  }

  // Slice by slice: most pictures have a colour in their first one.
  template <class T>
  static bool is_gray(const std::vector<T>& rgba) {
    constexpr std::size_t kSlice = 4096;
    for (std::size_t begin = 0; begin < rgba.size(); begin += kSlice) {
      const std::size_t end = std::min(begin + kSlice, rgba.size());
      unsigned differs = 0;
      for (std::size_t i = begin; i < end; i += 4) {
        differs |= static_cast<unsigned>(rgba[i] ^ rgba[i + 1]) | static_cast<unsigned>(rgba[i] ^ rgba[i + 2]);
      }
      if (differs != 0) {
        return false;
      }
    }
    return !rgba.empty();
  }

  template <class T>
  static void resize_for(std::vector<T>& numbers, std::size_t texels) {
    constexpr std::size_t kReadAhead = 16;  // bytes
    resize_big(numbers, 4 * texels + kReadAhead / sizeof(T));
  }

  void read(std::int32_t y, Rgba* to) const {
    format_ != Texture::Format::float32 ? read_row<true>(pixels_, y, to) : read_row<false>(pixels_, y, to);
  }

  // Rows in parallel; rows(begin, end).
  template <class Rows>
  void in_rows(std::int32_t width, std::int32_t height, const Rows& rows) const {
    parallel_slices(
        static_cast<std::size_t>(height), threads_,
        [&](std::size_t begin, std::size_t end) { rows(static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end)); },
        std::max<std::size_t>(1, kSmallestSlice / static_cast<std::size_t>(width)));
  }

  void store_row(const TextureLevel& level, std::int32_t y, const Rgba* row) {
    const std::size_t place = 4 * (static_cast<std::size_t>(level.first) + static_cast<std::size_t>(y) * static_cast<std::size_t>(level.row));
    const std::size_t count = 4 * static_cast<std::size_t>(level.width);
    const float* const from = row->data();
    const auto store_as = [&](auto& numbers, auto&& stored) {
      auto* const to = numbers.data() + place;
      for (std::size_t i = 0; i < count; ++i) {
        to[i] = stored(from[i]);
      }
      std::copy_n(to, 4, to + count);
    };
    switch (format_) {
      case Texture::Format::unorm8:
        return store_as(texture_->bytes_, [](float x) { return static_cast<std::uint8_t>(static_cast<std::int32_t>(x * 255 + 0.5F)); });
      case Texture::Format::unorm16:
        return store_as(texture_->unorms_, [](float x) { return static_cast<std::uint16_t>(static_cast<std::int32_t>(x * 65535 + 0.5F)); });
      case Texture::Format::float32:
        return store_as(texture_->floats_, [](float x) { return x; });
    }
  }

  // The picture is read once: each row is stored, and gives its share to the first level while it is at hand.
  FloatLevel picture_and_first_level() {
    const TextureLevel& picture = texture_->levels_[0];
    const TextureLevel& level = texture_->levels_[1];
    FloatLevel result{level.width, level.height, {}};
    resize_big(result.texels, static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height));
    in_rows(picture.width, level.height, [&](std::int32_t begin, std::int32_t end) {
      const auto width = static_cast<std::size_t>(picture.width);
      std::vector<Rgba> rows(3 * width);
      for (std::int32_t y = begin; y < end; ++y) {
        SourceRows source{share_of(y, picture.height, level.height)};
        const std::int32_t stored = y + 1 < level.height ? 2 : 3;  // the last row of an odd height belongs to the last slice
        for (std::size_t j = 0; j < count_of(source.down); ++j) {
          source.rows[j] = rows.data() + j * width;
          const std::int32_t row = source.down.first + static_cast<std::int32_t>(j);
          read(row, rows.data() + j * width);
          if (static_cast<std::int32_t>(j) < stored) {
            store_row(picture, row, source.rows[j]);
          }
        }
        halve_row(source, picture.width, level.width, result.row(y));
        store_row(level, y, result.row(y));
      }
    });
    return result;
  }

  FloatLevel next_level(const FloatLevel& before, const TextureLevel& level) {
    FloatLevel result{level.width, level.height, {}};
    resize_big(result.texels, static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height));
    in_rows(level.width, level.height, [&](std::int32_t begin, std::int32_t end) {
      for (std::int32_t y = begin; y < end; ++y) {
        SourceRows source{share_of(y, before.height, level.height)};
        for (std::size_t j = 0; j < count_of(source.down); ++j) {
          source.rows[j] = before.row(source.down.first + static_cast<std::int32_t>(j));
        }
        halve_row(source, before.width, level.width, result.row(y));
        store_row(level, y, result.row(y));
      }
    });
    return result;
  }

  const Image& pixels_;
  int threads_;
  Texture::Format format_ = Texture::Format::unorm16;
  std::shared_ptr<Texture> texture_;
};

std::array<float, 4> Texture::texel(std::size_t level, int x, int y) const {
  const TextureLevel& l = levels_[level];
  const std::size_t place =
      4 * (static_cast<std::size_t>(l.first) + static_cast<std::size_t>(y) * static_cast<std::size_t>(l.row) + static_cast<std::size_t>(x));
  std::array<float, 4> result{};
  for (std::size_t c = 0; c < 4; ++c) {
    switch (format()) {
      case Format::unorm8:
        result[c] = static_cast<float>(bytes_[place + c]) * (1.0F / 255);
        break;
      case Format::unorm16:
        result[c] = static_cast<float>(unorms_[place + c]) * (1.0F / 65535);
        break;
      case Format::float32:
        result[c] = floats_[place + c];
        break;
    }
  }
  return result;
}

Result<std::shared_ptr<const Texture>> make_texture(const Image& pixels, int threads) {
  if (pixels.channels < 1 || pixels.channels > 4) {
    return fail(ErrorKind::usage, "texture", fmt::format("has {} channels, expected 1 to 4", pixels.channels));
  }
  if (pixels.width < 1 || pixels.height < 1) {
    return fail(ErrorKind::usage, "texture", fmt::format("has {} x {} pixels, expected some", pixels.width, pixels.height));
  }
  if (pixels.width > kMostPixels || pixels.height > kMostPixels) {
    return fail(ErrorKind::limit, "texture",
                fmt::format("has {} x {} pixels; at most {} x {} can be used", pixels.width, pixels.height, kMostPixels, kMostPixels));
  }
  const std::size_t expected =
      static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height) * static_cast<std::size_t>(pixels.channels);
  if (pixels.pixels.size() != expected) {
    return fail(ErrorKind::usage, "texture", fmt::format("holds {} numbers, but its size asks for {}", pixels.pixels.size(), expected));
  }
  try {
    return TextureMaker(pixels, threads).make();
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::limit, "texture", fmt::format("not enough memory for {} x {} pixels", pixels.width, pixels.height));
  }
}

}  // namespace lustro
