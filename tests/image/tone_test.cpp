// Tone mapping: values on paper, and the properties of a curve.
#include "image/tone.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "image/store.hpp"

namespace lustro {
namespace {

Vec3f toned_by(ToneOperator curve, const Vec3f& color, float exposure = 0) {
  return toned(Toning(Tone{curve, exposure}), color);
}

void expect_near(const Vec3f& a, const Vec3d& b, double tolerance) {
  EXPECT_NEAR(static_cast<double>(a.x), b.x, tolerance);
  EXPECT_NEAR(static_cast<double>(a.y), b.y, tolerance);
  EXPECT_NEAR(static_cast<double>(a.z), b.z, tolerance);
}

TEST(Tone, NoneLeavesEveryBit) {
  EXPECT_FALSE(Toning(Tone{}).changes());
  EXPECT_EQ(toned_by(ToneOperator::none, {0.1F, 7, -2}), (Vec3f{0.1F, 7, -2}));
}

TEST(Tone, ExposureCountsInStops) {
  EXPECT_EQ(toned_by(ToneOperator::none, {0.25F, 0.5F, 1}, 2), (Vec3f{1, 2, 4}));
  EXPECT_EQ(toned_by(ToneOperator::none, {0.25F, 0.5F, 1}, -1), (Vec3f{0.125F, 0.25F, 0.5F}));
}

// Equation 3: L / (1 + L), the colour's ratios stay.
TEST(Tone, ReinhardDividesByOnePlusTheLuminance) {
  expect_near(toned_by(ToneOperator::reinhard, {1, 1, 1}), {0.5, 0.5, 0.5}, 1e-6);
  expect_near(toned_by(ToneOperator::reinhard, {3, 3, 3}), {0.75, 0.75, 0.75}, 1e-6);
  expect_near(toned_by(ToneOperator::reinhard, {1, 0, 0}), {1 / 1.2126, 0, 0}, 1e-6);
  expect_near(toned_by(ToneOperator::reinhard, {0, 2, 1}), {0, 2 / 2.5026, 1 / 2.5026}, 1e-6);
}

// Gray stays gray to the matrices' five digits; (v (v + 0.0245786) - 0.000090537) / (v (0.983729 v + 0.4329510) + 0.238081) at 0.18 is 0.1056,
// at 1 it is 0.6191.
TEST(Tone, AcesIsHillsFit) {
  expect_near(toned_by(ToneOperator::aces, {0.18F, 0.18F, 0.18F}), {0.10559, 0.10559, 0.10559}, 2e-4);
  expect_near(toned_by(ToneOperator::aces, {1, 1, 1}), {0.61912, 0.61912, 0.61912}, 2e-4);
  // 0.59719, 0.07600, 0.02840 through the curve: 0.438038, 0.027302, 0.005630, then the second matrix.
  expect_near(toned_by(ToneOperator::aces, {1, 0, 0}), {0.68803, -0.01450, 0.00264}, 2e-4);
}

double agx_curve(double stops) {
  const double x = (std::clamp(stops, -12.47393, 4.026069) + 12.47393) / (4.026069 + 12.47393);
  return 15.5 * std::pow(x, 6) - 40.14 * std::pow(x, 5) + 31.96 * std::pow(x, 4) - 6.868 * std::pow(x, 3) + 0.4298 * x * x + 0.1191 * x -
         0.00232;
}

// Mid gray is made for a display of a power of 2.2 to be about mid gray; the curve's ends are the ends of the range.
TEST(Tone, AgxIsThePolynomialOverItsStops) {
  for (const double gray : {1e-4, 0.01, 0.18, 1.0, 5.0, 1e3}) {
    const double expected = std::pow(std::max(agx_curve(std::log2(gray)), 0.0), 2.2);
    const auto g = static_cast<float>(gray);
    expect_near(toned_by(ToneOperator::agx, {g, g, g}), {expected, expected, expected}, 1e-3);
  }
  EXPECT_NEAR(toned_by(ToneOperator::agx, {0.18F, 0.18F, 0.18F}).y, 0.18F, 0.04F);
  EXPECT_NEAR(toned_by(ToneOperator::agx, {100, 100, 100}).y, 1, 0.02F);
  EXPECT_NEAR(toned_by(ToneOperator::agx, {0, 0, 0}).y, 0, 1e-3F);
  const Vec3f red = toned_by(ToneOperator::agx, {64, 0.5F, 0.5F});  // bright colours fade to white
  EXPECT_GT(red.y, 0.3F);
}

TEST(Tone, CurvesOfGrayNeverFall) {
  for (const ToneOperator curve : {ToneOperator::none, ToneOperator::reinhard, ToneOperator::aces, ToneOperator::agx}) {
    float before = -1;
    for (float stops = -14; stops < 14; stops += 0.05F) {
      const float gray = std::exp2(stops);
      const float now = toned_by(curve, {gray, gray, gray}).y;
      EXPECT_GE(now, before - 2e-6F) << static_cast<int>(curve) << " at " << stops;
      before = now;
    }
    EXPECT_LT(toned_by(curve, {0, 0, 0}).y, 0.002F);
  }
}

TEST(Tone, OfWhatIsNoNumberIsStillAByte) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const ToneOperator curve : {ToneOperator::reinhard, ToneOperator::aces, ToneOperator::agx}) {
    for (const float strange : {nan, infinity, -infinity, -1.0F, 3e38F}) {
      Image image(1, 1, 4);
      image.pixels = {strange, 0.5F, strange, 1};
      EXPECT_EQ(to_bytes(image, Transfer::srgb, {curve, 1}).pixels.size(), 4U);
    }
  }
}

TEST(Tone, ActsOnTheColourWithoutItsAlphaAndBeforeTheTransfer) {
  Image image(1, 1, 4);
  image.pixels = {0.5F, 0.5F, 0.5F, 0.5F};  // white, half covered
  EXPECT_EQ(to_bytes(image, Transfer::none, {ToneOperator::reinhard, 0}).pixels, (std::vector<std::uint8_t>{128, 128, 128, 128}));
  EXPECT_EQ(to_bytes(image, Transfer::srgb, {ToneOperator::reinhard, 0}).pixels, (std::vector<std::uint8_t>{188, 188, 188, 128}));
  EXPECT_EQ(stored16(image, Transfer::none, {ToneOperator::none, -1}), (std::vector<std::uint16_t>{32768, 32768, 32768, 32768}));
  Image gray(1, 1, 1);
  gray.pixels = {3};
  EXPECT_EQ(to_bytes(gray, Transfer::none, {ToneOperator::reinhard, 0}).pixels, (std::vector<std::uint8_t>{191}));
}

}  // namespace
}  // namespace lustro
