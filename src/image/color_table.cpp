// Choosing colours: see color_table.hpp. Sums are of integers, so the table does not depend on their order.
#include "image/color_table.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace lustro {
namespace {

constexpr std::size_t kCells = std::size_t{1} << 18U;

/// A mean colour and how many pixels have it.
struct Weighted {
  double count = 0;
  std::array<double, 3> mean{};
};

/// Some of the colours, with what decides where they are split.
struct Box {
  std::span<Weighted> colors;
  double error = 0;  ///< along `axis`, weighted
  std::size_t axis = 0;
  double mean = 0;  ///< on the axis
};

Box box_of(std::span<Weighted> colors) {
  Box box{.colors = colors};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double count = 0, sum = 0, squares = 0;
    for (const Weighted& color : colors) {
      count += color.count;
      sum += color.count * color.mean[axis];
      squares += color.count * color.mean[axis] * color.mean[axis];
    }
    const double error = count > 0 ? squares - sum * sum / count : 0;
    if (axis == 0 || error > box.error) {
      box.error = error;
      box.axis = axis;
      box.mean = sum / count;
    }
  }
  return box;
}

Rgb8 mean_of(std::span<const Weighted> colors) {
  Rgb8 out{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double count = 0, sum = 0;
    for (const Weighted& color : colors) {
      count += color.count;
      sum += color.count * color.mean[axis];
    }
    out[axis] = static_cast<std::uint8_t>(std::clamp(sum / count + 0.5, 0.0, 255.0));
  }
  return out;
}

}  // namespace

ColorCounts::ColorCounts() : cells_(kCells) {}

void ColorCounts::add(const ByteImage& picture) {
  for (std::size_t i = 0; i + 3 < picture.pixels.size(); i += 4) {
    const std::uint8_t* const p = &picture.pixels[i];
    if (p[3] < 128) {
      continue;
    }
    Cell& cell = cells_[cell_of(p[0], p[1], p[2])];
    ++cell.count;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cell.sum[axis] += p[axis];
    }
  }
}

std::vector<Rgb8> ColorCounts::table(std::size_t most) const {
  std::vector<Weighted> colors;
  for (const Cell& cell : cells_) {
    if (cell.count > 0) {
      const auto count = static_cast<double>(cell.count);
      Weighted& color = colors.emplace_back(Weighted{.count = count});
      for (std::size_t axis = 0; axis < 3; ++axis) {
        color.mean[axis] = static_cast<double>(cell.sum[axis]) / count;
      }
    }
  }
  if (colors.empty()) {
    return {};
  }
  std::vector<Box> boxes{box_of(colors)};
  while (boxes.size() < most) {
    const auto worst = std::max_element(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.error < b.error; });
    if (worst->colors.size() < 2 || !(worst->error > 0)) {
      // Boxes of one colour have no error left; rounding may leave some to a box of several that are equal on every axis.
      break;
    }
    const Box box = *worst;
    const auto middle =
        std::stable_partition(box.colors.begin(), box.colors.end(), [&](const Weighted& c) { return c.mean[box.axis] < box.mean; });
    const auto below = static_cast<std::size_t>(middle - box.colors.begin());
    if (below == 0 || below == box.colors.size()) {
      worst->error = 0;
      continue;
    }
    *worst = box_of(box.colors.first(below));
    boxes.push_back(box_of(box.colors.subspan(below)));
  }
  std::vector<Rgb8> table;
  table.reserve(boxes.size());
  for (const Box& box : boxes) {
    table.push_back(mean_of(box.colors));
  }
  return table;
}

std::vector<std::uint8_t> nearest_entries(const std::vector<Rgb8>& table) {
  std::vector<std::uint8_t> nearest(kCells);
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    const std::array<int, 3> middle{static_cast<int>(cell >> 12U) * 4 + 2, static_cast<int>(cell >> 6U & 63U) * 4 + 2,
                                    static_cast<int>(cell & 63U) * 4 + 2};
    int best = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < table.size(); ++i) {
      int distance = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const int d = table[i][axis] - middle[axis];
        distance += d * d;
      }
      if (distance < best) {
        best = distance;
        nearest[cell] = static_cast<std::uint8_t>(i);
      }
    }
  }
  return nearest;
}

}  // namespace lustro
