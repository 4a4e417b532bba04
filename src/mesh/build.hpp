// The ways by which build_mesh() goes.
#pragma once

#include "lustro/mesh.hpp"

namespace lustro {

/// build_mesh() for any mesh: polygons, corners with indices of their own, creases, smoothing groups, welding.
[[nodiscard]] Result<BuiltMesh> build_general(SourceMesh&& source, const NormalOptions& options, int threads);

}  // namespace lustro
