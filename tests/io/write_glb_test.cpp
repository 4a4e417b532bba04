// Binary glTF, taken apart by hand.
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "io/mesh_writers.hpp"
#include "io_testing.hpp"
#include "lustro/mesh_file.hpp"
#include "lustro/scene.hpp"
#include "temporary_folder.hpp"

namespace lustro {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

std::uint32_t u32(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) {
    value = value << 8U | static_cast<unsigned char>(bytes.at(at + i));
  }
  return value;
}

struct Glb {
  json gltf;
  std::string binary;
};

/// The chunks, after what the specification asks of every file.
Glb taken_apart(const std::string& bytes) {
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(u32(bytes, 4), 2U);
  EXPECT_EQ(u32(bytes, 8), bytes.size());
  const std::size_t json_bytes = u32(bytes, 12);
  EXPECT_EQ(json_bytes % 4, 0U);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  Glb glb{json::parse(bytes.substr(20, json_bytes)), {}};
  if (const std::size_t at = 20 + json_bytes; at < bytes.size()) {
    EXPECT_EQ(bytes.substr(at + 4, 4), std::string("BIN\0", 4));
    glb.binary = bytes.substr(at + 8);
    EXPECT_EQ(u32(bytes, at), glb.binary.size());
    EXPECT_EQ(glb.binary.size() % 4, 0U);
    EXPECT_EQ(glb.gltf["buffers"][0]["byteLength"], glb.binary.size());
  }
  for (const json& accessor : glb.gltf.value("accessors", json::array())) {
    const json& view = glb.gltf["bufferViews"].at(accessor["bufferView"].get<std::size_t>());
    const std::string type = accessor["type"];
    const std::size_t components = type == "SCALAR" ? 1U : static_cast<std::size_t>(type[3] - '0');
    EXPECT_EQ(view["byteLength"], 4 * components * accessor["count"].get<std::size_t>());
    EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0U);
    EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(), glb.binary.size());
  }
  return glb;
}

std::string bytes_of(const Glb& glb, const json& accessor) {
  const json& view = glb.gltf["bufferViews"].at(glb.gltf["accessors"].at(accessor.get<std::size_t>())["bufferView"].get<std::size_t>());
  return glb.binary.substr(view["byteOffset"], view["byteLength"]);
}
template <class T>
std::string raw(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

Mesh two_triangles() {
  Mesh mesh;
  mesh.positions = {{-0.0F, 1e-40F, 3}, {1, 0, 0}, {0, 1, 0}, {0.1F, 0.2F, -0.3F}};
  mesh.normals.assign(4, Vec3f{0, 0, 1});
  mesh.tangents.assign(4, {1, 0, 0, -1});
  mesh.uvs = {{0, 0.1F}, {1, 0}, {0, 1}, {2, -3}};
  mesh.uvs1 = {{5, 0}, {1, 0}, {0, 1}, {2, -3}};
  mesh.colors = {{1, 0, 0.5F}, {1, 1, 1}, {0, 0, 0}, {1, 1, 1}};
  mesh.alphas = {1, 0.5F, 0, 1};
  mesh.triangles = {{0, 1, 2}, {3, 2, 1}};
  return mesh;
}

TEST(WriteGlb, AttributesStandInTheBufferBitForBit) {
  const Mesh mesh = two_triangles();
  const Glb glb = taken_apart(good(glb_bytes(mesh, {})).bytes);
  ASSERT_EQ(glb.gltf["meshes"][0]["primitives"].size(), 1U);
  const json& primitive = glb.gltf["meshes"][0]["primitives"][0];
  const json& attributes = primitive["attributes"];
  EXPECT_EQ(bytes_of(glb, attributes["POSITION"]), raw(mesh.positions));
  EXPECT_EQ(bytes_of(glb, attributes["NORMAL"]), raw(mesh.normals));
  EXPECT_EQ(bytes_of(glb, attributes["TANGENT"]), raw(mesh.tangents));
  EXPECT_EQ(bytes_of(glb, attributes["TEXCOORD_0"]), raw(mesh.uvs));
  EXPECT_EQ(bytes_of(glb, attributes["TEXCOORD_1"]), raw(mesh.uvs1));
  EXPECT_EQ(bytes_of(glb, primitive["indices"]), raw(mesh.triangles));
  const json& positions = glb.gltf["accessors"].at(attributes["POSITION"].get<std::size_t>());
  EXPECT_EQ(positions["min"].get<std::vector<float>>(), (std::vector<float>{0, 0, -0.3F}));
  EXPECT_EQ(positions["max"].get<std::vector<float>>(), (std::vector<float>{1, 1, 3}));
  std::array<float, 4> color{};
  std::memcpy(color.data(), bytes_of(glb, attributes["COLOR_0"]).data(), sizeof color);
  EXPECT_NEAR(color[2], 0.21404, 1e-5);  // 0.5 decoded
  EXPECT_EQ(color[3], 1.0F);
  EXPECT_EQ(glb.gltf["nodes"][0]["mesh"], 0);
  EXPECT_EQ(glb.gltf["scenes"][0]["nodes"][0], 0);
}

TEST(WriteGlb, EachMaterialIsAPrimitiveWithItsOwnVertices) {
  Mesh mesh = two_triangles();
  mesh.triangle_material = {2, 0};
  mesh.materials.resize(3);
  const Glb glb = taken_apart(good(glb_bytes(mesh, {})).bytes);
  const json& primitives = glb.gltf["meshes"][0]["primitives"];
  ASSERT_EQ(primitives.size(), 2U);
  EXPECT_EQ(primitives[0]["material"], 0);
  EXPECT_EQ(primitives[1]["material"], 2);
  const std::vector<Vec3f> first{mesh.positions[3], mesh.positions[2], mesh.positions[1]};
  EXPECT_EQ(bytes_of(glb, primitives[0]["attributes"]["POSITION"]), raw(first));
  EXPECT_EQ(bytes_of(glb, primitives[0]["indices"]), raw(std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(WriteGlb, ClassicMaterialsBecomeMetalRoughOnes) {
  Mesh mesh = two_triangles();
  mesh.alphas.clear();
  mesh.materials.resize(3);
  Material& glossy = mesh.materials[0];
  glossy.name = "glossy";
  glossy.diffuse = {{0.5F, 2, 0}, ColorSpace::encoded};
  glossy.specular = {{1, 1, 1}, ColorSpace::linear};
  glossy.shininess = 30;  // alpha^2 = 2 / 32 = 1/16, roughness = sqrt(1/4)
  glossy.lighting = Lighting::blinn_phong;
  glossy.emission = {{4, 2, 0}, ColorSpace::linear};
  mesh.materials[1].opacity = 0.5F;
  mesh.materials[2].lighting = Lighting::constant;
  const json materials = taken_apart(good(glb_bytes(mesh, {})).bytes).gltf["materials"];
  const json& surface = materials[0]["pbrMetallicRoughness"];
  EXPECT_EQ(materials[0]["name"], "glossy");
  EXPECT_NEAR(surface["baseColorFactor"][0].get<double>(), 0.21404, 1e-5);
  EXPECT_EQ(surface["baseColorFactor"][1], 1.0);
  EXPECT_EQ(surface["metallicFactor"], 0);
  EXPECT_EQ(surface["roughnessFactor"], 0.5);
  EXPECT_EQ(materials[0]["emissiveFactor"], json({1.0, 0.5, 0.0}));
  EXPECT_EQ(materials[0]["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"], 4.0);
  EXPECT_FALSE(materials[0].contains("alphaMode"));
  EXPECT_EQ(materials[1]["alphaMode"], "BLEND");
  EXPECT_EQ(materials[1]["pbrMetallicRoughness"]["roughnessFactor"], 1.0);
  EXPECT_TRUE(materials[2]["extensions"].contains("KHR_materials_unlit"));
}

TEST(WriteGlb, DiffuseMapsComeAlongInTheFile) {
  const TemporaryFolder folder;
  const std::string png = "\x89PNG\r\n\x1A\nxyz";
  folder.write("maps/wood.png", png);
  folder.write("maps/wood.tga", "tga");
  Mesh mesh = two_triangles();
  mesh.materials.resize(3);
  for (Material& material : mesh.materials) {
    TextureMap map;
    map.statement = "map_Kd";
    map.file = "maps\\wood.png";
    map.scale = {2, 3, 1};
    map.offset = {0.25F, 0.5F, 0};
    material.maps = {map};
  }
  mesh.materials[1].maps[0].file = "maps/wood.tga";
  mesh.materials[2].maps[0].clamp = true;
  mesh.materials[2].maps.push_back(mesh.materials[0].maps[0]);
  mesh.materials[2].maps[1].statement = "map_Ks";
  const Notes notes = good(write_mesh(folder.path / "m.glb", mesh, {.texture_folder = folder.path}));
  EXPECT_THAT(texts(notes), testing::Contains(HasSubstr("1 maps are no diffuse ones")));
  EXPECT_THAT(texts(notes), testing::Contains(HasSubstr("1 diffuse maps are no PNG or JPEG files")));
  std::ifstream file(folder.path / "m.glb", std::ios::binary);
  const Glb glb = taken_apart({std::istreambuf_iterator<char>(file), {}});
  ASSERT_EQ(glb.gltf["images"].size(), 1U);  // once, however often it is used
  const json& view = glb.gltf["bufferViews"].at(glb.gltf["images"][0]["bufferView"].get<std::size_t>());
  EXPECT_EQ(glb.binary.substr(view["byteOffset"], view["byteLength"]), png);
  EXPECT_EQ(glb.gltf["images"][0]["mimeType"], "image/png");
  const json& texture = glb.gltf["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
  // (2 u + 0.25, 3 v + 0.5) with v up is (2 u + 0.25, 1 - 0.5 - 3 v) with v down
  EXPECT_EQ(texture["extensions"]["KHR_texture_transform"], json({{"offset", {0.25, 0.5}}, {"scale", {2.0, -3.0}}}));
  EXPECT_FALSE(glb.gltf["materials"][1]["pbrMetallicRoughness"].contains("baseColorTexture"));
  EXPECT_EQ(glb.gltf["samplers"][glb.gltf["textures"][1]["sampler"].get<std::size_t>()]["wrapS"], 33071);
  EXPECT_EQ(glb.gltf["extensionsUsed"], json({"KHR_texture_transform"}));
}

TEST(WriteGlb, OurReaderGetsTheSameBits) {
  const TemporaryFolder folder;
  const Mesh mesh = build_mesh(good(make_primitive("torus:12"))).value().mesh;
  ASSERT_FALSE(mesh.uvs.empty());
  EXPECT_THAT(good(write_mesh(folder.path / "m.glb", mesh)), IsEmpty());
  const SourceMesh read = good(load_mesh_file(folder.path / "m.glb"));
  expect_consistent(read);
  EXPECT_EQ(read.positions, mesh.positions);  // but for the sign of 0, which the node's matrix loses
  EXPECT_EQ(read.normals, mesh.normals);
  EXPECT_EQ(read.uvs, mesh.uvs);
  ASSERT_EQ(read.corner_position.size(), 3 * mesh.triangles.size());
  EXPECT_EQ(raw(read.corner_position), raw(mesh.triangles));
}

TEST(WriteGlb, AMeshWithoutTrianglesIsAnEmptyScene) {
  const Result<MeshBytes> glb = glb_bytes(Mesh{}, {});
  EXPECT_THAT(good(glb).notes, IsEmpty());
  EXPECT_FALSE(taken_apart(glb->bytes).gltf.contains("meshes"));
}

}  // namespace
}  // namespace lustro
