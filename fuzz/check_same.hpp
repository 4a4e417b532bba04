// That two ways through a file end in the same place.
#pragma once

#include <cstdlib>
#include <cstring>
#include <type_traits>
#include <vector>

#include "lustro/mesh.hpp"

namespace lustro {

inline bool same_value(float a, float b) {
  return std::memcmp(&a, &b, sizeof a) == 0 || (a != a && b != b);  // the bits of a NaN may change on the way through double
}
inline bool same_value(std::uint32_t a, std::uint32_t b) {
  return a == b;
}
inline bool same_value(const Vec2f& a, const Vec2f& b) {
  return same_value(a.x, b.x) && same_value(a.y, b.y);
}
inline bool same_value(const Vec3f& a, const Vec3f& b) {
  return same_value(a.x, b.x) && same_value(a.y, b.y) && same_value(a.z, b.z);
}

template <class T>
bool same_values(const std::vector<T>& a, const std::vector<T>& b) {
  bool is_same = a.size() == b.size();
  for (std::size_t i = 0; is_same && i < a.size(); ++i) {
    is_same = same_value(a[i], b[i]);
  }
  return is_same;
}

inline void check_same(const Result<SourceMesh>& a, const Result<SourceMesh>& b) {
  if (a.has_value() != b.has_value() || (!a && (a.error().text() != b.error().text() || a.error().kind != b.error().kind))) {
    std::abort();
  }
  if (a && !(same_values(a->positions, b->positions) && same_values(a->normals, b->normals) && same_values(a->uvs, b->uvs) &&
             same_values(a->colors, b->colors) && same_values(a->face_colors, b->face_colors) && same_values(a->face_begin, b->face_begin) &&
             same_values(a->corner_position, b->corner_position) && same_values(a->corner_normal, b->corner_normal) &&
             same_values(a->corner_uv, b->corner_uv) && same_values(a->face_smoothing, b->face_smoothing) &&
             same_values(a->face_material, b->face_material) && same_values(a->face_object, b->face_object) &&
             a->materials.size() == b->materials.size() && a->objects == b->objects && a->format == b->format && a->notes == b->notes)) {
    std::abort();
  }
}

}  // namespace lustro
