// XXH64 as its specification states it: see hash.hpp. Four accumulators take 32 bytes a step, what is left joins at the end.
#include "image/hash.hpp"

#include <array>
#include <bit>
#include <cstring>

#include "lustro/image.hpp"

namespace lustro {
namespace {

constexpr std::uint64_t kPrime1 = 0x9E3779B185EBCA87U;
constexpr std::uint64_t kPrime2 = 0xC2B2AE3D27D4EB4FU;
constexpr std::uint64_t kPrime3 = 0x165667B19E3779F9U;
constexpr std::uint64_t kPrime4 = 0x85EBCA77C2B2AE63U;
constexpr std::uint64_t kPrime5 = 0x27D4EB2F165667C5U;
constexpr std::size_t kStripe = 32;

// Pictures are floats in memory, which are hashed as they lie there; the specification, and so the promise, is little endian.
static_assert(std::endian::native == std::endian::little);

template <class Word>
std::uint64_t word_at(const std::byte* bytes) {
  Word word;
  std::memcpy(&word, bytes, sizeof(word));
  return word;
}

constexpr std::uint64_t round_of(std::uint64_t accumulator, std::uint64_t word) {
  return std::rotl(accumulator + word * kPrime2, 31) * kPrime1;
}

constexpr std::uint64_t avalanche(std::uint64_t h) {
  h = (h ^ (h >> 33)) * kPrime2;
  h = (h ^ (h >> 29)) * kPrime3;
  return h ^ (h >> 32);
}

/// Whole stripes, taken off the front of the bytes.
std::uint64_t hash_stripes(std::span<const std::byte>& bytes, std::uint64_t seed) {
  std::array<std::uint64_t, 4> lanes{seed + kPrime1 + kPrime2, seed + kPrime2, seed, seed - kPrime1};
  for (; bytes.size() >= kStripe; bytes = bytes.subspan(kStripe)) {
    for (std::size_t i = 0; i < 4; ++i) {
      lanes[i] = round_of(lanes[i], word_at<std::uint64_t>(bytes.data() + 8 * i));
    }
  }
  std::uint64_t h = std::rotl(lanes[0], 1) + std::rotl(lanes[1], 7) + std::rotl(lanes[2], 12) + std::rotl(lanes[3], 18);
  for (const std::uint64_t lane : lanes) {
    h = (h ^ round_of(0, lane)) * kPrime1 + kPrime4;
  }
  return h;
}

}  // namespace

std::uint64_t xxh64(std::span<const std::byte> bytes, std::uint64_t seed) {
  const std::uint64_t size = bytes.size();
  std::uint64_t h = (size >= kStripe ? hash_stripes(bytes, seed) : seed + kPrime5) + size;
  for (; bytes.size() >= 8; bytes = bytes.subspan(8)) {
    h = std::rotl(h ^ round_of(0, word_at<std::uint64_t>(bytes.data())), 27) * kPrime1 + kPrime4;
  }
  for (; bytes.size() >= 4; bytes = bytes.subspan(4)) {
    h = std::rotl(h ^ (word_at<std::uint32_t>(bytes.data()) * kPrime1), 23) * kPrime2 + kPrime3;
  }
  for (const std::byte byte : bytes) {
    h = std::rotl(h ^ (static_cast<std::uint64_t>(byte) * kPrime5), 11) * kPrime1;
  }
  return avalanche(h);
}

std::uint64_t hash_image(const Image& image) {
  const auto part = [](int value, int shift) { return static_cast<std::uint64_t>(value) << shift; };
  return xxh64(std::as_bytes(std::span(image.pixels)), part(image.width, 0) + part(image.height, 24) + part(image.channels, 48));
}

}  // namespace lustro
