// From a picture to texels and mip levels. A level is the average of the one before by area, in both directions: where a size is odd the
// smaller texel covers two whole texels and a share of a third (the polyphase box filter), so that every level has the picture's mean. Colours
// are averaged straight, whatever their alpha, as graphics hardware does. Levels are computed in float from the float level before, not from
// its rounded texels: a chain costs a third of the picture's own work, and rounding does not add up.
#include "texture/texture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

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

Rgba rgba_of(const Image& pixels, std::size_t i) {
  const float* p = pixels.pixels.data() + i * static_cast<std::size_t>(pixels.channels);
  switch (pixels.channels) {
    case 1:
      return {sound(p[0]), sound(p[0]), sound(p[0]), 1};
    case 2:
      return {sound(p[0]), sound(p[0]), sound(p[0]), sound(p[1])};
    case 3:
      return {sound(p[0]), sound(p[1]), sound(p[2]), 1};
    default:
      return {sound(p[0]), sound(p[1]), sound(p[2]), sound(p[3])};
  }
}

// A level in float, rows without padding.
struct FloatLevel {
  std::int32_t width = 0, height = 0;
  std::vector<Rgba> texels;

  const Rgba& operator()(std::int32_t x, std::int32_t y) const {
    return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

}  // namespace

class TextureMaker {
 public:
  TextureMaker(const Image& pixels, int threads) : pixels_(pixels), threads_(threads), texture_(new Texture) {}

  std::shared_ptr<const Texture> make() {
    texture_->channels_ = pixels_.channels;
    lay_out();
    const bool is_unorm = std::all_of(pixels_.pixels.begin(), pixels_.pixels.end(), [](float x) { return x >= 0 && x <= 1; });
    const auto& last = texture_->levels_.back();
    const std::size_t texels = static_cast<std::size_t>(last.first) + static_cast<std::size_t>(last.row) * static_cast<std::size_t>(last.height);
    if (is_unorm) {
      texture_->unorms_.resize(4 * texels);
    } else {
      texture_->floats_.resize(4 * texels);
    }
    const auto width = static_cast<std::size_t>(pixels_.width);
    const auto picture = [&](std::int32_t x, std::int32_t y) {
      return rgba_of(pixels_, static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x));
    };
    store_level(texture_->levels_[0], picture);
    FloatLevel before;
    for (std::size_t i = 1; i < texture_->levels_.size(); ++i) {
      const TextureLevel& level = texture_->levels_[i];
      if (i == 1) {
        before = halve(pixels_.width, pixels_.height, level, picture);
      } else {
        before = halve(before.width, before.height, level, before);
      }
      store_level(level, before);
    }
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

  // Rows in parallel; rows(begin, end).
  template <class Rows>
  void in_rows(std::int32_t width, std::int32_t height, const Rows& rows) const {
    parallel_slices(
        static_cast<std::size_t>(height), threads_,
        [&](std::size_t begin, std::size_t end) {
          for (auto y = static_cast<std::int32_t>(begin); y < static_cast<std::int32_t>(end); ++y) {
            rows(y);
          }
        },
        std::max<std::size_t>(1, kSmallestSlice / static_cast<std::size_t>(width)));
  }

  template <class At>
  void store_level(const TextureLevel& level, const At& texel_at) {
    in_rows(level.width, level.height, [&](std::int32_t y) {
      std::size_t place = 4 * (static_cast<std::size_t>(level.first) + static_cast<std::size_t>(y) * static_cast<std::size_t>(level.row));
      for (std::int32_t x = 0; x < level.row; ++x, place += 4) {
        const Rgba texel = texel_at(x < level.width ? x : 0, y);
        for (std::size_t c = 0; c < 4; ++c) {
          if (!texture_->unorms_.empty()) {
            texture_->unorms_[place + c] = static_cast<std::uint16_t>(texel[c] * 65535 + 0.5F);
          } else {
            texture_->floats_[place + c] = texel[c];
          }
        }
      }
    });
  }

  template <class At>
  FloatLevel halve(std::int32_t from_width, std::int32_t from_height, const TextureLevel& to, const At& texel_at) const {
    FloatLevel result{to.width, to.height, {}};
    result.texels.resize(static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height));
    in_rows(to.width, to.height, [&](std::int32_t y) {
      const Share down = share_of(y, from_height, to.height);
      for (std::int32_t x = 0; x < to.width; ++x) {
        const Share across = share_of(x, from_width, to.width);
        Rgba sum{};
        for (std::int32_t j = 0; j < 3 && down.weights[static_cast<std::size_t>(j)] > 0; ++j) {
          Rgba row{};
          for (std::int32_t i = 0; i < 3 && across.weights[static_cast<std::size_t>(i)] > 0; ++i) {
            const Rgba texel = texel_at(across.first + i, down.first + j);
            for (std::size_t c = 0; c < 4; ++c) {
              row[c] = row[c] + texel[c] * across.weights[static_cast<std::size_t>(i)];
            }
          }
          for (std::size_t c = 0; c < 4; ++c) {
            sum[c] = sum[c] + row[c] * down.weights[static_cast<std::size_t>(j)];
          }
        }
        result.texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(to.width) + static_cast<std::size_t>(x)] = sum;
      }
    });
    return result;
  }

  const Image& pixels_;
  int threads_;
  std::shared_ptr<Texture> texture_;
};

std::array<float, 4> Texture::texel(std::size_t level, int x, int y) const {
  const TextureLevel& l = levels_[level];
  const std::size_t place =
      4 * (static_cast<std::size_t>(l.first) + static_cast<std::size_t>(y) * static_cast<std::size_t>(l.row) + static_cast<std::size_t>(x));
  std::array<float, 4> result{};
  for (std::size_t c = 0; c < 4; ++c) {
    result[c] = unorms_.empty() ? floats_[place + c] : static_cast<float>(unorms_[place + c]) * (1.0F / 65535);
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
