// Labels in pictures: one line of text in DejaVu Sans, which the library carries inside itself.
#pragma once

#include <string_view>

#include "lustro/image.hpp"
#include "lustro/vec.hpp"

namespace lustro {

/// How large a line of text is, in pixels.
struct TextExtent {
  int width = 0;    ///< from the first pen position to the last, rounded up
  int ascent = 0;   ///< of the font at this size: what tall letters need above the baseline
  int descent = 0;  ///< and what low ones need below it, positive
};

/// The extent of a line of text.
///
/// utf8    bytes that are no UTF-8 count as U+FFFD, control characters as spaces; a character that the font lacks is an empty box
/// size    of the em square, pixels, 1..1000
/// errors  usage for a size out of range
[[nodiscard]] Result<TextExtent> measure_text(std::string_view utf8, int size);

/// Draws a line of text, anti-aliased, over the picture. What lies outside the picture is cut off.
///
/// image     3 channels, or 4 with premultiplied alpha; linear
/// x, y      pixels; where the baseline begins
/// color     linear
/// errors    usage for a size out of range, or an image of another number of channels
[[nodiscard]] Result<void> draw_text(Image& image, std::string_view utf8, int x, int y, int size, const Vec3f& color);

}  // namespace lustro
