// The check of a stated picture size, with its message.
#include "image/limits.hpp"

#include <fmt/format.h>

namespace lustro {

Result<void> check_image_size(std::int64_t width, std::int64_t height, const std::string& where, const ImageLimits& limits) {
  if (width < 1 || height < 1) {
    return fail(ErrorKind::malformed, where, fmt::format("states a size of {} x {} pixels; both must be at least 1", width, height));
  }
  if (width > limits.side || height > limits.side) {
    return fail(ErrorKind::limit, where,
                fmt::format("states a size of {} x {} pixels; at most {} x {} are read", width, height, limits.side, limits.side));
  }
  if (width * height > limits.pixels) {
    return fail(ErrorKind::limit, where,
                fmt::format("states a size of {} x {} pixels; at most {} pixels are read", width, height, limits.pixels));
  }
  return {};
}

}  // namespace lustro
