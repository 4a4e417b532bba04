// What a fuzzed reader of pictures must give: a picture whose sizes fit together, or an error that says what and where.
#pragma once

#include <cstddef>
#include <cstdlib>

#include "lustro/image.hpp"
#include "lustro/result.hpp"

namespace lustro {

inline void check_image(const Result<Image>& image) {
  if (!image) {
    if (image.error().message.empty() || image.error().where.empty()) {
      std::abort();
    }
    return;
  }
  const bool has_channels = image->channels == 1 || image->channels == 3 || image->channels == 4;
  const std::size_t floats =
      static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height) * static_cast<std::size_t>(image->channels);
  if (image->width < 1 || image->height < 1 || !has_channels || floats != image->pixels.size()) {
    std::abort();
  }
}

}  // namespace lustro
