// A picture as it is looked up: texels of all mip levels in one block of memory.
//
// Texels are straight RGBA in linear light (or data, as they stand), never premultiplied. Three formats, the smallest that does for the picture:
//   unorm8    every value is a whole 255th: normals, masks, whatever was 8 bits and is no light. 4 bytes a texel: what is looked up comes from
//             the caches, and half the bytes are half the wait. Not for pictures of one value: heights are looked at by their differences, which
//             8 bits would cut into steps in the smaller levels
//   unorm16   values of 0..1: the smallest step of an 8-bit sRGB picture is 19.9 steps of these, and no code moves by more than 1/40 of the
//             step to its neighbour; an 8-bit value v is stored as v 257, which is no rounding at all
//   float32   any other picture
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
/// bilinear pair lie side by side, also where the picture repeats, and one load brings both. Where it does not repeat the second one has
/// weight 0 (texture/sample.hpp). 16 bytes may be read from any texel on.
struct TextureLayout {
  const TextureLevel* levels = nullptr;
  const std::uint8_t* bytes = nullptr;  ///< one of the three is not null
  const std::uint16_t* unorms = nullptr;
  const float* floats = nullptr;
  std::int32_t level_count = 0;
  float unit = 1;        ///< the number that stands for 1: 255, 65535, or 1
  float scale = 1;       ///< what a texel's number is multiplied by: 1 / unit
  bool is_gray = false;  ///< red, green and blue are the same everywhere: one channel says it all; never of floats
};

/// Texels and mip levels, immutable.
class Texture {
 public:
  enum class Format : std::uint8_t { unorm8, unorm16, float32 };

  [[nodiscard]] Format format() const { return !bytes_.empty() ? Format::unorm8 : (!unorms_.empty() ? Format::unorm16 : Format::float32); }
  [[nodiscard]] const std::vector<TextureLevel>& levels() const { return levels_; }
  [[nodiscard]] int width() const { return levels_[0].width; }
  [[nodiscard]] int height() const { return levels_[0].height; }
  [[nodiscard]] int channels() const { return channels_; }  ///< of the picture that it was made of
  /// Of all levels.
  [[nodiscard]] std::size_t byte_count() const {
    return bytes_.size() + unorms_.size() * sizeof(std::uint16_t) + floats_.size() * sizeof(float);
  }
  [[nodiscard]] TextureLayout layout() const {
    const Format format = this->format();
    const float unit = format == Format::unorm8 ? 255.0F : (format == Format::unorm16 ? 65535.0F : 1.0F);
    return {levels_.data(),
            format == Format::unorm8 ? bytes_.data() : nullptr,
            format == Format::unorm16 ? unorms_.data() : nullptr,
            format == Format::float32 ? floats_.data() : nullptr,
            static_cast<std::int32_t>(levels_.size()),
            unit,
            1.0F / unit,
            is_gray_};
  }
  /// RGBA of one texel of a level; x may be the width, which is column 0 again.
  [[nodiscard]] std::array<float, 4> texel(std::size_t level, int x, int y) const;

 private:
  friend class TextureMaker;
  Texture() = default;

  int channels_ = 4;
  bool is_gray_ = false;
  std::vector<TextureLevel> levels_;  // the picture itself first, 1 x 1 last
  std::vector<std::uint8_t> bytes_;   // one of the three is not empty
  std::vector<std::uint16_t> unorms_;
  std::vector<float> floats_;
};

}  // namespace lustro
