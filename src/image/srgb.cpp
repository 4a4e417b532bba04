// The two curves of IEC 61966-2-1 on our own power function. The published constants 0.0031308 and 0.04045 are rounded: the two pieces meet
// within 3e-8 of each other, far below any step that is stored.
#include "image/srgb.hpp"

#include "math/power.hpp"

namespace lustro {
namespace {

int byte_of_bits(std::uint32_t bits) {
  return quantize8(srgb_encode(std::bit_cast<float>(bits)));
}

/// The bits of a float from which on `byte` or more is stored: q(at - 1) < byte <= q(at). `below` is stored as less.
std::uint32_t find_rise(std::uint32_t below, int byte) {
  std::uint32_t from = SrgbTable::kLast;
  while (from - below > 1) {
    const std::uint32_t middle = below + (from - below) / 2;
    (byte_of_bits(middle) < byte ? below : from) = middle;
  }
  return from;
}

/// Whether the floats around a rise are stored as less before it and not less from it on. The roundings of srgb_encode() reach four floats far.
bool is_even(std::uint32_t rise, int byte) {
  constexpr std::uint32_t kReach = 16;
  for (std::uint32_t bits = rise - kReach; bits <= rise + kReach; ++bits) {
    if ((byte_of_bits(bits) < byte) != (bits < rise)) {
      return false;
    }
  }
  return true;
}

SrgbTable make_srgb_table() {
  SrgbTable table;
  std::uint32_t rise = SrgbTable::kFirst;
  std::size_t next = 0;  // the first bucket whose start is not yet known to lie behind the last rise
  for (int byte = 1; byte < 256; ++byte) {
    rise = find_rise(rise, byte);
    const std::size_t bucket = (rise - SrgbTable::kFirst) >> 16;
    const bool is_only_one = next <= bucket;
    for (; next <= bucket; ++next) {
      table.entries[next] = static_cast<std::uint32_t>(byte - 1) << 16;
    }
    table.entries[bucket] += 0x10000 - (rise & 0xFFFF);
    if (!is_only_one || !is_even(rise, byte)) {
      table.entries[bucket] |= SrgbTable::kUneven;
    }
  }
  for (; next < table.entries.size(); ++next) {
    table.entries[next] = std::uint32_t{255} << 16;
  }
  return table;
}

}  // namespace

float srgb_encode(float linear) {
  if (linear <= 0.0031308F) {
    return 12.92F * linear;
  }
  // (1 + 0.055) x^n - 0.055, arranged so that the roundings vanish at x = 1
  const float root = power(linear, 1.0F / 2.4F);
  return root + 0.055F * (root - 1.0F);
}

float srgb_decode(float encoded) {
  if (encoded <= 0.04045F) {
    return encoded / 12.92F;
  }
  return power((encoded + 0.055F) / 1.055F, 2.4F);
}

std::uint16_t quantize16(float x) {
  return static_cast<std::uint16_t>(clamp01(x) * 65535.0F + 0.5F);
}

const SrgbTable& srgb_table() {
  static const SrgbTable table = make_srgb_table();
  return table;
}

}  // namespace lustro
