// trig.hpp against libm in double precision.
#include "math/trig.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lustro {
namespace {

TEST(Trig, SineAndCosineMatchLibm) {
  for (int i = -100000; i <= 100000; ++i) {
    const double x = i * 0.01;
    EXPECT_NEAR(sine(x), std::sin(x), 1e-15) << x;
    EXPECT_NEAR(cosine(x), std::cos(x), 1e-15) << x;
  }
}

TEST(Trig, DegreesAreExactAtTheQuarters) {
  EXPECT_EQ(cosine_deg(90), 0);
  EXPECT_EQ(sine_deg(180), 0);
  EXPECT_EQ(cosine_deg(180), -1);
  EXPECT_EQ(sine_deg(-90), -1);
  EXPECT_EQ(cosine_deg(360), 1);
  EXPECT_NEAR(sine_deg(30), 0.5, 1e-16);
  EXPECT_NEAR(tangent(radians(45)), 1, 2e-16);
}

TEST(Trig, ArctangentMatchesLibmInEveryQuadrant) {
  for (int i = 0; i < 100000; ++i) {
    const double a = (i / 100000.0 - 0.5) * 2 * kPi;
    for (double r : {1e-8, 1.0, 3e7}) {
      EXPECT_NEAR(arctangent2(r * std::sin(a), r * std::cos(a)), std::atan2(r * std::sin(a), r * std::cos(a)), 1e-15);
    }
  }
  EXPECT_EQ(arctangent2(0, 0), 0);
  EXPECT_NEAR(arctangent2(0, -1), kPi, 1e-15);
}

TEST(Trig, ArccosineMatchesLibmAndClamps) {
  for (int i = -1000; i <= 1000; ++i) {
    EXPECT_NEAR(arccosine(i / 1000.0), std::acos(i / 1000.0), 1e-15);
  }
  EXPECT_EQ(arccosine(1.5), 0);
  EXPECT_NEAR(arccosine(-1.5), kPi, 1e-15);
}

TEST(Trig, LaneFunctionsMatchLibm) {
  for (int i = 0; i <= 10000; ++i) {
    const double u = kPi * i / 10000.0;
    const auto [ratio, c] = sine_over_x(static_cast<float>(u));
    EXPECT_NEAR(static_cast<double>(ratio), u == 0 ? 1 : std::sin(u) / u, 8e-7) << u;
    EXPECT_NEAR(static_cast<double>(c), std::cos(u), 8e-7) << u;
    EXPECT_NEAR(static_cast<double>(angle_of(static_cast<float>(std::sin(u)), static_cast<float>(std::cos(u)))), u, 2e-6) << u;
  }
  for (double from_pi = 0.1; from_pi > 1e-12; from_pi *= 0.99) {  // where 1 + cos loses all its digits
    const double u = kPi - from_pi;
    EXPECT_NEAR(static_cast<double>(angle_of(static_cast<float>(std::sin(u)), static_cast<float>(std::cos(u)))), u, 2e-6) << from_pi;
  }
  EXPECT_NEAR(static_cast<double>(angle_of(0.0F, -1.0F)), kPi, 2e-6);
}

}  // namespace
}  // namespace lustro
