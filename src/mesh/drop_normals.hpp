// A mesh without normals.
#pragma once

#include "lustro/mesh.hpp"

namespace lustro {

/// Leaves out normals and tangents. Vertices that differed in nothing else become one, so that what normals had parted (creases, facets) is
/// joined again; vertices come in the order of their first use, unused ones go.
void drop_normals(Mesh& mesh);

}  // namespace lustro
