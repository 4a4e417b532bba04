// A mesh cut into clusters of neighbouring triangles: small enough for a box to say where they are, and for one byte to name a vertex.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lustro/mesh.hpp"

namespace lustro {

/// At most kMaxTriangles triangles over at most kMaxVertices vertices.
struct Cluster {
  static constexpr std::uint32_t kMaxTriangles = 128;
  static constexpr std::uint32_t kMaxVertices = 128;

  Vec3f lower, upper;                ///< box of its vertices, object space
  std::uint32_t first_vertex = 0;    ///< into Clusters::vertices
  std::uint32_t first_triangle = 0;  ///< into Clusters::corners and Clusters::triangles
  std::uint16_t vertices = 0;
  std::uint16_t triangles = 0;
};

/// All of a mesh's triangles, each in one cluster. Which triangle lies where never decides a pixel: every picture is the same for every way to
/// cut.
struct Clusters {
  /// Entries that may be read behind the last one, so that kernels load whole vectors.
  static constexpr std::size_t kPadding = 16;

  /// The box of kGroup clusters in a row.
  struct Group {
    Vec3f lower, upper;
  };
  static constexpr std::size_t kGroup = 64;

  std::vector<Cluster> clusters;
  std::vector<Group> groups;
  std::vector<std::uint32_t> vertices;          ///< the mesh's vertices, cluster by cluster (+ kPadding)
  std::array<std::vector<float>, 3> positions;  ///< x, y, z of `vertices`, for clusters that are drawn often; else empty (+ kPadding)
  std::vector<std::uint32_t> corners;           ///< a triangle's three vertices within its cluster: a | b << 8 | c << 16 (+ kPadding)
  std::vector<std::uint32_t> triangles;         ///< its index in the mesh; empty: the mesh's own order

  [[nodiscard]] std::uint32_t triangle_at(std::size_t i) const { return triangles.empty() ? static_cast<std::uint32_t>(i) : triangles[i]; }
};

/// How often the clusters will be drawn: whether tidy ones are worth their making.
enum class ClusterUse : std::uint8_t { once, often };

/// Cuts the triangles along a space-filling curve (Morton 1966): within stretches of the file, where neighbours in the file are roughly
/// neighbours in space (in the own order of a large file for a single picture); else through the whole mesh.
/// The result depends on the mesh alone, not on the number of threads.
///
/// mesh  indices inside their arrays, positions finite
[[nodiscard]] Clusters make_clusters(const Mesh& mesh, ClusterUse use, int threads);

}  // namespace lustro
