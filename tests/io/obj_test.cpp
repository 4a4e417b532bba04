// OBJ, clause by clause.
#include "io/obj.hpp"

#include <map>

#include "io_testing.hpp"

namespace lustro {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::uint32_t kNone = SourceMesh::kNone;
constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

SourceMesh obj(const std::string& text, const ObjOptions& options = {}) {
  SourceMesh mesh = good(parse_obj(text, "m.obj", options));
  expect_consistent(mesh);
  return mesh;
}
std::string error_of(const std::string& text) {
  return bad(parse_obj(text, "m.obj")).text();
}
SourceMesh square(const std::string& text) {
  return obj(kSquare + text);
}

ObjOptions libraries(std::map<std::string, std::string> files) {
  ObjOptions options;
  options.read_library = [files = std::move(files)](const std::string& name) -> Result<std::string> {
    const auto found = files.find(name);
    return found == files.end() ? Result<std::string>(fail(ErrorKind::io, name, "is not there")) : Result<std::string>(found->second);
  };
  return options;
}

TEST(Obj, ATriangleIsWhatItSays) {
  const SourceMesh mesh = obj("v 1 2 3\nv 4 5 6\nv 7 8 9.5\nf 1 2 3\n");
  EXPECT_THAT(mesh.positions, ElementsAre(Vec3f{1, 2, 3}, Vec3f{4, 5, 6}, Vec3f{7, 8, 9.5F}));
  EXPECT_THAT(mesh.corner_position, ElementsAre(0, 1, 2));
  EXPECT_THAT(mesh.face_begin, ElementsAre(0, 3));
  EXPECT_EQ(mesh.format, "OBJ");
  EXPECT_FALSE(mesh.weld_first);
  EXPECT_THAT(mesh.notes, IsEmpty());
  EXPECT_THAT(mesh.corner_normal, IsEmpty());
  EXPECT_THAT(mesh.corner_uv, IsEmpty());
  EXPECT_THAT(mesh.face_smoothing, IsEmpty());
  EXPECT_THAT(mesh.face_material, IsEmpty());
  EXPECT_THAT(mesh.face_object, IsEmpty());
}

TEST(Obj, TheFourFormsOfACornerMixInOneFile) {
  const SourceMesh mesh = square("vt 0.5 0.25\nvt 1\nvn 0 0 1\nf 1 2 3\nf 1/1 2/2 3/1\nf 1//1 2//1 3//1\nf 1/2/1 2/1/1 3/2/1\n");
  EXPECT_THAT(mesh.uvs, ElementsAre(Vec2f{0.5F, 0.25F}, Vec2f{1, 0}));
  EXPECT_THAT(mesh.normals, ElementsAre(Vec3f{0, 0, 1}));
  EXPECT_THAT(mesh.corner_uv, ElementsAre(kNone, kNone, kNone, 0, 1, 0, kNone, kNone, kNone, 1, 0, 1));
  EXPECT_THAT(mesh.corner_normal, ElementsAre(kNone, kNone, kNone, kNone, kNone, kNone, 0, 0, 0, 0, 0, 0));
}

TEST(Obj, CornersOfOneFaceMayDifferInForm) {
  const SourceMesh mesh = square("vt 0 0\nvn 0 0 1\nf 1/1/1 2 3//1 4/1\nf 1/ 2// 3/1/\n");
  EXPECT_THAT(mesh.corner_uv, ElementsAre(0, kNone, kNone, 0, kNone, kNone, 0));
  EXPECT_THAT(mesh.corner_normal, ElementsAre(0, kNone, 0, kNone, kNone, kNone, kNone));
}

TEST(Obj, NegativeIndicesCountBackFromTheLastRecordSoFar) {
  const SourceMesh mesh = obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvn 0 0 1\nf -3/-2/-1 -2/-1/-1 -1/-1/-1\nv 5 5 5\nf -4 -2 -1\n");
  EXPECT_THAT(mesh.corner_position, ElementsAre(0, 1, 2, 0, 2, 3));
  EXPECT_THAT(mesh.corner_uv, ElementsAre(0, 1, 1, kNone, kNone, kNone));
  EXPECT_THAT(mesh.corner_normal, ElementsAre(0, 0, 0, kNone, kNone, kNone));
}

TEST(Obj, IndicesMayPointAheadIfTheRecordComes) {
  EXPECT_THAT(obj(std::string("f 1 2 4\n") + kSquare).corner_position, ElementsAre(0, 1, 3));
  EXPECT_EQ(error_of(std::string("\nf 1 2 3\nf 1 2 5\nf 1 6 2\n") + kSquare), "m.obj:3: vertex index 5 is outside 1..4");
}

TEST(Obj, PolygonsStayPolygons) {
  const SourceMesh mesh = square("v 0.5 0.2 0\nf 1 2 3 4\nf 1 5 2 3 4\n");
  EXPECT_THAT(mesh.face_begin, ElementsAre(0, 4, 9));
  EXPECT_EQ(mesh.stated_triangle_count(), 5U);
}

TEST(Obj, AnIndexOutsideIsAnErrorThatNamesItsLine) {
  const std::string eight = std::string(kSquare) + kSquare;
  EXPECT_EQ(error_of(eight + "f 1 2 3\n\nf 1 2 99\n"), "m.obj:11: vertex index 99 is outside 1..8");
  EXPECT_EQ(error_of(std::string(kSquare) + "f 1 2 -5\n"), "m.obj:5: vertex index -5 is outside -4..-1");
  EXPECT_EQ(error_of(std::string(kSquare) + "f 0 1 2\n"), "m.obj:5: vertex index 0: indices count from 1");
  EXPECT_EQ(error_of(std::string(kSquare) + "vt 0 0\nf 1/1 2/2 3/1\n"), "m.obj:6: texture coordinate index 2 is outside 1..1");
  EXPECT_EQ(error_of(std::string(kSquare) + "vn 0 0 1\nf 1//1 2//3 3//2\n"), "m.obj:6: normal index 3 is outside 1..1");
  EXPECT_EQ(error_of("f 1 2 3\n"), "m.obj:1: vertex index 1, but the file has no such record");
  EXPECT_EQ(error_of("f -1 -2 -3\n"), "m.obj:1: vertex index -1 counts back from the first record");
  EXPECT_EQ(error_of(std::string(kSquare) + "f 1 2 99999999999999999999999\n"), "m.obj:5: vertex index 100000000000000000 is outside 1..4");
  EXPECT_EQ(error_of(std::string(kSquare) + "f 1 2 4294967297\n"), "m.obj:5: vertex index 4294967297 is outside 1..4");  // 2^32 + 1 is not 1
}

TEST(Obj, RecordsThatTheFileHasNoneOfAreAsNotNamed) {
  const SourceMesh mesh = square("f 1/7/1 2/8/2 3/9/3\nf 1/-1/-1 2/-1/-1 3/-1/-1\n");
  EXPECT_THAT(mesh.corner_uv, IsEmpty());
  EXPECT_THAT(mesh.corner_normal, IsEmpty());
  EXPECT_THAT(texts(mesh.notes), ElementsAre("m.obj:5: faces name texture coordinates, but the file has no vt record: they are as not named",
                                             "m.obj:5: faces name normals, but the file has no vn record: they are as not named"));
  EXPECT_EQ(error_of(std::string(kSquare) + "f 1//-1 2//-1 3//-1\nvn 0 0 1\n"), "m.obj:5: normal index -1 counts back from the first record");
}

TEST(Obj, MalformedNumbersAreErrorsThatSayWhatWasFound) {
  EXPECT_EQ(error_of("v 1 2\n"), "m.obj:1: a vertex has 2 numbers, and 3 are needed");
  EXPECT_EQ(error_of("v 1 two 3\n"), "m.obj:1: expected a number of the vertex, found \"two\"");
  EXPECT_EQ(error_of("v 1 2 3 x\n"), "m.obj:1: expected a number of the vertex, found \"x\"");
  EXPECT_EQ(error_of("vn 1 2\n"), "m.obj:1: vn has 2 numbers, and 3 are needed");
  EXPECT_EQ(error_of("vt\n"), "m.obj:1: vt has 0 numbers, and 1 are needed");
  EXPECT_EQ(error_of("v 0 0 0\nf 1 a 1\n"), "m.obj:2: expected a vertex index, found \"a\"");
  EXPECT_EQ(error_of("v 0 0 0\nf 1 1.5 1\n"), "m.obj:2: expected a vertex index, found \"1.5\"");
  EXPECT_EQ(error_of("v 0 0 0\nvt 0 0\nf 1/x 1 1\n"), "m.obj:3: expected a texture coordinate index, found \"x\"");
  EXPECT_EQ(error_of("v 0 0 0\nvt 0 0\nvn 0 0 1\nf 1/1/1/1 1 1\n"), "m.obj:4: expected v, v/vt, v//vn or v/vt/vn, found \"/1\"");
}

TEST(Obj, TheWeightOfAVertexIsIgnored) {
  const SourceMesh mesh = obj("v 1 2 3 1\nv 4 5 6 0.5\nv 7 8 9 2\n");
  EXPECT_EQ(mesh.positions[1], (Vec3f{4, 5, 6}));
  EXPECT_THAT(mesh.colors, IsEmpty());
  EXPECT_THAT(texts(mesh.notes),
              ElementsAre("m.obj:2: the weight w of a vertex is ignored: it has a meaning for rational curves only (2 times)"));
}

TEST(Obj, ColoursFollowTheVertexWithOrWithoutAWeight) {
  const SourceMesh mesh = obj("v 1 2 3 0.1 0.2 0.3\nv 4 5 6\nv 7 8 9 1 0.4 0.5 0.6\nv 0 0 0\n");
  EXPECT_THAT(mesh.colors, ElementsAre(Vec3f{0.1F, 0.2F, 0.3F}, Vec3f{1, 1, 1}, Vec3f{0.4F, 0.5F, 0.6F}, Vec3f{1, 1, 1}));
  EXPECT_EQ(mesh.positions[2], (Vec3f{7, 8, 9}));
}

TEST(Obj, NumbersTooManyAreIgnoredWithANote) {
  const SourceMesh mesh = obj("v 1 2 3 1 5\nv 1 2 3 1 0 0 0 9\nvt 1 2 3 4\nvn 0 0 1 7\n");
  EXPECT_THAT(texts(mesh.notes),
              ElementsAre("m.obj:1: numbers of a vertex behind x y z [w] [r g b] are ignored (2 times)",
                          "m.obj:3: numbers of vt behind the third are ignored", "m.obj:4: numbers of vn behind the third are ignored"));
}

TEST(Obj, PositionsMayBeNoNumbersUntilTheMeshIsBuilt) {
  const SourceMesh mesh = obj("v nan 0 0\nv 0 inf 0\nv 0 0 -1.#IND\nf 1 2 3\n");
  EXPECT_EQ(mesh.positions.size(), 3U);
  EXPECT_FALSE(is_finite(mesh.positions[2]));
}

TEST(Obj, FacesWithTooFewCornersAreDroppedWithANote) {
  const SourceMesh mesh = square("vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1\nf\nf 3\nf 1 2 3\nf 1//1 2//1 3//1\n");
  EXPECT_THAT(mesh.face_begin, ElementsAre(0, 3, 6));
  EXPECT_THAT(mesh.corner_position, ElementsAre(0, 1, 2, 0, 1, 2));
  EXPECT_THAT(mesh.corner_normal, ElementsAre(kNone, kNone, kNone, 0, 0, 0));
  EXPECT_THAT(mesh.corner_uv, IsEmpty());  // only the dropped face had some
  EXPECT_THAT(texts(mesh.notes), ElementsAre("m.obj:7: faces with fewer than three corners are dropped (3 times)"));
}

TEST(Obj, SmoothingGroupsAreNumbersOffOrNames) {
  const SourceMesh mesh = square(
      "f 1 2 3\ns 1\nf 1 2 3\ns off\nf 1 2 3\ns 7\nf 1 2 3\ns 0\nf 1 2 3\ns left\nf 1 2 3\ns right\nf 1 2 3\ns left\nf 1 2 3\n"
      "s 4294967297\nf 1 2 3\n");
  ASSERT_EQ(mesh.face_smoothing.size(), 9U);
  const auto& s = mesh.face_smoothing;
  EXPECT_EQ(std::vector<std::uint32_t>(s.begin(), s.begin() + 5), (std::vector<std::uint32_t>{0, 1, 0, 7, 0}));  // before the first s: off
  EXPECT_EQ(s[5], s[7]);
  EXPECT_NE(s[5], s[6]);
  EXPECT_GE(s[5], 0x80000000U);
  EXPECT_GE(s[6], 0x80000000U);
  EXPECT_GE(s[8], 0x80000000U);  // 2^32 + 1 is not 1
}

TEST(Obj, WithoutAnySmoothingStatementThereAreNoGroups) {
  EXPECT_THAT(square("f 1 2 3\ns\nf 1 2 3\n").face_smoothing, IsEmpty());
  EXPECT_THAT(square("f 1 2 3\ns off\nf 1 2 3\n").face_smoothing, ElementsAre(0, 0));
}

TEST(Obj, GroupsAndObjectsNameFaces) {
  const SourceMesh mesh = square("f 1 2 3\no Car\nf 1 2 3\ng wheel left\nf 1 2 3\ng empty\no Bike # x\ng wheel left\nf 1 2 3\no Car\nf 1 2 3\n");
  EXPECT_THAT(mesh.objects, ElementsAre("default", "Car", "wheel left", "wheel left"));
  EXPECT_THAT(mesh.face_object, ElementsAre(0, 1, 2, 3, 1));
}

TEST(Obj, AGroupThatComesAgainGoesOn) {
  const SourceMesh mesh = square("g a\nf 1 2 3\ng b\nf 1 2 3\ng a\nf 1 2 3\ng\nf 1 2 3\n");
  EXPECT_THAT(mesh.objects, ElementsAre("a", "b", "default"));
  EXPECT_THAT(mesh.face_object, ElementsAre(0, 1, 0, 2));
}

TEST(Obj, MaterialsComeFromLibraries) {
  const SourceMesh mesh = obj(std::string("mtllib a.mtl\n") + kSquare + "f 1 2 3\nusemtl White  Color # c\nf 1 2 3\nusemtl Red\nf 1 2 3\n",
                              libraries({{"a.mtl", "newmtl Red\nKd 1 0 0\nnewmtl Unused\nnewmtl   White  Color\nKd 1 1 1\n"}}));
  ASSERT_EQ(mesh.materials.size(), 3U);
  EXPECT_EQ(mesh.materials[0].name, "Red");
  EXPECT_EQ(mesh.materials[0].diffuse, (Color{{1, 0, 0}, ColorSpace::encoded}));
  EXPECT_EQ(mesh.materials[2].name, "White  Color");
  EXPECT_THAT(mesh.face_material, ElementsAre(kNone, 2, 0));
  EXPECT_THAT(mesh.notes, IsEmpty());
}

TEST(Obj, ALibraryMayComeBehindTheFaces) {
  const SourceMesh mesh = obj(std::string(kSquare) + "usemtl b\nf 1 2 3\nusemtl a\nf 1 2 3\nmtllib l.mtl\n",
                              libraries({{"l.mtl", "newmtl a\nKd 1 0 0\nnewmtl b\n"}}));
  EXPECT_THAT(mesh.face_material, ElementsAre(0, 1));
  EXPECT_EQ(mesh.materials[1].diffuse.rgb, (Vec3f{1, 0, 0}));
  EXPECT_THAT(mesh.notes, IsEmpty());
}

TEST(Obj, AMaterialThatNoLibraryDefinesHasTheDefaults) {
  const SourceMesh mesh = square("usemtl ghost\nf 1 2 3\nusemtl ghost\nf 1 2 3\n");
  ASSERT_EQ(mesh.materials.size(), 1U);
  Material expected;
  expected.name = "ghost";
  EXPECT_EQ(mesh.materials[0], expected);
  EXPECT_THAT(texts(mesh.notes), ElementsAre("m.obj:5: material \"ghost\" is not defined: it has the default coefficients"));
}

TEST(Obj, LibraryNamesMayHoldSpacesAndSeveralMayStandOnALine) {
  const ObjOptions options =
      libraries({{"my lib.mtl", "newmtl one\n"}, {"b.mtl", "newmtl two\n"}, {"c d.MTL", "newmtl three\n"}, {"plain", "newmtl four\n"}});
  const auto names = [&](const std::string& line) {
    std::vector<std::string> found;
    const SourceMesh mesh = obj(line + "\n", options);
    for (const Material& m : mesh.materials) {
      found.push_back(m.name);
    }
    EXPECT_THAT(mesh.notes, IsEmpty()) << line;
    return found;
  };
  EXPECT_THAT(names("mtllib my lib.mtl"), ElementsAre("one"));
  EXPECT_THAT(names("mtllib \"my lib.mtl\" # c"), ElementsAre("one"));
  EXPECT_THAT(names("mtllib my lib.mtl b.mtl  c d.MTL"), ElementsAre("one", "two", "three"));
  EXPECT_THAT(names("mtllib b.mtl\nmtllib c d.MTL\nmtllib b.mtl"), ElementsAre("two", "three"));
  EXPECT_THAT(names("mtllib b.mtl plain"), ElementsAre("two", "four"));
}

TEST(Obj, AMissingLibraryIsOneNote) {
  const SourceMesh mesh = obj("mtllib x y.mtl\nmtllib x y.mtl\nmtllib a.mtl b.mtl\n", libraries({{"b.mtl", ""}}));
  EXPECT_THAT(texts(mesh.notes), ElementsAre("m.obj:1: the material library \"x y.mtl\" is not read: is not there (2 times)",
                                             "m.obj:3: the material library \"a.mtl\" is not read: is not there"));
}

TEST(Obj, WhatALibraryRefusesRefusesTheObj) {
  const Error error = bad(parse_obj("mtllib a.mtl\n", "m.obj", libraries({{"a.mtl", "newmtl a\nKd spectral x.rfl\n"}})));
  EXPECT_EQ(error.kind, ErrorKind::unsupported);
  EXPECT_EQ(error.where, "a.mtl:2");
}

TEST(Obj, NotesOfLibrariesComeAlong) {
  const SourceMesh mesh = obj("mtllib a.mtl\n", libraries({{"a.mtl", "newmtl a\nKw 1\n"}}));
  EXPECT_THAT(texts(mesh.notes), ElementsAre("a.mtl:2: unknown statement \"Kw\" is ignored"));
}

TEST(Obj, LinesGoOnBehindABackslash) {
  const SourceMesh mesh = obj("v 0 \\\n0 \\\r\n0\nv 1 0 0\nv 1 1 0\nf 1 \\\n  2 \\\n  3\n");
  EXPECT_EQ(mesh.positions.size(), 3U);
  EXPECT_THAT(mesh.corner_position, ElementsAre(0, 1, 2));
  EXPECT_EQ(error_of("v 0 0 0\nf 1 \\\n 1 \\\n 9\n"), "m.obj:4: vertex index 9 is outside 1..1");
}

TEST(Obj, CommentsMayStandAnywhere) {
  const SourceMesh mesh = obj("# head\nv 0 0 0 # x\n  # y\nv 1 0 0#z\nv 1 1 0\n#\nf 1 2 3 # f 1 1 1\n# v 9 9 9");
  EXPECT_EQ(mesh.positions.size(), 3U);
  EXPECT_EQ(mesh.face_count(), 1U);
  EXPECT_THAT(mesh.notes, IsEmpty());
}

TEST(Obj, EveryKindOfLineEndGivesTheSameMesh) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\ns 1\ng a b\nusemtl m n\nf 1 2 3\n";
  const SourceMesh expected = obj(text);
  for (const char* line_end : {"\r\n", "\r"}) {
    std::string other;
    for (const char c : text) {
      other += c == '\n' ? std::string(line_end) : std::string(1, c);
    }
    for (const std::string& variant : {other, "\xEF\xBB\xBF" + other, other.substr(0, other.size() - std::string(line_end).size())}) {
      const SourceMesh mesh = obj(variant);
      EXPECT_EQ(mesh.positions, expected.positions);
      EXPECT_EQ(mesh.corner_position, expected.corner_position);
      EXPECT_EQ(mesh.objects, expected.objects);
      EXPECT_EQ(mesh.materials, expected.materials);
      EXPECT_EQ(mesh.face_smoothing, expected.face_smoothing);
      EXPECT_EQ(mesh.notes, expected.notes);
    }
  }
}

TEST(Obj, PointsLinesAndCurvesAreSkippedWithANoteEach) {
  const SourceMesh mesh =
      square("p 1 2\nl 1 2 3\nl 1/1 2/2\nvp 0.5\ncstype bezier\ndeg 3\ncurv 0 1 1 2 \\\n 3 4\nparm u 0 1\nend\nbevel on\nf 1 2 3\n");
  EXPECT_EQ(mesh.face_count(), 1U);
  EXPECT_THAT(texts(mesh.notes), ElementsAre("m.obj:5: point elements (p) are skipped", "m.obj:6: line elements (l) are skipped (2 times)",
                                             "m.obj:8: curves and surfaces are skipped: only polygons are read (6 times)",
                                             "m.obj:15: statements of display and grouping (bevel, lod, mg, ...) are skipped"));
}

TEST(Obj, UnknownStatementsAreANoteEach) {
  const SourceMesh mesh = square("foo 1\nbar\nfoo 2\nf 1 2 3\n");
  EXPECT_THAT(texts(mesh.notes),
              ElementsAre("m.obj:5: unknown statement \"foo\" is skipped (2 times)", "m.obj:6: unknown statement \"bar\" is skipped"));
}

TEST(Obj, AFileWithoutAnyStatementOfTheFormatIsNone) {
  EXPECT_EQ(error_of("# c\n\nhello world\nagain\n"), "m.obj:3: expected an OBJ statement, found \"hello\"");
  EXPECT_EQ(obj("# only a comment").positions.size(), 0U);
  EXPECT_EQ(obj("").positions.size(), 0U);
  EXPECT_EQ(obj("g x\nhello\n").positions.size(), 0U);
}

TEST(Obj, Utf16IsRefused) {
  for (const std::string& bytes : {std::string("\xFF\xFEv\0 \0", 6), std::string("\xFE\xFF\0v\0 ", 6)}) {
    EXPECT_EQ(bad(parse_obj(bytes, "m.obj")).kind, ErrorKind::unsupported);
  }
}

TEST(Obj, TheOldWordForAFaceIsAFace) {
  EXPECT_THAT(square("fo 1 2 3\n").corner_position, ElementsAre(0, 1, 2));
}

}  // namespace
}  // namespace lustro
