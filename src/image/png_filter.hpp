// PNG's row filters (W3C PNG 3rd edition, 9): a row as differences from what its neighbours foretell.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace lustro {

/// The numbers that PNG gives them.
enum class RowFilter : std::uint8_t { none = 0, sub = 1, up = 2, average = 3, paeth = 4 };

/// Filters one row: the filter's number, then the differences. `average` and `none` are not offered.
///
/// row   samples as PNG orders them
/// up    the row above, zeros above the first
/// step  bytes a pixel, 1..8
/// to    row.size() + 1 bytes
void filter_row(RowFilter filter, std::span<const std::uint8_t> row, std::span<const std::uint8_t> up, std::size_t step,
                std::span<std::uint8_t> to);

/// The same with the filter of up, paeth and sub that leaves the fewest bytes different from 0, in that order where they are equal: on rendered
/// pictures that foretells the size better than the usual sum of absolute differences does.
void filter_row_well(std::span<const std::uint8_t> row, std::span<const std::uint8_t> up, std::size_t step, std::span<std::uint8_t> to);

}  // namespace lustro
