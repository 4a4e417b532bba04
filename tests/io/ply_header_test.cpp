// The PLY header.
#include "io/ply_header.hpp"

#include "io_testing.hpp"

namespace lustro {
namespace {

PlyHeader header(const std::string& text) {
  return good(parse_ply_header(text, "m.ply"));
}
std::string error_of(const std::string& text) {
  return bad(parse_ply_header(text, "m.ply")).text();
}

TEST(PlyHeader, ElementsAndPropertiesAreWhatItSays) {
  const PlyHeader h = header(
      "ply\ncomment c\nformat binary_big_endian 1.0\nobj_info o\nelement vertex 7\nproperty float x\nproperty uint16 y\nelement face "
      "2\nproperty list "
      "uchar int32 vertex_indices\nend_header\nBODY");
  EXPECT_EQ(h.encoding, PlyEncoding::big_endian);
  ASSERT_EQ(h.elements.size(), 2U);
  EXPECT_EQ(h.elements[0].name, "vertex");
  EXPECT_EQ(h.elements[0].count, 7U);
  ASSERT_EQ(h.elements[0].properties.size(), 2U);
  EXPECT_EQ(h.elements[0].properties[0].type, PlyType::float32);
  EXPECT_EQ(h.elements[0].properties[1].type, PlyType::uint16);
  EXPECT_EQ(h.elements[0].properties[1].name, "y");
  EXPECT_FALSE(h.elements[0].properties[1].count_type);
  EXPECT_EQ(h.elements[1].properties[0].count_type, PlyType::uint8);
  EXPECT_EQ(h.elements[1].properties[0].type, PlyType::int32);
  EXPECT_EQ(h.body_line, 11U);
}

TEST(PlyHeader, EveryTypeHasTwoNamesAndASize) {
  const std::vector<std::tuple<std::string, std::string, std::size_t>> types{
      {"char", "int8", 1}, {"uchar", "uint8", 1}, {"short", "int16", 2},   {"ushort", "uint16", 2},
      {"int", "int32", 4}, {"uint", "uint32", 4}, {"float", "float32", 4}, {"double", "float64", 8}};
  for (const auto& [one, other, size] : types) {
    const PlyHeader h = header("ply\nformat ascii 1.0\nelement e 1\nproperty " + one + " a\nproperty " + other + " b\nend_header\n");
    EXPECT_EQ(h.elements[0].properties[0].type, h.elements[0].properties[1].type);
    EXPECT_EQ(size_of(h.elements[0].properties[0].type), size) << one;
    EXPECT_EQ(least_bytes(h.elements[0], PlyEncoding::little_endian), 2 * size);
    EXPECT_EQ(least_bytes(h.elements[0], PlyEncoding::ascii), 4U);
  }
}

TEST(PlyHeader, TheBodyBeginsBehindTheLinesEndAndNoByteLater) {
  const auto body = [](const std::string& text) { return text.substr(header(text).body); };
  EXPECT_EQ(body("ply\nformat ascii 1.0\nend_header\n\n\r\nX"), "\n\r\nX");
  EXPECT_EQ(body("ply\r\nformat ascii 1.0\r\nend_header\r\n\nX"), "\nX");
  EXPECT_EQ(body("ply\rformat ascii 1.0\rend_header\r\nX"), "\nX");  // a lone CR ends the lines: the LF is data
  EXPECT_EQ(body("ply\nformat ascii 1.0\nend_header  \nX"), "X");
  EXPECT_EQ(body("ply\nformat ascii 1.0\nend_header"), "");
}

TEST(PlyHeader, BrokenRulesAreErrorsWithTheirLine) {
  const std::string start = "ply\nformat ascii 1.0\n";
  EXPECT_EQ(error_of("plyx\n"), "m.ply:1: expected the line ply, found \"plyx\"");
  EXPECT_EQ(error_of(""), "m.ply:1: expected the line ply, found \"\"");
  EXPECT_EQ(error_of(start + "element vertex 3\n"), "m.ply:4: the file ends before end_header");
  EXPECT_EQ(error_of("ply\nend_header\n"), "m.ply:2: the header states no format");
  EXPECT_EQ(error_of(start + "property float x\n"), "m.ply:3: a property stands before the first element");
  EXPECT_EQ(error_of(start + "element vertex -3\n"), "m.ply:3: expected the number of elements \"vertex\"");
  EXPECT_EQ(error_of(start + "element vertex many\n"), "m.ply:3: expected the number of elements \"vertex\"");
  EXPECT_EQ(error_of(start + "element\n"), "m.ply:3: expected the element's name, found the end of the line");
  EXPECT_EQ(error_of(start + "element e 1\nproperty float\n"), "m.ply:4: expected the property's name, found the end of the line");
  EXPECT_EQ(error_of(start + "nonsense\n"), "m.ply:3: expected format, element, property, comment, obj_info or end_header, found \"nonsense\"");
}

TEST(PlyHeader, WhatIsNotReadIsUnsupported) {
  for (const char* text : {"ply\nformat ascii 1.1\n", "ply\nformat binary 1.0\n", "ply\nformat ascii 1.0\nelement e 1\nproperty int64 x\n",
                           "ply\nformat ascii 1.0\nelement e 1\nproperty list uchar half x\n", "ply\nformat ascii\n"}) {
    EXPECT_EQ(bad(parse_ply_header(text, "m.ply")).kind, ErrorKind::unsupported) << text;
  }
}

}  // namespace
}  // namespace lustro
