// OFF, both kinds, letter by letter of the keyword.
#include "io/off.hpp"

#include <bit>
#include <random>

#include "io_testing.hpp"

namespace lustro {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

SourceMesh off(const std::string& bytes) {
  SourceMesh mesh = good(parse_off(bytes, "m.off"));
  expect_consistent(mesh);
  return mesh;
}
Error error_of(const std::string& bytes) {
  return bad(parse_off(bytes, "m.off"));
}

constexpr const char* kTriangle = "3 1 0\n0 0 0\n1 0 0.5\n1 1 0\n3 0 1 2\n";

std::string raw(std::uint32_t bits) {
  std::string bytes;
  for (unsigned i = 0; i < 4; ++i) {
    bytes += static_cast<char>((bits >> (24 - 8 * i)) & 0xFFU);
  }
  return bytes;
}
std::string raw(float value) {
  return raw(std::bit_cast<std::uint32_t>(value));
}

TEST(Off, PolygonsStayPolygons) {
  const SourceMesh mesh = off("OFF\n# a square and a triangle\n\n4 2 5\n0 0 0\n1 0 0 # a corner\n1 1 0\n0 1 0.25\n\n4 0 1 2 3\n3 3 2 0\n");
  EXPECT_THAT(mesh.positions, ElementsAre(Vec3f{0, 0, 0}, Vec3f{1, 0, 0}, Vec3f{1, 1, 0}, Vec3f{0, 1, 0.25F}));
  EXPECT_THAT(mesh.face_begin, ElementsAre(0, 4, 7));
  EXPECT_THAT(mesh.corner_position, ElementsAre(0, 1, 2, 3, 3, 2, 0));
  EXPECT_THAT(mesh.colors, IsEmpty());
  EXPECT_THAT(mesh.face_colors, IsEmpty());
  EXPECT_THAT(mesh.notes, IsEmpty());
  EXPECT_EQ(mesh.format, "OFF (ascii)");
}

TEST(Off, CountsStandOnTheLineOfTheKeywordOrTheNextOrGluedToIt) {
  for (const std::string head : {"OFF ", "OFF\n", "OFF", "", "\xEF\xBB\xBF# c\nOFF # k\n# d\n", "OFF\r\n"}) {
    const SourceMesh mesh = off(head + kTriangle);
    EXPECT_EQ(mesh.positions.size(), 3U) << head;
    EXPECT_THAT(mesh.corner_position, ElementsAre(0, 1, 2)) << head;
    EXPECT_THAT(mesh.notes, IsEmpty());
  }
  EXPECT_EQ(off("OFF\n3 1\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n").face_count(), 1U);  // no number of edges
}

TEST(Off, LineEndsAreBlanksUpToTheFaces) {
  EXPECT_THAT(off("OFF 3 1 0 0 0 0 1 0 0\n1 1\n0 3 0 1\n2").positions, ElementsAre(Vec3f{0, 0, 0}, Vec3f{1, 0, 0}, Vec3f{1, 1, 0}));
}

TEST(Off, VerticesHoldWhatTheLettersSayInAnyOrder) {
  for (const std::string letters : {"STCN", "NCST", "CNST"}) {
    const SourceMesh mesh =
        off(letters + "OFF\n3 1 0\n0 0 0  0 0 1  1 0 0 1  0.25 0.5\n1 0 0  0 1 0  0 0.5 0 1  1 0\n1 1 0  2 0 0  0 0 1 1  1 1\n3 0 1 2\n");
    EXPECT_THAT(mesh.normals, ElementsAre(Vec3f{0, 0, 1}, Vec3f{0, 1, 0}, Vec3f{2, 0, 0}));
    EXPECT_THAT(mesh.corner_normal, ElementsAre(0, 1, 2));
    EXPECT_THAT(mesh.colors, ElementsAre(Vec3f{1, 0, 0}, Vec3f{0, 0.5F, 0}, Vec3f{0, 0, 1}));
    EXPECT_THAT(mesh.uvs, ElementsAre(Vec2f{0.25F, 0.5F}, Vec2f{1, 0}, Vec2f{1, 1}));
    EXPECT_THAT(mesh.corner_uv, ElementsAre(0, 1, 2));
    EXPECT_THAT(mesh.notes, IsEmpty());
    EXPECT_EQ(mesh.format, letters + "OFF (ascii)");
  }
}

TEST(Off, WholeColorsCountTo255UnlessNoneExceedsOne) {
  EXPECT_THAT(off("COFF\n3 1 0\n0 0 0 255 0 51 255\n1 0 0 0 1 0 255\n1 1 0 0 0 0 255\n3 0 1 2\n").colors,
              ElementsAre(Vec3f{1, 0, 0.2F}, Vec3f{0, 1 / 255.0F, 0}, Vec3f{0, 0, 0}));
  EXPECT_THAT(off("COFF\n3 1 0\n0 0 0 1 0 0\n1 0 0 0 1 0\n1 1 0 0 0 1\n3 0 1 2\n").colors,
              ElementsAre(Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}));  // three numbers, by their line
}

TEST(Off, FacesHaveColorsToTheEndOfTheirLine) {
  const SourceMesh mesh =
      off("OFF\n3 6 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n3 0 1 2 255 0 51\n3 0 1 2 0.5 0 1.0\n3 0 1 2 7\n3 0 1 2 0 0 102 128\n3 0 1 2 1 2\n");
  EXPECT_THAT(mesh.face_colors,
              ElementsAre(Vec3f{1, 1, 1}, Vec3f{1, 0, 0.2F}, Vec3f{0.5F, 0, 1}, Vec3f{1, 1, 1}, Vec3f{0, 0, 0.4F}, Vec3f{1, 1, 1}));
  EXPECT_THAT(texts(mesh.notes), ElementsAre("m.off:9: indices of a colour map, which does not come with the file, are ignored",
                                             "m.off:11: colours of two numbers are ignored", "m.off: opacities of face colours are ignored"));
}

TEST(Off, OtherDimensionsAreUnsupported) {
  for (const std::string head : {"4OFF", "nOFF", "C4nOFF"}) {
    const Error error = error_of("\n" + head + "\n3 1 0\n");
    EXPECT_EQ(error.kind, ErrorKind::unsupported);
    EXPECT_EQ(error.text(), "m.off:2: " + head + " holds points of other than three coordinates: expected OFF, or OFF led by ST, C or N");
  }
}

TEST(Off, ErrorsNameTheLine) {
  EXPECT_EQ(error_of("OFF\n3 1 0\n0 0 0\n1 0 x\n1 1 0\n3 0 1 2\n").text(), "m.off:4: expected a number of the vertex, found \"x\"");
  EXPECT_EQ(error_of("OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 3\n").text(), "m.off:6: vertex index 3 is outside 0..2");
  EXPECT_EQ(error_of("OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 -1 2\n").text(), "m.off:6: vertex index -1 is outside 0..2");
  EXPECT_EQ(error_of("OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2 red\n").text(), "m.off:6: expected a number of the face's colour, found \"red\"");
  EXPECT_EQ(error_of("OFF\n-3 1 0\n").text(), "m.off:2: -3 vertices");
  EXPECT_EQ(error_of("OFF\nthree\n").text(), "m.off:2: expected the numbers of vertices and faces, found \"three\"");
  EXPECT_THAT(error_of("").text(), HasSubstr("found the end of the file"));
}

TEST(Off, ClaimsAreCheckedAgainstTheBytesThatFollow) {
  EXPECT_EQ(error_of("OFF\n4000000000 1 0\n0 0 0\n").text(),
            "m.off:2: the header states 4000000000 vertices, which need 24000000000 bytes or more, and 7 follow");
  EXPECT_EQ(error_of("OFF\n5000000000 1 0\n").kind, ErrorKind::limit);
  EXPECT_EQ(error_of("OFF\n1 4000000000 0\n0 0 0\n").kind, ErrorKind::malformed);
  EXPECT_EQ(error_of("OFF\n1 1 0\n0 0 0\n2000000000 0\n").text(), "m.off:4: a face of 2000000000 corners");
  EXPECT_EQ(error_of("OFF BINARY\n" + raw(0x7FFFFFFFU) + raw(1U) + raw(0U)).kind, ErrorKind::malformed);
}

TEST(Off, FacesWithFewCornersAreDroppedWithTheirColors) {
  const SourceMesh mesh = off("OFF\n3 3 0\n0 0 0\n1 0 0\n1 1 0\n2 0 1 255 0 0\n3 0 1 2 0 255 0\n0\n");
  EXPECT_EQ(mesh.face_count(), 1U);
  EXPECT_THAT(mesh.face_colors, ElementsAre(Vec3f{0, 1, 0}));
  EXPECT_THAT(texts(mesh.notes), ElementsAre("m.off:6: faces with fewer than three corners are dropped (2 times)"));
}

TEST(Off, BinaryIsReadMostSignificantByteFirst) {
  std::string bytes = "CNOFF BINARY\n" + raw(3U) + raw(2U) + raw(0U);
  for (const float x : {0.0F, 1.0F, 2.0F}) {
    bytes += raw(x) + raw(0.5F) + raw(-1.0F) + raw(0.0F) + raw(0.0F) + raw(1.0F) + raw(0.25F) + raw(0.5F) + raw(1.0F) + raw(1.0F);
  }
  bytes += raw(3U) + raw(0U) + raw(1U) + raw(2U) + raw(0U);
  bytes += raw(3U) + raw(2U) + raw(1U) + raw(0U) + raw(3U) + raw(1.0F) + raw(0.5F) + raw(0.0F);
  const SourceMesh mesh = off(bytes);
  EXPECT_THAT(mesh.positions, ElementsAre(Vec3f{0, 0.5F, -1}, Vec3f{1, 0.5F, -1}, Vec3f{2, 0.5F, -1}));
  EXPECT_EQ(mesh.normals.at(1), (Vec3f{0, 0, 1}));
  EXPECT_EQ(mesh.colors.at(2), (Vec3f{0.25F, 0.5F, 1}));
  EXPECT_THAT(mesh.corner_position, ElementsAre(0, 1, 2, 2, 1, 0));
  EXPECT_THAT(mesh.face_colors, ElementsAre(Vec3f{1, 1, 1}, Vec3f{1, 0.5F, 0}));
  EXPECT_EQ(mesh.format, "CNOFF (binary)");
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_FALSE(parse_off(std::string_view(bytes).substr(0, length), "m.off").has_value()) << length;
  }
}

TEST(Off, EveryPrefixIsAMeshOrAnError) {
  const std::string text =
      "STCNOFF\n3 1 0\n0 0 0  0 0 1  1 0 0 1  0 0\n1 0 0  0 1 0  0 1 0 1  1 0\n1 1 0  1 0 0  0 0 1 1  1 1\n3 0 1 2 0.5 0 0\n";
  for (std::size_t length = 0; length <= text.size(); ++length) {
    const auto mesh = parse_off(std::string_view(text).substr(0, length), "m.off");
    if (mesh) {
      expect_consistent(*mesh);
      EXPECT_GT(length, text.size() - 12);  // from the last corner on
    }
  }
}

TEST(Off, OtherWordsAreNoKeyword) {
  for (const char* text : {"OFFICE", "off", "NOFFX", "CCOFF", "O F F", "3 1 0"}) {
    EXPECT_FALSE(is_off(text)) << text;
  }
  EXPECT_TRUE(is_off("# comment\n STOFF 3"));
}

}  // namespace
}  // namespace lustro
