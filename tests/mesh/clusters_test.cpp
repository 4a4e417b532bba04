// Every triangle lies in one cluster, with its corners, inside its box; clusters are patches; nothing depends on the number of threads.
#include "mesh/clusters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "lustro/mesh.hpp"

namespace lustro {
namespace {

Mesh mesh_of(const std::string& name) {
  const auto source = make_primitive(name);
  return build_mesh(*source)->mesh;
}

void expect_sound(const Mesh& mesh, const Clusters& clusters) {
  std::vector<int> seen(mesh.triangles.size());
  for (const Cluster& c : clusters.clusters) {
    ASSERT_LE(c.triangles, Cluster::kMaxTriangles);
    ASSERT_LE(c.vertices, Cluster::kMaxVertices);
    ASSERT_GT(c.triangles, 0);
    for (std::uint32_t t = 0; t < c.triangles; ++t) {
      const std::uint32_t in_mesh = clusters.triangle_at(c.first_triangle + t);
      ++seen[in_mesh];
      const std::uint32_t packed = clusters.corners[c.first_triangle + t];
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t local = packed >> (8 * k) & 0xFFU;
        ASSERT_LT(local, c.vertices);
        const std::uint32_t vertex = clusters.vertices[c.first_vertex + local];
        ASSERT_EQ(vertex, mesh.triangles[in_mesh][k]);
        const Vec3f& p = mesh.positions[vertex];
        ASSERT_TRUE(p.x >= c.lower.x && p.y >= c.lower.y && p.z >= c.lower.z && p.x <= c.upper.x && p.y <= c.upper.y && p.z <= c.upper.z);
      }
    }
  }
  EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int count) { return count == 1; }));
  EXPECT_GE(clusters.corners.size(), mesh.triangles.size() + Clusters::kPadding);
  ASSERT_EQ(clusters.groups.size(), (clusters.clusters.size() + Clusters::kGroup - 1) / Clusters::kGroup);
  for (std::size_t c = 0; c < clusters.clusters.size(); ++c) {
    const Clusters::Group& group = clusters.groups[c / Clusters::kGroup];
    EXPECT_LE(group.lower.x, clusters.clusters[c].lower.x);
    EXPECT_GE(group.upper.z, clusters.clusters[c].upper.z);
  }
}

double mean_size(const Clusters& clusters) {
  double sum = 0;
  for (const Cluster& c : clusters.clusters) {
    sum += static_cast<double>(std::max({c.upper.x - c.lower.x, c.upper.y - c.lower.y, c.upper.z - c.lower.z}));
  }
  return sum / static_cast<double>(clusters.clusters.size());
}

TEST(Clusters, HoldEveryTriangleOnce) {
  for (const char* name : {"cube", "teapot", "sphere:100", "torus:200"}) {
    const Mesh mesh = mesh_of(name);
    expect_sound(mesh, make_clusters(mesh, ClusterUse::once, 2));
    expect_sound(mesh, make_clusters(mesh, ClusterUse::often, 2));
  }
}

TEST(Clusters, AnEmptyMeshHasNone) {
  EXPECT_TRUE(make_clusters({}, ClusterUse::often, 2).clusters.empty());
}

TEST(Clusters, AreTheSameForAnyNumberOfThreads) {
  const Mesh mesh = mesh_of("torus:200");
  const Clusters one = make_clusters(mesh, ClusterUse::often, 1);
  for (const int threads : {2, 3, 7}) {
    const Clusters many = make_clusters(mesh, ClusterUse::often, threads);
    EXPECT_EQ(one.vertices, many.vertices);
    EXPECT_EQ(one.corners, many.corners);
    EXPECT_EQ(one.triangles, many.triangles);
  }
}

TEST(Clusters, ArePatchesWhereAFileGoesRowByRow) {
  const Mesh mesh = mesh_of("plane:300");
  constexpr double kStrip = 2.0 / 300 * 63;  // 126 triangles beside each other
  EXPECT_LT(mean_size(make_clusters(mesh, ClusterUse::often, 2)), 0.5 * kStrip);
}

TEST(Clusters, TrianglesInRandomOrderAreSortedInSpace) {
  Mesh mesh = mesh_of("sphere:200");
  std::mt19937 random(3);
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
  const Clusters clusters = make_clusters(mesh, ClusterUse::once, 2);
  expect_sound(mesh, clusters);
  EXPECT_LT(mean_size(clusters), 0.6) << "of a sphere of diameter 2";
}

}  // namespace
}  // namespace lustro
