// The common forms of numbers in text, eight digits at a step. Exact: what they cannot do rightly they leave to the caller.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace lustro {

/// A run of decimal digits.
struct Digits {
  std::uint64_t value = 0;
  unsigned count = 0;  ///< 8: there may be more
};

/// The digits at p, at most eight of them. Eight bytes can be read there.
/// source  Lemire, Quickly parsing eight digits, 2018
[[nodiscard]] inline Digits read_digits(const char* p) {
  std::uint64_t text = 0;
  std::memcpy(&text, p, 8);
  if constexpr (std::endian::native == std::endian::big) {
    text = __builtin_bswap64(text);
  }
  std::uint64_t digits = text ^ 0x3030303030303030U;
  const std::uint64_t others = ((digits + 0x7676767676767676U) | digits) & 0x8080808080808080U;  // right up to the first of them
  const unsigned count = others == 0 ? 8 : static_cast<unsigned>(std::countr_zero(others)) / 8;
  if (count == 0) {
    return {};
  }
  digits <<= 64 - 8 * count;  // zeros in front
  digits = digits * 10 + (digits >> 8U);
  digits = ((digits & 0x000000FF000000FFU) * 0x000F424000000064U + ((digits >> 16U) & 0x000000FF000000FFU) * 0x0000271000000001U) >> 32U;
  return {digits & 0xFFFFFFFFU, count};
}

/// Reads an index: up to seven digits, perhaps with a sign, none of them written with a plus. Moves p behind it and returns true; else p stays.
/// end  of the text that can be read
[[nodiscard]] inline bool read_short_integer(const char*& p, const char* end, std::int32_t& value) {
  const bool is_negative = end - p >= 9 && *p == '-';
  const char* const first = p + (is_negative ? 1 : 0);
  if (end - first < 8) {
    return false;
  }
  const Digits digits = read_digits(first);
  if (digits.count == 0 || digits.count == 8) {
    return false;
  }
  p = first + digits.count;
  const auto magnitude = static_cast<std::int32_t>(digits.value);
  value = is_negative ? -magnitude : magnitude;
  return true;
}

inline constexpr std::array<double, 10> kPowersOfTen{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
inline constexpr std::array<std::uint64_t, 9> kWholePowersOfTen{1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};

/// Reads [-]digits[.digits] with up to seven digits before the point and up to nine behind it, correctly rounded. Moves p behind it and returns
/// true; else p stays. What follows may still belong to the number (an exponent, more digits): the caller looks.
///
/// The digits make a whole number below 10^16 < 2^53.2, of which those below 2^53 are exact in double, as are the powers of ten: so the quotient
/// is the double that is nearest to the number. Rounding it to float is rounding the number itself unless it lies exactly between two floats.
/// end     of the text that can be read
/// source  Clinger 1990, How to read floating point numbers accurately
[[nodiscard]] inline bool read_short_float(const char*& p, const char* end, float& value) {
  if (end - p < 32) {
    return false;
  }
  const bool is_negative = *p == '-';
  const char* at = p + (is_negative ? 1 : 0);
  std::uint64_t number = static_cast<unsigned char>(*at) - static_cast<std::uint64_t>('0');
  if (number > 9) {
    return false;
  }
  ++at;
  if (*at != '.') {
    const Digits more = read_digits(at);
    if (more.count > 6) {
      return false;
    }
    number = number * kWholePowersOfTen[more.count] + more.value;
    at += more.count;
  }
  unsigned decimals = 0;
  if (*at == '.') {
    ++at;
    const Digits fraction = read_digits(at);
    decimals = fraction.count;
    number = number * kWholePowersOfTen[decimals] + fraction.value;
    at += decimals;
    if (decimals == 8) {
      const std::uint64_t ninth = static_cast<unsigned char>(*at) - static_cast<std::uint64_t>('0');
      if (ninth <= 9) {
        number = number * 10 + ninth;
        decimals = 9;
        ++at;
      }
    }
  }
  if (number > std::uint64_t{1} << 53U) {
    return false;
  }
  const double quotient = static_cast<double>(static_cast<std::int64_t>(number)) / kPowersOfTen[decimals];
  constexpr std::uint64_t kRounded = (std::uint64_t{1} << 29U) - 1;  // the bits of a double that a float lacks
  if ((std::bit_cast<std::uint64_t>(quotient) & kRounded) == (kRounded + 1) / 2) {
    return false;
  }
  const auto magnitude = static_cast<float>(quotient);
  value = is_negative ? -magnitude : magnitude;
  p = at;
  return true;
}

}  // namespace lustro
