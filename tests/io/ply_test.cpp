// PLY bodies, clause by clause, in each encoding.
#include "io/ply.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "io_testing.hpp"

namespace lustro {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::uint32_t kNone = SourceMesh::kNone;
constexpr const char* kXyz = "property float x\nproperty float y\nproperty float z\n";

SourceMesh ply(const std::string& bytes) {
  SourceMesh mesh = good(parse_ply(bytes, "m.ply"));
  expect_consistent(mesh);
  return mesh;
}
Error error_of(const std::string& bytes) {
  return bad(parse_ply(bytes, "m.ply"));
}
std::string ascii(const std::string& header, const std::string& body) {
  return "ply\nformat ascii 1.0\n" + header + "end_header\n" + body;
}

// Three vertices and what the faces say.
std::string triangle(const std::string& faces_header, const std::string& faces) {
  return ascii(std::string("element vertex 3\n") + kXyz + faces_header, "0 0 0\n1 0 0\n1 1 0\n" + faces);
}

// The bytes of a number, first the low or first the high ones.
template <class T>
std::string raw(T value, bool is_big) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (is_big == (std::endian::native == std::endian::little)) {
    std::reverse(bytes.begin(), bytes.end());
  }
  return bytes;
}

TEST(Ply, ATriangleIsWhatItSays) {
  const SourceMesh mesh = ply(triangle("element face 1\nproperty list uchar int vertex_indices\n", "3 0 1 2\n"));
  EXPECT_THAT(mesh.positions, ElementsAre(Vec3f{0, 0, 0}, Vec3f{1, 0, 0}, Vec3f{1, 1, 0}));
  EXPECT_THAT(mesh.corner_position, ElementsAre(0, 1, 2));
  EXPECT_EQ(mesh.format, "PLY (ascii)");
  EXPECT_FALSE(mesh.weld_first);
  EXPECT_THAT(mesh.notes, IsEmpty());
  EXPECT_THAT(mesh.corner_normal, IsEmpty());
  EXPECT_THAT(mesh.corner_uv, IsEmpty());
  EXPECT_THAT(mesh.colors, IsEmpty());
}

TEST(Ply, TheIndexListHasTwoNames) {
  EXPECT_EQ(ply(triangle("element face 1\nproperty list uchar int vertex_index\n", "3 2 1 0\n")).corner_position,
            (std::vector<std::uint32_t>{2, 1, 0}));
}

// Every scalar type in every place, in both byte orders and as text, gives the same mesh.
TEST(Ply, EveryTypeInEveryEncodingGivesTheSame) {
  const std::vector<std::string> types{"char", "uchar", "short", "ushort", "int", "uint", "float", "double"};
  const auto bytes_of = [](const std::string& type, int value, bool is_big) -> std::string {
    if (type == "char") {
      return raw(static_cast<std::int8_t>(value), is_big);
    }
    if (type == "uchar") {
      return raw(static_cast<std::uint8_t>(value), is_big);
    }
    if (type == "short") {
      return raw(static_cast<std::int16_t>(value), is_big);
    }
    if (type == "ushort") {
      return raw(static_cast<std::uint16_t>(value), is_big);
    }
    if (type == "int") {
      return raw(static_cast<std::int32_t>(value), is_big);
    }
    if (type == "uint") {
      return raw(static_cast<std::uint32_t>(value), is_big);
    }
    return type == "float" ? raw(static_cast<float>(value), is_big) : raw(static_cast<double>(value), is_big);
  };
  for (const std::string& position : types) {
    for (const std::string& count : types) {
      for (const std::string& index : types) {
        SCOPED_TRACE(position + " " + count + " " + index);
        const std::string header = "element vertex 4\nproperty " + position + " x\nproperty " + position + " y\nproperty " + position +
                                   " z\nelement face 2\nproperty list " + count + " " + index + " vertex_indices\nend_header\n";
        const SourceMesh text = ply("ply\nformat ascii 1.0\n" + header + "1 2 3\n4 5 6\n7 8 9\n100 11 12\n4 0 1 2 3\n3 2 1 0\n");
        EXPECT_EQ(text.positions[3], (Vec3f{100, 11, 12}));
        EXPECT_THAT(text.face_begin, ElementsAre(0, 4, 7));
        for (const bool is_big : {false, true}) {
          std::string body;
          for (const int value : {1, 2, 3, 4, 5, 6, 7, 8, 9, 100, 11, 12}) {
            body += bytes_of(position, value, is_big);
          }
          for (const std::vector<int>& face : {std::vector<int>{0, 1, 2, 3}, std::vector<int>{2, 1, 0}}) {
            body += bytes_of(count, static_cast<int>(face.size()), is_big);
            for (const int corner : face) {
              body += bytes_of(index, corner, is_big);
            }
          }
          const SourceMesh binary = ply(std::string("ply\nformat binary_") + (is_big ? "big" : "little") + "_endian 1.0\n" + header + body);
          EXPECT_EQ(binary.positions, text.positions);
          EXPECT_EQ(binary.corner_position, text.corner_position);
          EXPECT_EQ(binary.face_begin, text.face_begin);
          EXPECT_EQ(binary.format, is_big ? "PLY (binary, big endian)" : "PLY (binary, little endian)");
        }
      }
    }
  }
}

TEST(Ply, NegativeAndFractionalPositionsSurviveEveryEncoding) {
  const std::string header = "element vertex 1\nproperty float x\nproperty double y\nproperty short z\nend_header\n";
  const Vec3f expected{-0.1F, 0.1F, -300};
  EXPECT_EQ(ply("ply\nformat ascii 1.0\n" + header + "-0.1 0.1 -300\n").positions[0], expected);
  for (const bool is_big : {false, true}) {
    const std::string body = raw(-0.1F, is_big) + raw(0.1, is_big) + raw(static_cast<std::int16_t>(-300), is_big);
    EXPECT_EQ(ply(std::string("ply\nformat binary_") + (is_big ? "big" : "little") + "_endian 1.0\n" + header + body).positions[0], expected);
  }
}

TEST(Ply, TextIsRoundedToFloatOnce) {
  // halfway between two floats but for the last digit: rounded to double first, it would tie to the lower one
  const SourceMesh mesh = ply(ascii(std::string("element vertex 1\n") + kXyz, "1.00000017881393432617187499 1.00000017881393432617187501 0\n"));
  EXPECT_EQ(mesh.positions[0].x, std::nextafter(1.0F, 2.0F));
  EXPECT_EQ(mesh.positions[0].y, std::nextafter(std::nextafter(1.0F, 2.0F), 2.0F));
}

TEST(Ply, NormalsAndUvsOfVerticesFollowThePositions) {
  for (const auto& [u, v] : std::vector<std::pair<std::string, std::string>>{
           {"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}, {"texcoord_u", "texcoord_v"}}) {
    const SourceMesh mesh =
        ply(ascii(std::string("element vertex 3\n") + kXyz + "property float nx\nproperty float ny\nproperty float nz\nproperty float " + u +
                      "\nproperty float " + v + "\nelement face 1\nproperty list uchar int vertex_indices\n",
                  "0 0 0 0 0 1 0.5 0.25\n1 0 0 0 1 0 1 0\n1 1 0 1 0 0 0 1\n3 2 0 1\n"));
    EXPECT_THAT(mesh.normals, ElementsAre(Vec3f{0, 0, 1}, Vec3f{0, 1, 0}, Vec3f{1, 0, 0}));
    EXPECT_THAT(mesh.uvs, ElementsAre(Vec2f{0.5F, 0.25F}, Vec2f{1, 0}, Vec2f{0, 1}));
    EXPECT_THAT(mesh.corner_normal, ElementsAre(2, 0, 1));
    EXPECT_THAT(mesh.corner_uv, ElementsAre(2, 0, 1));
  }
}

TEST(Ply, ColoursOfEveryUsualNameAndTypeAreBetween0And1) {
  const auto color = [](const std::string& type, const std::string& r, const std::string& g, const std::string& b, const std::string& values) {
    const SourceMesh mesh = ply(ascii(std::string("element vertex 1\n") + kXyz + "property " + type + " " + r + "\nproperty " + type + " " + g +
                                          "\nproperty " + type + " " + b + "\nproperty uchar alpha\n",
                                      "0 0 0 " + values + " 7\n"));
    EXPECT_EQ(mesh.colors.size(), 1U);
    return mesh.colors.empty() ? Vec3f{} : mesh.colors[0];
  };
  EXPECT_EQ(color("uchar", "red", "green", "blue", "255 51 0"), (Vec3f{1, 51.0F / 255, 0}));
  EXPECT_EQ(color("uint8", "diffuse_red", "diffuse_green", "diffuse_blue", "1 2 3"), (Vec3f{1.0F / 255, 2.0F / 255, 3.0F / 255}));
  EXPECT_EQ(color("ushort", "r", "g", "b", "65535 0 257"), (Vec3f{1, 0, 257.0F / 65535}));
  EXPECT_EQ(color("float", "red", "green", "blue", "1 0.25 0"), (Vec3f{1, 0.25F, 0}));
  EXPECT_EQ(color("int", "red", "green", "blue", "255 51 0"), (Vec3f{1, 51.0F / 255, 0}));  // a larger type with the range of a byte
  EXPECT_EQ(color("float", "red", "green", "blue", "nan 1.5 -1"), (Vec3f{1, 1, 0}));
}

TEST(Ply, UvsOfSmallIntegersAreFractions) {
  const SourceMesh mesh = ply(ascii(std::string("element vertex 1\n") + kXyz + "property ushort u\nproperty uchar v\n", "0 0 0 65535 51\n"));
  EXPECT_EQ(mesh.uvs[0], (Vec2f{1, 0.2F}));
}

TEST(Ply, FacesHaveColoursOfTheirOwn) {
  const SourceMesh mesh =
      ply(triangle("element face 3\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty list uchar int vertex_indices\n",
                   "255 0 0 3 0 1 2\n1 1 1 2 0 1\n0 255 0 3 2 1 0\n"));
  EXPECT_THAT(mesh.face_colors, ElementsAre(Vec3f{1, 0, 0}, Vec3f{0, 1, 0}));  // the dropped face takes its colour along
  EXPECT_THAT(mesh.colors, IsEmpty());
}

TEST(Ply, TexcoordListsBecomeUvsOfCorners) {
  const SourceMesh mesh = ply(triangle("element face 4\nproperty list uchar float texcoord\nproperty list uchar int vertex_indices\n",
                                       "6 0 0 1 0 1 1 3 0 1 2\n0 3 0 1 2\n4 1 2 3 4 3 0 1 2\n6 .5 0 .25 0 1 .5 3 2 1 0\n"));
  EXPECT_THAT(mesh.uvs, ElementsAre(Vec2f{0, 0}, Vec2f{1, 0}, Vec2f{1, 1}, Vec2f{0.5F, 0}, Vec2f{0.25F, 0}, Vec2f{1, 0.5F}));
  EXPECT_THAT(mesh.corner_uv, ElementsAre(0, 1, 2, kNone, kNone, kNone, kNone, kNone, kNone, 3, 4, 5));
  EXPECT_THAT(texts(mesh.notes), ElementsAre("m.ply:16: lists texcoord that do not hold two numbers a corner are skipped"));
}

TEST(Ply, UvsOfCornersWinOverThoseOfVertices) {
  const SourceMesh mesh =
      ply(ascii(std::string("element vertex 3\n") + kXyz +
                    "property float u\nproperty float v\nelement face 2\nproperty list uchar int vertex_indices\nproperty list uchar "
                    "float texcoord\n",
                "0 0 0 1 1\n1 0 0 2 2\n1 1 0 3 3\n3 0 1 2 0\n3 0 1 2 6 4 4 5 5 6 6\n"));
  EXPECT_THAT(mesh.corner_uv, ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_EQ(mesh.uvs[3], (Vec2f{4, 4}));
}

TEST(Ply, FacesMayStandBeforeVertices) {
  const SourceMesh mesh = ply(ascii(std::string("element face 1\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n") +
                                        "element vertex 3\n" + kXyz + "property float u\nproperty float v\n",
                                    "3 0 1 2 6 4 4 5 5 6 6\n0 0 0 1 1\n1 0 0 2 2\n1 1 0 3 3\n"));
  EXPECT_THAT(mesh.corner_position, ElementsAre(0, 1, 2));
  EXPECT_EQ(mesh.uvs[mesh.corner_uv[0]], (Vec2f{4, 4}));
  EXPECT_EQ(mesh.positions.size(), 3U);
}

TEST(Ply, StripsTurnEveryOtherTriangleAndRestartAtMinusOne) {
  const std::string header = std::string("element vertex 5\n") + kXyz + "element tristrips 1\nproperty list int int vertex_indices\n";
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n";
  EXPECT_THAT(ply(ascii(header, vertices + "5 0 1 2 3 4\n")).corner_position, ElementsAre(0, 1, 2, 2, 1, 3, 2, 3, 4));
  EXPECT_THAT(ply(ascii(header, vertices + "9 0 1 2 -1 1 3 2 4 -1\n")).corner_position, ElementsAre(0, 1, 2, 1, 3, 2, 2, 3, 4));
  // triangles that name a vertex twice are left out, and count for the turn: 012, 122, 221, 213, 134
  EXPECT_THAT(ply(ascii(header, vertices + "7 0 1 2 2 1 3 4\n")).corner_position, ElementsAre(0, 1, 2, 1, 2, 3, 1, 3, 4));
}

TEST(Ply, AFlatGridOfStripsFacesOneWay) {  // the true reason for turning: all normals agree
  std::string vertices;
  for (int i = 0; i < 6; ++i) {
    vertices += std::to_string(i % 2) + " " + std::to_string(i / 2) + " 0\n";
  }
  const SourceMesh mesh = ply(ascii(std::string("element vertex 6\n") + kXyz + "element tristrips 1\nproperty list uchar char vertex_indices\n",
                                    vertices + "6 0 1 2 3 4 5\n"));
  ASSERT_EQ(mesh.face_count(), 4U);
  for (std::size_t f = 0; f < 4; ++f) {
    const auto at = [&](std::size_t i) { return mesh.positions[mesh.corner_position[3 * f + i]]; };
    EXPECT_GT(cross(at(1) - at(0), at(2) - at(0)).z, 0) << f;
  }
}

TEST(Ply, OtherElementsAndPropertiesAreSkipped) {
  const SourceMesh mesh = ply(
      ascii("element camera 1\nproperty float px\nproperty list uchar short path\nelement vertex 3\nproperty uchar flags\n" + std::string(kXyz) +
                "property list int double history\nelement edge 2\nproperty int vertex1\nproperty int vertex2\nelement face 1\nproperty int "
                "id\nproperty "
                "list uchar int vertex_indices\nproperty list uchar uchar bits\nelement nothing 4000000000\n",
            "0.5 3 1 2 3\n9 0 0 0 2 0.5 0.5\n9 1 0 0 0\n9 1 1 0 1 7\n0 1\n1 2\n77 3 0 1 2 2 5 5\n"));
  EXPECT_THAT(mesh.positions, ElementsAre(Vec3f{0, 0, 0}, Vec3f{1, 0, 0}, Vec3f{1, 1, 0}));
  EXPECT_THAT(mesh.corner_position, ElementsAre(0, 1, 2));
  EXPECT_THAT(texts(mesh.notes), ElementsAre("m.ply:21: elements \"camera\" are skipped", "m.ply:25: elements \"edge\" are skipped (2 times)"));
}

TEST(Ply, SkippedListsOfABinaryBodyAreSteppedOver) {
  const std::string body =
      raw(std::uint8_t{3}, false) + raw(1.0, false) + raw(2.0, false) + raw(3.0, false) + raw(1.0F, false) + raw(2.0F, false) + raw(3.0F, false);
  EXPECT_EQ(ply(std::string("ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty list uchar double history\n") + kXyz +
                "end_header\n" + body)
                .positions[0],
            (Vec3f{1, 2, 3}));
}

TEST(Ply, PointsAloneAreAMeshWithoutFaces) {
  const SourceMesh mesh = ply(ascii(std::string("element vertex 2\n") + kXyz, "1 2 3\n4 5 6\n"));
  EXPECT_EQ(mesh.positions.size(), 2U);
  EXPECT_EQ(mesh.face_count(), 0U);
}

TEST(Ply, FacesWithTooFewCornersAreDroppedWithANote) {
  const SourceMesh mesh = ply(triangle("element face 4\nproperty list uchar int vertex_indices\n", "0\n2 0 1\n3 0 1 2\n1 2\n"));
  EXPECT_THAT(mesh.face_begin, ElementsAre(0, 3));
  ASSERT_EQ(mesh.notes.size(), 1U);
  EXPECT_THAT(mesh.notes[0].message, HasSubstr("(3 times)"));
}

TEST(Ply, IndicesOutsideAreErrors) {
  const std::string header = "element face 1\nproperty list uchar int vertex_indices\n";
  EXPECT_EQ(error_of(triangle(header, "3 0 1 3\n")).text(), "m.ply:13: vertex index 3 is outside 0..2");
  EXPECT_EQ(error_of(triangle(header, "3 0 1 -1\n")).text(), "m.ply:13: vertex index -1 is outside 0..2");
  EXPECT_EQ(error_of(triangle(header, "3 0 1 0.5\n")).text(), "m.ply:13: vertex index 0.5 is outside 0..2");
  EXPECT_EQ(error_of(ascii("element face 1\nproperty list uchar int vertex_indices\n", "3 0 1 2\n")).text(),
            "m.ply:6: vertex index 0, but the header states no vertices");
  const std::string binary = "ply\nformat binary_little_endian 1.0\nelement vertex 1\n" + std::string(kXyz) +
                             "element face 1\nproperty list uchar uchar vertex_indices\nend_header\n";
  EXPECT_EQ(error_of(binary + std::string(12, '\0') + "\x03" + std::string("\0\0\x05", 3)).text(),
            "m.ply: byte " + std::to_string(binary.size() + 15) + ": vertex index 5 is outside 0..0");
}

TEST(Ply, DataThatEndEarlyAreAnError) {
  EXPECT_EQ(error_of(triangle("element face 1\nproperty list uchar int vertex_indices\n", "3 0 1")).text(),
            "m.ply:13: expected a value of \"vertex_indices\" (element \"face\", number 1 of 1), found the end of the file");
  EXPECT_EQ(error_of(ascii(std::string("element vertex 1\n") + kXyz, "0 zero 0\n")).text(),
            "m.ply:8: expected a value of \"y\" (element \"vertex\", number 1 of 1), found \"zero\"");
  EXPECT_THAT(error_of("ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list int int vertex_indices\nend_header\n" +
                       raw(std::int32_t{1000}, false))
                  .text(),
              HasSubstr("a list \"vertex_indices\" of 1000 entries, and 0 bytes follow"));
  for (const char* count : {"-1", "0.5", "nan", "1e300"}) {
    EXPECT_EQ(error_of(ascii("element face 1\nproperty list float int vertex_indices\n", std::string(count) + " 0 0 0\n")).kind,
              ErrorKind::malformed)
        << count;
  }
}

TEST(Ply, AHeaderThatClaimsMoreThanThereIsIsRefusedBeforeMemoryIsTaken) {
  for (const char* encoding : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string start = std::string("ply\nformat ") + encoding + " 1.0\n";
    EXPECT_EQ(error_of(start + "element vertex 4294967294\n" + kXyz + "end_header\n0 0 0\n").kind, ErrorKind::malformed);
    EXPECT_EQ(error_of(start + "element vertex 4294967295\n" + kXyz + "end_header\n0 0 0\n").kind, ErrorKind::limit);
    EXPECT_EQ(error_of(start + "element vertex 99999999999999999999\n" + kXyz + "end_header\n").kind, ErrorKind::limit);
    EXPECT_EQ(error_of(start + "element face 4000000000\nproperty list uchar int vertex_indices\nend_header\n").kind, ErrorKind::malformed);
    EXPECT_EQ(error_of(start + "element other 99999999999999999999\nproperty uchar a\nend_header\n").kind, ErrorKind::malformed);
  }
  EXPECT_EQ(error_of("ply\nformat binary_little_endian 1.0\nelement vertex 2\n" + std::string(kXyz) + "end_header\n0123456789").text(),
            "m.ply: byte 115: the header states 2 elements \"vertex\" of 12 bytes or more each, but only 10 bytes follow");
}

TEST(Ply, VerticesWithoutPlaceAreAnError) {
  EXPECT_EQ(error_of(ascii("element vertex 1\nproperty float x\nproperty float y\n", "0 0\n")).text(),
            "m.ply:7: the header states no x, y and z of the element \"vertex\"");
  EXPECT_EQ(error_of(ascii("element vertex 1\n", "\n")).kind, ErrorKind::malformed);
  EXPECT_EQ(error_of(ascii(std::string("element vertex 1\n") + kXyz + "element vertex 1\n" + kXyz, "0 0 0\n0 0 0\n")).kind,
            ErrorKind::malformed);
}

TEST(Ply, AsciiBodiesMayHoldBlankLinesCommentsAndMoreThanIsStated) {
  const SourceMesh mesh = ply(ascii(std::string("element vertex 2\n") + kXyz, "\ncomment a 1 2\n1 2 3 99 98\n\nobj_info b\n4\n5 6"));
  EXPECT_THAT(mesh.positions, ElementsAre(Vec3f{1, 2, 3}, Vec3f{4, 5, 6}));
  EXPECT_THAT(texts(mesh.notes), ElementsAre("m.ply:9: comments among the data are skipped (2 times)",
                                             "m.ply:10: values behind those that the header states are skipped"));
}

TEST(Ply, DataBehindTheLastElementAreANote) {
  EXPECT_THAT(texts(ply(ascii(std::string("element vertex 1\n") + kXyz, "1 2 3\n\n7 7\n")).notes),
              ElementsAre("m.ply:10: data behind the last element are skipped"));
  EXPECT_THAT(texts(ply(std::string("ply\nformat binary_little_endian 1.0\nelement vertex 0\n") + kXyz + "end_header\nxyz").notes),
              ElementsAre("m.ply: data behind the last element are skipped"));
}

}  // namespace
}  // namespace lustro
