// Whether two meshes are the same, bit by bit: what is promised for any way to a mesh and for any number of threads.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "lustro/mesh.hpp"

namespace lustro {

template <class T>
void expect_same_bits(const std::vector<T>& a, const std::vector<T>& b, const char* what) {
  static_assert(std::is_trivially_copyable_v<T>);
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(std::memcmp(&a[i], &b[i], sizeof(T)), 0) << what << '[' << i << ']';
  }
}

inline std::vector<std::string> texts_of(const Notes& notes) {
  std::vector<std::string> texts;
  for (const Note& note : notes) {
    texts.push_back(note.text());
  }
  return texts;
}

inline std::vector<std::string> names_of(const std::vector<Material>& materials) {
  std::vector<std::string> names;
  for (const Material& material : materials) {
    names.push_back(material.name);
  }
  return names;
}

inline void expect_same(const Mesh& a, const Mesh& b) {
  expect_same_bits(a.positions, b.positions, "positions");
  expect_same_bits(a.normals, b.normals, "normals");
  expect_same_bits(a.uvs, b.uvs, "uvs");
  expect_same_bits(a.colors, b.colors, "colors");
  expect_same_bits(a.triangles, b.triangles, "triangles");
  expect_same_bits(a.triangle_material, b.triangle_material, "triangle_material");
  EXPECT_EQ(names_of(a.materials), names_of(b.materials));
}

inline void expect_same(const BuiltMesh& a, const BuiltMesh& b) {
  expect_same(a.mesh, b.mesh);
  EXPECT_EQ(texts_of(a.notes), texts_of(b.notes));
}

/// NaNs are one value: on the way through double their bits may change.
inline void expect_same_values(const std::vector<Vec3f>& a, const std::vector<Vec3f>& b, const char* what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  const auto same = [](float x, float y) { return std::memcmp(&x, &y, sizeof x) == 0 || (x != x && y != y); };
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_TRUE(same(a[i].x, b[i].x) && same(a[i].y, b[i].y) && same(a[i].z, b[i].z)) << what << '[' << i << ']';
  }
}

inline void expect_same(const SourceMesh& a, const SourceMesh& b) {
  expect_same_values(a.positions, b.positions, "positions");
  expect_same_values(a.normals, b.normals, "normals");
  ASSERT_EQ(a.uvs.size(), b.uvs.size());
  for (std::size_t i = 0; i < a.uvs.size(); ++i) {
    expect_same_values({{a.uvs[i].x, a.uvs[i].y, 0}}, {{b.uvs[i].x, b.uvs[i].y, 0}}, "uvs");
  }
  expect_same_values(a.colors, b.colors, "colors");
  expect_same_values(a.face_colors, b.face_colors, "face_colors");
  expect_same_bits(a.face_begin, b.face_begin, "face_begin");
  expect_same_bits(a.corner_position, b.corner_position, "corner_position");
  expect_same_bits(a.corner_normal, b.corner_normal, "corner_normal");
  expect_same_bits(a.corner_uv, b.corner_uv, "corner_uv");
  expect_same_bits(a.face_smoothing, b.face_smoothing, "face_smoothing");
  expect_same_bits(a.face_material, b.face_material, "face_material");
  expect_same_bits(a.face_object, b.face_object, "face_object");
  EXPECT_EQ(names_of(a.materials), names_of(b.materials));
  EXPECT_EQ(a.objects, b.objects);
  EXPECT_EQ(a.format, b.format);
  EXPECT_EQ(a.weld_first, b.weld_first);
  EXPECT_EQ(texts_of(a.notes), texts_of(b.notes));
}

/// Both are the same mesh, or the same error.
inline void expect_same(const Result<SourceMesh>& a, const Result<SourceMesh>& b) {
  ASSERT_EQ(a.has_value(), b.has_value()) << (a ? b.error().text() : a.error().text());
  if (a) {
    expect_same(*a, *b);
  } else {
    EXPECT_EQ(a.error().text(), b.error().text());
    EXPECT_EQ(a.error().kind, b.error().kind);
  }
}

}  // namespace lustro
