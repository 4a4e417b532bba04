// Short words for tests of parsers: a text's mesh, its error, its notes.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lustro/mesh.hpp"
#include "lustro/result.hpp"

namespace lustro {

/// The value, or a failed test that shows the error.
template <class T>
T good(Result<T> result) {
  if (!result) {
    ADD_FAILURE() << result.error().text();
    return T{};
  }
  return std::move(*result);
}

/// The error's text, or a failed test.
template <class T>
Error bad(const Result<T>& result) {
  if (result) {
    ADD_FAILURE() << "expected an error";
    return {};
  }
  return result.error();
}

inline std::vector<std::string> texts(const Notes& notes) {
  std::vector<std::string> out;
  for (const Note& note : notes) {
    out.push_back(note.text());
  }
  return out;
}

/// That every array of a mesh fits the others and every index its array: what each parser promises for any input.
inline void expect_consistent(const SourceMesh& mesh) {
  const std::size_t faces = mesh.face_count();
  const std::size_t corners = mesh.corner_position.size();
  ASSERT_FALSE(mesh.face_begin.empty());
  EXPECT_EQ(mesh.face_begin.front(), 0U);
  EXPECT_EQ(mesh.face_begin.back(), corners);
  for (std::size_t f = 0; f < faces; ++f) {
    ASSERT_GE(mesh.face_begin[f + 1], mesh.face_begin[f] + 3);
  }
  const auto expect_inside = [](const std::vector<std::uint32_t>& indices, std::size_t count, bool may_be_none) {
    for (const std::uint32_t index : indices) {
      ASSERT_TRUE(index < count || (may_be_none && index == SourceMesh::kNone)) << index << " of " << count;
    }
  };
  for (const auto* per_corner : {&mesh.corner_uv, &mesh.corner_normal}) {
    EXPECT_TRUE(per_corner->empty() || per_corner->size() == corners);
  }
  for (const auto* per_face : {&mesh.face_smoothing, &mesh.face_material, &mesh.face_object}) {
    EXPECT_TRUE(per_face->empty() || per_face->size() == faces);
  }
  expect_inside(mesh.corner_position, mesh.positions.size(), false);
  expect_inside(mesh.corner_uv, mesh.uvs.size(), true);
  expect_inside(mesh.corner_normal, mesh.normals.size(), true);
  expect_inside(mesh.face_material, mesh.materials.size(), true);
  expect_inside(mesh.face_object, mesh.objects.size(), false);
  EXPECT_TRUE(mesh.colors.empty() || mesh.colors.size() == mesh.positions.size());
  EXPECT_TRUE(mesh.face_colors.empty() || mesh.face_colors.size() == faces);
  for (const auto* colors : {&mesh.colors, &mesh.face_colors}) {
    for (const Vec3f& c : *colors) {
      ASSERT_TRUE(c.x >= 0 && c.x <= 1 && c.y >= 0 && c.y <= 1 && c.z >= 0 && c.z <= 1);
    }
  }
}

}  // namespace lustro
