// A glTF file as a scene: objects, cameras, and scene files that name its nodes.
#include "io/gltf_scene.hpp"

#include "gltf_testing.hpp"
#include "lustro/scene.hpp"
#include "temporary_folder.hpp"

namespace lustro {
namespace {

using Json = nlohmann::json;

/// Two nodes with one mesh, and two cameras.
GltfMaker two_triangles() {
  GltfMaker maker;
  maker.add_node_with(maker.triangle(), {{"name", "first"}});
  maker.add("nodes", {{"mesh", 0}, {"translation", {0, 0, 3}}});
  maker.json["cameras"] = {{{"type", "perspective"}, {"name", "near"}, {"perspective", {{"yfov", 1.0471975511965976}, {"znear", 0.5}}}},
                           {{"type", "orthographic"}, {"orthographic", {{"xmag", 3}, {"ymag", 2}, {"znear", 0}, {"zfar", 9}}}}};
  maker.add("nodes", {{"camera", 0}, {"translation", {1, 2, 3}}});
  maker.add("nodes", {{"camera", 1}, {"name", "plan"}, {"rotation", {-0.70710678, 0, 0, 0.70710678}}, {"scale", {2, 2, 2}}});
  return maker;
}

TEST(GltfScene, EveryNodeWithAMeshIsAnObject) {
  const TemporaryFolder folder;
  folder.write("t.gltf", two_triangles().text());
  const LoadedScene loaded = good(load_scene(folder.path / "t.gltf"));
  ASSERT_EQ(loaded.scene.objects.size(), 2U);
  EXPECT_EQ(loaded.scene.objects[0].name, "first");
  EXPECT_EQ(loaded.scene.objects[1].name, "nodes[1]");
  EXPECT_EQ(loaded.scene.objects[1].matrix(2, 3), 3);
  EXPECT_EQ(loaded.scene.objects[0].mesh, loaded.scene.objects[1].mesh);  // one mesh in memory
  EXPECT_TRUE(loaded.scene.shading.two_sided);
  EXPECT_TRUE(loaded.scene.shading.normalized);
  EXPECT_FALSE(loaded.scene.lights);
  EXPECT_THAT(loaded.cameras, testing::ElementsAre("near", "plan"));
}

TEST(GltfScene, ACameraIsLookedThroughByNumberOrName) {
  const TemporaryFolder folder;
  folder.write("t.gltf", two_triangles().text());
  const auto camera = [&](const char* which) { return good(load_scene(folder.path / "t.gltf", {.gltf_camera = which})).scene.camera; };
  const Camera near = camera("near");
  EXPECT_EQ(near.eye, (Vec3d{1, 2, 3}));
  EXPECT_EQ(near.target, (Vec3d{1, 2, 2}));  // along -z
  EXPECT_NEAR(near.fov, 60, 1e-9);
  EXPECT_EQ(near.near, 0.5);
  EXPECT_FALSE(near.far);
  EXPECT_EQ(camera("0").eye, near.eye);
  const Camera plan = camera("plan");
  EXPECT_EQ(plan.projection, Projection::orthographic);
  EXPECT_EQ(plan.height, 4);
  EXPECT_NEAR(plan.target->y, -1, 1e-6);  // turned by -90 degrees about x it looks down
  EXPECT_NEAR(plan.up->z, -1, 1e-6);
  EXPECT_EQ(bad(load_scene(folder.path / "t.gltf", {.gltf_camera = "x"})).text(),
            (folder.path / "t.gltf").string() + ": has no camera \"x\", only 0 \"near\", 1 \"plan\"");
}

TEST(GltfScene, ASceneFileMayNameTheWholeOrANode) {
  const TemporaryFolder folder;
  folder.write("t.gltf", two_triangles().text());
  folder.write("s.json", R"({"objects": [{"mesh": "t.gltf"}, {"mesh": "t.gltf#nodes[1]"}, {"mesh": "t.gltf#nodes[0]"}]})");
  const LoadedScene loaded = good(load_scene(folder.path / "s.json"));
  EXPECT_EQ(loaded.scene.objects[0].mesh->triangles.size(), 2U);
  EXPECT_EQ(loaded.scene.objects[1].mesh->triangles.size(), 1U);
  EXPECT_EQ(loaded.scene.objects[1].mesh->bounds().upper.z, 0);  // not moved
  EXPECT_EQ(loaded.scene.objects[1].mesh, loaded.scene.objects[2].mesh);
  folder.write("s.json", R"({"objects": [{"mesh": "t.gltf#nodes[2]"}]})");
  EXPECT_THAT(bad(load_scene(folder.path / "s.json")).text(), testing::EndsWith("t.gltf: nodes[2]: is no node with a mesh"));
}

TEST(GltfScene, TheWrittenSceneIsTheSameScene) {
  const TemporaryFolder folder;
  folder.write("t.gltf", two_triangles().text());
  const LoadedScene loaded = good(load_scene(folder.path / "t.gltf", {.gltf_camera = "0"}));
  folder.write("s.json", scene_json(loaded.scene));
  const LoadedScene again = good(load_scene(folder.path / "s.json"));
  ASSERT_EQ(again.scene.objects.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(again.scene.objects[i].matrix, loaded.scene.objects[i].matrix);
    EXPECT_EQ(again.scene.objects[i].mesh->positions, loaded.scene.objects[i].mesh->positions);
  }
  EXPECT_EQ(again.scene.camera.eye, loaded.scene.camera.eye);
}

TEST(GltfScene, InstancesAreObjectsToo) {
  GltfMaker maker;
  maker.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  const std::size_t node = maker.add_node_with(maker.triangle(), {{"translation", {0, 10, 0}}});
  maker.json["nodes"][node]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"TRANSLATION", maker.add_accessor<float>("VEC3", {1, 0, 0, 2, 0, 0})}, {"SCALE", maker.add_accessor<float>("VEC3", {1, 1, 1, 3, 3, 3})}};
  GltfModel model = good(maker.model());
  const LoadedScene loaded = good(gltf_scene(model, "t.gltf", {}));
  ASSERT_EQ(loaded.scene.objects.size(), 2U);
  EXPECT_EQ(transform_point(loaded.scene.objects[1].matrix, {1, 1, 1}), (Vec3d{5, 13, 3}));
}

TEST(GltfScene, WhatAScaleOfZeroFlattensIsLeftOut) {
  GltfMaker maker;
  maker.add_node_with(maker.triangle(), {{"scale", {0, 1, 1}}});
  GltfModel model = good(maker.model());
  const LoadedScene loaded = good(gltf_scene(model, "t.gltf", {}));
  EXPECT_TRUE(loaded.scene.objects.empty());
  EXPECT_THAT(texts(loaded.notes), testing::ElementsAre("t.gltf: 1 node is flattened by its scale: not drawn"));
}

}  // namespace
}  // namespace lustro
