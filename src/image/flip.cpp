// FLIP from the formulas of the paper (Andersson et al. 2020). Every filter is separable or a sum of two that are, and the picture is worked on
// in bands of rows with the rows around them, so that memory does not grow with the picture and bands need nothing of each other.
//
// libm is used freely here: these numbers are reported and never become part of a rendering.
#include "image/flip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "image/srgb.hpp"
#include "parallel/parallel_for.hpp"

namespace lustro {
namespace {

using Color = std::array<float, 3>;
using Matrix = std::array<std::array<double, 3>, 3>;

// --- colour spaces -------------------------------------------------------------------------------------------------------------------

constexpr Matrix inverse(const Matrix& m) {
  Matrix r{};
  double determinant = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    determinant += m[0][i] * (m[1][i1] * m[2][i2] - m[1][i2] * m[2][i1]);
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      r[i][j] = m[j1][i1] * m[j2][i2] - m[j1][i2] * m[j2][i1];
    }
  }
  for (auto& row : r) {
    for (double& v : row) {
      v /= determinant;
    }
  }
  return r;
}

constexpr std::array<double, 3> product(const Matrix& m, const std::array<double, 3>& v) {
  std::array<double, 3> r{};
  for (std::size_t i = 0; i < 3; ++i) {
    r[i] = (m[i][0] * v[0] + m[i][1] * v[1]) + m[i][2] * v[2];
  }
  return r;
}

// The chromaticities of IEC 61966-2-1: red, green, blue and the white point D65.
constexpr double kX[] = {0.64, 0.30, 0.15, 0.3127};
constexpr double kY[] = {0.33, 0.60, 0.06, 0.3290};

constexpr std::array<double, 3> kWhite{kX[3] / kY[3], 1, (1 - kX[3] - kY[3]) / kY[3]};

/// Linear RGB to XYZ: the primaries, scaled so that (1, 1, 1) is the white point.
constexpr Matrix xyz_from_rgb() {
  Matrix m{};
  for (std::size_t i = 0; i < 3; ++i) {
    m[0][i] = kX[i];
    m[1][i] = kY[i];
    m[2][i] = 1 - kX[i] - kY[i];
  }
  const std::array<double, 3> scale = product(inverse(m), kWhite);
  for (auto& row : m) {
    for (std::size_t i = 0; i < 3; ++i) {
      row[i] *= scale[i];
    }
  }
  return m;
}

/// XYZ relative to the white point, and back.
constexpr Matrix relative_from_rgb() {
  Matrix m = xyz_from_rgb();
  for (std::size_t i = 0; i < 3; ++i) {
    for (double& v : m[i]) {
      v /= kWhite[i];
    }
  }
  return m;
}

constexpr Matrix kRelativeFromRgb = relative_from_rgb();
constexpr Matrix kRgbFromRelative = inverse(kRelativeFromRgb);

Color transform(const Matrix& m, const Color& v) {
  Color r{};
  for (std::size_t i = 0; i < 3; ++i) {
    r[i] = (static_cast<float>(m[i][0]) * v[0] + static_cast<float>(m[i][1]) * v[1]) + static_cast<float>(m[i][2]) * v[2];
  }
  return r;
}

/// The linear colour space in which contrast sensitivity is filtered (the linearised CIELab of Flohr et al. 1993).
Color ycxcz_from_rgb(const Color& rgb) {
  const Color xyz = transform(kRelativeFromRgb, rgb);
  return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

Color rgb_from_ycxcz(const Color& c) {
  const float y = (c[0] + 16) / 116;
  return transform(kRgbFromRelative, {y + c[1] / 500, y, y - c[2] / 200});
}

/// CIELab with the Hunt effect: colours are less vivid the darker they are.
Color hunt_lab_from_rgb(const Color& rgb) {
  Color f = transform(kRelativeFromRgb, rgb);
  constexpr float kDelta = 6.0F / 29;
  for (float& v : f) {
    v = v > kDelta * kDelta * kDelta ? std::cbrt(v) : v / (3 * kDelta * kDelta) + 4.0F / 29;
  }
  const float lightness = 116 * f[1] - 16;
  return {lightness, 0.01F * lightness * 500 * (f[0] - f[1]), 0.01F * lightness * 200 * (f[1] - f[2])};
}

/// The distance for large colour differences (Abasi et al. 2020).
float hyab(const Color& a, const Color& b) {
  return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

// --- filters -----------------------------------------------------------------------------------------------------------------------

/// Taps at -radius..radius.
struct Kernel {
  int radius = 0;
  std::vector<float> taps;
};

template <class F>
Kernel sampled(int radius, F f) {
  Kernel kernel{radius, {}};
  for (int i = -radius; i <= radius; ++i) {
    kernel.taps.push_back(static_cast<float>(f(static_cast<double>(i))));
  }
  return kernel;
}

/// Positive taps sum to 1, negative ones to -1.
Kernel balanced(Kernel kernel) {
  double positive = 0;
  double negative = 0;
  for (const float t : kernel.taps) {
    (t > 0 ? positive : negative) += static_cast<double>(t);
  }
  for (float& t : kernel.taps) {
    t = static_cast<float>(static_cast<double>(t) / (t > 0 ? positive : -negative));
  }
  return kernel;
}

/// All filters of the metric at one resolution.
struct Filters {
  // contrast sensitivity: luminance, red-green, and blue-yellow as a sum of two Gaussians with their shares
  Kernel luminance, red_green, blue_yellow[2];
  float blue_yellow_share[2];
  // features: a Gaussian and its first and second derivative
  Kernel smooth, slope, bend;
  [[nodiscard]] int radius() const { return std::max(luminance.radius, smooth.radius); }
};

Filters make_filters(double pixels_per_degree) {
  constexpr double kPi = std::numbers::pi;
  constexpr double kWidest = 0.04;  // b1 of blue-yellow
  const int reach = static_cast<int>(std::ceil(3 * std::sqrt(kWidest / (2 * kPi * kPi)) * pixels_per_degree));
  const auto contrast = [&](double b) {
    return sampled(reach, [&](double i) { return std::exp(-kPi * kPi * (i / pixels_per_degree) * (i / pixels_per_degree) / b); });
  };
  const auto sum = [](const Kernel& k) {
    double total = 0;
    for (const float t : k.taps) {
      total += static_cast<double>(t);
    }
    return total;
  };
  Filters f{};
  f.luminance = balanced(contrast(0.0047));
  f.red_green = balanced(contrast(0.0053));
  // 34.1 sqrt(pi / 0.04) exp(-pi^2 d^2 / 0.04) + 13.5 sqrt(pi / 0.025) exp(-pi^2 d^2 / 0.025), over two dimensions
  const double a[2] = {34.1, 13.5};
  const double b[2] = {kWidest, 0.025};
  double weight[2];
  for (std::size_t i = 0; i < 2; ++i) {
    const Kernel kernel = contrast(b[i]);
    weight[i] = a[i] * std::sqrt(kPi / b[i]) * sum(kernel) * sum(kernel);
    f.blue_yellow[i] = balanced(kernel);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    f.blue_yellow_share[i] = static_cast<float>(weight[i] / (weight[0] + weight[1]));
  }
  // a feature is as wide as an edge can be that still is seen as one: 0.082 degrees
  const double deviation = 0.5 * 0.082 * pixels_per_degree;
  const int extent = static_cast<int>(std::ceil(3 * deviation));
  const auto gauss = [&](double i) { return std::exp(-i * i / (2 * deviation * deviation)); };
  f.smooth = balanced(sampled(extent, gauss));
  f.slope = balanced(sampled(extent, [&](double i) { return -i * gauss(i); }));
  f.bend = balanced(sampled(extent, [&](double i) { return (i * i / (deviation * deviation) - 1) * gauss(i); }));
  return f;
}

/// One channel of a band: its rows and, above and below them, as many more as the widest filter reaches.
struct Plane {
  int width = 0;
  int rows = 0;
  std::vector<float> values;
  Plane(int width_, int rows_) : width(width_), rows(rows_), values(static_cast<std::size_t>(width_) * static_cast<std::size_t>(rows_)) {}
  float* row(int y) { return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
  [[nodiscard]] const float* row(int y) const { return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
};

/// Along the rows; beyond the border the border's value goes on.
Plane along_rows(const Plane& in, const Kernel& kernel) {
  Plane out(in.width, in.rows);
  std::vector<float> padded(static_cast<std::size_t>(in.width + 2 * kernel.radius));
  for (int y = 0; y < in.rows; ++y) {
    const float* from = in.row(y);
    float* to = out.row(y);
    std::fill_n(padded.begin(), kernel.radius, from[0]);
    std::copy_n(from, in.width, padded.begin() + kernel.radius);
    std::fill_n(padded.end() - kernel.radius, kernel.radius, from[in.width - 1]);
    for (std::size_t k = 0; k < kernel.taps.size(); ++k) {
      const float tap = kernel.taps[k];
      const float* shifted = padded.data() + k;
      for (int x = 0; x < in.width; ++x) {
        to[x] += tap * shifted[x];
      }
    }
  }
  return out;
}

/// Across the rows: leaves the band's own rows, without the `margin` above and below.
Plane across_rows(const Plane& in, const Kernel& kernel, int margin) {
  Plane out(in.width, in.rows - 2 * margin);
  for (int y = 0; y < out.rows; ++y) {
    float* to = out.row(y);
    for (std::size_t k = 0; k < kernel.taps.size(); ++k) {
      const float tap = kernel.taps[k];
      const float* from = in.row(y + margin - kernel.radius + static_cast<int>(k));
      for (int x = 0; x < in.width; ++x) {
        to[x] += tap * from[x];
      }
    }
  }
  return out;
}

// --- the two pipelines ---------------------------------------------------------------------------------------------------------------

/// What the metric knows of one picture in one band.
struct Seen {
  std::vector<Color> lab;     ///< filtered by contrast sensitivity, Hunt-adjusted
  std::vector<float> edges;   ///< strength of edges
  std::vector<float> points;  ///< and of lines and points
};

std::vector<float> magnitude(const Plane& a, const Plane& b) {
  std::vector<float> out(a.values.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = std::sqrt(a.values[i] * a.values[i] + b.values[i] * b.values[i]);
  }
  return out;
}

Seen look_at(std::span<const float> image, int width, int height, int first, int last, const Filters& filters) {
  const int margin = filters.radius();
  std::array<Plane, 3> planes{Plane(width, last - first + 2 * margin), Plane(width, last - first + 2 * margin),
                              Plane(width, last - first + 2 * margin)};
  Plane gray(width, last - first + 2 * margin);
  for (int y = 0; y < gray.rows; ++y) {
    const int source = std::clamp(first - margin + y, 0, height - 1);
    const float* in = image.data() + static_cast<std::size_t>(source) * static_cast<std::size_t>(width) * 3;
    for (int x = 0; x < width; ++x, in += 3) {
      const Color c = ycxcz_from_rgb({srgb_decode(in[0]), srgb_decode(in[1]), srgb_decode(in[2])});
      for (std::size_t i = 0; i < 3; ++i) {
        planes[i].row(y)[x] = c[i];
      }
      gray.row(y)[x] = (c[0] + 16) / 116;
    }
  }
  const auto filter = [&](const Plane& plane, const Kernel& horizontal, const Kernel& vertical) {
    return across_rows(along_rows(plane, horizontal), vertical, margin);
  };
  const Plane luminance = filter(planes[0], filters.luminance, filters.luminance);
  const Plane red_green = filter(planes[1], filters.red_green, filters.red_green);
  const Plane wide = filter(planes[2], filters.blue_yellow[0], filters.blue_yellow[0]);
  const Plane narrow = filter(planes[2], filters.blue_yellow[1], filters.blue_yellow[1]);
  Seen seen;
  seen.lab.resize(luminance.values.size());
  for (std::size_t i = 0; i < seen.lab.size(); ++i) {
    const float blue_yellow = filters.blue_yellow_share[0] * wide.values[i] + filters.blue_yellow_share[1] * narrow.values[i];
    Color rgb = rgb_from_ycxcz({luminance.values[i], red_green.values[i], blue_yellow});
    for (float& v : rgb) {
      v = std::clamp(v, 0.0F, 1.0F);
    }
    seen.lab[i] = hunt_lab_from_rgb(rgb);
  }
  const Plane smooth = along_rows(gray, filters.smooth);
  seen.edges = magnitude(filter(gray, filters.slope, filters.smooth), across_rows(smooth, filters.slope, margin));
  seen.points = magnitude(filter(gray, filters.bend, filters.smooth), across_rows(smooth, filters.bend, margin));
  return seen;
}

constexpr float kColorExponent = 0.7F;    // q_c
constexpr float kFeatureExponent = 0.5F;  // q_f
constexpr float kKnee = 0.4F;             // p_c: the share of the largest error that is mapped to ...
constexpr float kKneeValue = 0.95F;       // p_t

/// HyAB between the farthest colours, to the power q_c.
float largest_color_error() {
  return std::pow(hyab(hunt_lab_from_rgb({0, 1, 0}), hunt_lab_from_rgb({0, 0, 1})), kColorExponent);
}

float color_error(const Color& a, const Color& b, float largest) {
  const float error = std::pow(hyab(a, b), kColorExponent);
  const float knee = kKnee * largest;
  return error < knee ? kKneeValue / knee * error : kKneeValue + (error - knee) / (largest - knee) * (1 - kKneeValue);
}

}  // namespace

std::vector<float> flip_error(std::span<const float> a, std::span<const float> b, int width, int height, double pixels_per_degree) {
  constexpr int kBand = 64;
  const Filters filters = make_filters(pixels_per_degree);
  const float largest = largest_color_error();
  std::vector<float> errors(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  parallel_for(static_cast<std::size_t>((height + kBand - 1) / kBand), 0, [&](std::size_t band) {
    const int first = static_cast<int>(band) * kBand;
    const int last = std::min(first + kBand, height);
    const Seen seen_a = look_at(a, width, height, first, last, filters);
    const Seen seen_b = look_at(b, width, height, first, last, filters);
    float* out = errors.data() + static_cast<std::size_t>(first) * static_cast<std::size_t>(width);
    for (std::size_t i = 0; i < seen_a.lab.size(); ++i) {
      const float feature = std::max(std::abs(seen_a.edges[i] - seen_b.edges[i]), std::abs(seen_a.points[i] - seen_b.points[i]));
      const float feature_error = std::pow(feature / std::numbers::sqrt2_v<float>, kFeatureExponent);
      out[i] = std::pow(std::min(color_error(seen_a.lab[i], seen_b.lab[i], largest), 1.0F), 1 - std::min(feature_error, 1.0F));
    }
  });
  return errors;
}

}  // namespace lustro
