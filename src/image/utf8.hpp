// UTF-8 (RFC 3629) to code points, whatever the bytes are.
#pragma once

#include <string_view>

namespace lustro {

constexpr char32_t kReplacement = 0xFFFD;

/// Takes the next code point off the front of `text`, which must not be empty. A byte that begins nothing valid gives kReplacement.
[[nodiscard]] char32_t next_code_point(std::string_view& text);

}  // namespace lustro
