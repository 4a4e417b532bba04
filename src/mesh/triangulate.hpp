// Polygons into triangles: a fan where that is right, ears where it is not.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
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
  /// returns  false where the polygon was found to cross or overlap itself, so that triangles overlap
  bool cut(std::span<const Vec3f> polygon, std::vector<std::array<std::uint32_t, 3>>& out);

 private:
  struct Point {
    double x, y;
  };
  enum class Turn : std::uint8_t { left, straight, right };

  void project(std::span<const Vec3f> polygon);
  [[nodiscard]] std::optional<double> turning() const;
  [[nodiscard]] bool is_fan() const;
  void build_grid();
  [[nodiscard]] std::uint32_t cell_at(double x, double lower, double upper) const;
  [[nodiscard]] std::uint32_t column_of(double x) const { return cell_at(x, lower_.x, upper_.x); }
  [[nodiscard]] std::uint32_t row_of(double y) const { return cell_at(y, lower_.y, upper_.y); }
  bool cut_ears(std::vector<std::array<std::uint32_t, 3>>& out);
  [[nodiscard]] Turn turn_at(std::uint32_t corner) const;
  [[nodiscard]] bool is_ear(std::uint32_t corner, double slack);
  [[nodiscard]] double cross_at(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

  std::vector<Point> points_;
  double rounding_ = 0;  ///< a distance below which float coordinates say nothing
  std::vector<std::uint32_t> next_, previous_;
  std::vector<Turn> turn_;
  // The corners that are not convex, in a grid of cells_ x cells_ over the polygon.
  Point lower_{}, upper_{};
  std::uint32_t cells_ = 1;
  std::vector<std::uint32_t> cell_begin_, obstacles_;
  std::size_t tests_left_ = 0;
};

/// Triangles of all faces. A face has at least 3 corners, finite.
[[nodiscard]] Triangles triangulate(const SourceMesh& mesh, int threads = 0);

}  // namespace lustro
