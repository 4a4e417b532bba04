#include "image/flip.hpp"

#include <array>
#include <functional>

#include "image/support.hpp"

namespace lustro {
namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 64;

using Pattern = std::function<std::array<int, 3>(int x, int y, bool second)>;

std::array<int, 3> gray(int v) {
  return {v, v, v};
}

std::vector<float> draw(const Pattern& pattern, bool second) {
  std::vector<float> image;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (const int v : pattern(x, y, second)) {
        image.push_back(static_cast<float>(v) / 255.0F);
      }
    }
  }
  return image;
}

// The expected numbers are those of the authors' own implementation (the Python package flip-evaluator 1.7, LDR, per-pixel map averaged in
// double precision) for the same patterns.
struct Case {
  const char* name;
  Pattern pattern;
  double mean;     // at the default of 67.02 pixels a degree
  double mean_30;  // at 30 pixels a degree
  double at_40_30;
};

std::vector<Case> cases() {
  return {
      {"noise",
       [](int x, int y, bool second) {
         std::array<int, 3> c{(x * 7 + y * 3) % 256, (x * x + y * 5) % 256, ((x ^ y) * 4) % 256};
         for (int& v : c) {
           v = second ? std::min(v + 16, 255) : v;
         }
         return c;
       },
       0.2678535, 0.2958353, 0.234930},
      {"patch",
       [](int x, int y, bool second) {
         const bool inside = second && x >= 30 && x < 50 && y >= 20 && y < 40;
         return std::array<int, 3>{2 * x, 3 * y + (inside ? 40 : 0), 128 - (inside ? 40 : 0)};
       },
       0.0565398, 0.0505578, 0.718397},
      {"lines", [](int x, int y, bool second) { return gray(second && x % 16 == 5 ? 128 : ((x / 8 + y / 8) % 2 != 0 ? 255 : 32)); }, 0.1018762,
       0.0883854, 0.060027},
      {"hue",
       [](int x, int, bool second) {
         std::array<int, 3> c = (x / 12) % 2 != 0 ? std::array<int, 3>{200, 60, 60} : std::array<int, 3>{60, 120, 200};
         if (second) {
           std::swap(c[0], c[1]);
         }
         return c;
       },
       0.8153715, 0.7980202, 0.976123},
      {"black and white", [](int, int, bool second) { return gray(second ? 255 : 0); }, 0.9673883, 0.9673844, 0.967388},
      {"green and blue",
       [](int, int, bool second) {
         return std::array<int, 3>{0, second ? 255 : 0, second ? 0 : 255};
       },
       1.0, 1.0, 1.0},
      {"faint",
       [](int x, int y, bool second) {
         const int more = second && (x + y) % 7 == 0 ? 2 : 0;
         return std::array<int, 3>{100 + x / 4 + more, 100 + y / 4 + more, 90 + more};
       },
       0.0135132, 0.0128200, 0.020749},
  };
}

double mean_of(const std::vector<float>& values) {
  double sum = 0;
  for (const float v : values) {
    sum += static_cast<double>(v);
  }
  return sum / static_cast<double>(values.size());
}

TEST(Flip, AgreesWithTheAuthorsImplementation) {
  for (const Case& c : cases()) {
    const std::vector<float> a = draw(c.pattern, false);
    const std::vector<float> b = draw(c.pattern, true);
    const std::vector<float> errors = flip_error(a, b, kWidth, kHeight);
    EXPECT_NEAR(mean_of(errors), c.mean, 2e-5) << c.name;
    EXPECT_NEAR(static_cast<double>(errors[30 * kWidth + 40]), c.at_40_30, 5e-5) << c.name;
    EXPECT_NEAR(mean_of(flip_error(a, b, kWidth, kHeight, 30)), c.mean_30, 2e-5) << c.name;
  }
}

TEST(Flip, EqualPicturesHaveNoErrorAnywhere) {
  for (const Case& c : cases()) {
    const std::vector<float> a = draw(c.pattern, true);
    for (const float e : flip_error(a, a, kWidth, kHeight)) {
      ASSERT_EQ(e, 0.0F);
    }
  }
}

TEST(Flip, IsTheSameBothWaysRound) {
  for (const Case& c : cases()) {
    const std::vector<float> a = draw(c.pattern, false);
    const std::vector<float> b = draw(c.pattern, true);
    EXPECT_EQ(flip_error(a, b, kWidth, kHeight), flip_error(b, a, kWidth, kHeight));
  }
}

TEST(Flip, ADifferenceIsFeltOnlyAsFarAsTheFiltersReach) {
  constexpr int kSide = 200;  // more than one band of rows
  std::vector<float> a(kSide * kSide * 3, 0.5F);
  std::vector<float> b = a;
  for (std::size_t c = 0; c < 3; ++c) {
    b[(100 * kSide + 127) * 3 + c] = 1.0F;
  }
  const std::vector<float> errors = flip_error(a, b, kSide, kSide);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const bool near = std::max(std::abs(x - 127), std::abs(y - 100)) <= 10;
      if (!near) {
        ASSERT_LT(errors[static_cast<std::size_t>(y * kSide + x)], 1e-3F) << x << " " << y;
      }
    }
  }
  // symmetric about the pixel, also across the border between bands
  for (int d = 0; d < 10; ++d) {
    const auto at = [&](int x, int y) { return errors[static_cast<std::size_t>(y * kSide + x)]; };
    EXPECT_NEAR(at(127 + d, 100), at(127 - d, 100), 1e-5F);
    EXPECT_NEAR(at(127, 100 + d), at(127, 100 - d), 1e-5F);
    EXPECT_NEAR(at(127 + d, 100), at(127, 100 + d), 1e-5F);
  }
  EXPECT_GT(errors[100 * kSide + 127], 0.3F);
}

TEST(Flip, PicturesSmallerThanTheFiltersAreCompared) {
  const std::vector<float> black(3, 0.0F);
  const std::vector<float> white(3, 1.0F);
  EXPECT_NEAR(flip_error(black, white, 1, 1)[0], 0.967388F, 1e-4F);
}

}  // namespace
}  // namespace lustro
