// See sampling.hpp.
#include "path/sampling.hpp"

#include <algorithm>
#include <bit>

namespace lustro {

namespace {

// Without a branch, which nobody could predict.
float chosen(bool first, float a, float b) {
  const std::uint32_t mask = 0U - static_cast<std::uint32_t>(first);
  return std::bit_cast<float>((std::bit_cast<std::uint32_t>(a) & mask) | (std::bit_cast<std::uint32_t>(b) & ~mask));
}

}  // namespace

Vec2f sample_disk(const Vec2f& u) {
  const float x = 2.0F * u.x - 1.0F;
  const float y = 2.0F * u.y - 1.0F;
  if (x == 0 && y == 0) {
    return {0, 0};
  }
  const bool is_wide = std::abs(x) > std::abs(y);
  const float radius = chosen(is_wide, x, y);
  const float angle = (kPiF / 4) * (chosen(is_wide, y, x) / radius);  // -pi/4..pi/4 from the axis
  const auto [sine_over_angle, cosine] = sine_over_x(std::abs(angle));
  const float along = radius * cosine;
  const float across = radius * (sine_over_angle * angle);
  return {chosen(is_wide, along, across), chosen(is_wide, across, along)};
}

Choice::Choice(std::span<const float> weights) : sums_(weights.size() + 1), guide_(weights.size()) {
  for (std::size_t i = 0; i < weights.size(); ++i) {
    sums_[i + 1] = sums_[i] + static_cast<double>(weights[i]);
  }
  total_ = sums_.back();
  if (is_empty()) {
    return;
  }
  for (double& sum : sums_) {
    sum /= total_;
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    last_ = sums_[i + 1] > sums_[i] ? static_cast<std::uint32_t>(i) : last_;
  }
  std::uint32_t index = 0;
  for (std::size_t i = 0; i < guide_.size(); ++i) {
    const double at = static_cast<double>(i) / static_cast<double>(guide_.size());
    while (index < last_ && !(sums_[index + 1] > at)) {
      ++index;
    }
    guide_[i] = index;
  }
}

Choice::Chosen Choice::choose(float u) const {
  const auto at = static_cast<double>(u);
  std::uint32_t index = guide_[static_cast<std::size_t>(at * static_cast<double>(guide_.size()))];
  while (index < last_ && !(sums_[index + 1] > at)) {
    ++index;
  }
  const double probability = sums_[index + 1] - sums_[index];
  const double rest = std::clamp((at - sums_[index]) / probability, 0.0, 1.0 - 0x1p-24);
  return {index, static_cast<float>(probability), static_cast<float>(rest)};
}

}  // namespace lustro
