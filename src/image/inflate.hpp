// Unpacking of raw deflate data (RFC 1951).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace lustro {

/// The most that deflate makes of a byte: a claim beyond that is false.
inline constexpr std::uint64_t kMostInflation = 1032;

/// True where the packed bytes are exactly `out.size()` unpacked ones, which are then in `out`.
[[nodiscard]] bool inflate_exactly(std::string_view packed, std::span<char> out);

/// CRC-32, as ZIP, PNG and gzip have it.
[[nodiscard]] std::uint32_t crc32_of(std::string_view bytes);

}  // namespace lustro
