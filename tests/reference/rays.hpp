// Rays against every triangle of a scene: the slow and obvious truth about what hides what.
#pragma once

#include <cmath>
#include <vector>

#include "lustro/lustro.hpp"

namespace lustro {

struct Triangle {
  Vec3d a, b, c;
};

inline std::vector<Triangle> triangles_of(const Scene& scene) {
  std::vector<Triangle> all;
  for (const Object& object : scene.objects) {
    const Mat4& m = object.matrix;
    const auto place = [&](const Vec3f& v) {
      const Vec3d p = vec_cast<double>(v);
      const auto row = [&](int i) { return m(i, 0) * p.x + m(i, 1) * p.y + m(i, 2) * p.z + m(i, 3); };
      return Vec3d{row(0), row(1), row(2)};
    };
    for (const auto& t : object.mesh->triangles) {
      all.push_back({place(object.mesh->positions[t[0]]), place(object.mesh->positions[t[1]]), place(object.mesh->positions[t[2]])});
    }
  }
  return all;
}

// Moeller and Trumbore 1997: how far along the way the triangle is hit, or a negative number.
inline double hit(const Triangle& t, const Vec3d& from, const Vec3d& way) {
  const Vec3d ab = t.b - t.a;
  const Vec3d ac = t.c - t.a;
  const Vec3d p = cross(way, ac);
  const double determinant = dot(ab, p);
  if (std::abs(determinant) < 1e-14) {
    return -1;
  }
  const Vec3d s = from - t.a;
  const double u = dot(s, p) / determinant;
  const Vec3d q = cross(s, ab);
  const double v = dot(way, q) / determinant;
  return u < 0 || v < 0 || u + v > 1 ? -1 : dot(ac, q) / determinant;
}

}  // namespace lustro
