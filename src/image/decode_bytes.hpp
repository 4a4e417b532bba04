// What all readers of 8-bit pictures share: bytes to linear floats, and alpha in the form that is asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "lustro/image.hpp"

namespace lustro {

/// How colours and alpha stand beside each other.
enum class AlphaForm : std::uint8_t {
  premultiplied,  ///< of pictures: colours are multiplied by alpha
  straight,       ///< of textures: colours are what they are where nothing is covered, too
};

/// Stored bytes as floats: colours decoded by `transfer`, alpha (the last of 2 or 4 channels) divided by 255. Gray with alpha becomes four
/// channels.
[[nodiscard]] Image image_of_bytes(const ByteImage& bytes, Transfer transfer, AlphaForm alpha);

/// Colours divided by their alpha, the last of four channels; where that is 0 they become 0. Other numbers of channels have no alpha.
void unpremultiply(Image& image);

/// Some writers leave the bytes of alpha 0 that they do not use. A picture that is transparent everywhere says nothing: its alpha is left out.
void drop_empty_alpha(ByteImage& image);

/// round(value 255 / largest) for a value of a few bits.
[[nodiscard]] constexpr std::uint8_t to_8_bits(std::uint32_t value, std::uint32_t largest) {
  return static_cast<std::uint8_t>((std::uint64_t{value} * 510 + largest) / (std::uint64_t{largest} * 2));
}

/// `at byte 17`, as the place of an Error.
[[nodiscard]] std::string at_picture_byte(const std::string& where, std::size_t offset);

}  // namespace lustro
