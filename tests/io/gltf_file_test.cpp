// Containers and URIs: GLB headers cut and changed, data in URIs, files that lie elsewhere.
#include "io/gltf_file.hpp"

#include "gltf_testing.hpp"
#include "io/gltf_uri.hpp"
#include "parallel/big_memory.hpp"
#include "temporary_folder.hpp"

namespace lustro {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string word(std::size_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) {
    bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
  }
  return bytes;
}

/// A triangle as GLB.
std::string glb() {
  GltfMaker maker;
  maker.add_node_with(maker.triangle());
  maker.json["buffers"] = {{{"byteLength", maker.bytes.size()}}};
  std::string json = maker.json.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string chunks = word(json.size()) + "JSON" + json + word(maker.bytes.size()) + std::string("BIN\0", 4) + maker.bytes;
  return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
}

Result<SourceMesh> parse(const std::string& bytes, const GltfOptions& options = {}) {
  Result<GltfModel> model = parse_gltf(bytes, "t.glb", options, {});
  return model ? gltf_whole_mesh(*model) : tl::unexpected(model.error());
}

TEST(GltfFile, AGlbHoldsItsFirstBuffer) {
  const SourceMesh mesh = good(parse(glb()));
  EXPECT_EQ(mesh.positions[1], (Vec3f{1, 0, 0}));
  EXPECT_EQ(mesh.format, "glTF (binary)");
}

TEST(GltfFile, EveryPrefixOfAGlbIsAnErrorWithAPlace) {
  const std::string whole = glb();
  for (std::size_t length = 4; length < whole.size(); ++length) {
    const std::string prefix(whole, 0, length);
    EXPECT_THAT(bad(parse(prefix)).where, StartsWith("t.glb: byte ")) << length;
  }
}

TEST(GltfFile, HeadersThatAreWrongAreNamedByByte) {
  std::string bytes = glb();
  bytes[4] = 1;
  EXPECT_EQ(bad(parse(bytes)).text(), "t.glb: byte 4: GLB version 1 is not read, expected 2");
  bytes = glb();
  bytes[16] = 'X';
  EXPECT_EQ(bad(parse(bytes)).text(), "t.glb: byte 16: the first chunk is not JSON");
  bytes = glb();
  bytes[14] = 1;  // a chunk of 64 KiB more
  EXPECT_THAT(bad(parse(bytes)).text(), HasSubstr("byte 12: a chunk states"));
}

TEST(GltfFile, DataUrisAreDecoded) {
  const auto decoded = [](std::string_view uri) {
    const FileBytes bytes = good(decode_data_uri(uri));
    return std::string(bytes.view());
  };
  EXPECT_EQ(decoded("data:text/plain;base64,THVzdHJv"), "Lustro");
  EXPECT_EQ(decoded("data:;base64,TA=="), "L");
  EXPECT_EQ(decoded("data:;base64,THU="), "Lu");
  EXPECT_EQ(decoded("data:;base64,"), "");
  EXPECT_EQ(decoded("data:,a%20b"), "a b");
  EXPECT_EQ(bad(decode_data_uri("data:;base64,TA*=")).message, "its base64 has \"*\" at letter 2");
  EXPECT_EQ(bad(decode_data_uri("data:;base64,TAAAA")).message, "its base64 is cut short");
  EXPECT_THAT(bad(decode_data_uri("data:;base64")).message, HasSubstr("no comma"));
}

TEST(GltfFile, FilesLieBesideTheDocument) {
  EXPECT_EQ(good(confined_path("a.bin")), "a.bin");
  EXPECT_EQ(good(confined_path("sub/./x/../a%20b.bin")), "sub/a b.bin");
  EXPECT_EQ(good(confined_path("sub\\a.bin")), "sub/a.bin");
  for (const char* wrong : {"/etc/passwd", "../a.bin", "sub/../../a.bin", "%2e%2e/a.bin", "%2Fetc/passwd", "..\\a.bin", "file:///etc/passwd",
                            "http://x/a.bin", "C:/a.bin", "", "a%2", "a%zz.bin", "a%00b"}) {
    EXPECT_FALSE(confined_path(wrong)) << wrong;
  }
}

TEST(GltfFile, AFileThatIsNotThereIsNamedByItsUri) {
  const TemporaryFolder folder;
  folder.write("a.gltf", R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 4, "uri": "gone.bin"}]})");
  const Error error = bad(load_mesh_file(folder.path / "a.gltf"));
  EXPECT_EQ(error.kind, ErrorKind::io);
  EXPECT_EQ(error.where, (folder.path / "a.gltf").string() + ": buffers[0].uri");
  EXPECT_THAT(error.message, HasSubstr("gone.bin"));
  folder.write("b.gltf", R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 4, "uri": "../a.gltf"}]})");
  EXPECT_EQ(bad(load_mesh_file(folder.path / "b.gltf")).message, "\"../a.gltf\" lies outside the document's folder");
}

}  // namespace
}  // namespace lustro
