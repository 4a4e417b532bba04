// Formats by content and by name.
#include "io/mesh_format.hpp"

#include <gtest/gtest.h>

#include <string>

namespace lustro {
namespace {

TEST(MeshFormat, ContentTellsTheFormat) {
  EXPECT_EQ(mesh_format_of_content("ply\nformat"), MeshFormat::ply);
  EXPECT_EQ(mesh_format_of_content("ply\r\n"), MeshFormat::ply);
  EXPECT_EQ(mesh_format_of_content("solid x\nfacet"), MeshFormat::stl);
  EXPECT_EQ(mesh_format_of_content(std::string(84, '\0')), MeshFormat::stl);
  EXPECT_EQ(mesh_format_of_content("OFF\n"), MeshFormat::off);
  EXPECT_EQ(mesh_format_of_content("# c\nSTCNOFF 8 6 12"), MeshFormat::off);
  EXPECT_EQ(mesh_format_of_content("glTF\x02"), MeshFormat::glb);
  EXPECT_EQ(mesh_format_of_content("\n {\"scene\": 0, \"asset\": {\"version\": \"2.0\"}}"), MeshFormat::gltf);
  for (const char* obj :
       {"v 0 0 0", "# c\n\n\tvn 1 0 0", "mtllib a.mtl", "o x", "g", "\xEF\xBB\xBFusemtl x", "f 1 2 3", "s off", "vt 0 0", "l 1 2"}) {
    EXPECT_EQ(mesh_format_of_content(obj), MeshFormat::obj) << obj;
  }
}

TEST(MeshFormat, OtherContentIsUnknown) {
  for (const char* other :
       {"", "# only a comment", "plywood", "hello", "v is the first letter of this text", "{\"objects\": []}", "solid ground", "OFFICE\n"}) {
    EXPECT_EQ(mesh_format_of_content(other), MeshFormat::unknown) << other;
  }
}

TEST(MeshFormat, NamesTellTheFormatInAnyCase) {
  EXPECT_EQ(mesh_format_of_name("a/b.obj"), MeshFormat::obj);
  EXPECT_EQ(mesh_format_of_name("a.PLY"), MeshFormat::ply);
  EXPECT_EQ(mesh_format_of_name("a.b.Stl"), MeshFormat::stl);
  EXPECT_EQ(mesh_format_of_name("a.off"), MeshFormat::off);
  EXPECT_EQ(mesh_format_of_name("a.gltf"), MeshFormat::gltf);
  EXPECT_EQ(mesh_format_of_name("a.glb"), MeshFormat::glb);
  EXPECT_EQ(mesh_format_of_name("obj"), MeshFormat::unknown);
  EXPECT_EQ(mesh_format_of_name("a.objx"), MeshFormat::unknown);
}

TEST(MeshFormat, UnknownContentIsDescribed) {
  EXPECT_EQ(describe_content(""), "an empty file");
  EXPECT_EQ(describe_content("\x89PNG\r\n"), "a PNG image");
  EXPECT_EQ(describe_content("Kaydara FBX Binary"), "an FBX file");
  EXPECT_EQ(describe_content(std::string("\x01\x02zz\0", 5)), "a file that begins with \"\\x01\\x02zz\\x00\"");
}

}  // namespace
}  // namespace lustro
