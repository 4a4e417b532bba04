// From a triangle of a mesh to triangles on the image: project, clip, snap to fixed point. A clipped triangle becomes a fan of up to six, each
// of which remembers where its corners lie in the triangle that it was cut from.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/prepare.hpp"

namespace lustro {

/// A triangle on the image, ready to be filled. Corners are ordered so that area2 > 0.
struct ScreenTriangle {
  std::uint32_t id = 0;  ///< number of the triangle in the scene
  std::uint32_t instance = 0;
  bool is_front = true;                   ///< counter-clockwise on the image, y up (a mirrored object's winding is turned back first)
  std::array<std::int32_t, 3> x{}, y{};   ///< 1/256 pixel, within +-2^23
  std::int64_t area2 = 0;                 ///< twice the area, 1/65536 pixel^2
  std::array<float, 3> depth_key{};       ///< see depth_of()
  bool is_swapped = false;                ///< corners 1 and 2 are the mesh triangle's 2 and 1
  bool is_clipped = false;                ///< cut from a mesh triangle, of whose vertices each corner has weights of its own
  std::array<Vec3f, 3> corner_weights{};  ///< weights of the mesh triangle's vertices at each corner
};

/// The depth key: larger is nearer, linear on the image. 1/w for perspective; (far - depth) / (far - near) for orthographic cameras.
[[nodiscard]] float depth_key_of(const View& view, float depth);
[[nodiscard]] float depth_of(const View& view, float depth_key);

/// Twice the area of (a, b, p), positive where p lies to the left of a -> b as seen with y down; exact.
[[nodiscard]] inline std::int64_t edge_function(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by, std::int64_t px,
                                                std::int64_t py) {
  return (bx - ax) * (py - ay) - (by - ay) * (px - ax);
}

/// The three edge functions at p, each opposite its corner; their sum is area2.
[[nodiscard]] std::array<std::int64_t, 3> edges_at(const ScreenTriangle& t, std::int32_t px, std::int32_t py);

/// Whether p is inside; of the points on an edge those on a top or left edge are: a point on an edge that two triangles share belongs to exactly
/// one.
[[nodiscard]] bool covers(const ScreenTriangle& t, std::int32_t px, std::int32_t py);

/// Perspective-correct weights of the mesh triangle's vertices and the depth key at image point p (1/256 pixel).
struct Interpolants {
  float depth_key = 0;
  Vec3f weights;
};
[[nodiscard]] float depth_key_at(const ScreenTriangle& t, const std::array<std::int64_t, 3>& edges);
[[nodiscard]] Interpolants interpolants_at(const View& view, const ScreenTriangle& t, std::int32_t px, std::int32_t py);

/// How those weights change there, a pixel to the right and a pixel down.
[[nodiscard]] WeightSlopes<float> weight_slopes_at(const View& view, const ScreenTriangle& t, std::int32_t px, std::int32_t py);

/// Appends what of triangle `index` of an instance may cover samples of the image.
void setup_triangle(const PreparedScene& scene, std::uint32_t instance, std::uint32_t index, std::vector<ScreenTriangle>& out);

/// All triangles of the scene, in order.
[[nodiscard]] std::vector<ScreenTriangle> setup_triangles(const PreparedScene& scene, int threads);

}  // namespace lustro
