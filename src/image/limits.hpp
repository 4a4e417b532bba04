// How large a picture may be. Every reader checks its header against this before it takes memory.
#pragma once

#include <cstdint>
#include <string>

#include "lustro/result.hpp"

namespace lustro {

constexpr std::int64_t kMaxImageSide = 16384;

/// errors  malformed for a side below 1, limit for one above 16384
[[nodiscard]] Result<void> check_image_size(std::int64_t width, std::int64_t height, const std::string& where);

}  // namespace lustro
