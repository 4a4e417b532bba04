// Small sources that several tests share, written out or grown from a formula.
#pragma once

#include <initializer_list>
#include <random>
#include <vector>

#include "lustro/mesh.hpp"

namespace lustro {

inline SourceMesh polygons(std::vector<Vec3f> positions, const std::vector<std::vector<std::uint32_t>>& faces) {
  SourceMesh source;
  source.positions = std::move(positions);
  for (const auto& face : faces) {
    source.corner_position.insert(source.corner_position.end(), face.begin(), face.end());
    source.face_begin.push_back(static_cast<std::uint32_t>(source.corner_position.size()));
  }
  return source;
}

inline std::vector<Vec3f> cube_corners() {
  std::vector<Vec3f> corners;
  for (unsigned i = 0; i < 8; ++i) {
    corners.push_back({(i & 1U) != 0 ? 1.0F : -1.0F, (i & 2U) != 0 ? 1.0F : -1.0F, (i & 4U) != 0 ? 1.0F : -1.0F});
  }
  return corners;
}

/// Corner i is at (+-1, +-1, +-1) by the bits of i; six quads, outward.
inline SourceMesh cube_of_quads() {
  return polygons(cube_corners(), {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}});
}

/// The same cube, every quad cut from its first corner.
inline SourceMesh cube_of_triangles() {
  const SourceMesh quads = cube_of_quads();
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::size_t f = 0; f < 6; ++f) {
    const std::uint32_t* q = quads.corner_position.data() + 4 * f;
    faces.push_back({q[0], q[1], q[2]});
    faces.push_back({q[0], q[2], q[3]});
  }
  return polygons(cube_corners(), faces);
}

/// 0 <= x < 1 from the bits of the engine, the same on every system.
inline double uniform01(std::mt19937& random) {
  return static_cast<double>(random()) * 0x1p-32;
}

inline bool has_note(const Notes& notes, const std::string& part) {
  for (const Note& note : notes) {
    if (note.text().find(part) != std::string::npos) {
      return true;
    }
  }
  return false;
}

}  // namespace lustro
