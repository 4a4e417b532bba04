// The independent judge, part one: which triangle a pixel's ray meets first. Double precision, every triangle against every ray
// (Moeller and Trumbore 1997), written from docs/using/scene-file.md alone: it shares no line with src/.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "lustro/scene.hpp"

namespace lustro::truth {

/// A triangle that a ray meets. object -1: nothing.
struct Hit {
  int object = -1;
  int triangle = -1;
  double depth = 0;                 ///< distance along the view direction
  std::array<double, 3> weights{};  ///< of the triangle's vertices, sum 1
  [[nodiscard]] bool same_place(const Hit& other) const { return object == other.object && triangle == other.triangle; }
};

/// The scene's triangles in world space, and its camera.
class World {
 public:
  /// `scene` must state eye, target, near and far, and outlive the World.
  explicit World(const Scene& scene);

  struct Ray {
    Vec3d origin, direction;  ///< direction . forward = 1: the parameter is the depth
  };
  /// Through the point (x, y) of the image, in pixels from its upper left corner; a pixel's centre has the fraction .5.
  [[nodiscard]] Ray ray(double x, double y) const;
  /// The nearest triangle between the near and the far plane.
  [[nodiscard]] Hit cast(double x, double y) const;
  /// Where the ray meets the plane of one triangle, the triangle's outside included. object -1: nowhere.
  [[nodiscard]] Hit cast_at(double x, double y, int object, int triangle) const;
  /// The hits of all pixel centres, row by row.
  [[nodiscard]] std::vector<Hit> cast_all() const;

  /// The side from which a triangle is counter-clockwise on the image is its front.
  /// reading: the winding is the mesh's own. A matrix that mirrors an object turns its front with it, as a program that draws with OpenGL sees
  /// to by glFrontFace; the letter of the text, without that, would light a mirrored object from its inside.
  [[nodiscard]] bool is_front(double x, double y, const Hit& hit) const;

  struct Placed {
    const Mesh* mesh = nullptr;
    std::vector<Vec3d> positions;  ///< world
    std::vector<Vec3d> normals;    ///< world, unit, by the inverse transpose
    std::vector<Vec3d> face_normals;
    bool is_mirrored = false;
    Vec3d center;
    double radius = 0;
  };
  [[nodiscard]] const Placed& object(int index) const { return objects_[static_cast<std::size_t>(index)]; }
  [[nodiscard]] const Vec3d& eye() const { return eye_; }
  [[nodiscard]] const Vec3d& forward() const { return forward_; }

 private:
  const Scene* scene_;
  std::vector<Placed> objects_;
  Vec3d eye_, forward_, right_, up_;
  double half_width_, half_height_;  ///< of the image at depth 1 (perspective) or everywhere
};

}  // namespace lustro::truth
