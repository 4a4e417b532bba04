// The axis is the mean of the unit normals; the cone is as wide as the normal that leaves it most.
#include "mesh/cones.hpp"

#include <algorithm>
#include <cmath>

#include "parallel/slices.hpp"

namespace lustro {
namespace {

// Twice the area times the unit normal, in double: the thinnest triangles are what counts.
Vec3d area_normal(const std::array<Vec3d, 3>& p) {
  return cross(p[1] - p[0], p[2] - p[0]);
}

NormalCone cone_of(const Mesh& mesh, const Clusters& clusters, const Cluster& cluster) {
  std::array<Vec3d, Cluster::kMaxTriangles> normals;
  Vec3d sum;
  double thinnest = std::numeric_limits<double>::infinity();
  for (std::uint32_t t = 0; t < cluster.triangles; ++t) {
    const auto& corners = mesh.triangles[clusters.triangle_at(cluster.first_triangle + t)];
    const std::array<Vec3d, 3> p{vec_cast<double>(mesh.positions[corners[0]]), vec_cast<double>(mesh.positions[corners[1]]),
                                 vec_cast<double>(mesh.positions[corners[2]])};
    const Vec3d n = area_normal(p);
    const double area2 = length(n);
    const double longest = std::max({length(p[1] - p[0]), length(p[2] - p[1]), length(p[0] - p[2])});
    if (!(area2 > 0)) {
      return {};
    }
    thinnest = std::min(thinnest, area2 / longest);
    normals[t] = n * (1 / area2);
    sum = sum + normals[t];
  }
  if (!(length(sum) > 1e-6)) {
    return {};
  }
  const Vec3d axis = normalize(sum);
  double cosine = 1;
  for (std::uint32_t t = 0; t < cluster.triangles; ++t) {
    cosine = std::min(cosine, dot(axis, normals[t]));
  }
  constexpr double kRounding = 1e-6;  // of the way to floats
  return {vec_cast<float>(axis), static_cast<float>(cosine - kRounding), static_cast<float>(thinnest * (1 - kRounding))};
}

}  // namespace

std::vector<NormalCone> make_cones(const Mesh& mesh, const Clusters& clusters, int threads) {
  std::vector<NormalCone> cones(clusters.clusters.size());
  parallel_slices(cones.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      cones[c] = cone_of(mesh, clusters, clusters.clusters[c]);
    }
  });
  return cones;
}

}  // namespace lustro
