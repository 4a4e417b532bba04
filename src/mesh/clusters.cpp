// Clusters are cut greedily, in fixed stretches of triangles that threads share out.
#include "mesh/clusters.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "parallel/big_memory.hpp"
#include "parallel/slices.hpp"

namespace lustro {
namespace {

constexpr std::size_t kStretch = 16384;  // triangles that one job cuts; clusters do not cross its ends

// Triangles; the clusters of larger meshes are small on a picture in any order, and for a single one sorting costs more than it brings.
constexpr std::size_t kTidyOnce = std::size_t{1} << 19U;

Vec3f least(const Vec3f& a, const Vec3f& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vec3f greatest(const Vec3f& a, const Vec3f& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

// The vertices of the cluster that is being cut: a small open hash, forgotten by counting up its stamp.
class VertexTable {
 public:
  void clear() {
    ++stamp_;
    size_ = 0;
  }
  [[nodiscard]] std::uint32_t size() const { return size_; }

  // The number of `vertex` within the cluster, which it joins if it is new.
  std::uint32_t number(std::uint32_t vertex, std::vector<std::uint32_t>& vertices) {
    std::size_t slot = (vertex * 0x9E3779B1U) >> 23;
    while (slots_[slot].stamp == stamp_) {
      if (slots_[slot].vertex == vertex) {
        return slots_[slot].number;
      }
      slot = (slot + 1) % slots_.size();
    }
    slots_[slot] = {vertex, stamp_, size_};
    vertices.push_back(vertex);
    return size_++;
  }

 private:
  struct Slot {
    std::uint32_t vertex = 0, stamp = 0, number = 0;
  };
  std::array<Slot, 512> slots_{};  // at most a quarter full
  std::uint32_t stamp_ = 0;
  std::uint32_t size_ = 0;
};

struct Stretch {
  std::vector<Cluster> clusters;
  std::vector<std::uint32_t> vertices;
};

void finish(Cluster& cluster, const Mesh& mesh, const std::vector<std::uint32_t>& vertices) {
  cluster.lower = cluster.upper = mesh.positions[vertices[cluster.first_vertex]];
  for (std::size_t i = cluster.first_vertex; i < vertices.size(); ++i) {
    const Vec3f& p = mesh.positions[vertices[i]];
    cluster.lower = least(cluster.lower, p);
    cluster.upper = greatest(cluster.upper, p);
  }
  cluster.vertices = static_cast<std::uint16_t>(vertices.size() - cluster.first_vertex);
}

// Cuts triangles first..last; `order` names them, or is empty. Fills their entries of `corners`.
Stretch cut(const Mesh& mesh, const std::vector<std::uint32_t>& order, std::size_t first, std::size_t last,
            std::vector<std::uint32_t>& corners) {
  Stretch stretch;
  stretch.vertices.reserve((last - first) * 5 / 4);
  VertexTable table;
  table.clear();
  Cluster cluster;
  cluster.first_triangle = static_cast<std::uint32_t>(first);
  for (std::size_t i = first; i < last; ++i) {
    if (cluster.triangles == Cluster::kMaxTriangles || table.size() + 3 > Cluster::kMaxVertices) {
      finish(cluster, mesh, stretch.vertices);
      stretch.clusters.push_back(cluster);
      table.clear();
      cluster = {};
      cluster.first_vertex = static_cast<std::uint32_t>(stretch.vertices.size());
      cluster.first_triangle = static_cast<std::uint32_t>(i);
    }
    const auto& t = mesh.triangles[order.empty() ? i : order[i]];
    const std::uint32_t a = table.number(t[0], stretch.vertices);
    const std::uint32_t b = table.number(t[1], stretch.vertices);
    const std::uint32_t c = table.number(t[2], stretch.vertices);
    corners[i] = a | b << 8 | c << 16;
    ++cluster.triangles;
  }
  finish(cluster, mesh, stretch.vertices);
  stretch.clusters.push_back(cluster);
  return stretch;
}

double longest_side(const Vec3d& lower, const Vec3d& upper) {
  return std::max({upper.x - lower.x, upper.y - lower.y, upper.z - lower.z});
}

// Neighbours in the file make boxes far smaller than the mesh, even where a file goes row by row; triangles in random order make boxes as large
// as the mesh, each.
bool is_scattered(const Clusters& clusters) {
  Bounds bounds;
  double sum = 0;
  for (const Cluster& cluster : clusters.clusters) {
    const Vec3d lower = vec_cast<double>(cluster.lower);
    const Vec3d upper = vec_cast<double>(cluster.upper);
    bounds.include(lower);
    bounds.include(upper);
    sum += longest_side(lower, upper);
  }
  constexpr double kTolerated = 1.0 / 3;  // of the mesh's side, on the average
  const auto count = static_cast<double>(clusters.clusters.size());
  return count > 64 && sum > kTolerated * count * longest_side(bounds.lower, bounds.upper);
}

// Ten bits apart by two zeros each.
std::uint32_t spread(std::uint32_t v) {
  v = (v | v << 16) & 0x030000FFU;
  v = (v | v << 8) & 0x0300F00FU;
  v = (v | v << 4) & 0x030C30C3U;
  return (v | v << 2) & 0x09249249U;
}

// Three times a triangle's centre.
Vec3f center3(const Mesh& mesh, std::uint32_t triangle) {
  const auto& t = mesh.triangles[triangle];
  return (mesh.positions[t[0]] + mesh.positions[t[1]]) + mesh.positions[t[2]];
}

// Sorts triangles along the Morton curve of their centres. Equal codes keep their order.
void sort_along_curve(const Mesh& mesh, std::span<std::uint32_t> order) {
  if (order.size() <= Cluster::kMaxTriangles) {
    return;
  }
  Vec3f lower = center3(mesh, order[0]);
  Vec3f upper = lower;
  for (const std::uint32_t triangle : order) {
    const Vec3f p = center3(mesh, triangle);
    lower = least(lower, p);
    upper = greatest(upper, p);
  }
  // Cells are cubes: a flat stretch is cut as finely as its longest side allows.
  const float size = std::max({upper.x - lower.x, upper.y - lower.y, upper.z - lower.z});
  const float scale = size > 0 ? 255.99F / size : 0;
  const auto cell = [scale](float p, float low) { return std::min(static_cast<std::uint32_t>(std::max((p - low) * scale, 0.0F)), 255U); };
  std::vector<std::uint64_t> keys(order.size());
  std::vector<std::uint64_t> sorted(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Vec3f p = center3(mesh, order[i]);
    const std::uint64_t code = spread(cell(p.x, lower.x)) | spread(cell(p.y, lower.y)) << 1 | spread(cell(p.z, lower.z)) << 2;
    keys[i] = code << 32 | order[i];
  }
  constexpr std::size_t kDigit = 4096;
  for (const int shift : {32, 44}) {  // radix sort, stable
    std::array<std::uint32_t, kDigit + 1> begin{};
    for (const std::uint64_t key : keys) {
      ++begin[(key >> shift) % kDigit + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    for (const std::uint64_t key : keys) {
      sorted[begin[(key >> shift) % kDigit]++] = key;
    }
    keys.swap(sorted);
  }
  std::transform(keys.begin(), keys.end(), order.begin(), [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
}

// A coarser and much quicker sort_along_curve() of the triangles first .. first + order.size() - 1, a stretch of the file: places are cells of
// their first corners, and one counting pass sorts them.
void sort_roughly(const Mesh& mesh, std::uint32_t first, std::span<std::uint32_t> order) {
  const std::span triangles = std::span(mesh.triangles).subspan(first, order.size());
  const auto place_of = [&](const std::array<std::uint32_t, 3>& triangle) { return mesh.positions[triangle[0]]; };
  Vec3f lower = place_of(triangles[0]);
  Vec3f upper = lower;
  for (const auto& triangle : triangles) {
    const Vec3f p = place_of(triangle);
    lower = least(lower, p);
    upper = greatest(upper, p);
  }
  constexpr std::uint32_t kCells = 16;  // a side: few enough for one pass, and most cells of a surface's stretch hold less than a cluster
  const float size = std::max({upper.x - lower.x, upper.y - lower.y, upper.z - lower.z});
  const float scale = size > 0 ? static_cast<float>(kCells) / size : 0;
  constexpr auto kLast = static_cast<float>(kCells - 1);
  const auto cell = [scale, kLast](float p, float low) { return static_cast<std::uint32_t>(std::min(kLast, (p - low) * scale)); };  // NaN: kLast
  std::array<std::uint16_t, kStretch> codes{};
  std::array<std::uint32_t, kCells * kCells * kCells + 1> begin{};
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Vec3f p = place_of(triangles[i]);
    codes[i] = static_cast<std::uint16_t>(spread(cell(p.x, lower.x)) | spread(cell(p.y, lower.y)) << 1 | spread(cell(p.z, lower.z)) << 2);
    ++begin[codes[i] + std::size_t{1}];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    order[begin[codes[i]]++] = first + static_cast<std::uint32_t>(i);
  }
}

// How a stretch of the file becomes a patch, even where the file goes row by row.
enum class Tidying : std::uint8_t { none, rough, fine };

void tidy(Tidying tidying, const Mesh& mesh, std::uint32_t first, std::span<std::uint32_t> order) {
  if (tidying == Tidying::rough) {
    sort_roughly(mesh, first, order);
  } else if (tidying == Tidying::fine) {
    std::iota(order.begin(), order.end(), first);
    sort_along_curve(mesh, order);
  }
}

// `order` names the triangles, is room for their tidied order, or is empty.
Clusters cut_all(const Mesh& mesh, std::vector<std::uint32_t> order, Tidying tidying, int threads) {
  const std::size_t count = mesh.triangles.size();
  Clusters result;
  resize_big(result.corners, count + Clusters::kPadding);
  std::vector<Stretch> stretches((count + kStretch - 1) / kStretch);
  parallel_for(stretches.size(), threads, [&](std::size_t s) {
    const std::size_t first = s * kStretch;
    const std::size_t last = std::min(count, first + kStretch);
    if (tidying != Tidying::none) {
      tidy(tidying, mesh, static_cast<std::uint32_t>(first), std::span(order).subspan(first, last - first));
    }
    stretches[s] = cut(mesh, order, first, last, result.corners);
  });
  std::vector<std::size_t> first_cluster(stretches.size() + 1);
  std::vector<std::size_t> first_vertex(stretches.size() + 1);
  for (std::size_t s = 0; s < stretches.size(); ++s) {
    first_cluster[s + 1] = first_cluster[s] + stretches[s].clusters.size();
    first_vertex[s + 1] = first_vertex[s] + stretches[s].vertices.size();
  }
  result.clusters.resize(first_cluster.back());
  resize_big(result.vertices, first_vertex.back() + Clusters::kPadding);
  parallel_for(stretches.size(), threads, [&](std::size_t s) {
    std::copy(stretches[s].vertices.begin(), stretches[s].vertices.end(),
              result.vertices.begin() + static_cast<std::ptrdiff_t>(first_vertex[s]));
    for (std::size_t i = 0; i < stretches[s].clusters.size(); ++i) {
      Cluster cluster = stretches[s].clusters[i];
      cluster.first_vertex += static_cast<std::uint32_t>(first_vertex[s]);
      result.clusters[first_cluster[s] + i] = cluster;
    }
    stretches[s] = {};
  });
  for (std::size_t c = 0; c < result.clusters.size(); ++c) {
    const Cluster& cluster = result.clusters[c];
    if (c % Clusters::kGroup == 0) {
      result.groups.push_back({cluster.lower, cluster.upper});
    }
    Clusters::Group& group = result.groups.back();
    group.lower = least(group.lower, cluster.lower);
    group.upper = greatest(group.upper, cluster.upper);
  }
  result.triangles = std::move(order);
  return result;
}

// A cluster's positions beside each other, so that drawing it reads memory in one stretch.
void gather_positions(Clusters& clusters, const Mesh& mesh, int threads) {
  for (std::vector<float>& axis : clusters.positions) {
    resize_big(axis, clusters.vertices.size());
  }
  parallel_slices(clusters.vertices.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3f& p = mesh.positions[clusters.vertices[i]];  // the padding names vertex 0
      clusters.positions[0][i] = p.x;
      clusters.positions[1][i] = p.y;
      clusters.positions[2][i] = p.z;
    }
  });
}

}  // namespace

Clusters make_clusters(const Mesh& mesh, ClusterUse use, int threads) {
  if (mesh.triangles.empty()) {
    return {};
  }
  const Tidying tidying = use == ClusterUse::often ? Tidying::fine : mesh.triangles.size() <= kTidyOnce ? Tidying::rough : Tidying::none;
  std::vector<std::uint32_t> order;
  if (tidying != Tidying::none) {
    resize_big(order, mesh.triangles.size());
  }
  Clusters clusters = cut_all(mesh, std::move(order), tidying, threads);
  if (is_scattered(clusters)) {
    order = std::move(clusters.triangles);
    clusters = {};
    resize_big(order, mesh.triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    sort_along_curve(mesh, order);
    clusters = cut_all(mesh, std::move(order), Tidying::none, threads);
  }
  if (use == ClusterUse::often) {
    gather_positions(clusters, mesh, threads);
  }
  return clusters;
}

}  // namespace lustro
