// From sources to meshes: what becomes a vertex, a triangle, a note.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>

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

TEST(BuildMesh, NormalsOfTheFileWinUnlessRecomputed) {
  SourceMesh source = polygons({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  source.normals = {{0, 3, 4}, {2, 0, 0}};
  source.corner_normal = {0, 1, SourceMesh::kNone, 0};
  const Mesh mesh = build(source).mesh;
  EXPECT_THAT(mesh.normals, ElementsAre(Vec3f{0, 0.6F, 0.8F}, Vec3f{1, 0, 0}, Vec3f{0, 0, 1}, Vec3f{0, 0.6F, 0.8F}));
  EXPECT_THAT(build(source, {.recompute = true}).mesh.normals, testing::Each(Vec3f{0, 0, 1}));
}

TEST(BuildMesh, AVertexIsDoubledExactlyWhereAttributesDiffer) {
  SourceMesh source = polygons({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_THAT(build(source).mesh.positions, SizeIs(4));
  source.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {0.5F, 0.5F}};
  source.corner_uv = {0, 1, 2, 4, 5, 3};  // position 0 by another index to equal values, position 2 by another value
  const Mesh mesh = build(source).mesh;
  EXPECT_THAT(mesh.uvs, ElementsAre(Vec2f{0, 0}, Vec2f{1, 0}, Vec2f{1, 1}, Vec2f{0.5F, 0.5F}, Vec2f{0, 1}));
  using Triangle = std::array<std::uint32_t, 3>;
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 3, 4}));
  source.corner_uv[1] = SourceMesh::kNone;
  EXPECT_EQ(build(source).mesh.uvs[1], (Vec2f{0, 0}));
}

TEST(BuildMesh, ManyVariantsOfOnePositionTakeLinearTime) {
  constexpr std::uint32_t kFaces = 300000;
  SourceMesh source;
  source.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (std::uint32_t f = 0; f < kFaces; ++f) {
    source.corner_position.insert(source.corner_position.end(), {0, 1, 2});
    source.face_begin.push_back(3 * f + 3);
    source.uvs.push_back({static_cast<float>(f), 0});
    source.corner_uv.insert(source.corner_uv.end(), {f, f, f});
  }
  EXPECT_THAT(build(source).mesh.positions, SizeIs(3 * kFaces));
  for (Vec2f& uv : source.uvs) {
    uv.x = 1;
  }
  EXPECT_THAT(build(source).mesh.positions, SizeIs(3));
}

TEST(BuildMesh, ColoursOfVerticesStayAndThoseOfFacesDoubleVertices) {
  SourceMesh source = polygons({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  source.colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
  EXPECT_THAT(build(source).mesh.colors, ElementsAre(Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}, Vec3f{1, 1, 0}));
  source.face_colors = {{0.5F, 0, 0}, {0, 0.5F, 0}};
  const BuiltMesh both = build(source);
  EXPECT_THAT(both.mesh.colors,
              ElementsAre(Vec3f{0.5F, 0, 0}, Vec3f{0.5F, 0, 0}, Vec3f{0.5F, 0, 0}, Vec3f{0, 0.5F, 0}, Vec3f{0, 0.5F, 0}, Vec3f{0, 0.5F, 0}));
  EXPECT_TRUE(has_note(both.notes, "those of the faces are used"));
  source.colors.clear();
  EXPECT_EQ(build(source).mesh.colors, both.mesh.colors);
  EXPECT_THAT(build(source).notes, IsEmpty());
}

TEST(BuildMesh, FacesWithoutAMaterialGetTheDefaultOneAppendedOnce) {
  SourceMesh source = cube_of_quads();
  source.materials.resize(2);
  source.materials[0].name = "a";
  source.materials[1].name = "b";
  constexpr std::uint32_t kNone = SourceMesh::kNone;
  source.face_material = {1, kNone, 0, 0, kNone, 1};
  const Mesh mesh = build(source).mesh;
  ASSERT_THAT(mesh.materials, SizeIs(3));
  EXPECT_EQ(mesh.materials[0].name, "a");
  EXPECT_EQ(mesh.materials[2].name, "default");
  EXPECT_EQ(mesh.materials[2].diffuse, Material{}.diffuse);
  EXPECT_THAT(mesh.triangle_material, ElementsAre(1, 1, 2, 2, 0, 0, 0, 0, 2, 2, 1, 1));
}

TEST(BuildMesh, MaterialsThatNobodyUsesOrThatAllShareCostNothing) {
  SourceMesh source = cube_of_quads();
  source.materials.resize(2);
  EXPECT_THAT(build(source).mesh.materials, IsEmpty());  // the default material
  source.face_material.assign(6, SourceMesh::kNone);
  EXPECT_THAT(build(source).mesh.materials, IsEmpty());
  EXPECT_THAT(build(source).mesh.triangle_material, IsEmpty());
  source.face_material.assign(6, 0);
  EXPECT_THAT(build(source).mesh.materials, SizeIs(2));
  EXPECT_THAT(build(source).mesh.triangle_material, IsEmpty());  // all 0
  source.face_material.assign(6, 1);
  EXPECT_THAT(build(source).mesh.triangle_material, SizeIs(12));
}

TEST(BuildMesh, TrianglesWithoutAreaAreDroppedWithOneNote) {
  SourceMesh source = polygons({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 1, 0}, {1, 1, 1}, {2, 2, 2}},
                               {{0, 1, 2}, {0, 1, 4}, {0, 2, 3}, {0, 5, 6}, {0, 1, 2, 3}});
  source.materials.resize(5);
  source.face_material = {0, 1, 2, 3, 4};
  const BuiltMesh built = build(source);
  EXPECT_THAT(built.mesh.triangles, SizeIs(1));
  EXPECT_THAT(built.mesh.positions, SizeIs(3));
  EXPECT_THAT(built.mesh.triangle_material, ElementsAre(1));
  EXPECT_THAT(built.notes, ElementsAre(Note{"", "5 triangles without area: dropped"}));
}

TEST(BuildMesh, EveryKindOfDamageIsNotedOnceWithItsCount) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  SourceMesh source = polygons({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {nan, 0, 0}, {2, 0, 0}},
                               {{0, 1, 2}, {0, 1, 4}, {1, 2, 4}, {0, 1}, {0, 1, 5}, {0, 1, 1, 2, 3}, {0, 2, 1, 3}});
  source.colors.assign(6, {nan, nan, nan});
  const BuiltMesh built = build(source);
  EXPECT_THAT(
      built.notes,
      ElementsAre(Note{"", "6 colours not finite: white instead"}, Note{"", "2 faces with a position that is not finite: dropped"},
                  Note{"", "1 face with fewer than three distinct corners: dropped"},
                  Note{"", "1 corner at the place of the corner before: dropped"},
                  Note{"", "1 polygon that crosses itself: cut into triangles that overlap"}, Note{"", "1 triangle without area: dropped"}));
  for (const Vec3f& color : built.mesh.colors) {
    EXPECT_EQ(color, (Vec3f{1, 1, 1}));
  }
}

/// Every facet with positions of its own, as STL has them.
SourceMesh as_facets(const SourceMesh& source) {
  SourceMesh facets;
  facets.weld_first = true;
  for (const std::uint32_t position : source.corner_position) {
    facets.corner_position.push_back(static_cast<std::uint32_t>(facets.positions.size()));
    facets.positions.push_back(source.positions[position]);
  }
  facets.face_begin = source.face_begin;
  return facets;
}

TEST(BuildMesh, FacetsAreWeldedBeforeNormalsAreMade) {
  for (const double crease : {180.0, 40.0}) {
    const Mesh indexed = build(cube_of_triangles(), {.crease_deg = crease}).mesh;
    SourceMesh facets = as_facets(cube_of_triangles());
    const Mesh welded = build(facets, {.crease_deg = crease}).mesh;
    EXPECT_EQ(welded.positions, indexed.positions);
    EXPECT_EQ(welded.normals, indexed.normals);
    EXPECT_EQ(welded.triangles, indexed.triangles);
    facets.weld_first = false;
    EXPECT_THAT(build(facets, {.crease_deg = crease}).mesh.positions, SizeIs(36));
  }
}

TEST(BuildMesh, ColoursOfWeldedPositionsStayApart) {
  SourceMesh facets = as_facets(polygons({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5F}}, {{0, 1, 2}, {0, 2, 3}}));
  facets.colors = {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}};
  const Mesh mesh = build(facets).mesh;
  EXPECT_THAT(mesh.positions, SizeIs(5));  // position 2 has two colours
  EXPECT_EQ(mesh.normals[2], mesh.normals[3]);
  EXPECT_THAT(mesh.colors, ElementsAre(Vec3f{1, 0, 0}, Vec3f{1, 0, 0}, Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 1, 0}));
}

TEST(BuildMesh, RefusesWhatDoesNotFitTogether) {
  SourceMesh source = cube_of_quads();
  source.corner_position[3] = 8;
  const auto built = build_mesh(source);
  ASSERT_FALSE(built.has_value());
  EXPECT_EQ(built.error().kind, ErrorKind::malformed);
  for (const double crease : {-1.0, 180.5, std::nan("")}) {
    EXPECT_EQ(build_mesh(cube_of_quads(), {.crease_deg = crease}).error().kind, ErrorKind::usage);
  }
}

TEST(BuildMesh, RandomSourcesNeverBreakTheMesh) {
  std::mt19937 engine(21);
  const auto random = [&] { return static_cast<std::uint32_t>(engine()); };
  for (int round = 0; round < 500; ++round) {
    SourceMesh source;
    const std::uint32_t positions = 1 + random() % 12;
    for (std::uint32_t i = 0; i < positions; ++i) {
      const auto coordinate = [&] {
        const auto kind = random() % 40;
        return kind == 0 ? std::numeric_limits<float>::infinity() : kind == 1 ? 3e38F : kind == 2 ? 1e-40F : static_cast<float>(random() % 4);
      };
      source.positions.push_back({coordinate(), coordinate(), coordinate()});
    }
    for (std::uint32_t f = random() % 12; f > 0; --f) {
      for (std::uint32_t c = random() % 9; c > 0; --c) {
        source.corner_position.push_back(random() % positions);
      }
      source.face_begin.push_back(static_cast<std::uint32_t>(source.corner_position.size()));
      source.face_smoothing.push_back(random() % 3);
    }
    source.weld_first = random() % 2 != 0;
    if (random() % 2 != 0) {
      source.face_smoothing.clear();
    }
    const NormalOptions options{.weights = static_cast<VertexNormals>(random() % 3), .crease_deg = random() % 2 != 0 ? 180.0 : 45.0};
    const Mesh mesh = build(source, options).mesh;
    EXPECT_LE(mesh.triangles.size(), source.stated_triangle_count());
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    std::vector<bool> used(mesh.positions.size(), false);
    for (const auto& t : mesh.triangles) {
      for (const std::uint32_t v : t) {
        ASSERT_LT(v, mesh.positions.size());
        used[v] = true;
        EXPECT_TRUE(is_finite(mesh.positions[v]));
        EXPECT_NEAR(length(mesh.normals[v]), 1, 1e-6);
      }
    }
    EXPECT_THAT(used, testing::Each(true));
  }
}

TEST(BuildMesh, AMillionTrianglesTakeASecondOrSo) {  // the time is printed, not asserted
  constexpr std::uint32_t kSide = 708;
  SourceMesh source;
  for (std::uint32_t y = 0; y <= kSide; ++y) {
    for (std::uint32_t x = 0; x <= kSide; ++x) {
      source.positions.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(x * y % 17) * 0.1F});
    }
  }
  for (std::uint32_t y = 0; y < kSide; ++y) {
    for (std::uint32_t x = 0; x < kSide; ++x) {
      const std::uint32_t a = y * (kSide + 1) + x;
      source.corner_position.insert(source.corner_position.end(), {a, a + 1, a + kSide + 2, a, a + kSide + 2, a + kSide + 1});
      const auto end = static_cast<std::uint32_t>(source.corner_position.size());
      source.face_begin.insert(source.face_begin.end(), {end - 3, end});
    }
  }
  for (const double crease : {180.0, 5.0}) {
    for (const bool facets : {false, true}) {
      const SourceMesh& input = facets ? as_facets(source) : source;
      const auto begin = std::chrono::steady_clock::now();
      const Mesh mesh = build(input, {.crease_deg = crease}).mesh;
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
      std::cout << mesh.triangles.size() << " triangles, crease " << crease << (facets ? ", welded: " : ": ") << seconds.count() << " s\n";
      EXPECT_THAT(mesh.triangles, SizeIs(2 * kSide * kSide));
    }
  }
}

TEST(BuildMesh, NothingIsNotAnError) {
  const BuiltMesh built = build(SourceMesh{});
  EXPECT_THAT(built.mesh.triangles, IsEmpty());
  EXPECT_THAT(built.mesh.positions, IsEmpty());
  EXPECT_THAT(built.notes, IsEmpty());
}

}  // namespace
}  // namespace lustro
