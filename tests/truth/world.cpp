// Rays against triangles, in double precision.
#include "truth/world.hpp"

#include <cmath>
#include <stdexcept>

namespace lustro::truth {
namespace {

constexpr double kPi = 3.14159265358979323846;

double determinant(const Mat4& m) {
  return dot(Vec3d{m(0, 0), m(0, 1), m(0, 2)}, cross(Vec3d{m(1, 0), m(1, 1), m(1, 2)}, Vec3d{m(2, 0), m(2, 1), m(2, 2)}));
}

/// A normal's way through a matrix: the inverse transpose, by cofactors over the determinant. The sign of the determinant stays in, so that a
/// normal that points out of a mirrored object still points out of it.
Vec3d transform_normal(const Mat4& m, const Vec3d& n) {
  const Vec3d a{m(0, 0), m(0, 1), m(0, 2)};
  const Vec3d b{m(1, 0), m(1, 1), m(1, 2)};
  const Vec3d c{m(2, 0), m(2, 1), m(2, 2)};
  return Vec3d{dot(cross(b, c), n), dot(cross(c, a), n), dot(cross(a, b), n)} * (1 / determinant(m));
}

Vec3d unit(const Vec3d& v) {
  const double size = std::sqrt(dot(v, v));
  return size > 0 ? v * (1 / size) : v;
}

/// Moeller-Trumbore without the inside test: parameter and weights. False where the ray is parallel to the plane.
bool meet_plane(const World::Ray& ray, const Vec3d& a, const Vec3d& b, const Vec3d& c, Hit& hit) {
  const Vec3d ab = b - a;
  const Vec3d ac = c - a;
  const Vec3d p = cross(ray.direction, ac);
  const double determinant = dot(ab, p);
  if (determinant == 0) {
    return false;
  }
  const Vec3d s = ray.origin - a;
  const Vec3d q = cross(s, ab);
  const double v = dot(s, p) / determinant;
  const double w = dot(ray.direction, q) / determinant;
  hit.weights = {1 - v - w, v, w};
  hit.depth = dot(ac, q) / determinant;
  return true;
}

}  // namespace

World::World(const Scene& scene) : scene_(&scene) {
  const Camera& camera = scene.camera;
  if (!camera.eye || !camera.target || !camera.near || !camera.far) {
    throw std::runtime_error("the judge wants a camera that states eye, target, near and far");
  }
  eye_ = *camera.eye;
  forward_ = unit(*camera.target - eye_);
  right_ = unit(cross(forward_, camera.up.value_or(Vec3d{0, 1, 0})));
  up_ = cross(right_, forward_);
  half_height_ = camera.projection == Projection::perspective ? std::tan(camera.fov * kPi / 360) : *camera.height / 2;
  half_width_ = half_height_ * scene.image.width / scene.image.height;

  for (const Object& object : scene.objects) {
    Placed placed;
    placed.mesh = object.mesh.get();
    placed.is_mirrored = determinant(object.matrix) < 0;
    for (const Vec3f& p : placed.mesh->positions) {
      placed.positions.push_back(transform_point(object.matrix, vec_cast<double>(p)));
    }
    for (const Vec3f& n : placed.mesh->normals) {
      placed.normals.push_back(unit(transform_normal(object.matrix, unit(vec_cast<double>(n)))));
    }
    for (const auto& [a, b, c] : placed.mesh->triangles) {
      const auto corner = [&](std::uint32_t i) { return vec_cast<double>(placed.mesh->positions[i]); };
      placed.face_normals.push_back(unit(transform_normal(object.matrix, unit(cross(corner(b) - corner(a), corner(c) - corner(a))))));
    }
    for (const Vec3d& p : placed.positions) {
      placed.center = placed.center + p * (1 / static_cast<double>(placed.positions.size()));
    }
    for (const Vec3d& p : placed.positions) {
      placed.radius = std::max(placed.radius, length(p - placed.center) * 1.001);
    }
    objects_.push_back(std::move(placed));
  }
}

World::Ray World::ray(double x, double y) const {
  const double across = (2 * x / scene_->image.width - 1) * half_width_;
  const double upward = (1 - 2 * y / scene_->image.height) * half_height_;
  const Vec3d offset = right_ * across + up_ * upward;
  if (scene_->camera.projection == Projection::perspective) {
    return {eye_, forward_ + offset};
  }
  return {eye_ + offset, forward_};
}

Hit World::cast(double x, double y) const {
  const Ray ray = this->ray(x, y);
  Hit nearest;
  for (std::size_t o = 0; o < objects_.size(); ++o) {
    const Placed& placed = objects_[o];
    const Vec3d to_center = placed.center - ray.origin;
    const Vec3d off_axis = cross(to_center, ray.direction);
    if (dot(off_axis, off_axis) > placed.radius * placed.radius * dot(ray.direction, ray.direction)) {
      continue;  // the ray passes by the ball that holds the object
    }
    for (std::size_t t = 0; t < placed.mesh->triangles.size(); ++t) {
      const auto& [a, b, c] = placed.mesh->triangles[t];
      Hit hit{static_cast<int>(o), static_cast<int>(t), 0, {}};
      if (!meet_plane(ray, placed.positions[a], placed.positions[b], placed.positions[c], hit)) {
        continue;
      }
      const auto& [u, v, w] = hit.weights;
      if (u < 0 || v < 0 || w < 0 || hit.depth < *scene_->camera.near || hit.depth > *scene_->camera.far) {
        continue;
      }
      if (scene_->shading.cull != Culling::none && is_front(x, y, hit) == (scene_->shading.cull == Culling::front)) {
        continue;
      }
      if (nearest.object < 0 || hit.depth < nearest.depth) {
        nearest = hit;
      }
    }
  }
  return nearest;
}

Hit World::cast_at(double x, double y, int object, int triangle) const {
  const Placed& placed = this->object(object);
  const auto& [a, b, c] = placed.mesh->triangles[static_cast<std::size_t>(triangle)];
  Hit hit{object, triangle, 0, {}};
  return meet_plane(ray(x, y), placed.positions[a], placed.positions[b], placed.positions[c], hit) ? hit : Hit{};
}

std::vector<Hit> World::cast_all() const {
  std::vector<Hit> hits;
  for (int y = 0; y < scene_->image.height; ++y) {
    for (int x = 0; x < scene_->image.width; ++x) {
      hits.push_back(cast(x + 0.5, y + 0.5));
    }
  }
  return hits;
}

bool World::is_front(double x, double y, const Hit& hit) const {
  const Placed& placed = object(hit.object);
  const auto& [a, b, c] = placed.mesh->triangles[static_cast<std::size_t>(hit.triangle)];
  const Vec3d& p = placed.positions[a];
  const bool is_counter_clockwise = dot(cross(placed.positions[b] - p, placed.positions[c] - p), ray(x, y).direction) < 0;
  return is_counter_clockwise != placed.is_mirrored;
}

}  // namespace lustro::truth
