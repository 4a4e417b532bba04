#include "image/srgb.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace lustro {
namespace {

double encode_by_libm(double x) {
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}
double decode_by_libm(double u) {
  return u <= 0.04045 ? u / 12.92 : std::pow((u + 0.055) / 1.055, 2.4);
}

TEST(Srgb, KnownValuesOfTheStandard) {
  EXPECT_EQ(srgb_encode(0.0F), 0.0F);
  EXPECT_EQ(srgb_encode(1.0F), 1.0F);
  EXPECT_EQ(srgb_decode(0.0F), 0.0F);
  EXPECT_EQ(srgb_decode(1.0F), 1.0F);
  EXPECT_NEAR(srgb_encode(0.5F), 0.735357, 1e-6);     // mid grey of light
  EXPECT_NEAR(srgb_decode(0.5F), 0.214041, 1e-6);     // mid grey of the code
  EXPECT_EQ(quantize8(srgb_encode(0.18F)), 118);      // the photographer's 18 % card
  EXPECT_EQ(quantize8(srgb_encode(0.0031308F)), 10);  // where the straight part ends
  EXPECT_NEAR(srgb_decode(128 / 255.0F), 0.2158605, 1e-6);
}

TEST(Srgb, FollowsTheDoublePrecisionCurves) {
  double worst_encode = 0;
  double worst_decode = 0;
  for (int i = 0; i <= 1 << 20; ++i) {
    const float x = static_cast<float>(i) / static_cast<float>(1 << 20);
    worst_encode = std::max(worst_encode, std::abs(static_cast<double>(srgb_encode(x)) - encode_by_libm(static_cast<double>(x))));
    if (i > 0) {
      const double exact = decode_by_libm(static_cast<double>(x));
      worst_decode = std::max(worst_decode, std::abs(static_cast<double>(srgb_decode(x)) - exact) / exact);
    }
  }
  EXPECT_LT(worst_encode, 1e-6);
  EXPECT_LT(worst_decode, 1e-5);
}

TEST(Srgb, EveryByteComesBack) {
  for (int v = 0; v < 256; ++v) {
    const float u = static_cast<float>(v) / 255.0F;
    ASSERT_EQ(quantize8(u), v);
    ASSERT_EQ(quantize8(srgb_encode(srgb_decode(u))), v);
    ASSERT_EQ(quantize8(static_cast<float>(encode_by_libm(decode_by_libm(static_cast<double>(u))))), v);
  }
}

TEST(Srgb, EverySixteenBitValueComesBack) {
  for (int v = 0; v < 65536; ++v) {
    const float u = static_cast<float>(v) / 65535.0F;
    ASSERT_EQ(quantize16(u), v);
    ASSERT_EQ(quantize16(srgb_encode(srgb_decode(u))), v);
  }
}

TEST(Srgb, BytesAgreeWithLibmButWhereARoundingStandsOnTheEdge) {
  for (int i = 0; i <= 1 << 18; ++i) {
    const float x = static_cast<float>(i) / static_cast<float>(1 << 18);
    const double scaled = 255 * encode_by_libm(static_cast<double>(x)) + 0.5;
    if (std::abs(scaled - std::round(scaled)) > 3e-4) {
      ASSERT_EQ(quantize8(srgb_encode(x)), static_cast<int>(scaled)) << x;
    }
  }
}

TEST(Srgb, EncodingNeverFallsAsLightRises) {
  float before = -1;
  for (int i = 0; i <= 1 << 20; ++i) {
    const float now = srgb_encode(static_cast<float>(i) / static_cast<float>(1 << 20));
    ASSERT_GE(now, before - 2e-7F);
    before = now;
  }
}

TEST(Quantize, RoundsHalvesUpAndClamps) {
  const float infinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(quantize8(0.5F / 255.0F), 1);
  EXPECT_EQ(quantize8(0.499F / 255.0F), 0);
  EXPECT_EQ(quantize8(-3.0F), 0);
  EXPECT_EQ(quantize8(7.0F), 255);
  EXPECT_EQ(quantize8(infinity), 255);
  EXPECT_EQ(quantize8(-infinity), 0);
  EXPECT_EQ(quantize8(nan), 0);
  EXPECT_EQ(quantize8(-nan), 0);
  EXPECT_EQ(quantize16(nan), 0);
  EXPECT_EQ(quantize16(infinity), 65535);
  EXPECT_EQ(quantize16(0.5F), 32768);
}

int slow_byte(float x) {
  return quantize8(srgb_encode(x));
}

/// The bits of the first float that the table stores as each byte.
std::vector<std::uint32_t> rises() {
  const SrgbTable& table = srgb_table();
  std::vector<std::uint32_t> result{SrgbTable::kFirst};
  for (std::uint32_t start = SrgbTable::kFirst; start <= SrgbTable::kLast; start += 0x10000) {
    const std::uint32_t entry = table.entries[(start - SrgbTable::kFirst) >> 16];
    if ((entry & 0xFFFF) != 0) {
      result.push_back(start + 0x10000 - (entry & 0xFFFF));
    }
  }
  return result;
}

TEST(SrgbTable, EveryByteHasItsRiseInABucketOfItsOwn) {
  const std::vector<std::uint32_t> all = rises();
  ASSERT_EQ(all.size(), 256U);
  for (int byte = 1; byte < 256; ++byte) {
    const std::uint32_t rise = all[static_cast<std::size_t>(byte)];
    EXPECT_EQ(srgb_byte(srgb_table(), std::bit_cast<float>(rise - 1)), byte - 1);
    EXPECT_EQ(srgb_byte(srgb_table(), std::bit_cast<float>(rise)), byte);
  }
}

TEST(SrgbTable, NeverStoresLessForMore) {
  int last = 0;
  for (std::uint32_t bits = SrgbTable::kFirst - 100; bits <= SrgbTable::kLast + 100; ++bits) {
    const int byte = srgb_byte(srgb_table(), std::bit_cast<float>(bits));
    ASSERT_GE(byte, last) << std::hex << bits;
    last = byte;
  }
}

TEST(SrgbTable, AgreesWithTheFunctionAroundEveryRiseAndEveryEdgeOfABucket) {
  int swaying = 0;  // floats around a rise where the function's roundings go to and fro
  const auto expect_equal = [&](std::uint32_t middle, std::uint32_t reach, std::uint32_t tolerated) {
    for (std::uint32_t bits = middle - reach; bits <= middle + reach; ++bits) {
      const auto x = std::bit_cast<float>(bits);
      const bool is_equal = srgb_byte(srgb_table(), x) == slow_byte(x);
      ASSERT_TRUE(is_equal || (bits + tolerated >= middle && bits <= middle + tolerated)) << std::hex << bits;
      swaying += is_equal ? 0 : 1;
    }
  };
  for (std::uint32_t start = SrgbTable::kFirst; start <= SrgbTable::kLast; start += 0x10000) {
    expect_equal(start, 20, 0);
  }
  for (const std::uint32_t rise : rises()) {
    expect_equal(rise, 500, 4);
  }
  EXPECT_LE(swaying, 8);
}

TEST(SrgbTable, AgreesWithTheFunctionForFloatsOfEveryKind) {
  const SrgbTable& table = srgb_table();
  std::mt19937 random(3);
  int different = 0;
  for (int i = 0; i < 4'000'000; ++i) {
    const auto any = std::bit_cast<float>(static_cast<std::uint32_t>(random()));  // NaN, infinity, denormal, negative
    const float unit = static_cast<float>(random() >> 8) * 0x1p-24F;
    different += (srgb_byte(table, any) != slow_byte(any) ? 1 : 0) + (srgb_byte(table, unit) != slow_byte(unit) ? 1 : 0);
  }
  EXPECT_LE(different, 4);
}

TEST(Srgb, ValuesBeyondOneGoOnRising) {
  EXPECT_GT(srgb_encode(4.0F), srgb_encode(2.0F));
  EXPECT_NEAR(srgb_decode(srgb_encode(4.0F)), 4.0, 1e-4);
  EXPECT_LT(srgb_encode(-0.5F), 0.0F);
}

}  // namespace
}  // namespace lustro
