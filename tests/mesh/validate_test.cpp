// What validate() refuses, repairs and drops.
#include "mesh/validate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "mesh/shapes.hpp"

namespace lustro {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::uint32_t kNone = SourceMesh::kNone;

ValidMesh valid(const SourceMesh& source) {
  auto result = validate(source);
  EXPECT_TRUE(result.has_value()) << result.error().text();
  return result ? *result : ValidMesh{};
}

SourceMesh two_triangles() {
  return polygons({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
}

TEST(Validate, ASoundSourceIsNotTouched) {
  const ValidMesh mesh = valid(cube_of_quads());
  EXPECT_EQ(mesh.source.corner_position, cube_of_quads().corner_position);
  EXPECT_EQ(mesh.source.face_begin, cube_of_quads().face_begin);
  EXPECT_EQ(mesh.source.positions, cube_of_quads().positions);
  EXPECT_THAT(mesh.notes, IsEmpty());
}

TEST(Validate, ArraysThatDoNotFitAreMalformedAndTheMessageNamesThem) {
  struct Case {
    const char* message;
    std::function<void(SourceMesh&)> spoil;
  };
  const std::vector<Case> cases{
      {"face_begin does not begin with 0", [](SourceMesh& s) { s.face_begin = {}; }},
      {"face_begin does not begin with 0",
       [](SourceMesh& s) {
         s.face_begin = {1, 3, 6};
       }},
      {"face_begin[2] is 2, smaller than the 3 before it",
       [](SourceMesh& s) {
         s.face_begin = {0, 3, 2, 6};
       }},
      {"face_begin ends with 5, but there are 6 corners",
       [](SourceMesh& s) {
         s.face_begin = {0, 3, 5};
       }},
      {"corner_position[4] is 4, expected an index below 4, the number of positions", [](SourceMesh& s) { s.corner_position[4] = 4; }},
      {"corner_position[0] is 4294967295, expected an index below 4, the number of positions",
       [](SourceMesh& s) { s.corner_position[0] = kNone; }},
      {"corner_normal[1] is 7, expected an index below 1, the number of normals",
       [](SourceMesh& s) {
         s.normals = {{0, 0, 1}}, s.corner_normal = {0, 7, 0, 0, 0, 0};
       }},
      {"corner_normal has 5 entries, expected one for each of the 6 corners", [](SourceMesh& s) { s.corner_normal.assign(5, kNone); }},
      {"corner_uv[2] is 0, expected an index below 0, the number of texture coordinates",
       [](SourceMesh& s) { s.corner_uv = {kNone, kNone, 0, kNone, kNone, kNone}; }},
      {"corner_uv has 7 entries", [](SourceMesh& s) { s.corner_uv.assign(7, kNone); }},
      {"colors has 3 entries, expected one for each of the 4 positions", [](SourceMesh& s) { s.colors.resize(3); }},
      {"face_colors has 1 entries, expected one for each of the 2 faces", [](SourceMesh& s) { s.face_colors.resize(1); }},
      {"face_smoothing has 3 entries", [](SourceMesh& s) { s.face_smoothing.resize(3); }},
      {"face_material has 4 entries", [](SourceMesh& s) { s.face_material.resize(4); }},
      {"face_material[1] is 0, expected an index below 0, the number of materials",
       [](SourceMesh& s) {
         s.face_material = {kNone, 0};
       }},
      {"face_object has 1 entries", [](SourceMesh& s) { s.face_object.resize(1); }},
      {"face_object[0] is 1, expected an index below 1, the number of objects",
       [](SourceMesh& s) {
         s.objects = {"a"}, s.face_object = {1, 0};
       }},
  };
  for (const Case& c : cases) {
    SourceMesh source = two_triangles();
    c.spoil(source);
    const auto refused = validate(source);
    ASSERT_FALSE(refused.has_value()) << c.message;
    EXPECT_EQ(refused.error().kind, ErrorKind::malformed);
    EXPECT_THAT(refused.error().text(), HasSubstr(c.message));
  }
}

TEST(Validate, MoreThanCanBeIndexedIsALimit) {
  EXPECT_TRUE(check_count(0xFFFFFFFEU, "corners").has_value());
  const auto refused = check_count(std::size_t{0xFFFFFFFFU}, "corners");
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().kind, ErrorKind::limit);
}

TEST(Validate, FacesWithPositionsThatAreNotFiniteAreDroppedAndCounted) {
  SourceMesh source =
      polygons({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, kNan, 0}, {kInfinity, 0, 0}, {0, 1, kNan}}, {{0, 1, 3}, {0, 1, 2}, {2, 1, 4}});
  source.face_smoothing = {7, 8, 9};
  source.face_colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  source.materials.resize(3);
  source.face_material = {0, 1, 2};
  const ValidMesh mesh = valid(source);
  EXPECT_THAT(mesh.source.corner_position, ElementsAre(0, 1, 2));
  EXPECT_THAT(mesh.source.face_begin, ElementsAre(0, 3));
  EXPECT_THAT(mesh.source.face_smoothing, ElementsAre(8));
  EXPECT_THAT(mesh.source.face_material, ElementsAre(1));
  EXPECT_THAT(mesh.source.face_colors, ElementsAre(Vec3f{0, 1, 0}));
  EXPECT_THAT(mesh.notes, ElementsAre(Note{"", "2 faces with a position that is not finite: dropped"}));  // position 5 is not used
}

TEST(Validate, FacesWithFewerThanThreeDistinctCornersAreDroppedAndCounted) {
  const ValidMesh mesh = valid(polygons({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 0}},
                                        {{}, {0}, {0, 1}, {0, 1, 1}, {0, 1, 0, 1}, {0, 1, 3}, {2, 2, 2, 2, 2}, {0, 1, 0, 3, 0}, {0, 1, 2}}));
  EXPECT_THAT(mesh.source.corner_position, ElementsAre(0, 1, 2));
  EXPECT_THAT(mesh.notes, ElementsAre(Note{"", "8 faces with fewer than three distinct corners: dropped"}));
}

TEST(Validate, ACornerAtThePlaceOfTheOneBeforeIsDropped) {
  SourceMesh source = polygons({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2, 4, 3, 0}, {0, 1, 2}});
  source.uvs = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}};
  source.corner_uv = {0, 1, 2, 3, 4, 5, 0, 1, 2};
  const ValidMesh mesh = valid(source);
  EXPECT_THAT(mesh.source.corner_position, ElementsAre(0, 1, 2, 3, 0, 1, 2));
  EXPECT_THAT(mesh.source.corner_uv, ElementsAre(0, 1, 2, 4, 0, 1, 2));
  EXPECT_THAT(mesh.source.face_begin, ElementsAre(0, 4, 7));
  EXPECT_THAT(mesh.notes, ElementsAre(Note{"", "2 corners at the place of the corner before: dropped"}));
}

TEST(Validate, ColoursThatAreNotFiniteBecomeWhite) {
  SourceMesh source = two_triangles();
  source.colors = {{kNan, 0, 0}, {0, 0.5F, 0}, {0, kInfinity, 0}, {1, 1, 1}};
  source.face_colors = {{0, 0, kNan}, {0, 0, 0}};
  const ValidMesh mesh = valid(source);
  EXPECT_THAT(mesh.source.colors, ElementsAre(Vec3f{1, 1, 1}, Vec3f{0, 0.5F, 0}, Vec3f{1, 1, 1}, Vec3f{1, 1, 1}));
  EXPECT_THAT(mesh.source.face_colors, ElementsAre(Vec3f{1, 1, 1}, Vec3f{0, 0, 0}));
  EXPECT_THAT(mesh.notes, ElementsAre(Note{"", "3 colours not finite: white instead"}));
}

TEST(Validate, NormalsGetLengthOneAndUnusableOnesAreForgotten) {
  SourceMesh source = two_triangles();
  source.normals = {{0, 0, 5}, {0, 0, 0}, {kNan, 0, 1}, {0, 3e38F, 3e38F}, {0, 1e-40F, 0}};
  source.corner_normal = {0, 1, 2, 3, 4, kNone};
  const ValidMesh mesh = valid(source);
  EXPECT_THAT(mesh.source.corner_normal, ElementsAre(0, kNone, kNone, 3, 4, kNone));
  EXPECT_EQ(mesh.source.normals[0], (Vec3f{0, 0, 1}));
  EXPECT_NEAR(length(mesh.source.normals[3]), 1, 1e-7);
  EXPECT_EQ(mesh.source.normals[4], (Vec3f{0, 1, 0}));
  EXPECT_THAT(mesh.notes, ElementsAre(Note{"", "2 normals zero or not finite: made from the faces instead"}));
}

TEST(Validate, TextureCoordinatesThatAreNotFiniteBecomeZero) {
  SourceMesh source = two_triangles();
  source.uvs = {{kNan, 1}, {0.5F, 0.25F}};
  source.corner_uv = {0, 1, 1, 1, 1, kNone};
  const ValidMesh mesh = valid(source);
  EXPECT_THAT(mesh.source.uvs, ElementsAre(Vec2f{0, 0}, Vec2f{0.5F, 0.25F}));
  EXPECT_THAT(mesh.notes, ElementsAre(Note{"", "1 texture coordinate not finite: (0, 0) instead"}));
}

TEST(Validate, WeldingComesBeforeCornersAreCounted) {
  SourceMesh source = polygons({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}},
                               {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}});
  source.colors.assign(9, {0, 0, 0});
  source.weld_first = true;
  const ValidMesh mesh = valid(source);
  EXPECT_THAT(mesh.source.corner_position, ElementsAre(0, 1, 2, 0, 2, 5));
  EXPECT_THAT(mesh.corner_color, ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(mesh.notes, SizeIs(1));
}

}  // namespace
}  // namespace lustro
