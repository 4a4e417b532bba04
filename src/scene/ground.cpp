// See ground.hpp.
#include "scene/ground.hpp"

#include <algorithm>
#include <memory>

namespace lustro {
namespace {

constexpr double kReach = 8;  // diagonals of the scene's box: the shadow of what is as high ends there, under a sun of 7 degrees

std::shared_ptr<const Mesh> make_square() {
  Mesh mesh;
  mesh.positions = {{-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}};
  mesh.normals.assign(4, {0, 1, 0});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return std::make_shared<const Mesh>(std::move(mesh));
}

}  // namespace

bool catches_shadows(const Material& material) {
  constexpr int kShadowCatcher = 10;
  return material.illumination == kShadowCatcher;
}

Object make_ground(const GroundSettings& settings, const Camera& camera, const Bounds& bounds, View& view) {
  static const std::shared_ptr<const Mesh> square = make_square();  // one for all, so that what is worked out about it is kept
  const Vec3d middle = (bounds.lower + bounds.upper) * 0.5;
  const double diagonal = length(bounds.upper - bounds.lower);
  const double reach = kReach * (diagonal > 0 ? diagonal : 1);
  const double height = settings.height.value_or(bounds.lower.y);
  Object ground;
  ground.name = "ground";
  ground.mesh = square;
  ground.material.emplace();
  ground.material->name = "ground";
  ground.material->illumination = 10;
  ground.material->opacity = settings.strength;
  ground.material->cull = Culling::back;
  ground.matrix.m = {reach, 0, 0, middle.x, 0, 1, 0, height, 0, 0, reach, middle.z, 0, 0, 0, 1};
  double nearest = view.near;
  double farthest = view.far;
  for (const double x : {-reach, reach}) {
    for (const double z : {-reach, reach}) {
      const double depth = dot(Vec3d{middle.x + x, height, middle.z + z} - view.eye, view.forward);
      nearest = std::min(nearest, depth);
      farthest = std::max(farthest, depth);
    }
  }
  if (!camera.far) {
    view.far = farthest;
  }
  if (!camera.near) {
    view.near = view.projection == Projection::perspective ? std::max(nearest, 1e-5 * view.far) : nearest;
  }
  complete_view(view);
  return ground;
}

}  // namespace lustro
