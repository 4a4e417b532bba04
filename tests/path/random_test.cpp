// The sequence by hand, its stratification, and that nothing depends on anything but its three numbers.
#include "path/random.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace lustro {
namespace {

TEST(PathRandom, BitsAreReversed) {
  EXPECT_EQ(reversed_bits(1), 0x80000000U);
  EXPECT_EQ(reversed_bits(0x00F00003U), 0xC0000F00U);
}

TEST(PathRandom, TheSecondDimensionIsSobols) {
  // The direction numbers of Sobol 1967: v = 1/2, then each v ^ (v >> 1).
  for (std::uint32_t index = 0; index < 5000; ++index) {
    std::uint32_t expected = 0;
    std::uint32_t v = 0x80000000U;
    for (std::uint32_t i = index; i != 0; i >>= 1U, v ^= v >> 1U) {
      expected ^= (i & 1U) != 0 ? v : 0U;
    }
    ASSERT_EQ(reversed_bits(sobol_second_reversed(index)), expected) << index;
  }
}

TEST(PathRandom, AnOwenScrambleKeepsEveryDyadicInterval) {
  // Of bits in opposite order: numbers that share their lowest k bits share them afterwards, too, and others do not.
  for (const std::uint32_t seed : {0U, 1U, 0xDEADBEEFU}) {
    for (std::uint32_t k = 1; k < 12; ++k) {
      const std::uint32_t mask = (1U << k) - 1;
      std::set<std::uint32_t> images;
      for (std::uint32_t low = 0; low <= mask; ++low) {
        const std::uint32_t image = owen_hash(low, seed) & mask;
        EXPECT_EQ(owen_hash(low | (0xABCDU << k), seed) & mask, image);
        images.insert(image);
      }
      EXPECT_EQ(images.size(), static_cast<std::size_t>(mask) + 1);
    }
  }
}

TEST(PathRandom, EveryPairIsStratifiedInAllElementaryIntervals) {
  // 2^m points: one in every rectangle of 2^-a by 2^-(m - a). So it is for each pixel and pair, whatever the seed.
  constexpr std::uint32_t kBits = 6;
  constexpr std::uint32_t kPoints = 1U << kBits;
  for (const std::uint32_t pixel : {0U, 17U, 123456U}) {
    for (const std::uint32_t pair : {0U, 3U, 400U}) {
      for (std::uint32_t a = 0; a <= kBits; ++a) {
        std::vector<int> cells(kPoints);
        for (std::uint32_t sample = 0; sample < kPoints; ++sample) {
          const Vec2f u = PathRandom(pixel, sample, 5).pair(pair);
          const auto x = static_cast<std::uint32_t>(u.x * static_cast<float>(1U << a));
          const auto y = static_cast<std::uint32_t>(u.y * static_cast<float>(1U << (kBits - a)));
          ++cells[(x << (kBits - a)) + y];
        }
        for (const int count : cells) {
          ASSERT_EQ(count, 1) << pixel << ' ' << pair << ' ' << a;
        }
      }
    }
  }
}

TEST(PathRandom, PixelsPairsAndSeedsHaveNumbersOfTheirOwn) {
  // The mean product of what should not know of each other: 1/4, with a standard error of 0.0039 / sqrt(...).
  const auto mean_product = [](auto&& first, auto&& second) {
    double sum = 0;
    constexpr std::uint32_t kPixels = 20000;
    for (std::uint32_t p = 0; p < kPixels; ++p) {
      sum += static_cast<double>(first(p)) * static_cast<double>(second(p));
    }
    return sum / kPixels;
  };
  const auto x = [](std::uint32_t p) { return PathRandom(p, 0, 0).pair(0).x; };
  constexpr double kTolerance = 4 * 0.2205 / 141.4;  // four standard errors: sqrt(1/9 - 1/16) / sqrt(20000)
  EXPECT_NEAR(mean_product(x, [](std::uint32_t p) { return PathRandom(p, 0, 0).pair(0).y; }), 0.25, kTolerance);
  EXPECT_NEAR(mean_product(x, [](std::uint32_t p) { return PathRandom(p + 1, 0, 0).pair(0).x; }), 0.25, kTolerance);
  EXPECT_NEAR(mean_product(x, [](std::uint32_t p) { return PathRandom(p, 0, 0).pair(1).x; }), 0.25, kTolerance);
  EXPECT_NEAR(mean_product(x, [](std::uint32_t p) { return PathRandom(p, 0, 1).pair(0).x; }), 0.25, kTolerance);
}

}  // namespace
}  // namespace lustro
