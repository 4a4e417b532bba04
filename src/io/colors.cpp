// One pass to see the range, one to bring it into 0..1.
#include "io/colors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lustro {

void settle_colors(std::vector<Vec3f>& colors, std::string_view what, NoteBook& notes) {
  float largest = 0;
  for (const Vec3f& c : colors) {
    for (const float channel : {c.x, c.y, c.z}) {
      largest = std::isfinite(channel) ? std::max(largest, channel) : largest;
    }
  }
  float divisor = 1;
  if (largest > 2 && largest <= 65535) {
    divisor = largest > 255 ? 65535.0F : 255.0F;
    notes.add(0, fmt::format("{} colours reach {}: they are taken as 0..{}", what, largest, divisor));
  }
  std::size_t clamped = 0;
  std::size_t not_numbers = 0;
  const auto settle = [&](float channel) {
    if (std::isnan(channel)) {
      ++not_numbers;
      return 1.0F;
    }
    const float scaled = channel / divisor;
    clamped += scaled < 0 || scaled > 1 ? 1U : 0U;
    return std::clamp(scaled, 0.0F, 1.0F);
  };
  for (Vec3f& c : colors) {
    c = {settle(c.x), settle(c.y), settle(c.z)};
  }
  if (clamped != 0) {
    notes.add(0, fmt::format("{} colour channels outside 0..1 are clamped", what), clamped);
  }
  if (not_numbers != 0) {
    notes.add(0, fmt::format("{} colour channels are not numbers and become 1", what), not_numbers);
  }
}

}  // namespace lustro
