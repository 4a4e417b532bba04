// From sources to meshes: what becomes a vertex, a triangle, a note.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <iostream>

#include "lustro/mesh.hpp"
#include "mesh/shapes.hpp"

namespace lustro {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

BuiltMesh build(const SourceMesh& source, const NormalOptions& options = {}) {
  auto built = build_mesh(source, options);
  EXPECT_TRUE(built.has_value()) << built.error().text();
  return built ? *built : BuiltMesh{};
}

TEST(BuildMesh, ACubeThatIsSmoothHasEightVerticesWithNormalsAlongTheDiagonals) {
  for (const auto weights : {VertexNormals::uniform, VertexNormals::area, VertexNormals::angle}) {
    const BuiltMesh built = build(cube_of_quads(), {.weights = weights});
    EXPECT_THAT(built.mesh.triangles, SizeIs(12));
    EXPECT_THAT(built.notes, IsEmpty());
    ASSERT_THAT(built.mesh.positions, SizeIs(8));
    for (std::size_t v = 0; v < 8; ++v) {
      const Vec3f expected = built.mesh.positions[v] * static_cast<float>(1 / std::sqrt(3.0));
      EXPECT_EQ(built.mesh.normals[v], expected) << v;
    }
  }
}

TEST(BuildMesh, ACubeWithACreaseHasTwentyFourVerticesWithTheNormalsOfItsFaces) {
  for (const double crease : {0.0, 30.0, 89.9}) {
    for (const SourceMesh& source : {cube_of_quads(), cube_of_triangles()}) {
      const Mesh mesh = build(source, {.crease_deg = crease}).mesh;
      EXPECT_THAT(mesh.triangles, SizeIs(12));
      ASSERT_THAT(mesh.positions, SizeIs(24)) << crease;
      for (const auto& t : mesh.triangles) {
        const Vec3f face = normalize(cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]));
        for (const std::uint32_t v : t) {
          EXPECT_EQ(mesh.normals[v], face);
        }
      }
    }
  }
}

TEST(BuildMesh, FacesThatMeetAtExactlyTheCreaseAngleShare) {
  EXPECT_THAT(build(cube_of_quads(), {.crease_deg = 90}).mesh.positions, SizeIs(8));
}

TEST(BuildMesh, AnglesOfATriangulatedCubeGiveTheDiagonalWhereUniformWeightsDoNot) {
  const Mesh angle = build(cube_of_triangles(), {.weights = VertexNormals::angle}).mesh;
  const Mesh uniform = build(cube_of_triangles(), {.weights = VertexNormals::uniform}).mesh;
  bool uniform_is_off = false;
  for (std::size_t v = 0; v < 8; ++v) {
    const Vec3f diagonal = angle.positions[v] * static_cast<float>(1 / std::sqrt(3.0));
    EXPECT_NEAR(length(angle.normals[v] - diagonal), 0, 1e-7);
    uniform_is_off = uniform_is_off || length(uniform.normals[v] - diagonal) > 0.1F;
  }
  EXPECT_TRUE(uniform_is_off);
}

TEST(BuildMesh, VerticesStandInTheOrderOfTheCornersThatNeedThemFirst) {
  const Mesh mesh = build(polygons({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{3, 4, 1, 2}})).mesh;  // position 0 is not used
  EXPECT_THAT(mesh.positions, ElementsAre(Vec3f{1, 1, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 0}, Vec3f{1, 0, 0}));
  using Triangle = std::array<std::uint32_t, 3>;
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
}

TEST(BuildMesh, NothingIsNotAnError) {
  const BuiltMesh built = build(SourceMesh{});
  EXPECT_THAT(built.mesh.triangles, IsEmpty());
  EXPECT_THAT(built.mesh.positions, IsEmpty());
  EXPECT_THAT(built.notes, IsEmpty());
}

}  // namespace
}  // namespace lustro
