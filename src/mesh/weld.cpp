// Welding by hashing: of the coordinates themselves, or of the cells of a grid as wide as the tolerance.
#include "mesh/weld.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/index_table.hpp"

namespace lustro {
namespace {

constexpr std::uint32_t kNone = IndexTable::kNone;

std::vector<std::uint32_t> weld_equal(std::span<const Vec3f> positions) {
  std::vector<std::uint32_t> first(positions.size());
  IndexTable table(positions.size() / 4);
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    const Vec3f& p = positions[i];
    first[i] = is_finite(p) ? table.find_or_insert(mix(0, p), i, [&](std::uint32_t j) { return positions[j] == p; }) : i;
  }
  return first;
}

struct Cell {
  std::int64_t x, y, z;
  friend bool operator==(const Cell&, const Cell&) = default;
};

Cell cell_of(const Vec3f& p, double width) {
  const auto coordinate = [width](float x) {  // far cells run together, which costs time and changes nothing
    return static_cast<std::int64_t>(std::clamp(std::floor(static_cast<double>(x) / width), -0x1p62, 0x1p62));
  };
  return {coordinate(p.x), coordinate(p.y), coordinate(p.z)};
}

std::uint64_t hash_of(const Cell& c) {
  return mix(mix(mix(0, static_cast<std::uint64_t>(c.x)), static_cast<std::uint64_t>(c.y)), static_cast<std::uint64_t>(c.z));
}

std::vector<std::uint32_t> weld_near(std::span<const Vec3f> positions, double tolerance) {
  std::vector<std::uint32_t> first(positions.size());
  std::vector<std::uint32_t> next_in_cell(positions.size(), kNone);  // first points of one cell, the latest of them behind the cell's first
  IndexTable cells;                                                  // a cell is known by the first point in it
  const auto in_cell = [&](const Cell& cell) {
    return cells.find(hash_of(cell), [&](std::uint32_t j) { return cell_of(positions[j], tolerance) == cell; });
  };
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    first[i] = i;
    if (!is_finite(positions[i])) {
      continue;
    }
    const Vec3d p = vec_cast<double>(positions[i]);
    const Cell home = cell_of(positions[i], tolerance);
    for (int neighbour = 0; neighbour < 27; ++neighbour) {
      const Cell cell{home.x + neighbour % 3 - 1, home.y + neighbour / 3 % 3 - 1, home.z + neighbour / 9 - 1};
      for (std::uint32_t j = in_cell(cell); j != kNone; j = next_in_cell[j]) {
        if (j < first[i] && length(vec_cast<double>(positions[j]) - p) <= tolerance) {
          first[i] = j;
        }
      }
    }
    if (first[i] == i) {
      const std::uint32_t head =
          cells.find_or_insert(hash_of(home), i, [&](std::uint32_t j) { return cell_of(positions[j], tolerance) == home; });
      if (head != i) {
        next_in_cell[i] = next_in_cell[head];
        next_in_cell[head] = i;
      }
    }
  }
  return first;
}

}  // namespace

std::vector<std::uint32_t> weld_positions(std::span<const Vec3f> positions, double tolerance) {
  return tolerance > 0 ? weld_near(positions, tolerance) : weld_equal(positions);
}

}  // namespace lustro
