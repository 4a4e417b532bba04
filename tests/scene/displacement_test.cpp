// Displacement maps of materials: which of them are drawn, what their values mean, and that a mesh is displaced once.
#include "scene/displacement.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/prepare.hpp"

namespace lustro {
namespace {

// Heights rise from 0 at the left of the picture to 1 at its right.
TextureUse ramp() {
  Image image(16, 4, 1);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 16; ++x) {
      image.at(x, y)[0] = static_cast<float>(x) / 15;
    }
  }
  return {.texture = *make_texture(image, 1), .sampler = {.wrap_u = Wrap::clamp_to_edge, .wrap_v = Wrap::clamp_to_edge}};
}

std::shared_ptr<Mesh> quad() {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh->normals.assign(4, {0, 0, 1});
  mesh->uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

Scene scene_of(const std::shared_ptr<Mesh>& mesh, const TextureUse& use) {
  Scene scene;
  scene.objects.push_back({.source = "test", .mesh = mesh, .material = Material{.textures = {.displacement = use}}});
  return scene;
}

TEST(Displacement, HeightsAreValueTimesGainPlusBase) {
  TextureUse use = ramp();
  use.gain = {0.5F, 0.5F, 0.5F};
  use.base = {-0.1F, -0.1F, -0.1F};
  const auto prepared = prepare(scene_of(quad(), use));
  ASSERT_TRUE(prepared);
  const Mesh& mesh = *prepared->instances[0].mesh;
  EXPECT_GT(mesh.triangles.size(), 100U);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const float texel = std::clamp(mesh.uvs[v].x * 16 - 0.5F, 0.0F, 15.0F);
    EXPECT_NEAR(mesh.positions[v].z, texel / 15 * 0.5F - 0.1F, 1e-4F);
  }
}

TEST(Displacement, AnObjectsMaterialCoversAllTrianglesAndAMeshsOwnItsOwn) {
  auto mesh = quad();
  mesh->triangle_material = {0, 1};
  mesh->materials.resize(2);
  Object object{.mesh = mesh, .material = Material{.textures = {.displacement = ramp()}}};
  EXPECT_EQ(displacement_of(object).size(), 2U);
  EXPECT_TRUE(displacement_of(object)[0] && displacement_of(object)[1]);
  object.material.reset();
  EXPECT_TRUE(displacement_of(object).empty());
  mesh->materials[1].textures.displacement = ramp();
  ASSERT_EQ(displacement_of(object).size(), 2U);
  EXPECT_FALSE(displacement_of(object)[0]);
  EXPECT_TRUE(displacement_of(object)[1]);
}

TEST(Displacement, WhatCannotBeDrawnIsLeftOutWithANote) {
  auto bare = quad();
  bare->uvs.clear();
  const auto prepared = prepare(scene_of(bare, ramp()));
  ASSERT_TRUE(prepared);
  EXPECT_EQ(prepared->triangle_count, 2U);
  EXPECT_EQ(prepared->notes, (Notes{{"objects[0]", "its displacement map is left out: the mesh has no texture coordinates 0"}}));
}

TEST(Displacement, WhatTheLimitCutsOffIsNotedInEveryPicture) {
  Image image(16, 16, 1);
  TextureUse use{.texture = *make_texture(image, 1)};
  use.uv_matrix = {1000, 0, 0, 0, 1000, 0};  // 16000 texels a side
  const Scene scene = scene_of(quad(), use);
  MeshCache cache(ClusterUse::often);
  PreparedScene prepared;
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(prepare(scene, cache, 0, prepared));
    EXPECT_LE(prepared.triangle_count, 2097152U);
    EXPECT_GT(prepared.triangle_count, 500000U);
    ASSERT_EQ(prepared.notes.size(), 1U);
    EXPECT_NE(prepared.notes[0].text().find("would take more than 2097152 triangles"), std::string::npos) << prepared.notes[0].text();
  }
}

TEST(Displacement, AMeshIsDisplacedOnceForManyPictures) {
  const Scene scene = scene_of(quad(), ramp());
  MeshCache cache(ClusterUse::often);
  PreparedScene prepared;
  ASSERT_TRUE(prepare(scene, cache, 0, prepared));
  const Mesh* first = prepared.instances[0].mesh;
  ASSERT_TRUE(prepare(scene, cache, 0, prepared));
  EXPECT_EQ(prepared.instances[0].mesh, first);
  Scene other = scene;
  other.objects[0].material->textures.displacement->gain = {2, 2, 2};
  ASSERT_TRUE(prepare(other, cache, 0, prepared));
  EXPECT_NE(prepared.instances[0].mesh, first);
}

TEST(Displacement, FlatFacesMoveAlongTheVerticesNormals) {
  Scene scene = scene_of(quad(), ramp());
  scene.objects[0].mesh = [] {
    auto mesh = quad();
    mesh->normals.clear();
    return mesh;
  }();
  scene.shading.interpolation = Interpolation::flat;
  const auto prepared = prepare(scene);
  ASSERT_TRUE(prepared);
  EXPECT_GT(prepared->triangle_count, 100U);
  EXPECT_NEAR(prepared->instances[0].mesh->bounds().upper.z, 1, 1e-3);
}

}  // namespace
}  // namespace lustro
