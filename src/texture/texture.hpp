// A picture as it is looked up: texels of all mip levels in one block of memory.
//
// Texels are straight RGBA in linear light (or data, as they stand), never premultiplied. Values of 0..1 are kept as 16 bits a channel, 8 bytes
// a texel: the smallest step of an 8-bit sRGB picture is 19.9 steps of these, and no code moves by more than 1/40 of the step to its
// neighbour; an 8-bit data value v is stored as v 257, which is no rounding at all. A picture with any other value is kept as floats.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lustro/texture.hpp"

namespace lustro {

/// Where a level's texels lie. Four words, so that a kernel loads a level at once.
struct TextureLevel {
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::int32_t row = 0;    ///< texels from one row to the next: width + 1
  std::int32_t first = 0;  ///< place of the level's first texel
};

/// A texture as kernels read it: numbers, and pointers into the Texture that owns them.
///
/// Texel p is channels 4 p .. 4 p + 3 of the block. Behind every row's last texel stands the row's first one once more: the two texels of a
/// bilinear pair lie side by side, also where the picture repeats, and one load of 16 bytes brings both. Where it does not repeat the second
/// one has weight 0 (texture/sample.hpp).
struct TextureLayout {
  const TextureLevel* levels = nullptr;
  const std::uint16_t* unorms = nullptr;  ///< 65535 is 1; null where the texels are floats
  const float* floats = nullptr;
  std::int32_t level_count = 0;
  float scale = 1;  ///< what a texel's number is multiplied by: 1/65535, or 1
};

/// Texels and mip levels, immutable.
class Texture {
 public:
  enum class Format : std::uint8_t { unorm16, float32 };

  [[nodiscard]] Format format() const { return unorms_.empty() ? Format::float32 : Format::unorm16; }
  [[nodiscard]] const std::vector<TextureLevel>& levels() const { return levels_; }
  [[nodiscard]] int width() const { return levels_[0].width; }
  [[nodiscard]] int height() const { return levels_[0].height; }
  [[nodiscard]] int channels() const { return channels_; }  ///< of the picture that it was made of
  [[nodiscard]] TextureLayout layout() const {
    const bool is_unorm = format() == Format::unorm16;
    return {levels_.data(), is_unorm ? unorms_.data() : nullptr, is_unorm ? nullptr : floats_.data(), static_cast<std::int32_t>(levels_.size()),
            is_unorm ? 1.0F / 65535 : 1.0F};
  }
  /// RGBA of one texel of a level; x may be the width, which is column 0 again.
  [[nodiscard]] std::array<float, 4> texel(std::size_t level, int x, int y) const;

 private:
  friend class TextureMaker;
  Texture() = default;

  int channels_ = 4;
  std::vector<TextureLevel> levels_;   // the picture itself first, 1 x 1 last
  std::vector<std::uint16_t> unorms_;  // one of the two is empty
  std::vector<float> floats_;
};

}  // namespace lustro
