// Welding by hashing: of the coordinates themselves, or of the cells of a grid as wide as the tolerance.
#include "mesh/weld.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "mesh/index_table.hpp"
#include "parallel/big_memory.hpp"
#include "parallel/slices.hpp"

namespace lustro {
namespace {

constexpr std::uint32_t kNone = IndexTable::kNone;

/// A position in the bucket of its hash.
struct Entry {
  std::uint32_t hash;
  std::uint32_t index;
};

std::uint64_t hash_of(const Vec3f& p) {
  return mix(0, p);
}

/// The first of equal positions within one bucket; the entries are in the order of the positions.
void weld_bucket(std::span<const Vec3f> positions, std::span<const Entry> entries, std::vector<std::uint32_t>& first) {
  IndexTable table(entries.size() / 4);
  for (const Entry& entry : entries) {
    const Vec3f& p = positions[entry.index];
    first[entry.index] = table.find_or_insert(entry.hash, entry.index, [&](std::uint32_t j) { return positions[j] == p; });
  }
}

// Equal positions have equal hashes, so that they meet in one bucket: small enough for a core's own cache, and no bucket needs another one.
std::vector<std::uint32_t> weld_equal(std::span<const Vec3f> positions, int threads) {
  constexpr std::size_t kBucketSize = 8192;
  const std::size_t buckets = std::bit_ceil(positions.size() / kBucketSize + 1);
  const auto shift = static_cast<unsigned>(64 - std::countr_zero(buckets));  // the table takes the lower bits
  const auto bucket_of = [&](std::uint64_t hash) { return buckets == 1 ? 0 : static_cast<std::size_t>(hash >> shift); };
  std::vector<std::uint32_t> first;
  resize_big(first, positions.size());
  const std::size_t slices = slice_count(positions.size(), threads, 4 * kSmallestSlice);
  const auto slice_begin = [&](std::size_t s) { return positions.size() * s / slices; };

  std::vector<std::size_t> ends(slices * buckets);  // counts, then where the entries of a slice in a bucket end
  parallel_for(slices, threads, [&](std::size_t s) {
    for (std::size_t i = slice_begin(s); i < slice_begin(s + 1); ++i) {
      first[i] = static_cast<std::uint32_t>(i);
      if (is_finite(positions[i])) {
        ++ends[s * buckets + bucket_of(hash_of(positions[i]))];
      }
    }
  });
  std::size_t count = 0;
  std::vector<std::size_t> bucket_begin(buckets + 1);
  for (std::size_t b = 0; b < buckets; ++b) {
    for (std::size_t s = 0; s < slices; ++s) {
      const std::size_t here = ends[s * buckets + b];
      ends[s * buckets + b] = count;
      count += here;
    }
    bucket_begin[b + 1] = count;
  }
  const BigArray<Entry> entries = make_big_array<Entry>(count);
  parallel_for(slices, threads, [&](std::size_t s) {
    for (std::size_t i = slice_begin(s); i < slice_begin(s + 1); ++i) {
      if (is_finite(positions[i])) {
        const std::uint64_t hash = hash_of(positions[i]);
        entries[ends[s * buckets + bucket_of(hash)]++] = {static_cast<std::uint32_t>(hash), static_cast<std::uint32_t>(i)};
      }
    }
  });
  parallel_slices(
      buckets, threads,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
          weld_bucket(positions, {entries.get() + bucket_begin[b], bucket_begin[b + 1] - bucket_begin[b]}, first);
        }
      },
      8);
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

std::vector<std::uint32_t> weld_positions(std::span<const Vec3f> positions, double tolerance, int threads) {
  return tolerance > 0 ? weld_near(positions, tolerance) : weld_equal(positions, threads);
}

}  // namespace lustro
