// The numbers by which two pictures are compared. Every sum is made row by row and the rows are added in their order, so that it does not depend
// on the number of threads.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/flip.hpp"
#include "image/heat.hpp"
#include "image/srgb.hpp"
#include "lustro/image.hpp"
#include "math/lane.hpp"
#include "parallel/parallel_for.hpp"

namespace lustro {
namespace {

/// A picture as it would be stored, not rounded yet: encoded colours over black, and alpha.
struct Stored {
  std::vector<float> rgb;
  std::vector<float> alpha;
};

Stored store(const Image& image, Transfer transfer) {
  const auto step = static_cast<std::size_t>(image.channels);
  const auto width = static_cast<std::size_t>(image.width);
  const auto height = static_cast<std::size_t>(image.height);
  const bool has_alpha = step == 2 || step == 4;
  Stored stored{std::vector<float>(width * height * 3), std::vector<float>(width * height, 1.0F)};
  parallel_for(height, 0, [&](std::size_t y) {
    for (std::size_t p = y * width; p < (y + 1) * width; ++p) {
      const float* pixel = image.pixels.data() + p * step;
      for (std::size_t c = 0; c < 3; ++c) {
        const float linear = clamp01(pixel[step >= 3 ? c : 0]);
        stored.rgb[3 * p + c] = transfer == Transfer::srgb ? clamp01(srgb_encode(linear)) : linear;
      }
      if (has_alpha) {
        stored.alpha[p] = clamp01(pixel[step - 1]);
      }
    }
  });
  return stored;
}

/// What one row adds.
struct RowSums {
  double max = 0, absolute = 0, squared = 0;
  std::size_t over = 0;
};

Result<void> check_pair(const Image& a, const Image& b) {
  for (const Image* image : {&a, &b}) {
    const auto expected = static_cast<std::int64_t>(image->width) * image->height * image->channels;
    if (image->width < 1 || image->height < 1 || image->channels < 1 || image->channels > 4 ||
        expected != static_cast<std::int64_t>(image->pixels.size())) {
      return fail(ErrorKind::usage, "",
                  fmt::format("an image of {} x {} pixels and {} channels cannot be compared", image->width, image->height, image->channels));
    }
  }
  if (a.width != b.width || a.height != b.height) {
    return fail(ErrorKind::usage, "",
                fmt::format("the pictures have different sizes: {} x {} and {} x {}", a.width, a.height, b.width, b.height));
  }
  return {};
}

}  // namespace

Result<Comparison> compare_images(const Image& a, const Image& b, double tolerance, Transfer transfer) {
  if (auto ok = check_pair(a, b); !ok) {
    return tl::unexpected(std::move(ok).error());
  }
  const auto width = static_cast<std::size_t>(a.width);
  const auto height = static_cast<std::size_t>(a.height);
  const Stored first = store(a, transfer);
  const Stored second = store(b, transfer);
  const auto is_clear = [](float alpha) { return alpha != 1.0F; };
  const bool with_alpha = std::ranges::any_of(first.alpha, is_clear) || std::ranges::any_of(second.alpha, is_clear);
  // Stored integers pass through floats, so that a difference of exactly the tolerance may come out a rounding larger.
  const double limit = tolerance + 1e-6;

  std::vector<RowSums> rows(height);
  parallel_for(height, 0, [&](std::size_t y) {
    RowSums sums;
    for (std::size_t p = y * width; p < (y + 1) * width; ++p) {
      double worst = 0;
      const auto add = [&](float va, float vb) {
        const double difference = std::abs(static_cast<double>(va) - static_cast<double>(vb));
        worst = std::max(worst, difference);
        sums.absolute += difference;
        sums.squared += difference * difference;
      };
      for (std::size_t c = 0; c < 3; ++c) {
        add(first.rgb[3 * p + c], second.rgb[3 * p + c]);
      }
      if (with_alpha) {
        add(first.alpha[p], second.alpha[p]);
      }
      sums.max = std::max(sums.max, worst);
      sums.over += worst > limit ? 1 : 0;
    }
    rows[y] = sums;
  });
  RowSums total;
  for (const RowSums& row : rows) {
    total.max = std::max(total.max, row.max);
    total.absolute += row.absolute;
    total.squared += row.squared;
    total.over += row.over;
  }
  const auto pixels = static_cast<double>(width * height);
  const double values = pixels * (with_alpha ? 4 : 3);
  Comparison result;
  result.max = total.max;
  result.mean = total.absolute / values;
  result.rmse = std::sqrt(total.squared / values);
  result.psnr = total.squared > 0 ? -20 * std::log10(result.rmse) : std::numeric_limits<double>::infinity();
  result.share_over = static_cast<double>(total.over) / pixels;

  const std::vector<float> errors = flip_error(first.rgb, second.rgb, a.width, a.height);
  result.heatmap = Image(a.width, a.height, 3);
  std::vector<double> row_errors(height);
  parallel_for(height, 0, [&](std::size_t y) {
    for (std::size_t p = y * width; p < (y + 1) * width; ++p) {
      row_errors[y] += static_cast<double>(errors[p]);
      const Vec3f color = heat_color(errors[p]);
      result.heatmap.pixels[3 * p] = color.x;
      result.heatmap.pixels[3 * p + 1] = color.y;
      result.heatmap.pixels[3 * p + 2] = color.z;
    }
  });
  for (const double row : row_errors) {
    result.flip += row;
  }
  result.flip /= pixels;
  return result;
}

}  // namespace lustro
