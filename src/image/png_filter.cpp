// Row filters: see png_filter.hpp. The loops are written so that a compiler turns them into lanes of bytes.
#include "image/png_filter.hpp"

#include <algorithm>
#include <cstring>

namespace lustro {
namespace {

using Byte = std::uint8_t;

Byte least(Byte a, Byte b) {
  return a < b ? a : b;
}
Byte most(Byte a, Byte b) {
  return a > b ? a : b;
}
Byte minus(Byte a, Byte b) {
  return static_cast<Byte>(a - b);
}

/// Paeth's predictor from the left, upper and upper left neighbour, without leaving bytes. With the corner moved between the other two, left +
/// up - corner lies between them as well, `up - corner` away from the left one and so on; the nearest of the three is chosen, left before up
/// before corner. Where the corner does not lie between them, moving it there changes nothing: the answer is the one beyond which it lay not.
Byte paeth(Byte left, Byte up, Byte corner) {
  const Byte low = least(left, up);
  const Byte high = most(left, up);
  const Byte between = least(most(corner, low), high);
  const Byte to_low = minus(high, between);
  const Byte to_high = minus(between, low);
  const Byte nearer = least(to_low, to_high);
  const Byte to_corner = minus(most(to_low, to_high), nearer);
  const Byte side = to_low <= to_high ? low : high;
  return nearer <= to_corner ? side : corner;
}

void subtract(const Byte* a, const Byte* b, std::size_t n, Byte* __restrict to) {
  for (std::size_t i = 0; i < n; ++i) {
    to[i] = minus(a[i], b[i]);
  }
}

void subtract_paeth(const Byte* row, const Byte* up, std::size_t n, std::size_t step, Byte* __restrict to) {
  for (std::size_t i = 0; i < n; ++i) {
    to[i] = minus(row[i], paeth((row - step)[i], up[i], (up - step)[i]));
  }
}

/// How many bytes of a differ from those of b, or from 0 where there is no b.
std::size_t count_different(const Byte* a, const Byte* b, std::size_t n) {
  using Lanes = Byte __attribute__((vector_size(16)));
  constexpr std::size_t kMostSteps = 255;  // so that a count fits into a lane
  std::size_t sum = 0;
  std::size_t i = 0;
  while (i + sizeof(Lanes) <= n) {
    Lanes counts{};
    for (const std::size_t end = i + sizeof(Lanes) * std::min(kMostSteps, (n - i) / sizeof(Lanes)); i < end; i += sizeof(Lanes)) {
      Lanes x;
      Lanes y{};
      std::memcpy(&x, a + i, sizeof x);
      if (b != nullptr) {
        std::memcpy(&y, b + i, sizeof y);
      }
      counts -= reinterpret_cast<Lanes>(x != y);  // true is all bits: -1
    }
    for (std::size_t lane = 0; lane < sizeof(Lanes); ++lane) {
      sum += counts[lane];
    }
  }
  for (; i < n; ++i) {
    sum += a[i] != (b != nullptr ? b[i] : 0) ? 1U : 0U;
  }
  return sum;
}

}  // namespace

void filter_row(RowFilter filter, std::span<const std::uint8_t> row, std::span<const std::uint8_t> up, std::size_t step,
                std::span<std::uint8_t> to) {
  const std::size_t n = row.size();
  Byte* out = to.data() + 1;
  to[0] = static_cast<Byte>(filter);
  switch (filter) {
    case RowFilter::sub:
      std::copy_n(row.data(), step, out);
      subtract(row.data() + step, row.data(), n - step, out + step);
      return;
    case RowFilter::paeth:
      subtract(row.data(), up.data(), step, out);  // nothing to the left
      subtract_paeth(row.data() + step, up.data() + step, n - step, step, out + step);
      return;
    default:
      subtract(row.data(), up.data(), n, out);
  }
}

void filter_row_well(std::span<const std::uint8_t> row, std::span<const std::uint8_t> up, std::size_t step, std::span<std::uint8_t> to) {
  const std::size_t n = row.size();
  filter_row(RowFilter::paeth, row, up, step, to);
  const std::size_t by_paeth = count_different(to.data() + 1, nullptr, n);
  const std::size_t by_up = count_different(row.data(), up.data(), n);
  const std::size_t by_sub = count_different(row.data(), nullptr, step) + count_different(row.data() + step, row.data(), n - step);
  if (by_up <= by_paeth && by_up <= by_sub) {
    filter_row(RowFilter::up, row, up, step, to);
  } else if (by_sub < by_paeth) {
    filter_row(RowFilter::sub, row, up, step, to);
  }
}

}  // namespace lustro
