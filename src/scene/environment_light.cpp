// See environment_light.hpp. Every sum is made row by row, and the rows are added in their order.
#include "scene/environment_light.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "math/power.hpp"
#include "math/trig.hpp"
#include "parallel/parallel_for.hpp"

namespace lustro {
namespace {

/// The rows and columns of a picture of all directions.
struct SphereGrid {
  SphereGrid(int width, int height) {
    for (int x = 0; x < width; ++x) {
      const double longitude = 2 * kPi * ((x + 0.5) / width - 0.5);  // from -z towards +x
      columns.push_back({sine(longitude), -cosine(longitude)});
    }
    for (int y = 0; y < height; ++y) {
      const double colatitude = kPi * (y + 0.5) / height;
      const double top = cosine(kPi * y / height), bottom = cosine(kPi * (y + 1) / height);
      rows.push_back({sine(colatitude), cosine(colatitude), (top - bottom) * 2 * kPi / width});
    }
  }
  struct Column {
    double x, z;
  };
  struct Row {
    double flat, y;
    double solid_angle;  // of each of its pixels
  };
  [[nodiscard]] Vec3d direction(std::size_t x, std::size_t y) const {
    return {columns[x].x * rows[y].flat, rows[y].y, columns[x].z * rows[y].flat};
  }

  std::vector<Column> columns;
  std::vector<Row> rows;
};

Vec3d pixel(const Image& picture, std::size_t x, std::size_t y) {
  const float* p = picture.pixels.data() + (y * static_cast<std::size_t>(picture.width) + x) * static_cast<std::size_t>(picture.channels);
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

using Harmonics = std::array<Vec3d, 9>;

// The real spherical harmonics Y_00, Y_1-1 .. Y_22 without their constants, in the order of ShadingEnvironment.
std::array<double, 9> polynomials(const Vec3d& d) {
  return {1, d.x, d.y, d.z, d.x * d.y, d.y * d.z, d.x * d.z, 3 * d.z * d.z - 1, d.x * d.x - d.y * d.y};
}

// c^2 of each polynomial's constant times A_l / pi: the projection's constant, the evaluation's, and the cosine lobe's.
constexpr std::array<double, 9> kWeights{
    1 / (4 * kPi),      3 / (4 * kPi) * 2 / 3, 3 / (4 * kPi) * 2 / 3, 3 / (4 * kPi) * 2 / 3, 15 / (4 * kPi) / 4,
    15 / (4 * kPi) / 4, 15 / (4 * kPi) / 4,    5 / (16 * kPi) / 4,    15 / (16 * kPi) / 4,
};

// 3 z^2 - 1 as z^2 and 1.
ShadingEnvironment from_harmonics(const Harmonics& sums) {
  Harmonics c;
  for (std::size_t i = 0; i < 9; ++i) {
    c[i] = sums[i] * kWeights[i];
  }
  c[0] = c[0] - c[7];
  c[7] = c[7] * 3.0;
  ShadingEnvironment result;
  std::transform(c.begin(), c.end(), result.of.begin(), [](const Vec3d& v) { return vec_cast<float>(v); });
  return result;
}

}  // namespace

ShadingEnvironment diffuse_light(const Image& picture, int threads) {
  const SphereGrid grid(picture.width, picture.height);
  const auto height = static_cast<std::size_t>(picture.height);
  const auto width = static_cast<std::size_t>(picture.width);
  std::vector<Harmonics> rows(height);
  parallel_for(height, threads, [&](std::size_t y) {
    Harmonics sums{};
    for (std::size_t x = 0; x < width; ++x) {
      const Vec3d light = pixel(picture, x, y);
      const std::array<double, 9> p = polynomials(grid.direction(x, y));
      for (std::size_t i = 0; i < 9; ++i) {
        sums[i] += light * p[i];
      }
    }
    for (Vec3d& sum : sums) {
      sum = sum * grid.rows[y].solid_angle;
    }
    rows[y] = sums;
  });
  Harmonics total{};
  for (const Harmonics& row : rows) {
    for (std::size_t i = 0; i < 9; ++i) {
      total[i] += row[i];
    }
  }
  return from_harmonics(total);
}

ShadingEnvironment diffuse_light(const Vec3f& color) {
  ShadingEnvironment result;
  result.of[0] = color;
  return result;
}

ShadingEnvironment turned(const ShadingEnvironment& light, double degrees) {
  // L'(d) = L(Q d), with Q the turn backwards: x -> c x - s z, z -> s x + c z
  const double s = sine_deg(degrees), c = cosine_deg(degrees);
  std::array<Vec3d, 9> from;
  std::transform(light.of.begin(), light.of.end(), from.begin(), [](const Vec3f& v) { return vec_cast<double>(v); });
  std::array<Vec3d, 9> to = from;
  to[1] = from[1] * c + from[3] * s;
  to[3] = from[3] * c - from[1] * s;
  to[4] = from[4] * c + from[5] * s;  // x y, y z
  to[5] = from[5] * c - from[4] * s;
  // the rest is a form of x^2, y^2, z^2 and x z: a x^2 - a y^2 + b z^2 + e x z
  const Vec3d a = from[8], b = from[7], e = from[6];
  const Vec3d xx = a * (c * c) + b * (s * s) + e * (c * s);
  const Vec3d zz = a * (s * s) + b * (c * c) - e * (c * s);
  const Vec3d xz = (b - a) * (2 * c * s) + e * (c * c - s * s);
  // x^2 and y^2 as they are kept: with x^2 + y^2 + z^2 = 1, p x^2 - a y^2 + q z^2 is k + m (x^2 - y^2) + r z^2
  const Vec3d k = (xx - a) * 0.5;
  to[0] = from[0] + k;
  to[6] = xz;
  to[7] = zz - k;
  to[8] = (xx + a) * 0.5;
  ShadingEnvironment result;
  std::transform(to.begin(), to.end(), result.of.begin(), [](const Vec3d& v) { return vec_cast<float>(v); });
  return result;
}

Image reduced_sphere(const Image& picture, int width) {
  const int to_width = std::min(width, picture.width);
  const int to_height = std::min(std::max(width / 2, 1), picture.height);
  const SphereGrid grid(picture.width, picture.height);
  const double step_x = static_cast<double>(picture.width) / to_width, step_y = static_cast<double>(picture.height) / to_height;
  // how much of pixel i lies between two places
  const auto overlap = [](int i, double low, double high) {
    return std::max(0.0, std::min(high, i + 1.0) - std::max(low, static_cast<double>(i)));
  };
  Image result(to_width, to_height, 3);
  for (int y = 0; y < to_height; ++y) {
    for (int x = 0; x < to_width; ++x) {
      const double left = x * step_x, right = (x + 1) * step_x, top = y * step_y, bottom = (y + 1) * step_y;
      Vec3d sum{};
      double weight = 0;
      for (int j = static_cast<int>(top); j < std::min(static_cast<int>(bottom) + 1, picture.height); ++j) {
        const double share = grid.rows[static_cast<std::size_t>(j)].solid_angle * overlap(j, top, bottom);
        for (int i = static_cast<int>(left); i < std::min(static_cast<int>(right) + 1, picture.width); ++i) {
          const double part = share * overlap(i, left, right);
          sum += pixel(picture, static_cast<std::size_t>(i), static_cast<std::size_t>(j)) * part;
          weight += part;
        }
      }
      const Vec3f mean = vec_cast<float>(sum * (1 / weight));
      const auto to = result.at(x, y);
      to[0] = mean.x;
      to[1] = mean.y;
      to[2] = mean.z;
    }
  }
  return result;
}

Image blurred_by_lobe(const Image& picture, float n, int threads) {
  // the lobe falls to a half at 1.18 / sqrt(n): two texels to that
  constexpr int kLeast = 32, kMost = 512;
  const double needed = 2 * kPi / 0.6 * std::sqrt(static_cast<double>(std::max(n, 1.0F)));
  const int width = std::clamp(4 * static_cast<int>(needed / 4), kLeast, kMost);
  const Image from = reduced_sphere(picture, width);
  const SphereGrid grid(from.width, from.height);
  Image result(width, width / 2, 3);
  const SphereGrid looks(result.width, result.height);
  const Exponent exponent(n);
  // beyond this cosine the lobe is below 1/4096 of its peak
  const double least_cosine = n > 0 ? std::max(0.0, 1 - 8.3178 / static_cast<double>(n)) : 0;
  parallel_for(static_cast<std::size_t>(result.height), threads, [&](std::size_t y) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(result.width); ++x) {
      const Vec3d mirrored = looks.direction(x, y);
      Vec3d sum{};
      double weight = 0;
      for (std::size_t j = 0; j < grid.rows.size(); ++j) {
        // the cosine is y y' + flat flat' cos(difference of longitudes): the columns where it is large enough
        const SphereGrid::Row& row = grid.rows[j];
        const double largest = (least_cosine - mirrored.y * row.y) / (looks.rows[y].flat * row.flat);
        if (largest >= 1) {
          continue;
        }
        const auto columns = static_cast<int>(grid.columns.size());
        const double turns = largest <= -1 ? 0.5 : arccosine(largest) / (2 * kPi);
        const int reach = std::min(static_cast<int>(turns * columns) + 1, (columns - 1) / 2);
        const int middle = static_cast<int>(x) * columns / result.width;
        const int last = largest <= -1 ? middle - reach + columns - 1 : middle + reach;
        for (int column = middle - reach; column <= last; ++column) {
          const auto i = static_cast<std::size_t>((column + columns) % columns);
          const double cosine = dot(mirrored, grid.direction(i, j));
          if (cosine <= least_cosine) {
            continue;
          }
          const double share = static_cast<double>(power(static_cast<float>(cosine), exponent)) * row.solid_angle;
          sum += pixel(from, i, j) * share;
          weight += share;
        }
      }
      const Vec3f mean = vec_cast<float>(sum * (1 / weight));
      const auto to = result.at(static_cast<int>(x), static_cast<int>(y));
      to[0] = mean.x;
      to[1] = mean.y;
      to[2] = mean.z;
    }
  });
  return result;
}

}  // namespace lustro
