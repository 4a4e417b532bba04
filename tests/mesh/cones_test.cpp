#include "mesh/cones.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lustro {
namespace {

Mesh built(const char* name) {
  return build_mesh(*make_primitive(name))->mesh;
}

TEST(NormalCone, OfAPlaneIsALine) {
  const Mesh mesh = built("plane:10");
  const Clusters clusters = make_clusters(mesh, ClusterUse::often, 1);
  for (const NormalCone& cone : make_cones(mesh, clusters, 1)) {
    EXPECT_NEAR(cone.axis.y, 1, 1e-6);
    EXPECT_NEAR(cone.cosine, 1, 2e-6);
    EXPECT_NEAR(cone.thinnest, 0.2 / std::sqrt(2.0), 1e-6);  // half a square of 0.2: its altitude stands on the diagonal
  }
}

TEST(NormalCone, HoldsEveryNormalAndNoTriangleIsThinner) {
  for (const char* name : {"sphere:40", "torus:100"}) {
    const Mesh mesh = built(name);
    const Clusters clusters = make_clusters(mesh, ClusterUse::often, 2);
    const std::vector<NormalCone> cones = make_cones(mesh, clusters, 3);
    ASSERT_EQ(cones.size(), clusters.clusters.size());
    std::size_t usable = 0;
    for (std::size_t c = 0; c < cones.size(); ++c) {
      if (cones[c].thinnest == 0) {
        continue;
      }
      ++usable;
      const Cluster& cluster = clusters.clusters[c];
      for (std::uint32_t t = 0; t < cluster.triangles; ++t) {
        const auto& corners = mesh.triangles[clusters.triangle_at(cluster.first_triangle + t)];
        const auto at = [&](std::size_t k) { return vec_cast<double>(mesh.positions[corners[k]]); };
        const Vec3d n = cross(at(1) - at(0), at(2) - at(0));
        EXPECT_GE(dot(normalize(n), vec_cast<double>(cones[c].axis)), static_cast<double>(cones[c].cosine));
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_GE(length(n) / length(at((k + 1) % 3) - at(k)), static_cast<double>(cones[c].thinnest));
        }
      }
    }
    EXPECT_GT(usable, 0U) << name;
  }
}

TEST(NormalCone, ATriangleWithoutAreaFacesNowhere) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}};
  const std::vector<NormalCone> cones = make_cones(mesh, make_clusters(mesh, ClusterUse::once, 1), 1);
  ASSERT_EQ(cones.size(), 1U);
  EXPECT_EQ(cones[0].thinnest, 0);
}

TEST(NormalCone, OppositeFacesHaveNone) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {2, 1, 0}};
  const std::vector<NormalCone> cones = make_cones(mesh, make_clusters(mesh, ClusterUse::once, 1), 1);
  EXPECT_LE(cones[0].cosine, 0);
}

}  // namespace
}  // namespace lustro
