// One triangle in its place: what its vertices say, and what lies between them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "reference/triangle.hpp"
#include "scene/prepare.hpp"
#include "shade/interpolation.hpp"

namespace lustro {

/// One triangle of a mesh with all that its shading asks for.
struct Face {
  const PreparedScene& scene;
  const Instance& instance;
  const ShadingMaterial& material;
  std::array<std::uint32_t, 3> vertices;
  float side;  // -1 where the back is seen and lit with its normals turned round

  // What the mesh states of a vertex.
  [[nodiscard]] Vec3f stated_position(std::size_t i) const { return instance.mesh->positions[vertices[i]]; }
  [[nodiscard]] Vec3f stated_normal(std::size_t i) const { return instance.mesh->normals[vertices[i]]; }
  [[nodiscard]] std::array<float, 4> stated_tangent(std::size_t i) const { return instance.mesh->tangents[vertices[i]]; }
  [[nodiscard]] Vec2f stated_uv(std::size_t set, std::size_t i) const {
    return (set == 0 ? instance.mesh->uvs : instance.mesh->uvs1)[vertices[i]];
  }

  [[nodiscard]] float stated_alpha(std::size_t i) const { return instance.mesh->alphas[vertices[i]]; }

  [[nodiscard]] Vec3f position(std::size_t i) const { return instance.relative_from_object(stated_position(i)); }

  // A vertex's normal, world.
  [[nodiscard]] Vec3f normal(std::size_t i) const {
    const Vec3f n = instance.normal_from_object(stated_normal(i));
    return (instance.is_similarity ? n : normalize(n)) * side;
  }

  // A similarity turns all normals alike, so that they are interpolated as the mesh has them and turned once.
  [[nodiscard]] Vec3f normal_at(NormalInterpolation mode, const Vec3f& w) const {
    const Weights<float> weights{w.x, w.y, w.z};
    if (!instance.is_similarity) {
      return interpolate_normal<float>(mode, {normal(0), normal(1), normal(2)}, weights, face_normal());
    }
    return instance.normal_from_object(
               interpolate_normal<float>(mode, {stated_normal(0), stated_normal(1), stated_normal(2)}, weights, normalize(object_normal()))) *
           side;
  }

  // The face's normal of any length, from the object's own coordinates, where edges have all their digits; scaled, so that tiny faces do not
  // underflow.
  [[nodiscard]] Vec3f object_normal() const {
    const Vec3f a = stated_position(0);
    const Vec3f ab = stated_position(1) - a;
    const Vec3f ac = stated_position(2) - a;
    const float size = std::max({std::abs(ab.x), std::abs(ab.y), std::abs(ab.z), std::abs(ac.x), std::abs(ac.y), std::abs(ac.z)});
    const float scale = 1.0F / size;
    return cross(ab * scale, ac * scale);
  }
  [[nodiscard]] Vec3f face_normal() const { return normalize(instance.normal_from_object(object_normal())) * side; }

  // Vertex colours multiply the ambient and the diffuse coefficient.
  [[nodiscard]] Vec3f tint(const Vec3f& w) const {
    if (instance.drawable->colors.empty()) {
      return {1, 1, 1};
    }
    return weighted_sum<float>(
        {instance.drawable->colors[vertices[0]], instance.drawable->colors[vertices[1]], instance.drawable->colors[vertices[2]]},
        {w.x, w.y, w.z});
  }
};

/// The face that a triangle on the image shows.
[[nodiscard]] inline Face face_of(const PreparedScene& scene, const ScreenTriangle& t) {
  const Instance& instance = scene.instances[t.instance];
  const std::uint32_t triangle = t.id - instance.first_triangle;
  return {scene, instance, scene.materials[instance.material_of(triangle)], instance.mesh->triangles[triangle],
          scene.shading.two_sided && !t.is_front ? -1.0F : 1.0F};
}

}  // namespace lustro
