// A fast deflate encoder (RFC 1951) for the rows of filtered pictures. After a good row filter there is little left to find but runs of one byte
// and a skewed choice of bytes, so it looks for runs alone and gives every piece its own Huffman code (as fpng and fpnge do). Pieces start and
// end at whole bytes: they can be packed at the same time and laid one behind the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lustro {

/// The longest piece, in bytes.
constexpr std::size_t kLongestPiece = std::size_t{1} << 24;

/// Appends the deflate blocks of one piece to `out`; what does not shrink is stored, which takes 5 bytes for each 65535. Equal bytes in give
/// equal bytes out.
///
/// data      1..kLongestPiece bytes
/// is_last   whether the stream ends with this piece
void append_deflate(std::span<const std::uint8_t> data, bool is_last, std::vector<std::byte>& out);

}  // namespace lustro
