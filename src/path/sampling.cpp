// See sampling.hpp.
#include "path/sampling.hpp"

#include <algorithm>

namespace lustro {

Vec2f sample_disk(const Vec2f& u) {
  const float x = 2.0F * u.x - 1.0F;
  const float y = 2.0F * u.y - 1.0F;
  if (x == 0 && y == 0) {
    return {0, 0};
  }
  const bool is_wide = std::abs(x) > std::abs(y);
  const float radius = is_wide ? x : y;
  const float angle = (kPiF / 4) * (is_wide ? y / x : x / y);  // -pi/4..pi/4 from the axis
  const auto [sine_over_angle, cosine] = sine_over_x(std::abs(angle));
  const float sine = sine_over_angle * angle;
  return is_wide ? Vec2f{radius * cosine, radius * sine} : Vec2f{radius * sine, radius * cosine};
}

Choice::Choice(std::span<const float> weights) : sums_(weights.size() + 1) {
  for (std::size_t i = 0; i < weights.size(); ++i) {
    sums_[i + 1] = sums_[i] + static_cast<double>(weights[i]);
  }
  total_ = sums_.back();
  for (double& sum : sums_) {
    sum = total_ > 0 ? sum / total_ : 0;
  }
}

Choice::Chosen Choice::choose(float u) const {
  const auto at = static_cast<double>(u);
  const auto above = std::upper_bound(sums_.begin() + 1, sums_.end() - 1, at);  // the first sum above u, which ends what is chosen
  auto index = static_cast<std::size_t>(above - sums_.begin()) - 1;
  while (index > 0 && !(sums_[index + 1] > sums_[index])) {
    --index;  // u is as near to 1 as rounding allows, and the last ones have no weight
  }
  const double probability = sums_[index + 1] - sums_[index];
  const double rest = std::clamp((at - sums_[index]) / probability, 0.0, 1.0 - 0x1p-24);
  return {static_cast<std::uint32_t>(index), static_cast<float>(probability), static_cast<float>(rest)};
}

}  // namespace lustro
