#include "image/deflate.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "image/support.hpp"

namespace lustro {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<std::byte> deflated(const Bytes& data, bool is_last = true) {
  std::vector<std::byte> out;
  append_deflate(data, is_last, out);
  return out;
}

/// What libdeflate makes of a whole stream; every byte of it must be used.
Bytes inflated(const std::vector<std::byte>& stream, std::size_t size) {
  Bytes data(size + 1);
  std::size_t in = 0;
  std::size_t out = 0;
  libdeflate_decompressor* decompressor = libdeflate_alloc_decompressor();
  EXPECT_EQ(libdeflate_deflate_decompress_ex(decompressor, stream.data(), stream.size(), data.data(), data.size(), &in, &out),
            LIBDEFLATE_SUCCESS);
  libdeflate_free_decompressor(decompressor);
  EXPECT_EQ(in, stream.size());
  data.resize(out);
  return data;
}

/// Bytes whose statistics are drawn too: how many values, how skewed, how long they stay the same, how often that changes.
Bytes random_bytes(RandomBits& random, std::size_t size) {
  Bytes data;
  while (data.size() < size) {
    const std::uint32_t values = 1 + random() % 256;
    const std::uint32_t skew = random() % 9;
    const std::uint32_t stays = 1 + (random() % 600) / (1 + random() % 600);
    const std::size_t end = std::min<std::size_t>(size, data.size() + random() % 5000);
    while (data.size() < end) {
      const auto value = static_cast<std::uint8_t>((random() % values) >> (random() % (skew + 1)));
      data.insert(data.end(), std::min<std::size_t>(1 + random() % stays, end - data.size()), value);
    }
  }
  return data;
}

TEST(Deflate, AHandfulOfBytesIsStoredAsRfc1951Says) {
  EXPECT_EQ(deflated({7, 9}),
            (std::vector<std::byte>{std::byte{1}, std::byte{2}, std::byte{0}, std::byte{0xFD}, std::byte{0xFF}, std::byte{7}, std::byte{9}}));
  EXPECT_EQ(deflated({7}, false)[0], std::byte{0});
}

TEST(Deflate, RunsOfEveryLengthAtEveryPlaceComeBack) {
  for (std::size_t length = 1; length < 1100; length += length < 300 ? 1 : 37) {
    for (const std::size_t before : {0U, 1U, 7U, 8U, 55U, 56U, 57U, 63U, 64U, 65U}) {
      Bytes data;
      for (std::size_t i = 0; i < before; ++i) {
        data.push_back(static_cast<std::uint8_t>(1 + i % 2));
      }
      data.insert(data.end(), length, 0);
      ASSERT_EQ(inflated(deflated(data), data.size()), data) << before << " before " << length;
      for (const int behind : {0, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 3, 4}) {
        data.push_back(static_cast<std::uint8_t>(behind));
      }
      ASSERT_EQ(inflated(deflated(data), data.size()), data) << before << " before " << length;
    }
  }
}

TEST(Deflate, EverySizeComesBack) {
  RandomBits random(4);
  for (std::size_t size = 1; size < 400; ++size) {
    const Bytes data = random_bytes(random, size);
    ASSERT_EQ(inflated(deflated(data), size), data) << size;
    const Bytes flat(size, static_cast<std::uint8_t>(size));
    ASSERT_EQ(inflated(deflated(flat), size), flat) << size;
  }
}

TEST(Deflate, RandomStatisticsComeBack) {
  RandomBits random(5);
  for (int round = 0; round < 400; ++round) {
    const Bytes data = random_bytes(random, 1 + random() % 100'000);
    ASSERT_EQ(inflated(deflated(data), data.size()), data) << round;
  }
}

TEST(Deflate, CountsThatGrowLikeFibonaccisNumbersMeetTheLimitOfTheCode) {
  Bytes data;
  std::uint32_t a = 1;
  std::uint32_t b = 1;
  for (std::uint8_t value = 0; value < 26; ++value) {
    for (std::uint32_t i = 0; i < a; ++i) {
      data.push_back(value);
    }
    b = std::exchange(a, b) + b;
  }
  RandomBits random(6);
  std::shuffle(data.begin(), data.end(), random);
  EXPECT_EQ(inflated(deflated(data), data.size()), data);
}

TEST(Deflate, PiecesLieOneBehindTheOther) {
  RandomBits random(7);
  for (int round = 0; round < 100; ++round) {
    Bytes all;
    std::vector<std::byte> stream;
    const std::uint32_t pieces = 1 + random() % 6;
    for (std::uint32_t piece = 1; piece <= pieces; ++piece) {
      Bytes data = random_bytes(random, 1 + random() % 3000);
      if (random() % 3 == 0) {  // one that will be stored
        std::generate(data.begin(), data.end(), [&] { return static_cast<std::uint8_t>(random()); });
      }
      append_deflate(data, piece == pieces, stream);
      all.insert(all.end(), data.begin(), data.end());
    }
    ASSERT_EQ(inflated(stream, all.size()), all) << round;
  }
}

TEST(Deflate, NoiseGrowsByFiveBytesForEvery65535) {
  RandomBits random(8);
  for (const std::size_t size : {1U, 65534U, 65535U, 65536U, 131070U, 200'000U}) {
    Bytes noise(size);
    std::generate(noise.begin(), noise.end(), [&] { return static_cast<std::uint8_t>(random() >> 13); });
    for (const bool is_last : {false, true}) {
      const auto packed = deflated(noise, is_last);
      EXPECT_LE(packed.size(), size + 5 * ((size + 65534) / 65535));
    }
    EXPECT_EQ(inflated(deflated(noise), size), noise);
  }
}

TEST(Deflate, WhatIsTakenForARunDoesNotDependOnItsPlace) {
  std::size_t expected = 0;
  for (std::size_t place = 0; place < 64; ++place) {
    Bytes data;
    const auto add_restless = [&](std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) {
        data.push_back(data.empty() || data.back() != 1 ? std::uint8_t{1} : std::uint8_t{2});
      }
    };
    add_restless(place);
    for (const std::size_t repeats : {8U, 7U, 8U, 9U, 8U, 6U, 7U, 8U}) {
      add_restless(2);
      data.insert(data.end(), repeats, data.back());
    }
    add_restless(64 - place);
    const std::size_t size = deflated(data).size();
    expected = place == 0 ? size : expected;
    ASSERT_EQ(size, expected) << place;
  }
}

TEST(Deflate, NothingIsCodedThatWouldBeSmallerStored) {
  RandomBits random(10);
  int stored = 0;
  for (int round = 0; round < 3000; ++round) {
    Bytes data(400 + random() % 800);
    const std::uint32_t values = 100 + random() % 150;
    for (std::uint8_t& v : data) {
      v = static_cast<std::uint8_t>(random() % values);
    }
    const auto packed = deflated(data, round % 2 == 0);
    ASSERT_LE(packed.size(), data.size() + 5) << round;
    stored += packed.size() == data.size() + 5 ? 1 : 0;
  }
  EXPECT_GT(stored, 300);
  EXPECT_LT(stored, 2700);  // or the edge was not met
}

TEST(Deflate, ARunCostsTwoBitsForEvery258Bytes) {
  const std::size_t size = std::size_t{1} << 20;
  EXPECT_LE(deflated(Bytes(size)).size(), size / 258 / 4 + 40);
}

TEST(Deflate, SkewedBytesComeCloseToTheirEntropy) {
  RandomBits random(9);
  Bytes data(100'000);
  for (std::uint8_t& v : data) {  // a half, a quarter, an eighth, ...: 2 bits a byte
    v = static_cast<std::uint8_t>(std::countr_zero(random() | 0x8000U));
  }
  EXPECT_LT(deflated(data).size(), 25'000 * 1.01);
  EXPECT_GT(deflated(data).size(), 25'000 * 0.97);  // some eight in a row are equal
}

}  // namespace
}  // namespace lustro
