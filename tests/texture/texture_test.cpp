// Texels as they are stored, and mip levels against averages in double precision.
#include "texture/texture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "texture/random_texture.hpp"

namespace lustro {
namespace {

TEST(Texture, EightBitDataIsStoredAsItIs) {
  for (const int channels : {2, 3, 4}) {
    Image image(256, 1, channels);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      image.pixels[i] = i % 2 == 0 ? static_cast<float>(i * 7 % 256) / 255 : static_cast<float>(i * 7 % 256) * (1.0F / 255);
    }
    const auto texture = made(image);
    ASSERT_EQ(texture->format(), Texture::Format::unorm8);
    for (std::size_t x = 0; x < 256; ++x) {
      const std::size_t alpha = static_cast<std::size_t>(channels) - 1;
      const std::size_t i = x * static_cast<std::size_t>(channels);
      EXPECT_EQ(texture->layout().bytes[4 * x], i * 7 % 256);
      EXPECT_EQ(texture->layout().bytes[4 * x + 3], channels == 3 ? 255 : (i + alpha) * 7 % 256);
      EXPECT_FLOAT_EQ(texture->texel(0, static_cast<int>(x), 0)[0], image.pixels[i]);
    }
  }
}

TEST(Texture, SmallerLevelsOfBytesAreRoundedOnce) {
  Image image(4, 4, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = static_cast<float>(i * 37 % 256) / 255;
  }
  const auto texture = made(image);
  ASSERT_EQ(texture->format(), Texture::Format::unorm8);
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0;
    for (std::size_t i = c; i < image.pixels.size(); i += 3) {
      sum += static_cast<double>(i * 37 % 256);
    }
    EXPECT_EQ(texture->layout().bytes[4 * static_cast<std::size_t>(texture->levels()[2].first) + c], std::lround(sum / 16));
  }
}

TEST(Texture, OneValueOutsideTheWhole255thsKeepsSixteenBits) {
  Image image(64, 64, 3);
  std::fill(image.pixels.begin(), image.pixels.end(), 17.0F / 255);
  EXPECT_EQ(made(image)->format(), Texture::Format::unorm8);
  image.pixels[5000] = 17.001F / 255;
  EXPECT_EQ(made(image)->format(), Texture::Format::unorm16);
  image.pixels[5000] = 1.5F;
  EXPECT_EQ(made(image)->format(), Texture::Format::float32);
}

TEST(Texture, EightBitHeightsAreStoredAs257TimesThemselves) {
  Image image(256, 1, 1);
  for (int v = 0; v < 256; ++v) {
    image.at(v, 0)[0] = static_cast<float>(v) / 255;
  }
  const auto texture = made(image);
  ASSERT_EQ(texture->format(), Texture::Format::unorm16);
  const TextureLayout layout = texture->layout();
  for (std::size_t v = 0; v < 256; ++v) {
    EXPECT_EQ(layout.unorms[4 * v], v * 257);
    EXPECT_FLOAT_EQ(texture->texel(0, static_cast<int>(v), 0)[0], image.pixels[v]);
  }
}

TEST(Texture, NoSrgbCodeMovesByMoreThanAFortiethOfAStep) {
  Image image(256, 1, 1);
  std::array<double, 257> light{};
  for (std::size_t v = 0; v < 257; ++v) {
    const double x = static_cast<double>(v) / 255;
    light[v] = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    if (v < 256) {
      image.pixels[v] = static_cast<float>(light[v]);
    }
  }
  const auto texture = made(image);
  for (std::size_t v = 0; v < 256; ++v) {
    const double stored = static_cast<double>(texture->layout().unorms[4 * v]) / 65535;
    const double step = v == 0 ? light[1] : std::min(light[v] - light[v - 1], light[v + 1] - light[v]);
    EXPECT_LE(std::abs(stored - light[v]), step / 40) << v;
  }
}

TEST(Texture, GrayIsInAllColoursAndAlphaIsOneWhereNoneIsStated) {
  using Rgba = std::array<float, 4>;
  Image one(1, 1, 1), two(1, 1, 2), three(1, 1, 3), four(1, 1, 4);
  one.pixels = {0.2F};
  two.pixels = {0.2F, 0.4F};
  three.pixels = {0.2F, 0.4F, 0.6F};
  four.pixels = {0.2F, 0.4F, 0.6F, 0.8F};  // multiples of 1/5, so of 1/65535 and of 1/255
  const auto expect_texel = [](const Image& image, const Rgba& expected) {
    const Rgba found = made(image)->texel(0, 0, 0);
    for (std::size_t c = 0; c < 4; ++c) {
      EXPECT_FLOAT_EQ(found[c], expected[c]);
    }
  };
  expect_texel(one, Rgba{0.2F, 0.2F, 0.2F, 1});
  expect_texel(two, Rgba{0.2F, 0.2F, 0.2F, 0.4F});
  expect_texel(three, Rgba{0.2F, 0.4F, 0.6F, 1});
  expect_texel(four, Rgba{0.2F, 0.4F, 0.6F, 0.8F});
}

TEST(Texture, PicturesWithoutAColourAnywhereAreGray) {
  for (const auto& [channels, steps] : {std::pair{1, 255.0F}, {2, 255.0F}, {3, 255.0F}, {4, 255.0F}, {2, 1000.0F}, {3, 1000.0F}}) {
    Image image(67, 61, channels);  // not in the first slice alone
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      const std::size_t pixel = i / static_cast<std::size_t>(channels);
      image.pixels[i] = static_cast<float>(pixel * 37 % 256) / steps;
    }
    EXPECT_TRUE(made(image)->layout().is_gray) << channels;
    for (std::size_t i = 0; i < image.pixels.size(); i += 97 * static_cast<std::size_t>(channels)) {
      for (std::size_t c = 0; channels > 2 && c < 3; ++c) {
        Image colored = image;
        colored.pixels[i + c] = colored.pixels[i + c] > 0.5F ? 0.0F : 1.0F;
        ASSERT_FALSE(made(colored)->layout().is_gray) << "channel " << c << " of number " << i;
      }
    }
  }
  Image floats(8, 8, 1);
  floats.pixels[3] = 1.5F;
  EXPECT_FALSE(made(floats)->layout().is_gray);
}

TEST(Texture, EveryRowEndsWithItsFirstTexelAgain) {
  for (const float high : {1.0F, 3.0F}) {
    const auto texture = made(noise(7, 5, 4, 1, 0, high));
    for (std::size_t l = 0; l < texture->levels().size(); ++l) {
      const TextureLevel& level = texture->levels()[l];
      EXPECT_EQ(level.row, level.width + 1);
      for (int y = 0; y < level.height; ++y) {
        EXPECT_EQ(texture->texel(l, level.width, y), texture->texel(l, 0, y));
      }
    }
  }
}

TEST(Texture, SizesHalveRoundedDownTo1x1) {
  const auto texture = made(noise(20, 5, 1, 1));
  std::vector<std::array<int, 2>> sizes;
  for (const TextureLevel& level : texture->levels()) {
    sizes.push_back({level.width, level.height});
  }
  EXPECT_EQ(sizes, (std::vector<std::array<int, 2>>{{20, 5}, {10, 2}, {5, 1}, {2, 1}, {1, 1}}));
}

// Level l of the chain in double precision: each texel the average of the level before over the area that it covers, by overlap of intervals.
std::vector<double> average_by_area(const std::vector<double>& from, int from_w, int from_h, int to_w, int to_h) {
  const auto overlap = [](int i, int from_n, int to_n, int s) {
    const double scale = static_cast<double>(from_n) / to_n;
    return std::max(0.0, std::min((i + 1) * scale, s + 1.0) - std::max(i * scale, static_cast<double>(s))) / scale;
  };
  std::vector<double> to;
  for (int y = 0; y < to_h; ++y) {
    for (int x = 0; x < to_w; ++x) {
      for (std::size_t c = 0; c < 4; ++c) {
        double sum = 0;
        for (int sy = 0; sy < from_h; ++sy) {
          for (int sx = 0; sx < from_w; ++sx) {
            sum += overlap(y, from_h, to_h, sy) * overlap(x, from_w, to_w, sx) * from[static_cast<std::size_t>(sy * from_w + sx) * 4 + c];
          }
        }
        to.push_back(sum);
      }
    }
  }
  return to;
}

TEST(Texture, LevelsAreAveragesByAreaForEverySize) {
  for (const auto& [width, height] :
       std::vector<std::array<int, 2>>{{1, 1}, {2, 2}, {3, 3}, {16, 16}, {5, 3}, {7, 1}, {1, 9}, {33, 17}, {31, 2}}) {
    for (const float high : {1.0F, 50.0F}) {
      const Image image = noise(width, height, 4, static_cast<unsigned>(width * 100 + height), high > 1 ? -high : 0, high);
      const auto texture = made(image);
      std::vector<double> level(image.pixels.begin(), image.pixels.end());
      int w = width, h = height;
      const double tolerance = high > 1 ? 1e-5 * static_cast<double>(high) : 0.5 / 65535 + 1e-6;
      for (std::size_t l = 0; l < texture->levels().size(); ++l) {
        const TextureLevel& made_level = texture->levels()[l];
        if (l > 0) {
          level = average_by_area(level, w, h, made_level.width, made_level.height);
          w = made_level.width;
          h = made_level.height;
        }
        for (int y = 0; y < h; ++y) {
          for (int x = 0; x < w; ++x) {
            for (std::size_t c = 0; c < 4; ++c) {
              ASSERT_NEAR(static_cast<double>(texture->texel(l, x, y)[c]), level[static_cast<std::size_t>(y * w + x) * 4 + c], tolerance)
                  << width << " x " << height << ", level " << l;
            }
          }
        }
      }
      std::array<double, 4> mean{};
      for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        mean[i % 4] += static_cast<double>(image.pixels[i]) / (width * height);
      }
      for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_NEAR(static_cast<double>(texture->texel(texture->levels().size() - 1, 0, 0)[c]), mean[c], tolerance);
      }
    }
  }
}

TEST(Texture, AnyValueOutside0To1MakesItFloat) {
  Image image = noise(3, 3, 3, 4);
  EXPECT_EQ(made(image)->format(), Texture::Format::unorm16);
  image.pixels[5] = 1.5F;
  EXPECT_EQ(made(image)->format(), Texture::Format::float32);
  EXPECT_EQ(made(image)->texel(0, 1, 0)[2], 1.5F);
  EXPECT_EQ(made(image)->texel(0, 0, 0)[0], image.pixels[0]);
  image.pixels[5] = -0.5F;
  EXPECT_EQ(made(image)->format(), Texture::Format::float32);
}

TEST(Texture, WhatIsNotFiniteBecomesFinite) {
  Image image(2, 1, 1);
  image.pixels = {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()};
  const auto texture = made(image);
  EXPECT_EQ(texture->texel(0, 0, 0)[0], 0.0F);
  EXPECT_EQ(texture->texel(0, 1, 0)[0], -1e30F);
  EXPECT_EQ(texture->texel(1, 0, 0)[0], -0.5e30F);
}

TEST(Texture, IsTheSameForAnyNumberOfThreads) {
  const Image image = noise(301, 277, 3, 9);
  const auto one = made(image, 1);
  const auto many = made(image, 7);
  const TextureLevel& last = one->levels().back();
  const auto numbers = static_cast<std::size_t>(4 * (last.first + last.row));
  EXPECT_TRUE(std::equal(one->layout().unorms, one->layout().unorms + numbers, many->layout().unorms));
}

TEST(Texture, WhatIsNoPictureIsAnError) {
  EXPECT_EQ(make_texture(Image{}).error().text(), "texture: has 0 channels, expected 1 to 4");
  EXPECT_EQ(make_texture(Image(0, 3, 4)).error().text(), "texture: has 0 x 3 pixels, expected some");
  EXPECT_EQ(make_texture(Image(1, 1, 5)).error().text(), "texture: has 5 channels, expected 1 to 4");
  const auto large = make_texture(Image(16385, 1, 1));
  EXPECT_EQ(large.error().kind, ErrorKind::limit);
  EXPECT_EQ(large.error().text(), "texture: has 16385 x 1 pixels; at most 16384 x 16384 can be used");
  Image short_of_pixels(2, 2, 1);
  short_of_pixels.pixels.pop_back();
  EXPECT_EQ(make_texture(short_of_pixels).error().text(), "texture: holds 3 numbers, but its size asks for 4");
}

}  // namespace
}  // namespace lustro
