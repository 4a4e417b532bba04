// STL, both kinds, clause by clause.
#include "io/stl.hpp"

#include <cmath>
#include <cstring>

#include "io_testing.hpp"

namespace lustro {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

SourceMesh stl(const std::string& bytes) {
  SourceMesh mesh = good(parse_stl(bytes, "m.stl"));
  expect_consistent(mesh);
  EXPECT_TRUE(mesh.weld_first);
  return mesh;
}
Error error_of(const std::string& bytes) {
  return bad(parse_stl(bytes, "m.stl"));
}

constexpr const char* kFacet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0.5\nendloop\nendfacet\n";

std::string raw(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, 4);
  std::string bytes;
  for (unsigned i = 0; i < 4; ++i) {
    bytes += static_cast<char>((bits >> (8 * i)) & 0xFFU);
  }
  return bytes;
}
// Facets with the corners 0..8, 9..17, ...
std::string binary(std::string header, std::uint32_t count, int facets) {
  header.resize(80, ' ');
  for (unsigned i = 0; i < 4; ++i) {
    header += static_cast<char>((count >> (8 * i)) & 0xFFU);
  }
  float next = 0;
  for (int facet = 0; facet < facets; ++facet) {
    header += raw(0) + raw(0) + raw(1);
    for (int i = 0; i < 9; ++i) {
      header += raw(next++);
    }
    header += "\xAB\xCD";
  }
  return header;
}

TEST(Stl, AsciiFacetsHaveThreePositionsEach) {
  const SourceMesh mesh = stl(std::string("solid part 1\n") + kFacet + kFacet + "endsolid part 1\n");
  ASSERT_EQ(mesh.positions.size(), 6U);
  EXPECT_EQ(mesh.positions[2], (Vec3f{1, 1, 0.5F}));
  EXPECT_THAT(mesh.corner_position, ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(mesh.face_begin, ElementsAre(0, 3, 6));
  EXPECT_THAT(mesh.objects, ElementsAre("part 1"));
  EXPECT_THAT(mesh.face_object, ElementsAre(0, 0));
  EXPECT_THAT(mesh.normals, IsEmpty());
  EXPECT_THAT(mesh.notes, IsEmpty());
  EXPECT_EQ(mesh.format, "STL (ascii)");
}

TEST(Stl, BinaryFacetsHaveThreePositionsEach) {
  const SourceMesh mesh = stl(binary("anything", 2, 2));
  ASSERT_EQ(mesh.positions.size(), 6U);
  EXPECT_EQ(mesh.positions[0], (Vec3f{0, 1, 2}));
  EXPECT_EQ(mesh.positions[5], (Vec3f{15, 16, 17}));
  EXPECT_THAT(mesh.corner_position, ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(mesh.face_begin, ElementsAre(0, 3, 6));
  EXPECT_THAT(mesh.notes, IsEmpty());
  EXPECT_EQ(mesh.format, "STL (binary)");
}

TEST(Stl, ABinaryThatBeginsWithSolidIsBinary) {
  EXPECT_EQ(stl(binary("solid facet endsolid", 1, 1)).format, "STL (binary)");
  EXPECT_EQ(stl(binary("solid", 1, 2)).positions.size(), 3U);  // trailing bytes: the size does not tell, the zero bytes of the count do
  EXPECT_EQ(error_of(binary("solid", 3, 2)).kind, ErrorKind::malformed);
  EXPECT_EQ(error_of(binary("solid", 3, 2)).where, "m.stl: byte 80");
}

TEST(Stl, KindsAreToldApart) {
  EXPECT_FALSE(is_binary_stl("solid\n"));
  EXPECT_FALSE(is_binary_stl("  SOLID x\nfacet"));
  EXPECT_FALSE(is_binary_stl("# c\nsolid x\n"));
  EXPECT_TRUE(is_binary_stl("solidarity"));
  EXPECT_TRUE(is_binary_stl("hello"));
  EXPECT_TRUE(is_ascii_stl("solid\nendsolid"));
  EXPECT_TRUE(is_ascii_stl("solid a b\n# c\n facet"));
  EXPECT_FALSE(is_ascii_stl("solid a b\nf 1 2 3"));
  EXPECT_TRUE(has_binary_stl_size(binary("", 2, 2)));
  EXPECT_FALSE(has_binary_stl_size(binary("", 2, 2) + "x"));
}

TEST(Stl, SeveralSolidsAreSeveralObjects) {
  const SourceMesh mesh =
      stl(std::string("solid a\n") + kFacet + "endsolid a\nsolid empty\nendsolid\nsolid a\n" + kFacet + kFacet + "endsolid\n");
  EXPECT_THAT(mesh.objects, ElementsAre("a", "a"));
  EXPECT_THAT(mesh.face_object, ElementsAre(0, 1, 1));
}

TEST(Stl, KeywordsMayHaveAnyCaseAndLinesAnyForm) {
  const SourceMesh mesh =
      stl("SOLID x\r\nFacet Normal 0 0 1 Outer Loop Vertex 0 0 0 vertex\n1\n0 0 vertex 1 1 0 EndLoop EndFacet\rEndSolid X\r");
  EXPECT_EQ(mesh.positions.size(), 3U);
  EXPECT_EQ(mesh.positions[1], (Vec3f{1, 0, 0}));
  EXPECT_THAT(mesh.objects, ElementsAre("x"));
}

TEST(Stl, NormalsOfAnyKindAreReadOver) {
  for (const char* normal :
       {"", "normal", "normal 0 0 1", "normal nan nan nan", "normal 1.#QNAN -1.#IND 0", "normal -nan(ind) 0 0", "normal 0 0"}) {
    const SourceMesh mesh =
        stl(std::string("solid\nfacet ") + normal + "\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\nendsolid");
    EXPECT_EQ(mesh.positions.size(), 3U) << normal;
    EXPECT_THAT(mesh.normals, IsEmpty());
  }
}

TEST(Stl, CommentsAreSkipped) {
  EXPECT_EQ(stl("# a\nsolid x # b\n# c\nfacet normal 0 0 1 # d\nouter loop # e\nvertex 0 0 0 # f\nvertex 1 0 0\n# g\nvertex 1 1 "
                "0\nendloop\nendfacet # "
                "h\nendsolid # i\n# j")
                .positions.size(),
            3U);
}

TEST(Stl, BytesBehindTheStatedFacetsAreANote) {
  const SourceMesh mesh = stl(binary("x", 1, 2) + "abc");
  EXPECT_EQ(mesh.positions.size(), 3U);
  EXPECT_THAT(texts(mesh.notes), ElementsAre("m.stl: 53 bytes behind the 1 facets that the header states are ignored"));
}

TEST(Stl, FewerFacetsThanStatedAreAnError) {
  EXPECT_EQ(error_of(binary("x", 3, 2)).text(), "m.stl: byte 80: the header states 3 facets, which need 234 bytes, but the file has 184");
  EXPECT_EQ(error_of(binary("x", 1431655764, 1)).kind, ErrorKind::malformed);
  EXPECT_EQ(error_of(binary("x", 1431655765, 1)).kind, ErrorKind::limit);  // 2^32 - 1 vertices
  EXPECT_EQ(error_of(binary("x", 0xFFFFFFFFU, 1)).kind, ErrorKind::limit);
  EXPECT_EQ(error_of("abc").text(), "m.stl: byte 3: the file ends here: expected ascii STL (solid ...) or 84 bytes of a binary header");
  EXPECT_EQ(error_of("").kind, ErrorKind::malformed);
}

TEST(Stl, LoopsOfOtherThanThreeVerticesAreANote) {
  const SourceMesh mesh =
      stl("solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 "
          "0\nvertex 0 1 "
          "0\nendloop\nendfacet\nendsolid\n");
  EXPECT_THAT(mesh.face_begin, ElementsAre(0, 4));
  EXPECT_EQ(mesh.positions.size(), 4U);
  EXPECT_THAT(texts(mesh.notes), ElementsAre("m.stl:2: facets with fewer than three vertices are dropped",
                                             "m.stl:8: facets with more than three vertices are taken as polygons"));
}

TEST(Stl, AMissingEndsolidIsANote) {
  EXPECT_THAT(texts(stl(std::string("solid x\n") + kFacet).notes), ElementsAre("m.stl:9: the file ends without endsolid"));
}

TEST(Stl, WhatIsNoFacetIsAnErrorWithItsLine) {
  EXPECT_EQ(error_of("solid\nface\n").text(), "m.stl:2: expected facet or endsolid, found \"face\"");
  EXPECT_EQ(error_of("solid\nfacet\nloop\n").text(), "m.stl:3: expected outer loop, found \"loop\"");
  EXPECT_EQ(error_of("solid\nfacet normal 0 0 1 0 outer loop\n").text(), "m.stl:2: expected outer loop, found \"0\"");
  EXPECT_EQ(error_of("solid\nfacet\nouter ring\n").text(), "m.stl:3: expected loop, found \"ring\"");
  EXPECT_EQ(error_of("solid\nfacet\nouter loop\nvertex 0 x 0\n").text(), "m.stl:4: expected a number of the vertex, found \"x\"");
  EXPECT_EQ(error_of("solid\nfacet\nouter loop\nvertex 0 0 0\nfoo").text(), "m.stl:5: expected vertex or endloop, found \"foo\"");
  EXPECT_EQ(error_of("solid\nfacet\nouter loop\nvertex 0 0 0\nendloop\n").text(), "m.stl:6: expected endfacet, found the end of the file");
  EXPECT_EQ(error_of("solid\n").text(), "m.stl:2: expected facet or endsolid, found the end of the file");
  EXPECT_EQ(error_of("solid\nendsolid\nfacet").text(), "m.stl:3: expected solid, found \"facet\"");
}

TEST(Stl, PositionsMayBeNoNumbersUntilTheMeshIsBuilt) {
  const SourceMesh mesh = stl("solid\nfacet\nouter loop\nvertex nan inf -1.#IND\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\nendsolid\n");
  EXPECT_FALSE(is_finite(mesh.positions[0]));
  EXPECT_TRUE(std::isinf(mesh.positions[0].y));
}

}  // namespace
}  // namespace lustro
