// Batches of triangles are measured, then added to their vertices one after the other.
#include "mesh/triangle_normals.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

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

/// The sums of the groups begin .. end - 1.
class RangeOfSums {
 public:
  RangeOfSums(const TriangleCorners& corners, VertexNormals weights, Sum* sums, std::uint32_t begin, std::uint32_t end)
      : positions_(corners.positions),
        triangles_(corners.triangles),
        groups_(corners.groups),
        weights_(weights),
        sums_(sums),
        begin_(begin),
        end_(end),
        is_whole_(begin == 0 && end == corners.group_count),
        batch_(new TriangleBatch{}) {}

  void add_all() {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const Triangle& v = groups_[t];
      if (is_whole_ || is_inside(v[0]) || is_inside(v[1]) || is_inside(v[2])) {
        add(t);
      }
    }
    flush(false);
    const std::vector<std::uint32_t> slivers = std::move(slivers_);
    for (const std::uint32_t t : slivers) {
      at_[filled_++] = t;
      if (filled_ == TriangleBatch::kSize) {
        flush(true);
      }
    }
    flush(true);
  }

  [[nodiscard]] bool has_flat() const { return has_flat_; }

 private:
  [[nodiscard]] bool is_inside(std::uint32_t v) const { return v - begin_ < end_ - begin_; }

  void add(std::uint32_t t) {
    at_[filled_++] = t;
    if (filled_ == TriangleBatch::kSize) {
      flush(false);
    }
  }

  void flush(bool as_slivers) {
    TriangleBatch& b = *batch_;
    for (std::size_t i = 0; i < filled_; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3f& p = positions_[triangles_[at_[i]][k]];
        b.x[k][i] = static_cast<double>(p.x);
        b.y[k][i] = static_cast<double>(p.y);
        b.z[k][i] = static_cast<double>(p.z);
      }
    }
    measure(b, weights_ == VertexNormals::angle);
    for (std::size_t i = 0; i < filled_; ++i) {
      if (!as_slivers && b.is_sliver[i] != 0) {
        slivers_.push_back(at_[i]);
        has_flat_ |= b.area[i] == 0;
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = groups_[at_[i]][k];
        if (!is_inside(v)) {
          continue;
        }
        Sum& sum = sums_[v];
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

  std::span<const Vec3f> positions_;
  std::span<const Triangle> triangles_;
  std::span<const Triangle> groups_;
  VertexNormals weights_;
  Sum* sums_;
  std::uint32_t begin_, end_;
  bool is_whole_;
  std::unique_ptr<TriangleBatch> batch_;
  std::array<std::uint32_t, TriangleBatch::kSize> at_{};
  std::size_t filled_ = 0;
  std::vector<std::uint32_t> slivers_;
  bool has_flat_ = false;
};

}  // namespace

TriangleNormals make_triangle_normals(const TriangleCorners& corners, VertexNormals weights, int threads) {
  TriangleNormals made;
  const std::size_t count = corners.group_count;
  const BigArray<Sum> sums = make_big_array<Sum>(count);
  const std::size_t ranges = corners.triangles.size() < kSmallestSlice ? 1 : thread_count(threads);
  std::atomic<bool> has_flat = false;
  std::atomic<bool> has_zero = false;
  parallel_for(ranges, threads, [&](std::size_t i) {
    RangeOfSums range(corners, weights, sums.get(), static_cast<std::uint32_t>(count * i / ranges),
                      static_cast<std::uint32_t>(count * (i + 1) / ranges));
    range.add_all();
    if (range.has_flat()) {
      has_flat = true;
    }
  });
  resize_big(made.normals, count);
  parallel_slices(count, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const Sum& sum = sums[v];
      const double size = length(Vec3d{sum.x, sum.y, sum.z});
      if (size > kCancelled * std::abs(sum.weight)) {
        made.normals[v] = vec_cast<float>(Vec3d{sum.x / size, sum.y / size, sum.z / size});
      } else {
        has_zero = true;
      }
    }
  });
  made.has_flat = has_flat;
  made.has_zero = has_zero;
  return made;
}

Vec3f own_normal(std::span<const Vec3f> positions, const Triangle& triangle) {
  const Vec3f own = vec_cast<float>(plane_of(3, [&](std::size_t k) { return positions[triangle[k]]; }).normal);
  return own == Vec3f{} ? Vec3f{0, 0, 1} : own;
}

}  // namespace lustro
