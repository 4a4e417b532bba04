// A mesh without normals has only the vertices that differ in something else.
#include "mesh/drop_normals.hpp"

#include <gmock/gmock.h>

namespace lustro {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(DropNormals, ACubeHasEightCorners) {
  Mesh cube = build_mesh(*make_primitive("cube"), {.crease_deg = 30}).value().mesh;
  cube.uvs.clear();
  ASSERT_EQ(cube.positions.size(), 24U);
  const std::vector<std::array<std::uint32_t, 3>> before = cube.triangles;
  const std::vector<Vec3f> positions = cube.positions;
  drop_normals(cube);
  EXPECT_EQ(cube.positions.size(), 8U);
  EXPECT_THAT(cube.normals, IsEmpty());
  for (std::size_t t = 0; t < before.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(cube.positions[cube.triangles[t][i]], positions[before[t][i]]);
    }
  }
}

TEST(DropNormals, VerticesThatDifferInAnythingElseStayApart) {
  Mesh mesh;
  mesh.positions.assign(6, Vec3f{1, 2, 3});
  mesh.uvs = {{0, 0}, {1, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}};
  mesh.colors = {{1, 1, 1}, {1, 1, 1}, {0, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  mesh.alphas = {1, 1, 1, 0, 1, 1};
  mesh.uvs1 = {{0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 5}, {0, 0}};
  mesh.triangles = {{3, 4, 5}, {0, 1, 2}};
  drop_normals(mesh);
  EXPECT_THAT(mesh.triangles, ElementsAre(std::array<std::uint32_t, 3>{0, 1, 2}, std::array<std::uint32_t, 3>{2, 3, 4}));
  EXPECT_THAT(mesh.alphas, ElementsAre(0, 1, 1, 1, 1));
  EXPECT_THAT(mesh.uvs1, ElementsAre(Vec2f{0, 0}, Vec2f{0, 5}, Vec2f{0, 0}, Vec2f{0, 0}, Vec2f{0, 0}));
}

}  // namespace
}  // namespace lustro
