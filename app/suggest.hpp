// "Did you mean ...?" for a mistyped word.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace lustro::app {

/// The known word that the typed one begins (`inter` for `interpolation`) or is a slip of the finger away from; nothing where there is none.
[[nodiscard]] std::string nearest_word(std::string_view typed, std::span<const std::string> known);

}  // namespace lustro::app
