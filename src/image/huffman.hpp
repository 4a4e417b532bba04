// Prefix codes as deflate has them (RFC 1951, 3.2.2): canonical, of limited length, sent lowest bit first.
#pragma once

#include <cstdint>
#include <span>

namespace lustro {

/// The code length of every symbol, at most `limit`; 0 for a symbol of count 0. Shortest in sum where the limit does not bind; where it does,
/// within a hundredth of that for limits from 14 on. Equal counts always give equal lengths. At least two counts are not 0, and at most 2^limit.
///
/// counts   one a symbol, at most 512 of them, their sum below 2^32
/// source   Moffat and Katajainen 1995, In-Place Calculation of Minimum-Redundancy Codes; the limit by moving leaves until Kraft's sum is 1
void huffman_lengths(std::span<const std::uint32_t> counts, int limit, std::span<std::uint8_t> lengths);

/// The canonical code of every symbol with its bits reversed, for a writer that begins with the lowest bit. Lengths up to 15.
void huffman_codes(std::span<const std::uint8_t> lengths, std::span<std::uint16_t> codes);

}  // namespace lustro
