// Where bytes come again: the only repetitions that the fast deflate encoder looks for.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace lustro {

/// Bytes to be coded one by one, and behind them how often the last of them comes again.
struct Stretch {
  std::uint32_t literals = 0;
  std::uint32_t repeats = 0;  ///< at least kShortestRun, or 0 at the end of the data
  bool operator==(const Stretch&) const = default;
};

/// Shorter ones would save a bit here and there, and cost more time than they save.
constexpr std::size_t kShortestRun = 8;

/// The data as stretches, from its begin to its end; the last one has no repeats, and may have no literals. Every run that is long enough is
/// found, with all its repeats. data: 1..2^32-1 bytes
[[nodiscard]] std::vector<Stretch> find_stretches(std::span<const std::uint8_t> data);

/// The eight bytes from `at` on, the first one lowest, on every machine.
inline std::uint64_t load_little_endian(const std::uint8_t* at) {
  std::uint64_t v = 0;
  std::memcpy(&v, at, sizeof v);
  return std::endian::native == std::endian::little ? v : __builtin_bswap64(v);
}

}  // namespace lustro
