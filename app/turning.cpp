// Turning: see turning.hpp. Sines come from math/trig.hpp, so that a turned scene has the same bits everywhere.
#include "turning.hpp"

#include <algorithm>
#include <cmath>

namespace lustro::app {
namespace {

template <class Use>
void for_each_vertex(const Scene& scene, const Use& use) {
  for (const Object& object : scene.objects) {
    if (!object.mesh) {
      continue;
    }
    for (const auto& triangle : object.mesh->triangles) {
      for (const std::uint32_t vertex : triangle) {
        if (vertex < object.mesh->positions.size()) {
          use(transform_point(object.matrix, vec_cast<double>(object.mesh->positions[vertex])));
        }
      }
    }
  }
}

}  // namespace

SweptBody swept_body(const Scene& scene) {
  Bounds bounds;
  for_each_vertex(scene, [&](const Vec3d& p) { bounds.include(p); });
  SweptBody body;
  if (bounds.is_empty()) {
    return body;
  }
  body.center = bounds.center();
  if (scene.camera.target) {
    body.center = {scene.camera.target->x, body.center.y, scene.camera.target->z};
  }
  body.half_height = (bounds.upper.y - bounds.lower.y) / 2;
  double farthest = 0;
  for_each_vertex(scene, [&](const Vec3d& p) {
    const double x = p.x - body.center.x, z = p.z - body.center.z;
    farthest = std::max(farthest, x * x + z * z);
  });
  body.radius = std::sqrt(farthest);
  return body;
}

Extent extent_of(const SweptBody& body) {
  Extent extent;
  const Vec3d reach{body.radius, body.half_height, body.radius};
  extent.bounds.lower = body.center - reach;
  extent.bounds.upper = body.center + reach;
  extent.reach = [body](std::span<const Vec3d> directions, std::span<double> out) {
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Vec3d& d = directions[i];
      out[i] = dot(d, body.center) + body.radius * std::sqrt(d.x * d.x + d.z * d.z) + body.half_height * std::abs(d.y);
    }
  };
  return extent;
}

std::vector<Mat4> matrices_of(const Scene& scene) {
  std::vector<Mat4> matrices;
  matrices.reserve(scene.objects.size());
  for (const Object& object : scene.objects) {
    matrices.push_back(object.matrix);
  }
  return matrices;
}

void turn_objects(Scene& scene, std::span<const Mat4> matrices, const SweptBody& body, double sine, double cosine) {
  const Vec3d& c = body.center;
  // T(c) R T(-c): x' = cos x + sin z, z' = cos z - sin x, about c
  Mat4 turn;
  turn.m = {cosine, 0, sine,   c.x - (cosine * c.x + sine * c.z),  //
            0,      1, 0,      0,                                  //
            -sine,  0, cosine, c.z - (cosine * c.z - sine * c.x),  //
            0,      0, 0,      1};
  for (std::size_t i = 0; i < matrices.size(); ++i) {
    scene.objects[i].matrix = turn * matrices[i];
  }
}

void settle_for_turn(Scene& scene, const SweptBody& body) {
  if (scene.occlusion && !scene.occlusion->radius && body.radius > 0) {
    const Bounds bounds = extent_of(body).bounds;
    scene.occlusion->radius = length(bounds.upper - bounds.lower) / 4;
  }
  if (scene.ground && !scene.ground->height) {
    scene.ground->height = body.center.y - body.half_height;
  }
}

Result<Camera> definite_camera(const Camera& camera, const ImageSettings& image, const View& view, const SweptBody& body) {
  Camera definite = camera;
  definite.eye = view.eye;
  definite.target = view.target;
  definite.up = view.up;
  if (view.projection == Projection::orthographic) {
    definite.height = image.height / view.pixels_per_unit;
  }
  const Result<View> planes = make_view(definite, image, extent_of(body));
  if (!planes) {
    return tl::unexpected(planes.error());
  }
  definite.near = planes->near;
  definite.far = planes->far;
  return definite;
}

Vec3d turned(const Vec3d& point, const SweptBody& body, double sine, double cosine) {
  const Vec3d p = point - body.center;
  return body.center + Vec3d{cosine * p.x + sine * p.z, p.y, cosine * p.z - sine * p.x};
}

}  // namespace lustro::app
