// What a primitive becomes, by values on paper.
#include <algorithm>
#include <cmath>

#include "gltf_testing.hpp"
#include "image/srgb.hpp"

namespace lustro {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

/// Five points of a strip: a zigzag whose triangles all face +z.
std::vector<float> zigzag() {
  return {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0};
}

float normal_z(const SourceMesh& mesh, std::size_t face) {
  const auto p = [&](std::size_t k) { return mesh.positions[mesh.corner_position[3 * face + k]]; };
  return cross(p(1) - p(0), p(2) - p(0)).z;
}

TEST(GltfMesh, AStripTurnsEveryOtherTriangleRound) {
  GltfMaker maker;
  maker.add_node_with({{"attributes", {{"POSITION", maker.add_accessor<float>("VEC3", zigzag())}}}, {"mode", 5}});
  const SourceMesh mesh = good(maker.mesh());
  EXPECT_THAT(mesh.corner_position, ElementsAre(0, 1, 2, 1, 3, 2, 2, 3, 4));
  for (std::size_t f = 0; f < 3; ++f) {
    EXPECT_EQ(normal_z(mesh, f), 1) << f;
  }
}

TEST(GltfMesh, AFanEndsInItsHub) {
  GltfMaker maker;
  maker.add_node_with({{"attributes", {{"POSITION", maker.add_accessor<float>("VEC3", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0})}}}, {"mode", 6}});
  const SourceMesh mesh = good(maker.mesh());
  EXPECT_THAT(mesh.corner_position, ElementsAre(1, 2, 0, 2, 3, 0));
  EXPECT_EQ(normal_z(mesh, 0), 1);
  EXPECT_EQ(normal_z(mesh, 1), 1);
}

TEST(GltfMesh, IndicesOfEveryWidthAreTheSame) {
  const auto corners = [](auto zero) {
    GltfMaker maker;
    using T = decltype(zero);
    Json primitive = maker.triangle();
    primitive["indices"] = maker.add_accessor<T>("SCALAR", {2, 0, 1});
    maker.add_node_with(primitive);
    return good(maker.mesh()).corner_position;
  };
  EXPECT_THAT(corners(std::uint8_t{}), ElementsAre(2, 0, 1));
  EXPECT_THAT(corners(std::uint16_t{}), ElementsAre(2, 0, 1));
  EXPECT_THAT(corners(std::uint32_t{}), ElementsAre(2, 0, 1));
}

TEST(GltfMesh, PointsAndLinesAreCountedInANote) {
  GltfMaker maker;
  for (const int mode : {0, 1, 2, 3, 4}) {
    Json primitive = maker.triangle();
    primitive["mode"] = mode;
    maker.add_node_with(primitive);
  }
  const SourceMesh mesh = good(maker.mesh());
  EXPECT_EQ(mesh.face_count(), 1U);
  EXPECT_THAT(texts(mesh.notes), ElementsAre("t.gltf: 1 primitive of points is skipped: only triangles are drawn",
                                             "t.gltf: 3 primitives of lines are skipped: only triangles are drawn"));
}

TEST(GltfMesh, WithoutNormalsFacesAreFlat) {
  GltfMaker maker;
  maker.add_node_with({{"attributes", {{"POSITION", maker.add_accessor<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 1})}}}, {"mode", 5}});
  const BuiltMesh built = good(build_mesh(good(maker.mesh())));
  ASSERT_EQ(built.mesh.positions.size(), 6U);  // no vertex is shared
  for (const auto& triangle : built.mesh.triangles) {
    EXPECT_EQ(built.mesh.normals[triangle[0]], built.mesh.normals[triangle[1]]);
    EXPECT_EQ(built.mesh.normals[triangle[0]], built.mesh.normals[triangle[2]]);
  }
  EXPECT_EQ(built.mesh.normals[built.mesh.triangles[0][0]], (Vec3f{0, 0, 1}));
}

TEST(GltfMesh, InterleavedAttributesAreReadByTheirStride) {
  GltfMaker maker;
  const std::size_t view = maker.add_view<float>({0, 0, 0, 0.25F, 0.5F, 1, 0, 0, 0.75F, 1, 0, 1, 0, 0, 0}, 20);
  const std::size_t position = maker.add("accessors", {{"bufferView", view}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
  const std::size_t uv =
      maker.add("accessors", {{"bufferView", view}, {"byteOffset", 12}, {"componentType", 5126}, {"count", 3}, {"type", "VEC2"}});
  maker.add_node_with({{"attributes", {{"POSITION", position}, {"TEXCOORD_0", uv}}}});
  const SourceMesh mesh = good(maker.mesh());
  EXPECT_THAT(mesh.positions, ElementsAre(Vec3f{0, 0, 0}, Vec3f{1, 0, 0}, Vec3f{0, 1, 0}));
  EXPECT_THAT(mesh.uvs, ElementsAre(Vec2f{0.25F, 0.5F}, Vec2f{0.75F, 1}, Vec2f{0, 0}));
}

TEST(GltfMesh, NormalizedIntegersReachBothEnds) {
  GltfMaker maker;
  maker.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  const std::size_t position = maker.add_accessor<std::int16_t>("VEC3", {-32768, 0, 32767, 32767, 0, 0, 0, 32767, 0}, true);
  maker.json["bufferViews"][0]["byteLength"] = 18;
  const std::size_t uv = maker.add_accessor<std::uint8_t>("VEC2", {0, 255, 51, 102, 0, 0}, true);
  maker.add_node_with({{"attributes", {{"POSITION", position}, {"TEXCOORD_0", uv}}}});
  const SourceMesh mesh = good(maker.mesh());
  EXPECT_EQ(mesh.positions[0], (Vec3f{-1, 0, 1}));  // -32768 counts as -32767
  EXPECT_EQ(mesh.uvs[0], (Vec2f{0, 1}));
  EXPECT_EQ(mesh.uvs[1], (Vec2f{0.2F, 0.4F}));
}

TEST(GltfMesh, QuantizedPositionsStandAsTheyAre) {
  GltfMaker maker;
  maker.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  const std::size_t position = maker.add_accessor<std::int8_t>("VEC3", {-3, 0, 7, 0, 0, 0, 0, 5, 0});
  maker.add_node_with({{"attributes", {{"POSITION", position}}}});
  EXPECT_EQ(good(maker.mesh()).positions[0], (Vec3f{-3, 0, 7}));
  maker.json.erase("extensionsUsed");
  const Error error = bad(maker.mesh());
  EXPECT_EQ(error.where, "t.gltf: meshes[0].primitives[0].attributes.POSITION");
  EXPECT_THAT(error.message, HasSubstr("VEC3 of BYTE"));
  EXPECT_THAT(error.message, HasSubstr("KHR_mesh_quantization"));
}

TEST(GltfMesh, SparseValuesReplaceThoseOfTheView) {
  GltfMaker maker;
  const std::size_t position = maker.add_accessor<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
  maker.json["accessors"][position]["sparse"] = {{"count", 2},
                                                 {"indices", {{"bufferView", maker.add_view<std::uint16_t>({0, 2})}, {"componentType", 5123}}},
                                                 {"values", {{"bufferView", maker.add_view<float>({-1, -1, 0, 0, 3, 0})}}}};
  maker.add_node_with({{"attributes", {{"POSITION", position}}}});
  EXPECT_THAT(good(maker.mesh()).positions, ElementsAre(Vec3f{-1, -1, 0}, Vec3f{1, 0, 0}, Vec3f{0, 3, 0}));
  maker.bytes[36] = 2;  // indices 2, 2
  const Error error = bad(maker.mesh());
  EXPECT_EQ(error.text(), "t.gltf: accessors[0].sparse.indices: element 1 is 2, expected 3..2 (they rise)");
}

TEST(GltfMesh, WithoutAViewThereAreZeros) {
  GltfMaker maker;
  const std::size_t position = maker.add("accessors", {{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
  maker.json["accessors"][position]["sparse"] = {{"count", 1},
                                                 {"indices", {{"bufferView", maker.add_view<std::uint8_t>({1})}, {"componentType", 5121}}},
                                                 {"values", {{"bufferView", maker.add_view<float>({4, 5, 6})}}}};
  maker.add_node_with({{"attributes", {{"POSITION", position}}}});
  EXPECT_THAT(good(maker.mesh()).positions, ElementsAre(Vec3f{}, Vec3f{4, 5, 6}, Vec3f{}));
}

TEST(GltfMesh, ACountWithoutBytesTakesNoMemory) {
  GltfMaker maker;
  const std::size_t position = maker.add("accessors", {{"componentType", 5126}, {"count", 4'000'000'000U}, {"type", "VEC3"}});
  maker.add_node_with({{"attributes", {{"POSITION", position}}}, {"mode", 5}});
  const Error error = bad(maker.mesh());
  EXPECT_EQ(error.kind, ErrorKind::limit);
  EXPECT_EQ(error.where, "t.gltf: accessors[0].count");
}

TEST(GltfMesh, ColoursAreLinearInTheFile) {
  GltfMaker maker;
  Json primitive = maker.triangle();
  primitive["attributes"]["COLOR_0"] = maker.add_accessor<float>("VEC4", {0.5F, 1, 0, 0.25F, 2, -1, 0.1F, 1, 1, 1, 1, 7});
  maker.add_node_with(primitive);
  const SourceMesh mesh = good(maker.mesh());
  EXPECT_NEAR(srgb_decode(mesh.colors[0].x), 0.5, 1e-5);
  EXPECT_EQ(mesh.colors[0].y, 1);
  EXPECT_EQ(mesh.colors[1].x, 1);
  EXPECT_EQ(mesh.colors[1].y, 0);
  EXPECT_NEAR(srgb_decode(mesh.colors[1].z), 0.1, 1e-5);
  EXPECT_THAT(mesh.alphas, ElementsAre(0.25F, 1, 1));
  expect_consistent(mesh);
}

TEST(GltfMesh, EveryStreamReachesTheMeshThatIsDrawn) {
  GltfMaker maker;
  Json primitive = maker.triangle();
  primitive["attributes"]["NORMAL"] = maker.add_accessor<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
  primitive["attributes"]["TANGENT"] = maker.add_accessor<float>("VEC4", {1, 0, 0, -1, 0, 2, 0, 1, 1, 0, 0, 1});
  primitive["attributes"]["TEXCOORD_0"] = maker.add_accessor<float>("VEC2", {0, 0, 1, 0, 0, 1});
  primitive["attributes"]["TEXCOORD_1"] = maker.add_accessor<float>("VEC2", {5, 6, 7, 8, 9, 10});
  primitive["indices"] = maker.add_accessor<std::uint8_t>("SCALAR", {2, 0, 1});
  maker.add_node_with(primitive);
  const Mesh mesh = good(build_mesh(good(maker.mesh()))).mesh;
  const auto vertex = static_cast<std::size_t>(std::find(mesh.positions.begin(), mesh.positions.end(), Vec3f{1, 0, 0}) - mesh.positions.begin());
  ASSERT_LT(vertex, 3U);
  EXPECT_EQ(mesh.uvs[vertex], (Vec2f{1, 0}));
  EXPECT_EQ(mesh.uvs1[vertex], (Vec2f{7, 8}));
  EXPECT_EQ(mesh.tangents[vertex], (std::array<float, 4>{0, 1, 0, 1}));  // made a unit vector
  EXPECT_EQ(mesh.normals[vertex], (Vec3f{0, 0, 1}));
}

TEST(GltfMesh, PrimitivesWithTheSameAccessorsShareTheirVertices) {
  GltfMaker maker;
  Json primitive = maker.triangle();
  Json other = primitive;
  other["indices"] = maker.add_accessor<std::uint8_t>("SCALAR", {2, 1, 0});
  const std::size_t mesh = maker.add("meshes", {{"primitives", {primitive, other}}});
  maker.add("nodes", {{"mesh", mesh}});
  const SourceMesh made = good(maker.mesh());
  EXPECT_EQ(made.positions.size(), 3U);
  EXPECT_THAT(made.corner_position, ElementsAre(0, 1, 2, 2, 1, 0));
}

TEST(GltfMesh, AMirroredNodeKeepsItsFrontInFront) {
  GltfMaker maker;
  Json primitive = maker.triangle();
  primitive["attributes"]["NORMAL"] = maker.add_accessor<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
  maker.add_node_with(primitive, {{"scale", {-2, 1, 1}}});
  const SourceMesh mesh = good(maker.mesh());
  EXPECT_EQ(mesh.positions[1], (Vec3f{-2, 0, 0}));
  EXPECT_EQ(mesh.normals[0], (Vec3f{0, 0, 1}));
  EXPECT_GT(normal_z(mesh, 0), 0);
}

TEST(GltfMesh, NormalsGoByTheInverseTranspose) {
  GltfMaker maker;
  Json primitive = maker.triangle();
  const float h = std::sqrt(0.5F);
  primitive["attributes"]["NORMAL"] = maker.add_accessor<float>("VEC3", {h, 0, h, h, 0, h, h, 0, h});
  maker.add_node_with(primitive, {{"scale", {2, 1, 1}}});
  const Vec3f normal = good(maker.mesh()).normals[0];  // (1/2, 0, 1), made a unit vector
  EXPECT_NEAR(normal.x, 1 / std::sqrt(5.0), 1e-6);
  EXPECT_NEAR(normal.z, 2 / std::sqrt(5.0), 1e-6);
}

TEST(GltfMesh, MorphTargetsAddUp) {
  GltfMaker maker;
  Json primitive = maker.triangle();
  primitive["targets"] = {{{"POSITION", maker.add_accessor<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1})}},
                          {{"POSITION", maker.add_accessor<float>("VEC3", {4, 0, 0, 0, 0, 0, 0, 0, 0})}}};
  const std::size_t node = maker.add_node_with(primitive);
  EXPECT_EQ(good(maker.mesh()).positions[0], (Vec3f{0, 0, 0}));
  maker.json["meshes"][0]["weights"] = {0.5, 0};
  EXPECT_EQ(good(maker.mesh()).positions[0], (Vec3f{0, 0, 0.5F}));
  maker.json["nodes"][node]["weights"] = {2, 0.25};  // the node's own win
  EXPECT_EQ(good(maker.mesh()).positions[0], (Vec3f{1, 0, 2}));
  maker.json["nodes"][node]["weights"] = {2};
  EXPECT_EQ(bad(maker.mesh()).where, "t.gltf: nodes[0].weights");
}

TEST(GltfMesh, ASkinBlendsItsJointsAndForgetsItsNode) {
  GltfMaker maker;
  Json primitive = maker.triangle();
  primitive["attributes"]["JOINTS_0"] = maker.add_accessor<std::uint8_t>("VEC4", {0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0});
  primitive["attributes"]["WEIGHTS_0"] = maker.add_accessor<float>("VEC4", {1, 0, 0, 0, 0.25F, 0.25F, 0, 0, 1, 0, 0, 0});
  const std::size_t node = maker.add_node_with(primitive, {{"translation", {100, 100, 100}}});
  // Joint 0 stands where it was bound, at x = 10. Joint 1 is bound at the origin, and stands 4 higher.
  const std::size_t first = maker.add("nodes", {{"translation", {10, 0, 0}}});
  const std::size_t second = maker.add("nodes", {{"translation", {0, 4, 0}}});
  const std::size_t bind =
      maker.add_accessor<float>("MAT4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -10, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
  maker.add("skins", {{"joints", {first, second}}, {"inverseBindMatrices", bind}});
  maker.json["nodes"][node]["skin"] = 0;
  EXPECT_THAT(good(maker.mesh()).positions, ElementsAre(Vec3f{0, 0, 0}, Vec3f{1, 2, 0}, Vec3f{0, 5, 0}));  // halves of weights 1/4 and 1/4

  GltfModel model = good(maker.model());
  EXPECT_EQ(good(gltf_scene(model, "t.gltf", {})).scene.objects[0].matrix, Mat4{});
  maker.json["skins"][0]["joints"] = {first};
  maker.json["skins"][0].erase("inverseBindMatrices");
  const Error error = bad(maker.mesh());
  EXPECT_EQ(error.text(), "t.gltf: accessors[1]: vertex 1 names joint 1, outside 0..0 of skins[0]");
}

TEST(GltfMesh, AnIndexBeyondTheVerticesIsAnError) {
  GltfMaker maker;
  Json primitive = maker.triangle();
  primitive["indices"] = maker.add_accessor<std::uint8_t>("SCALAR", {0, 1, 3});
  maker.add_node_with(primitive);
  EXPECT_EQ(bad(maker.mesh()).text(), "t.gltf: meshes[0].primitives[0].indices: element 2 of accessors[1] is 3, outside 0..2");
}

}  // namespace
}  // namespace lustro
