// Polygons into triangles: a fan where that is right, ears where it is not.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lustro/mesh.hpp"

namespace lustro {

/// Triangles over the corners of a mesh's faces.
struct Triangles {
  std::vector<std::array<std::uint32_t, 3>> corners;  ///< T, in the order of the faces; each turns the way its face does
  std::vector<std::uint32_t> face;                    ///< T
  std::size_t crossing_polygons = 0;                  ///< cross or overlap themselves, so that triangles overlap
};

/// Cuts one polygon. Keeps its working memory from call to call.
///
/// A convex polygon becomes a fan from its first corner, unless a corner on a straight edge would leave a triangle of the fan without area.
/// Any other polygon is cut by ears, seen along Newell's normal: corner by corner round the polygon, those first whose triangle has area and
/// holds no other corner. Corners may coincide and edges touch (holes joined to the outline by a bridge). Always n - 2 triangles, whose
/// signed areas sum to the polygon's.
/// source  Meisters 1975, Polygons have ears; Held 2001, FIST (on touching corners and on giving up well)
class Triangulator {
 public:
  /// polygon  at least 3 points, finite, object space
  /// out      gets size - 2 triangles as indices into polygon
  /// returns  whether the polygon could be cut without triangles overlapping
  bool cut(std::span<const Vec3f> polygon, std::vector<std::array<std::uint32_t, 3>>& out);

 private:
  struct Point {
    double x, y;
  };
  enum class Turn : std::uint8_t { left, straight, right };

  void project(std::span<const Vec3f> polygon);
  [[nodiscard]] bool is_fan() const;
  bool cut_ears(std::vector<std::array<std::uint32_t, 3>>& out);
  [[nodiscard]] Turn turn_at(std::uint32_t corner) const;
  [[nodiscard]] bool is_ear(std::uint32_t corner, double slack);
  [[nodiscard]] double cross_at(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

  std::vector<Point> points_;
  double rounding_ = 0;  ///< a distance below which float coordinates say nothing
  std::vector<std::uint32_t> next_, previous_;
  std::vector<Turn> turn_;
  std::vector<std::uint32_t> by_x_;  ///< corners that are not convex, from left to right: only they can lie in an ear
  std::size_t tests_left_ = 0;
};

/// Triangles of all faces. A face has at least 3 corners, finite.
[[nodiscard]] Triangles triangulate(const SourceMesh& mesh);

}  // namespace lustro
