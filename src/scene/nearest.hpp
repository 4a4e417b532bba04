// "Did you mean ...?": the nearest known name to one that is not known, by the optimal string alignment distance (Damerau 1964).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lustro {

/// The known name that is nearest to `name`, where it is near enough to be meant: at most a third of its letters away. Letter case and - against
/// _ count nothing.
[[nodiscard]] std::optional<std::string_view> nearest_name(std::string_view name, std::span<const std::string_view> known);

/// `unknown word "jad", did you mean "jade"? (known: ...)`
[[nodiscard]] std::string unknown_name_message(std::string_view what, std::string_view name, std::span<const std::string_view> known);

/// Text from outside as it may stand in a message: in quotes, shortened, control characters and broken UTF-8 escaped.
[[nodiscard]] std::string quote(std::string_view text);

}  // namespace lustro
