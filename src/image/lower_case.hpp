// Names and words without regard to case, the same whatever the locale.
#pragma once

#include <algorithm>
#include <string>

namespace lustro {

/// The text with the letters A to Z as a to z; all others stay.
[[nodiscard]] inline std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

}  // namespace lustro
