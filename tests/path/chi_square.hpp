// Pearson's chi-square test of a sampler of directions: how many fall into each cell of the sphere against the integral of the density over it.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "lustro/vec.hpp"
#include "path/sampling.hpp"

namespace lustro {

/// 0..1, the 1 excluded.
class Uniform {
 public:
  explicit Uniform(std::uint32_t seed = 1) : random_(seed) {}
  float one() { return static_cast<float>(random_() >> 8U) * 0x1p-24F; }
  Vec2f two() {
    const float x = one();
    return {x, one()};
  }

 private:
  std::mt19937 random_;
};

/// found and expected counts a cell; cells that expect fewer than 5 count together. Fails beyond 4.5 standard deviations of the statistic.
inline void expect_counts(const std::vector<double>& found, const std::vector<double>& expected, const std::string& what) {
  double statistic = 0;
  double rest_found = 0;
  double rest_expected = 0;
  int cells = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (expected[i] < 5) {
      rest_found += found[i];
      rest_expected += expected[i];
      continue;
    }
    statistic += (found[i] - expected[i]) * (found[i] - expected[i]) / expected[i];
    ++cells;
  }
  if (rest_expected >= 5) {
    statistic += (rest_found - rest_expected) * (rest_found - rest_expected) / rest_expected;
    ++cells;
  } else {
    EXPECT_LT(rest_found, rest_expected + 30) << what << ": samples where the density is nothing";
  }
  ASSERT_GT(cells, 3) << what;
  EXPECT_LT(statistic, cells + 4.5 * std::sqrt(2.0 * cells)) << what << ": " << cells << " cells";
}

/// sample   a direction, or 0 where none was chosen
/// density  by solid angle
inline void expect_distribution(const std::function<Vec3f(const Vec2f&)>& sample, const std::function<double(const Vec3f&)>& density,
                                const std::string& what, int samples = 200000) {
  constexpr int kRows = 24;     // of equal steps of the cosine
  constexpr int kColumns = 24;  // around z
  constexpr int kFine = 24;     // steps of a cell, for the integral
  std::vector<double> found(kRows * kColumns);
  std::vector<double> expected(kRows * kColumns);
  Uniform uniform;
  for (int i = 0; i < samples; ++i) {
    const Vec3f d = sample(uniform.two());
    if (d == Vec3f{}) {
      continue;
    }
    const double row = (static_cast<double>(d.z) + 1) / 2 * kRows;
    const double column = (std::atan2(static_cast<double>(d.y), static_cast<double>(d.x)) / (2 * kPi) + 0.5) * kColumns;
    const int r = std::min(std::max(static_cast<int>(row), 0), kRows - 1);
    const int c = std::min(std::max(static_cast<int>(column), 0), kColumns - 1);
    found[static_cast<std::size_t>(r * kColumns + c)] += 1;
  }
  const double step = 4 * kPi / (kRows * kColumns) / (kFine * kFine);
  for (int r = 0; r < kRows * kFine; ++r) {
    const double z = (r + 0.5) / (kRows * kFine) * 2 - 1;
    const double flat = std::sqrt(1 - z * z);
    for (int c = 0; c < kColumns * kFine; ++c) {
      const double angle = ((c + 0.5) / (kColumns * kFine) - 0.5) * 2 * kPi;
      const Vec3f d{static_cast<float>(flat * std::cos(angle)), static_cast<float>(flat * std::sin(angle)), static_cast<float>(z)};
      expected[static_cast<std::size_t>(r / kFine * kColumns + c / kFine)] += density(d) * step * samples;
    }
  }
  expect_counts(found, expected, what);
}

}  // namespace lustro
