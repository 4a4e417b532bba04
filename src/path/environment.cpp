// A picture's pixels are chosen by their luminance as it is blended, times the solid angle of their row.
// source  Pharr, Jakob and Humphreys, Physically Based Rendering, 4th edition, 12.5.2
#include "path/environment.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "path/bsdf.hpp"
#include "shade/reflection.hpp"

namespace lustro {
namespace {

// From the world to the sky's own directions, and back.
Vec3f into_sky(const PreparedEnvironment& e, const Vec3f& d) {
  return {e.cosine * d.x - e.sine * d.z, d.y, e.sine * d.x + e.cosine * d.z};
}
Vec3f from_sky(const PreparedEnvironment& e, const Vec3f& d) {
  return {e.cosine * d.x + e.sine * d.z, d.y, e.cosine * d.z - e.sine * d.x};
}

const float* pixel(const Image& picture, int x, int y) {
  return picture.pixels.data() + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
}

Vec3f color_of(const Image& picture, int x, int y) {
  const float* const p = pixel(picture, x, y);
  return {p[0], p[1], p[2]};
}

// The luminance of a pixel's blended values, on the average: 1/8, 6/8, 1/8 of it and its neighbours, along both axes.
std::vector<float> blended_luminance(const Image& picture) {
  const int width = picture.width;
  const int height = picture.height;
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x); };
  std::vector<float> along(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int left = x == 0 ? width - 1 : x - 1;
      const int right = x == width - 1 ? 0 : x + 1;
      const auto luminance = [&](int column) { return luminance_of(color_of(picture, column, y)); };
      along[at(x, y)] = (luminance(left) + luminance(right)) * 0.125F + luminance(x) * 0.75F;
    }
  }
  std::vector<float> both(along.size());
  for (int y = 0; y < height; ++y) {
    const int above = std::max(y - 1, 0);
    const int below = std::min(y + 1, height - 1);
    for (int x = 0; x < width; ++x) {
      both[at(x, y)] = (along[at(x, above)] + along[at(x, below)]) * 0.125F + along[at(x, y)] * 0.75F;
    }
  }
  return both;
}

}  // namespace

Sky::Sky(const PreparedEnvironment& environment) : environment_(&environment) {
  if (environment.picture == nullptr) {
    power_ = 4 * kPiF * luminance_of(environment.color);
    return;
  }
  const Image& picture = *environment.picture;
  width_ = picture.width;
  height_ = picture.height;
  const std::vector<float> luminance = blended_luminance(picture);
  std::vector<float> rows;
  columns_.reserve(static_cast<std::size_t>(height_));
  for (int y = 0; y < height_; ++y) {
    const auto row =
        std::span(luminance).subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(width_), static_cast<std::size_t>(width_));
    columns_.emplace_back(row);
    const double colatitude = (static_cast<double>(y) + 0.5) / static_cast<double>(height_) * kPi;
    rows.push_back(static_cast<float>(columns_.back().total() * sine(colatitude)));
  }
  rows_ = Choice(rows);
  // A pixel spans 2 pi / width by pi / height.
  const double pixel_angle = 2 * kPi * kPi / (static_cast<double>(width_) * static_cast<double>(height_));
  power_ = static_cast<float>(rows_.total() * pixel_angle) * luminance_of(environment.color);
  if (rows_.is_empty()) {
    power_ = 0;
  }
}

Vec2f Sky::place_of(const Vec3f& direction) const {
  const Footprint<float> at = on_sphere(DirectionSlopes<float>{into_sky(*environment_, direction), {}, {}});
  return {at.u * static_cast<float>(width_), at.v * static_cast<float>(height_)};
}

Vec3f Sky::radiance(const Vec3f& direction) const {
  if (environment_->picture == nullptr) {
    return environment_->color;
  }
  const Image& picture = *environment_->picture;
  const Vec2f place = place_of(direction);
  const float x = place.x - 0.5F;
  const float y = std::clamp(place.y - 0.5F, 0.0F, static_cast<float>(height_ - 1));
  const float left = std::floor(x);
  const float top = std::floor(y);
  const int x0 = left < 0 ? width_ - 1 : std::min(static_cast<int>(left), width_ - 1);
  const int x1 = x0 == width_ - 1 ? 0 : x0 + 1;
  const int y0 = static_cast<int>(top);
  const int y1 = std::min(y0 + 1, height_ - 1);
  const float across = x - left;
  const float down = y - top;
  const Vec3f upper = color_of(picture, x0, y0) * (1.0F - across) + color_of(picture, x1, y0) * across;
  const Vec3f lower = color_of(picture, x0, y1) * (1.0F - across) + color_of(picture, x1, y1) * across;
  return (upper * (1.0F - down) + lower * down) * environment_->color;
}

SkySample Sky::sample(const Vec2f& u) const {
  if (environment_->picture == nullptr) {
    return {sample_sphere(u), 0.25F * kInversePiF};
  }
  if (rows_.is_empty()) {
    return {};
  }
  const Choice::Chosen row = rows_.choose(u.y);
  const Choice::Chosen column = columns_[row.index].choose(u.x);
  const float turn = (static_cast<float>(column.index) + column.rest) / static_cast<float>(width_);
  const float colatitude = kPiF * ((static_cast<float>(row.index) + row.rest) / static_cast<float>(height_));
  const auto [sine_over, cosine] = sine_over_x(colatitude);
  const float flat = sine_over * colatitude;
  const Vec2f around = on_circle(turn + (turn < 0.5F ? 0.5F : -0.5F));  // u = 1/2 is -z
  const Vec3f local{flat * around.y, cosine, -(flat * around.x)};
  const Vec3f direction = from_sky(*environment_, normalize(local));
  return {direction, density(direction)};
}

float Sky::density(const Vec3f& direction) const {
  if (environment_->picture == nullptr) {
    return 0.25F * kInversePiF;
  }
  const Vec2f place = place_of(direction);
  const int x = std::clamp(static_cast<int>(place.x), 0, width_ - 1);
  const int y = std::clamp(static_cast<int>(place.y), 0, height_ - 1);
  if (columns_[static_cast<std::size_t>(y)].is_empty()) {
    return 0;
  }
  const float chosen =
      rows_.probability(static_cast<std::uint32_t>(y)) * columns_[static_cast<std::size_t>(y)].probability(static_cast<std::uint32_t>(x));
  const float sine = safe_root(1.0F - direction.y * direction.y);
  const float angle = (2 * kPiF * kPiF) * sine / (static_cast<float>(width_) * static_cast<float>(height_));
  return sine > 1e-6F ? chosen / angle : 0.0F;
}

}  // namespace lustro
