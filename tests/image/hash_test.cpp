// Hashes of pictures against published values of XXH64, and against the smallest differences that two pictures can have.
#include "image/hash.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <random>
#include <set>
#include <string_view>

#include "lustro/image.hpp"

namespace lustro {
namespace {

std::uint64_t hash_of(std::string_view text, std::uint64_t seed = 0) {
  return xxh64(std::as_bytes(std::span(text)), seed);
}

TEST(Hash, HasThePublishedValues) {
  EXPECT_EQ(hash_of(""), 0xEF46DB3751D8E999U);
  EXPECT_EQ(hash_of("a"), 0xD24EC4F1A98C6E5BU);
  EXPECT_EQ(hash_of("abc"), 0x44BC2CF5AD770999U);
  EXPECT_EQ(hash_of("The quick brown fox jumps over the lazy dog"), 0x0B242D361FDA71BCU);  // more than one stripe
}

/// The test vectors of xxHash itself (tests/sanity_test.c): a buffer of bytes made by a multiplicative generator.
TEST(Hash, HasTheValuesOfItsAuthorsTest) {
  constexpr std::uint64_t kPrime32 = 2654435761U, kPrime64 = 11400714785074694797U;
  std::vector<std::byte> buffer(222);
  std::uint64_t generator = kPrime32;
  for (std::byte& byte : buffer) {
    byte = static_cast<std::byte>(generator >> 56);
    generator *= kPrime64;
  }
  const std::span<const std::byte> bytes(buffer);
  EXPECT_EQ(xxh64(bytes.first(1), 0), 0xE934A84ADB052768U);
  EXPECT_EQ(xxh64(bytes.first(1), kPrime32), 0x5014607643A9B4C3U);
  EXPECT_EQ(xxh64(bytes.first(4), 0), 0x9136A0DCA57457EEU);
  EXPECT_EQ(xxh64(bytes.first(14), 0), 0x8282DCC4994E35C8U);
  EXPECT_EQ(xxh64(bytes.first(14), kPrime32), 0xC3BD6BF63DEB6DF0U);
  EXPECT_EQ(xxh64(bytes.first(222), 0), 0xB641AE8CB691C174U);
  EXPECT_EQ(xxh64(bytes.first(222), kPrime32), 0x20CB8AB7AE10C14AU);
}

Image noise(int width, int height, int channels) {
  Image image(width, height, channels);
  std::mt19937 random(5);
  for (float& value : image.pixels) {
    value = static_cast<float>(random() >> 8U) * 0x1p-24F;
  }
  return image;
}

TEST(Hash, OfAPictureIsWhatItsDocumentationSays) {
  Image image(2, 1, 3);
  image.pixels = {0, 0.5F, 1, -0.0F, 0.25F, 2};
  // 00000000 0000003F 0000803F 00000080 0000803E 00000040, little endian
  constexpr std::string_view kBytes("\0\0\0\0\0\0\0\x3F\0\0\x80\x3F\0\0\0\x80\0\0\x80\x3E\0\0\0\x40", 24);
  EXPECT_EQ(hash_image(image), hash_of(kBytes, 0x0003000001000002U));
}

TEST(Hash, SeesEveryBitOfEveryPixel) {
  Image image = noise(5, 3, 4);
  std::set<std::uint64_t> seen{hash_image(image)};
  for (float& value : image.pixels) {
    const float kept = value;
    for (unsigned bit = 0; bit < 32; ++bit) {
      value = std::bit_cast<float>(std::bit_cast<std::uint32_t>(kept) ^ (1U << bit));
      EXPECT_TRUE(seen.insert(hash_image(image)).second) << "bit " << bit;
    }
    value = kept;
  }
  EXPECT_TRUE(seen.contains(hash_image(image)));
  EXPECT_EQ(seen.size(), 1U + 5 * 3 * 4 * 32);
}

TEST(Hash, SeesTheShape) {
  const Image image = noise(6, 4, 4);
  std::set<std::uint64_t> seen;
  for (const auto& [width, height, channels] : {std::tuple{6, 4, 4}, std::tuple{4, 6, 4}, std::tuple{8, 4, 3}, std::tuple{24, 4, 1}}) {
    Image other(width, height, channels);
    other.pixels = image.pixels;
    EXPECT_TRUE(seen.insert(hash_image(other)).second) << width << " x " << height << " x " << channels;
  }
}

}  // namespace
}  // namespace lustro
