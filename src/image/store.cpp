// The one path from a float pixel to stored integers, for both widths.
#include "image/store.hpp"

#include <cstddef>
#include <span>

#include "image/srgb.hpp"
#include "image/tone.hpp"
#include "parallel/parallel_for.hpp"

namespace lustro {
namespace {

/// One row of pixels. `color_of` and `alpha_of` make the stored integer of a float.
template <std::size_t kChannels, class Int, class Color, class Alpha>
void store_row(std::span<const float> from, Int* to, Color color_of, Alpha alpha_of) {
  constexpr bool kHasAlpha = kChannels == 2 || kChannels == 4;
  constexpr std::size_t kColors = kHasAlpha ? kChannels - 1 : kChannels;
  for (std::size_t i = 0; i < from.size(); i += kChannels) {
    const float alpha = kHasAlpha ? from[i + kColors] : 1.0F;
    if (alpha >= 1) {  // more than full coverage is full coverage
      for (std::size_t c = 0; c < kColors; ++c) {
        to[i + c] = color_of(from[i + c]);
      }
    } else {
      for (std::size_t c = 0; c < kColors; ++c) {
        to[i + c] = color_of(alpha > 0 ? from[i + c] / alpha : 0.0F);
      }
    }
    if constexpr (kHasAlpha) {
      to[i + kColors] = alpha_of(alpha);
    }
  }
}

/// The same of a picture that is toned before. A picture of gray is one of three equal channels.
template <std::size_t kChannels, class Int, class Color, class Alpha>
void store_row(std::span<const float> from, Int* to, const Toning& toning, Color color_of, Alpha alpha_of) {
  constexpr bool kHasAlpha = kChannels == 2 || kChannels == 4;
  if (!toning.changes()) {
    store_row<kChannels>(from, to, color_of, alpha_of);
    return;
  }
  for (std::size_t i = 0; i < from.size(); i += kChannels) {
    const float alpha = kHasAlpha ? from[i + kChannels - 1] : 1.0F;
    const auto straight = [&](std::size_t c) { return alpha >= 1 ? from[i + c] : alpha > 0 ? from[i + c] / alpha : 0.0F; };
    if constexpr (kChannels >= 3) {
      const Vec3f color = toned(toning, Vec3f{straight(0), straight(1), straight(2)});
      to[i] = color_of(color.x);
      to[i + 1] = color_of(color.y);
      to[i + 2] = color_of(color.z);
    } else {
      to[i] = color_of(toned(toning, Vec3f{straight(0), straight(0), straight(0)}).y);
    }
    if constexpr (kHasAlpha) {
      to[i + kChannels - 1] = alpha_of(alpha);
    }
  }
}

template <class Int, class Color, class Alpha>
std::vector<Int> store(const Image& image, const Toning& toning, int threads, Color color_of, Alpha alpha_of) {
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::size_t row_length = static_cast<std::size_t>(image.width) * channels;
  std::vector<Int> out(image.pixels.size());
  parallel_for(static_cast<std::size_t>(image.height), threads, [&](std::size_t y) {
    const std::span<const float> from(&image.pixels[y * row_length], row_length);
    Int* to = &out[y * row_length];
    switch (channels) {
      case 1:
        return store_row<1>(from, to, toning, color_of, alpha_of);
      case 2:
        return store_row<2>(from, to, toning, color_of, alpha_of);
      case 3:
        return store_row<3>(from, to, toning, color_of, alpha_of);
      default:
        return store_row<4>(from, to, toning, color_of, alpha_of);
    }
  });
  return out;
}

}  // namespace

std::vector<std::uint8_t> stored8(const Image& image, Transfer transfer, const Tone& tone, int threads) {
  if (transfer != Transfer::srgb) {
    return store<std::uint8_t>(image, Toning(tone), threads, quantize8, quantize8);
  }
  const auto encode = [&table = srgb_table()](float x) { return srgb_byte(table, x); };
  return store<std::uint8_t>(image, Toning(tone), threads, encode, quantize8);
}

std::vector<std::uint16_t> stored16(const Image& image, Transfer transfer, const Tone& tone, int threads) {
  const auto encode = [](float x) { return quantize16(srgb_encode(x)); };
  return transfer == Transfer::srgb ? store<std::uint16_t>(image, Toning(tone), threads, encode, quantize16)
                                    : store<std::uint16_t>(image, Toning(tone), threads, quantize16, quantize16);
}

void store_pixel8(const std::array<float, 4>& pixel, Transfer transfer, const Toning& toning, std::array<std::uint8_t, 4>& out) {
  if (transfer == Transfer::srgb) {
    store_row<4>(
        pixel, out.data(), toning, [&table = srgb_table()](float x) { return srgb_byte(table, x); }, quantize8);
  } else {
    store_row<4>(pixel, out.data(), toning, quantize8, quantize8);
  }
}

ByteImage to_bytes(const Image& image, Transfer transfer, const Tone& tone) {
  return {.width = image.width, .height = image.height, .channels = image.channels, .pixels = stored8(image, transfer, tone)};
}

}  // namespace lustro
