// Text by FreeType. Outlines are not hinted: a line's shape and width then depend on the font alone, and its letters may stand between pixels.
#include "image/text.hpp"

#include <fmt/format.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <cstdint>
#include <memory>

#include "image/font_data.hpp"
#include "image/utf8.hpp"

namespace lustro {
namespace {

struct FreeLibrary {
  void operator()(FT_Library library) const { FT_Done_FreeType(library); }
};
struct FreeFace {
  void operator()(FT_Face face) const { FT_Done_Face(face); }
};

/// The font at one size. Members are destroyed in the reverse order: the face before its library.
struct Font {
  std::unique_ptr<FT_LibraryRec_, FreeLibrary> library;
  std::unique_ptr<FT_FaceRec_, FreeFace> face;
};

Result<Font> open_font(int size) {
  if (size < 1 || size > 1000) {
    return fail(ErrorKind::usage, "", fmt::format("a text size of {} pixels is outside 1..1000", size));
  }
  const std::span<const unsigned char> data = dejavu_sans();
  FT_Library library = nullptr;
  FT_Error error = FT_Init_FreeType(&library);
  Font font;
  font.library.reset(error == 0 ? library : nullptr);
  FT_Face face = nullptr;
  if (error == 0) {
    error = FT_New_Memory_Face(library, data.data(), static_cast<FT_Long>(data.size()), 0, &face);
    font.face.reset(error == 0 ? face : nullptr);
  }
  if (error == 0) {
    error = FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(size));
  }
  if (error != 0) {
    return fail(ErrorKind::io, "", fmt::format("FreeType cannot open the built-in font (error {})", error));
  }
  return font;
}

/// Calls visit(glyph, pen) for every glyph, the pen in 1/64 pixels from the start; returns the pen behind the last one.
template <class Visit>
std::int64_t walk(FT_Face face, std::string_view utf8, Visit visit) {
  std::int64_t pen = 0;
  FT_UInt before = 0;
  while (!utf8.empty()) {
    const char32_t code = next_code_point(utf8);
    const bool is_control = code < 0x20 || (code >= 0x7F && code < 0xA0);
    const FT_UInt glyph = FT_Get_Char_Index(face, is_control ? U' ' : code);
    FT_Vector kerning{};
    if (before != 0 && glyph != 0 && FT_Get_Kerning(face, before, glyph, FT_KERNING_UNFITTED, &kerning) == 0) {
      pen += kerning.x;
    }
    before = glyph;
    if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0) {
      continue;
    }
    visit(face->glyph, pen);
    pen += face->glyph->linearHoriAdvance >> 10;  // 16.16 to 26.6
  }
  return pen;
}

/// One pixel of the text's colour, `coverage` 0..1, over what is there.
void blend(std::span<float> pixel, const Vec3f& color, float coverage) {
  const float source[4] = {color.x, color.y, color.z, 1.0F};
  for (std::size_t c = 0; c < pixel.size(); ++c) {
    pixel[c] = pixel[c] * (1 - coverage) + source[c] * coverage;
  }
}

void blend_bitmap(Image& image, const FT_Bitmap& bitmap, std::int64_t left, std::int64_t top, const Vec3f& color) {
  for (std::int64_t row = 0; row < bitmap.rows; ++row) {
    const std::int64_t y = top + row;
    for (std::int64_t column = 0; column < bitmap.width; ++column) {
      const std::int64_t x = left + column;
      if (x >= 0 && y >= 0 && x < image.width && y < image.height) {
        const unsigned char value = bitmap.buffer[row * bitmap.pitch + column];
        blend(image.at(static_cast<int>(x), static_cast<int>(y)), color, static_cast<float>(value) / 255.0F);
      }
    }
  }
}

}  // namespace

Result<TextExtent> measure_text(std::string_view utf8, int size) {
  const auto font = open_font(size);
  if (!font) {
    return tl::unexpected(font.error());
  }
  FT_Face face = font->face.get();
  const std::int64_t end = walk(face, utf8, [](FT_GlyphSlot, std::int64_t) {});
  const auto pixels = [&](int units) { return (units * size + face->units_per_EM - 1) / face->units_per_EM; };
  return TextExtent{static_cast<int>((end + 63) / 64), pixels(face->ascender), pixels(-face->descender)};
}

Result<void> draw_text(Image& image, std::string_view utf8, int x, int y, int size, const Vec3f& color) {
  if (image.channels != 3 && image.channels != 4) {
    return fail(ErrorKind::usage, "", fmt::format("text is drawn on 3 or 4 channels, not on {}", image.channels));
  }
  const auto font = open_font(size);
  if (!font) {
    return tl::unexpected(font.error());
  }
  walk(font->face.get(), utf8, [&](FT_GlyphSlot slot, std::int64_t pen) {
    FT_Outline_Translate(&slot->outline, static_cast<FT_Pos>(pen & 63), 0);
    if (FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL) == 0) {
      blend_bitmap(image, slot->bitmap, x + (pen >> 6) + slot->bitmap_left, std::int64_t{y} - slot->bitmap_top, color);
    }
  });
  return {};
}

}  // namespace lustro
