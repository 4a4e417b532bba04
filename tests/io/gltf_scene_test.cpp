// A glTF file as a scene: objects, cameras, and scene files that name its nodes.
#include "io/gltf_scene.hpp"

#include <algorithm>
#include <cmath>

#include "gltf_testing.hpp"
#include "lustro/render.hpp"
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

/// Lights at nodes that stand at (1, 2, 3) and look along -y.
GltfMaker lit_triangle(const Json& lights) {
  GltfMaker maker;
  maker.add_node_with(maker.triangle());
  maker.json["extensionsUsed"] = {"KHR_lights_punctual"};
  maker.json["extensions"]["KHR_lights_punctual"]["lights"] = lights;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    maker.add("nodes", {{"name", "lamp"},
                        {"translation", {1, 2, 3}},
                        {"rotation", {-0.7071067811865476, 0, 0, 0.7071067811865476}},
                        {"scale", {5, 5, 5}},
                        {"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
  }
  return maker;
}

std::optional<std::vector<Light>> lights_of(const GltfMaker& maker) {
  GltfModel model = good(maker.model());
  return good(gltf_scene(model, "t.gltf", {})).scene.lights;
}

TEST(GltfScene, LightsShineWhereTheirNodesStand) {
  const auto lights = lights_of(lit_triangle({{{"type", "point"}, {"color", {1, 0.5, 0}}, {"intensity", 10}, {"range", 7}},
                                              {{"type", "directional"}, {"name", "sun"}, {"intensity", 3}},
                                              {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.5}, {"outerConeAngle", 1.0471975511965976}}}},
                                              {{"type", "spot"}, {"spot", Json::object()}}}));
  ASSERT_TRUE(lights);
  ASSERT_EQ(lights->size(), 4U);
  const Light& point = (*lights)[0];
  EXPECT_EQ(point.type, LightType::point);
  EXPECT_EQ(point.name, "lamp");
  EXPECT_EQ(point.position, (Vec3d{1, 2, 3}));
  EXPECT_NEAR(point.diffuse.rgb.x, 10 / 3.14159265358979, 1e-6);  // c I / pi
  EXPECT_NEAR(point.specular.rgb.y, 5 / 3.14159265358979, 1e-6);
  EXPECT_EQ(point.ambient.rgb, (Vec3f{}));
  EXPECT_EQ(point.attenuation.falloff, 2);
  EXPECT_TRUE(point.attenuation.unclamped);
  EXPECT_EQ(point.attenuation.range, 7);
  const Light& sun = (*lights)[1];
  EXPECT_EQ(sun.type, LightType::directional);
  EXPECT_EQ(sun.name, "sun");
  EXPECT_NEAR(normalize(sun.direction).y, -1, 1e-12);
  EXPECT_FALSE(sun.attenuation.falloff);
  const Light& spot = (*lights)[2];
  EXPECT_EQ(spot.type, LightType::spot);
  EXPECT_NEAR(normalize(spot.direction).y, -1, 1e-12);
  EXPECT_NEAR(spot.cutoff, 60, 1e-9);
  EXPECT_NEAR(*spot.beam, 0.5 * 180 / 3.14159265358979, 1e-9);
  EXPECT_EQ(spot.fade, SpotFade::quadratic);
  EXPECT_FALSE(spot.attenuation.range);
  EXPECT_NEAR((*lights)[3].cutoff, 45, 1e-9);  // the defaults: pi / 4 and 0
  EXPECT_EQ(*(*lights)[3].beam, 0);
}

TEST(GltfScene, WithoutLightsTheRigStaysAndWithThemThereIsNone) {
  EXPECT_FALSE(lights_of(two_triangles()));
  GltfMaker elsewhere = lit_triangle({{{"type", "point"}}});
  elsewhere.json["scenes"] = {{{"nodes", {0}}}};  // the light's node is in no scene
  EXPECT_FALSE(lights_of(elsewhere));
  GltfMaker flat = lit_triangle({{{"type", "directional"}}});
  flat.json["nodes"][1]["scale"] = {1, 1, 0};
  GltfModel model = good(flat.model());
  const LoadedScene loaded = good(gltf_scene(model, "t.gltf", {}));
  EXPECT_EQ(loaded.scene.lights->size(), 0U);
  EXPECT_THAT(texts(loaded.notes), testing::ElementsAre(testing::HasSubstr("nodes[1]: its light has no direction")));
}

TEST(GltfScene, WhatIsSeenIsTheReflectanceOverPiTimesTheIlluminance) {
  // KHR_lights_punctual: E = I / d^2 (1 - (d / r)^4) saturate((t - cos o) / (cos i - cos o))^2 cos; a white diffuse surface shows 0.96 E / pi
  // and a little more: with ggx (1 - F) is 0.96 where light and eye are near the normal, and the roughest highlight 0.04 / 4 E cos / cos.
  GltfMaker maker =
      lit_triangle({{{"type", "spot"}, {"intensity", 50}, {"range", 6}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.9}}}}});
  maker.json["materials"] = {{{"pbrMetallicRoughness", {{"metallicFactor", 0}}}}};
  maker.json["meshes"][0]["primitives"][0]["material"] = 0;
  maker.json["nodes"][1].erase("rotation");
  maker.json["nodes"][1]["translation"] = {0.9, 0.5, 3};  // looks along -z onto the triangle in z = 0
  const TemporaryFolder folder;
  folder.write("t.gltf", maker.text());
  Scene scene = good(load_scene(folder.path / "t.gltf", {.gltf_shading = GltfShading::ggx})).scene;
  scene.camera.eye = Vec3d{0.3, 0.3, 50};
  scene.camera.target = Vec3d{0.3, 0.3, 0};
  scene.camera.fov = 2;
  scene.ambient.rgb = {};
  scene.image = {.width = 64, .height = 64, .samples = 1};
  const Explanation seen = good(explain(scene, 32, 32));
  ASSERT_EQ(seen.fragments.size(), 1U);
  const ShadingExplanation& shading = seen.fragments[0].shadings[0];
  const Vec3d offset = Vec3d{0.9, 0.5, 3} - vec_cast<double>(shading.position);
  const double d = length(offset);
  const double t = offset.z / d;
  const double cone = std::clamp((t - std::cos(0.9)) / (std::cos(0.2) - std::cos(0.9)), 0.0, 1.0);
  const double illuminance = 50 / (d * d) * (1 - std::pow(d / 6, 4)) * cone * cone * t;
  EXPECT_LT(cone, 1);
  EXPECT_NEAR(shading.diffuse.x, 0.96 * illuminance / 3.14159265358979, 2e-4 * illuminance);
  EXPECT_NEAR(shading.specular.x, 0.04 / (2 * (1 + t)) * illuminance / 3.14159265358979, 2e-4 * illuminance);
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
