// Every sampler against its density.
#include "path/sampling.hpp"

#include "chi_square.hpp"

namespace lustro {
namespace {

TEST(Sampling, AFrameIsOrthonormalAndRightHanded) {
  Uniform uniform;
  for (int i = 0; i < 2000; ++i) {
    const Vec3f n = i == 0 ? Vec3f{0, 0, -1} : i == 1 ? Vec3f{0, 0, 1} : sample_sphere(uniform.two());
    const Frame3 frame(n);
    EXPECT_NEAR(dot(frame.x, frame.y), 0, 2e-6F);
    EXPECT_NEAR(dot(frame.x, n), 0, 2e-6F);
    EXPECT_NEAR(length(frame.x), 1, 2e-6F);
    EXPECT_NEAR(dot(cross(frame.x, frame.y), n), 1, 4e-6F);
    EXPECT_NEAR(length(frame.world({0, 0, 1}) - n), 0, 1e-6F);
  }
}

TEST(Sampling, DirectionsFallAsTheirDensitySays) {
  expect_distribution([](const Vec2f& u) { return sample_cosine(u); },
                      [](const Vec3f& d) { return std::max(static_cast<double>(d.z), 0.0) / kPi; }, "cosine");
  expect_distribution([](const Vec2f& u) { return sample_sphere(u); }, [](const Vec3f&) { return 0.25 / kPi; }, "sphere");
  for (const float n : {0.0F, 1.0F, 7.5F, 40.0F}) {
    expect_distribution([n](const Vec2f& u) { return sample_power_cosine(n, u); },
                        [n](const Vec3f& d) { return static_cast<double>(power_cosine_density(n, d.z)); }, "cos^n " + std::to_string(n));
  }
  for (const float a : {1.0F, 0.3F, 0.05F}) {
    expect_distribution([a](const Vec2f& u) { return sample_ggx_normal(a, u); },
                        [a](const Vec3f& d) { return static_cast<double>(ggx_normal_density(a, d.z)); }, "GGX " + std::to_string(a));
  }
  for (const float half_angle : {20.0F, 60.0F, 89.0F}) {
    const auto cosine = static_cast<float>(std::cos(radians(static_cast<double>(half_angle))));
    Uniform uniform;
    double lowest = 1;
    double sum = 0;
    for (int i = 0; i < 100000; ++i) {
      const Vec3f d = sample_cone(1.0F - cosine, uniform.two());
      EXPECT_NEAR(length(d), 1, 2e-6F);
      lowest = std::min(lowest, static_cast<double>(d.z));
      sum += static_cast<double>(d.z);
    }
    EXPECT_NEAR(lowest, static_cast<double>(cosine), 1e-3);
    EXPECT_NEAR(sum / 100000, (1 + static_cast<double>(cosine)) / 2, 4e-3) << "uniform in the cosine";
  }
}

/// Points of the plane within -1..1: counts a cell against the share of the shape.
template <class Sample, class Inside>
void expect_uniform(Sample&& sample, Inside&& inside, double area, const std::string& what) {
  constexpr int kCells = 16;
  constexpr int kFine = 64;
  constexpr int kSamples = 200000;
  std::vector<double> found(kCells * kCells);
  std::vector<double> expected(kCells * kCells);
  Uniform uniform;
  const auto cell = [](double x, double y) {
    const auto index = [](double v) { return std::min(std::max(static_cast<int>((v + 1) / 2 * kCells), 0), kCells - 1); };
    return static_cast<std::size_t>(index(y) * kCells + index(x));
  };
  for (int i = 0; i < kSamples; ++i) {
    const Vec2f p = sample(uniform.two());
    found[cell(static_cast<double>(p.x), static_cast<double>(p.y))] += 1;
  }
  constexpr int kSteps = kCells * kFine;
  for (int y = 0; y < kSteps; ++y) {
    for (int x = 0; x < kSteps; ++x) {
      const double px = (x + 0.5) / kSteps * 2 - 1;
      const double py = (y + 0.5) / kSteps * 2 - 1;
      expected[cell(px, py)] += inside(px, py) ? 4.0 / (kSteps * kSteps) / area * kSamples : 0;
    }
  }
  expect_counts(found, expected, what);
}

TEST(Sampling, PointsFallEvenlyOverDisksAndTriangles) {
  expect_uniform([](const Vec2f& u) { return sample_disk(u); }, [](double x, double y) { return x * x + y * y < 1; }, kPi, "disk");
  expect_uniform(
      [](const Vec2f& u) {  // corners (-1, -1), (1, -1), (-1, 1)
        const Vec3f w = sample_triangle(u);
        EXPECT_GE(std::min({w.x, w.y, w.z}), -1e-6F);
        return Vec2f{w.y - w.x - w.z, w.z - w.x - w.y};
      },
      [](double x, double y) { return x + y < 0; }, 2, "triangle");
}

TEST(Sampling, AChoiceFollowsItsWeights) {
  const std::vector<float> weights{0, 3, 0, 1, 4, 0};
  const Choice choice(weights);
  EXPECT_EQ(choice.total(), 8);
  EXPECT_EQ(choice.probability(1), 0.375F);
  EXPECT_EQ(choice.probability(2), 0);
  for (const auto& [u, index, rest] : {std::tuple{0.0F, 1U, 0.0F}, std::tuple{0.1875F, 1U, 0.5F}, std::tuple{0.375F, 3U, 0.0F},
                                       std::tuple{0.75F, 4U, 0.5F}, std::tuple{0x1.fffffep-1F, 4U, 0x1.fffffcp-1F}}) {
    const Choice::Chosen chosen = choice.choose(u);
    EXPECT_EQ(chosen.index, index) << u;
    EXPECT_NEAR(chosen.rest, rest, 1e-6F) << u;
    EXPECT_EQ(chosen.probability, weights[index] / 8);
  }
  EXPECT_TRUE(Choice(std::vector<float>{0, 0}).is_empty());
  EXPECT_TRUE(Choice().is_empty());
}

TEST(Sampling, ThePowerHeuristicSharesWithoutRemainder) {
  EXPECT_FLOAT_EQ(power_heuristic(3, 4) + power_heuristic(4, 3), 1);
  EXPECT_FLOAT_EQ(power_heuristic(3, 4), 9.0F / 25);
  EXPECT_EQ(power_heuristic(0, 4), 0);
  EXPECT_EQ(power_heuristic(1, 0), 1);
  EXPECT_FLOAT_EQ(power_heuristic(1e30F, 1e30F), 0.5F) << "squares would overflow";
}

}  // namespace
}  // namespace lustro
