// Which way the triangles of a cluster face: the cone around their normals (Shirman and Abi-Ezzi 1993), and how thin the thinnest of them is.
#pragma once

#include <vector>

#include "mesh/clusters.hpp"

namespace lustro {

/// Of one cluster, in object space.
struct NormalCone {
  Vec3f axis;          ///< unit
  float cosine = -1;   ///< no normal leaves the axis by more than the angle of this cosine
  float thinnest = 0;  ///< the smallest altitude of its triangles; 0: there is no cone, since a triangle without area faces nowhere
};

/// The cones of a mesh's clusters, one each, in their order.
[[nodiscard]] std::vector<NormalCone> make_cones(const Mesh& mesh, const Clusters& clusters, int threads);

}  // namespace lustro
