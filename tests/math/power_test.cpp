// power.hpp against libm in double precision, over the whole range of floats.
#include "math/power.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lustro {
namespace {

TEST(Power, Log2StaysBelowItsStatedErrorOverAllExponents) {
  double worst = 0;
  for (std::uint32_t bits = 0x00800000; bits < 0x7F800000; bits += 997) {  // every normal exponent, about 2 million values
    const float x = from_bits(static_cast<std::int32_t>(bits));
    const double exact = std::log2(static_cast<double>(x));
    const double error = std::abs(static_cast<double>(log2_of(x)) - exact) / std::max(std::abs(exact), 1e-30);
    if (exact != 0) {
      worst = std::max(worst, error);
    }
  }
  EXPECT_LT(worst, 4e-7);
  EXPECT_EQ(log2_of(1.0F), 0.0F);
  EXPECT_EQ(log2_of(8.0F), 3.0F);
}

TEST(Power, Log2IsAccurateNextToOne) {
  for (int step = -2000; step <= 2000; ++step) {
    const float x = from_bits(bits_of(1.0F) + step);
    const double exact = std::log2(static_cast<double>(x));
    EXPECT_NEAR(static_cast<double>(log2_of(x)), exact, 4e-7 * std::abs(exact)) << step;
  }
}

TEST(Power, Exp2StaysBelowItsStatedError) {
  double worst = 0;
  for (int i = -99999; i < 127000; ++i) {
    const float y = static_cast<float>(i) / 1000.0F;
    const double exact = std::exp2(static_cast<double>(y));
    worst = std::max(worst, std::abs(static_cast<double>(exp2_of(y)) - exact) / exact);
  }
  EXPECT_LT(worst, 3e-7);
  EXPECT_EQ(exp2_of(0.0F), 1.0F);
  EXPECT_EQ(exp2_of(-3.0F), 0.125F);
}

TEST(Power, Exp2IsZeroOrNormalEverywhere) {
  for (float y : {-100.0F, -100.5F, -150.0F, -1e30F}) {
    EXPECT_EQ(exp2_of(y), 0.0F) << y;
  }
  EXPECT_GT(exp2_of(-99.99F), 1.17549435e-38F);
  EXPECT_EQ(exp2_of(1e30F), exp2_of(127.0F));
}

TEST(Power, FollowsTheConventionsOfLighting) {
  EXPECT_EQ(power(0.0F, 0.0F), 1.0F);
  EXPECT_EQ(power(0.5F, 0.0F), 1.0F);
  EXPECT_EQ(power(-1.0F, 0.0F), 1.0F);
  EXPECT_EQ(power(0.0F, 5.0F), 0.0F);
  EXPECT_EQ(power(0.0F, 0.125F), 0.0F);
  EXPECT_EQ(power(-0.5F, 2.0F), 0.0F);
  EXPECT_EQ(power(1.0F, 1000.0F), 1.0F);
  EXPECT_GT(power(0.0F, -2.0F), 1e38F);
}

TEST(Power, WholeExponentsStayBelowTheirStatedError) {
  std::mt19937 random(2);
  for (int n = 1; n <= 256; ++n) {
    double worst = 0;
    for (int i = 0; i < 4000; ++i) {
      // highlights are where the power is: down to 2^-25
      const float x = i == 0 ? 1.0F : static_cast<float>(std::exp2(-25.0 / n * static_cast<double>(random() >> 8) * 0x1p-24));
      const double exact = std::pow(static_cast<double>(x), n);
      worst = std::max(worst, std::abs(static_cast<double>(power(x, static_cast<float>(n))) - exact) / exact);
    }
    EXPECT_LT(worst, n * 6e-8) << n;
  }
}

TEST(Power, WholeExponentsAreZeroOrNormalEverywhere) {
  for (int n = 0; n <= 256; ++n) {
    const Exponent exponent(static_cast<float>(n));
    EXPECT_EQ(exponent.whole, n);
    EXPECT_EQ(power(1.0F, exponent), 1.0F);
    for (const float x : {0.0F, -0.0F, -1.0F, 1e-38F, 1e-45F}) {
      EXPECT_EQ(power(x, exponent), n == 0 ? 1.0F : 0.0F) << n << " " << x;
    }
    if (n > 0) {
      const float below = from_bits(bits_of(exponent.smallest) - 1);
      EXPECT_EQ(power(below, exponent), 0.0F);
      EXPECT_NEAR(std::log2(power(exponent.smallest, exponent)), -99, 1e-4) << n;
    }
  }
}

TEST(Power, WhatIsSquaredAndWhatIsNotIsStated) {
  EXPECT_EQ(Exponent(256).whole, 256);
  EXPECT_EQ(Exponent(257).whole, -1);
  EXPECT_EQ(Exponent(76.8F).whole, -1);
  EXPECT_EQ(Exponent(-2).whole, -1);
  EXPECT_EQ(Exponent(1e30F).whole, -1);
  const float squared = power(0.9F, 256);
  EXPECT_NEAR(squared, exp2_of(256 * log2_of(0.9F)), 3e-5F * squared);  // the two ways meet
}

TEST(Power, StaysBelowItsStatedErrorForExponentsOfMaterials) {
  std::mt19937 random(1);
  double worst = 0;
  for (int i = 0; i < 1000000; ++i) {
    const float x = static_cast<float>(random() >> 8) * 0x1p-24F;
    const float n = static_cast<float>(random() >> 8) * 0x1p-24F * 200.0F;
    const double y = static_cast<double>(n) * std::log2(static_cast<double>(x));
    if (x == 0 || y < -99.9) {
      continue;
    }
    const double exact = std::exp2(y);
    worst = std::max(worst, std::abs(static_cast<double>(power(x, n)) - exact) / exact / (1 + std::abs(y)));
  }
  EXPECT_LT(worst, 1e-6);
}

TEST(Power, AnExponentOfItsOwnLaneAgreesWithTheOneOfAllLanes) {
  for (const float n : {0.0F, 0.25F, 1.0F, 7.5F, 20.0F, 256.0F, 1000.0F}) {
    for (const float x : {0.0F, -0.5F, 1e-10F, 0.3F, 0.9F, 0.999F, 1.0F}) {
      const float expected = power(x, Exponent(n));
      EXPECT_NEAR(power(x, LaneExponent<float>{n}), expected, 2e-5F * expected + 1e-29F) << x << "^" << n;
    }
  }
  EXPECT_EQ(power(0.0F, LaneExponent<float>{0}), 1);
  EXPECT_EQ(power(0.0F, LaneExponent<float>{0.5F}), 0);
  EXPECT_EQ(power(1.0F, LaneExponent<float>{3.7F}), 1);
}

}  // namespace
}  // namespace lustro
