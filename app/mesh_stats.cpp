// Surface statistics by sorting: see mesh_stats.hpp.
#include "mesh_stats.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <vector>

namespace lustro::app {
namespace {

using Index = std::uint32_t;

/// For each vertex the smallest vertex at the same position.
std::vector<Index> position_ids(const std::vector<Vec3f>& positions) {
  std::vector<Index> order(positions.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto key = [&](Index i) { return std::tuple(positions[i].x, positions[i].y, positions[i].z, i); };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
  std::vector<Index> ids(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    ids[order[i]] = i > 0 && positions[order[i]] == positions[order[i - 1]] ? ids[order[i - 1]] : order[i];
  }
  return ids;
}

struct Edge {
  Index lower = 0, upper = 0;
  bool forward = false;  ///< walked from lower to upper
  friend bool operator<(const Edge& a, const Edge& b) { return std::tie(a.lower, a.upper, a.forward) < std::tie(b.lower, b.upper, b.forward); }
};

std::vector<Edge> sorted_edges(const Mesh& mesh, const std::vector<Index>& ids) {
  std::vector<Edge> edges;
  edges.reserve(mesh.triangles.size() * 3);
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = ids[triangle[k]], b = ids[triangle[(k + 1) % 3]];
      if (a != b) {
        edges.push_back({std::min(a, b), std::max(a, b), a < b});
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

void count_edges(const std::vector<Edge>& edges, MeshStats& stats) {
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    std::size_t forward = 0;
    for (; end < edges.size() && edges[end].lower == edges[i].lower && edges[end].upper == edges[i].upper; ++end) {
      forward += edges[end].forward ? 1U : 0U;
    }
    const std::size_t count = end - i;
    ++stats.edges;
    stats.boundary_edges += count == 1 ? 1U : 0U;
    stats.nonmanifold_edges += count > 2 ? 1U : 0U;
    stats.misoriented_edges += count == 2 && forward != 1 ? 1U : 0U;
    i = end;
  }
}

/// Union-find with path halving.
Index root_of(std::vector<Index>& parent, Index i) {
  while (parent[i] != i) {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

void count_pieces(const Mesh& mesh, const std::vector<Index>& ids, const std::vector<Edge>& edges, MeshStats& stats) {
  std::vector<Index> parent(ids.size());
  std::iota(parent.begin(), parent.end(), Index{0});
  for (const Edge& edge : edges) {
    parent[root_of(parent, edge.lower)] = root_of(parent, edge.upper);
  }
  std::vector<bool> used(ids.size());
  for (const auto& triangle : mesh.triangles) {
    for (const Index vertex : triangle) {
      used[ids[vertex]] = true;
    }
  }
  for (Index i = 0; i < ids.size(); ++i) {
    stats.positions += used[i] ? 1U : 0U;
    stats.pieces += used[i] && parent[i] == i ? 1U : 0U;
  }
}

}  // namespace

MeshStats mesh_stats(const Mesh& mesh) {
  MeshStats stats;
  const std::vector<Index> ids = position_ids(mesh.positions);
  const std::vector<Edge> edges = sorted_edges(mesh, ids);
  count_edges(edges, stats);
  count_pieces(mesh, ids, edges, stats);
  const Vec3d origin = mesh.bounds().is_empty() ? Vec3d{} : mesh.bounds().center();  // near the mesh, so that far-away meshes keep their digits
  for (const auto& triangle : mesh.triangles) {
    const Vec3d a = vec_cast<double>(mesh.positions[triangle[0]]) - origin, b = vec_cast<double>(mesh.positions[triangle[1]]) - origin,
                c = vec_cast<double>(mesh.positions[triangle[2]]) - origin;
    stats.area += length(cross(b - a, c - a)) / 2;
    stats.volume += dot(a, cross(b, c)) / 6;
  }
  return stats;
}

}  // namespace lustro::app
