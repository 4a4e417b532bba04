// Hashes of pictures as text: 16 hexadecimal digits.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "lustro/result.hpp"

namespace lustro::app {

[[nodiscard]] std::string hash_text(std::uint64_t hash);

/// The opposite, in upper and lower case.
/// errors  usage for anything but 16 hexadecimal digits
[[nodiscard]] Result<std::uint64_t> parse_hash(std::string_view text);

}  // namespace lustro::app
