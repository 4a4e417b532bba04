// Batches of triangles are measured, then added to the groups of their corners one after the other.
#include "mesh/triangle_normals.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <utility>

#include "mesh/normals.hpp"
#include "mesh/polygon.hpp"
#include "mesh/triangle_batch.hpp"
#include "parallel/big_memory.hpp"
#include "parallel/slices.hpp"

namespace lustro {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

struct Sum {
  double x, y, z;
  double weight;  ///< of all summands; negative where they are slivers, which nothing but slivers may join
};

/// Triangles in blocks, and which groups each block touches: a range of groups needs to look at few of them.
struct Block {
  static constexpr std::size_t kSize = 512;
  std::uint32_t lowest;
  std::uint32_t highest;
};

std::vector<Block> blocks_of(std::span<const Triangle> groups, int threads) {
  std::vector<Block> blocks((groups.size() + Block::kSize - 1) / Block::kSize);
  parallel_slices(
      blocks.size(), threads,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
          Block block{0xFFFFFFFFU, 0};
          for (const Triangle& t : groups.subspan(b * Block::kSize, std::min(Block::kSize, groups.size() - b * Block::kSize))) {
            block.lowest = std::min({block.lowest, t[0], t[1], t[2]});
            block.highest = std::max({block.highest, t[0], t[1], t[2]});
          }
          blocks[b] = block;
        }
      },
      kSmallestSlice / Block::kSize);
  return blocks;
}

/// How many groups make a range. Few, so that the sums stay in a core's own cache, where groups are numbered about as the triangles use them;
/// else each thread has one range, as every range would look at most of the triangles.
std::size_t range_size_for(const std::vector<Block>& blocks, std::size_t groups, int threads) {
  constexpr std::size_t kSmall = std::size_t{1} << 15U;
  if (blocks.size() * Block::kSize < kSmallestSlice) {
    return std::max<std::size_t>(1, groups);
  }
  const std::size_t large = (groups + thread_count(threads) - 1) / thread_count(threads);
  std::size_t visits = 0;
  for (const Block& block : blocks) {
    visits += block.highest / kSmall - block.lowest / kSmall + 1;
  }
  return visits <= 2 * blocks.size() ? std::min(kSmall, large) : large;
}

/// Sums up one range of groups after the other.
class Summation {
 public:
  Summation(const TriangleCorners& corners, const std::vector<Block>& blocks, VertexNormals weights, std::size_t range_size)
      : corners_(corners), blocks_(blocks), weights_(weights), sums_(make_big_array<Sum>(range_size)), batch_(new TriangleBatch{}) {}

  /// The sums of the groups begin .. end - 1.
  std::span<const Sum> sum(std::uint32_t begin, std::uint32_t end) {
    begin_ = begin;
    size_ = end - begin;
    std::fill_n(sums_.get(), size_, Sum{});
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      if (blocks_[b].lowest >= end || blocks_[b].highest < begin) {
        continue;
      }
      const bool is_whole = blocks_[b].lowest >= begin && blocks_[b].highest < end;
      const auto stop = static_cast<std::uint32_t>(std::min(corners_.groups.size(), (b + 1) * Block::kSize));
      for (auto t = static_cast<std::uint32_t>(b * Block::kSize); t < stop; ++t) {
        const Triangle& g = corners_.groups[t];
        if (is_whole || is_inside(g[0]) || is_inside(g[1]) || is_inside(g[2])) {
          add(t, false);
        }
      }
    }
    flush(false);
    const std::vector<std::uint32_t> slivers = std::exchange(slivers_, {});
    for (const std::uint32_t t : slivers) {
      add(t, true);
    }
    flush(true);
    return {sums_.get(), size_};
  }

  [[nodiscard]] bool has_flat() const { return has_flat_; }
  [[nodiscard]] bool has_thin() const { return has_thin_; }

 private:
  [[nodiscard]] bool is_inside(std::uint32_t group) const { return group - begin_ < size_; }

  void add(std::uint32_t t, bool as_sliver) {
    at_[filled_++] = t;
    if (filled_ == TriangleBatch::kSize) {
      flush(as_sliver);
    }
  }

  void set_aside(std::uint32_t t, bool is_flat) {
    const Triangle& corners = corners_.triangles[t];
    const auto meet = [&](std::size_t a, std::size_t b) { return corners_.positions[corners[a]] == corners_.positions[corners[b]]; };
    if (is_flat && (meet(0, 1) || meet(1, 2) || meet(2, 0))) {
      has_thin_ = true;
      return;
    }
    has_flat_ |= is_flat;
    slivers_.push_back(t);
  }

  void flush(bool as_slivers) {
    TriangleBatch& b = *batch_;
    for (std::size_t i = 0; i < filled_; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3f& p = corners_.positions[corners_.triangles[at_[i]][k]];
        b.x[k][i] = static_cast<double>(p.x);
        b.y[k][i] = static_cast<double>(p.y);
        b.z[k][i] = static_cast<double>(p.z);
      }
    }
    if (filled_ != 0) {
      measure(b, weights_ == VertexNormals::angle);
    }
    for (std::size_t i = 0; i < filled_; ++i) {
      if (!as_slivers && b.is_sliver[i] != 0) {
        set_aside(at_[i], b.area[i] == 0);
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t group = corners_.groups[at_[i]][k] - begin_;
        if (group >= size_) {
          continue;
        }
        Sum& sum = sums_[group];
        if (as_slivers && sum.weight > 0) {
          continue;
        }
        const double weight = weights_ == VertexNormals::angle ? b.angle[k][i] : (weights_ == VertexNormals::area ? b.area[i] : 1.0);
        sum.x += b.normal_x[i] * weight;
        sum.y += b.normal_y[i] * weight;
        sum.z += b.normal_z[i] * weight;
        sum.weight += as_slivers ? -weight : weight;
      }
    }
    filled_ = 0;
  }

  const TriangleCorners& corners_;
  const std::vector<Block>& blocks_;
  VertexNormals weights_;
  BigArray<Sum> sums_;
  std::uint32_t begin_ = 0, size_ = 0;
  std::unique_ptr<TriangleBatch> batch_;
  std::array<std::uint32_t, TriangleBatch::kSize> at_{};
  std::size_t filled_ = 0;
  std::vector<std::uint32_t> slivers_;
  bool has_flat_ = false;
  bool has_thin_ = false;
};

}  // namespace

TriangleNormals make_triangle_normals(const TriangleCorners& corners, VertexNormals weights, int threads) {
  TriangleNormals made;
  resize_big(made.normals, corners.group_count);
  const std::vector<Block> blocks = blocks_of(corners.groups, threads);
  const std::size_t size = range_size_for(blocks, corners.group_count, threads);
  const std::size_t ranges = (corners.group_count + size - 1) / size;
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> has_flat = false;
  std::atomic<bool> has_thin = false;
  std::atomic<bool> has_zero = false;
  parallel_for(std::min(ranges, thread_count(threads)), threads, [&](std::size_t) {
    Summation summation(corners, blocks, weights, size);
    bool zero = false;
    for (std::size_t range = next++; range < ranges; range = next++) {
      const std::size_t begin = range * size;
      const std::size_t end = std::min(begin + size, corners.group_count);
      std::size_t group = begin;
      for (const Sum& sum : summation.sum(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end))) {
        const double norm = length(Vec3d{sum.x, sum.y, sum.z});
        if (norm > kCancelled * std::abs(sum.weight)) {
          made.normals[group] = vec_cast<float>(Vec3d{sum.x / norm, sum.y / norm, sum.z / norm});
        } else {
          zero = true;
        }
        ++group;
      }
    }
    if (summation.has_flat()) {
      has_flat = true;
    }
    if (summation.has_thin()) {
      has_thin = true;
    }
    if (zero) {
      has_zero = true;
    }
  });
  made.has_flat = has_flat;
  made.has_thin = has_thin;
  made.has_zero = has_zero;
  return made;
}

Vec3f own_normal(std::span<const Vec3f> positions, const Triangle& triangle) {
  const Vec3f own = vec_cast<float>(plane_of(3, [&](std::size_t k) { return positions[triangle[k]]; }).normal);
  return own == Vec3f{} ? Vec3f{0, 0, 1} : own;
}

}  // namespace lustro
