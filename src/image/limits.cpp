// The check of a stated picture size, with its message.
#include "image/limits.hpp"

#include <fmt/format.h>

namespace lustro {

Result<void> check_image_size(std::int64_t width, std::int64_t height, const std::string& where) {
  if (width < 1 || height < 1) {
    return fail(ErrorKind::malformed, where, fmt::format("states a size of {} x {} pixels; both must be at least 1", width, height));
  }
  if (width > kMaxImageSide || height > kMaxImageSide) {
    return fail(ErrorKind::limit, where,
                fmt::format("states a size of {} x {} pixels; at most {} x {} are read", width, height, kMaxImageSide, kMaxImageSide));
  }
  return {};
}

}  // namespace lustro
