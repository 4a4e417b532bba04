// What a mesh is like as a surface: edges, openings, pieces. Vertices at the same position count as one, as the eye sees them.
#pragma once

#include <cstdint>

#include "lustro/mesh.hpp"

namespace lustro::app {

struct MeshStats {
  std::uint64_t positions = 0;  ///< distinct ones that triangles use
  std::uint64_t edges = 0;
  std::uint64_t boundary_edges = 0;     ///< of one triangle
  std::uint64_t nonmanifold_edges = 0;  ///< of more than two triangles
  std::uint64_t misoriented_edges = 0;  ///< of two triangles that are wound against each other
  std::uint64_t pieces = 0;             ///< connected through shared positions
  double area = 0;                      ///< object units squared
  double volume = 0;                    ///< object units cubed, signed; only means something where the surface is closed

  [[nodiscard]] bool is_closed() const { return edges > 0 && boundary_edges == 0 && nonmanifold_edges == 0; }
  [[nodiscard]] bool is_oriented() const { return misoriented_edges == 0; }
};

[[nodiscard]] MeshStats mesh_stats(const Mesh& mesh);

}  // namespace lustro::app
