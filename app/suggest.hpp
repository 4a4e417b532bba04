// "Did you mean ...?" for a mistyped word.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace lustro::app {

/// The known word nearest to the typed one, or nothing where none is near enough to be meant.
/// source  optimal string alignment distance (Damerau 1964): a swap of neighbours counts one, as typists make them
[[nodiscard]] std::string nearest_word(std::string_view typed, std::span<const std::string> known);

}  // namespace lustro::app
