// Percent-encoding of addresses (RFC 3986, 2.1), undone.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lustro {

/// `%20` as a space; nothing where a % has no two digits behind it.
[[nodiscard]] std::optional<std::string> without_percent(std::string_view text);

}  // namespace lustro
