// What a header claims takes no memory: every allocation of this program is counted.
#include <string>

#include "allocation_hooks.hpp"
#include "io/obj.hpp"
#include "io/ply.hpp"
#include "io/stl.hpp"
#include "io_testing.hpp"

#ifndef LUSTRO_HOOKS_ARE_TAKEN

namespace lustro {
namespace {

TEST(Memory, AHeaderThatClaimsFourBillionTakesNone) {
  const std::size_t before = allocated_bytes;
  const std::string xyz = "property float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\nproperty float nz\n";
  const std::string list = "property list uint uint vertex_indices\n";
  for (const char* encoding : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string start = std::string("ply\nformat ") + encoding + " 1.0\n";
    EXPECT_FALSE(parse_ply(start + "element vertex 4000000000\n" + xyz + "end_header\n" + std::string(100, '1'), "m"));
    EXPECT_FALSE(
        parse_ply(start + "element vertex 0\n" + xyz + "element face 4000000000\n" + list + "end_header\n" + std::string(100, '1'), "m"));
    EXPECT_FALSE(parse_ply(start + "element face 1\n" + list + "end_header\n" + std::string(100, '\xEE'), "m"));
    EXPECT_FALSE(parse_ply(start + "element face 1\nproperty list double uchar other\nend_header\n4e9" + std::string(100, '\x42'), "m"));
    EXPECT_FALSE(parse_ply(start + "element tristrips 1\n" + list + "end_header\n4000000000 " + std::string(9, '\xEE'), "m"));
  }
  std::string stl(134, '\0');
  for (const char* count : {"\x00\x00\x00\x55", "\x55\x55\x55\x55", "\xFF\xFF\xFF\xFF"}) {  // 1.4 billion facets, one too many, 4 billion
    stl.replace(80, 4, std::string(count, 4));
    EXPECT_FALSE(parse_stl(stl, "m"));
  }
  EXPECT_FALSE(parse_obj("v 0 0 0\nf 4000000000 4000000000 4000000000\n", "m"));
  EXPECT_LT(allocated_bytes - before, 200'000U);
}

TEST(Memory, AParserTakesAFewTimesTheBytesOfItsFile) {
  std::string text;
  for (int i = 0; i < 20000; ++i) {
    text += "v 0 0 0\nvt 0 0\nvn 0 0 1\nf -1/-1/-1 -1/-1/-1 -1/-1/-1\n";
  }
  std::string ply =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty char x\nproperty char y\nproperty char z\nelement face 100000\n";
  ply += "property list uchar uchar vertex_indices\nend_header\nabc";
  for (int i = 0; i < 100000; ++i) {
    ply += std::string("\x03\0\0\0", 4);
  }
  std::size_t before = allocated_bytes;
  EXPECT_TRUE(parse_obj(text, "m"));
  EXPECT_LT(allocated_bytes - before, 8 * text.size());
  before = allocated_bytes;
  EXPECT_TRUE(parse_ply(ply, "m"));
  EXPECT_LT(allocated_bytes - before, 16 * ply.size());
}

}  // namespace
}  // namespace lustro

#endif  // LUSTRO_HOOKS_ARE_TAKEN
