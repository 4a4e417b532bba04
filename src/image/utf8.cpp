// The decoder follows the table of well-formed sequences (Unicode, table 3-7): no surrogates, no overlong forms, nothing above U+10FFFF.
#include "image/utf8.hpp"

namespace lustro {

char32_t next_code_point(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(0);
  const auto take = [&](std::size_t count, char32_t code) {
    text.remove_prefix(count);
    return code;
  };
  if (first < 0x80) {
    return take(1, static_cast<char32_t>(first));
  }
  const std::size_t length = first >= 0xF0 ? 4 : (first >= 0xE0 ? 3 : 2);
  constexpr char32_t kLowest[] = {0, 0, 0x80, 0x800, 0x10000};
  auto code = static_cast<char32_t>(first & (0xFFU >> (length + 1)));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) {
      return take(1, kReplacement);
    }
    code = (code << 6) | static_cast<char32_t>(byte(i) & 0x3FU);
  }
  const bool is_lead = first >= 0xC2 && first <= 0xF4;
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (!is_lead || code < kLowest[length] || code > 0x10FFFF || is_surrogate) {
    return take(1, kReplacement);
  }
  return take(length, code);
}

}  // namespace lustro
