// A mesh whose triangles share no vertex.
#pragma once

#include "lustro/mesh.hpp"
#include "lustro/result.hpp"

namespace lustro {

/// The mesh with three vertices a triangle, whose normals are the triangle's own; all else as it was. Triangles without an area keep the
/// normals of their vertices.
/// errors  limit for more than 2^32 / 3 triangles
[[nodiscard]] Result<Mesh> faceted(const Mesh& mesh);

}  // namespace lustro
