// Scenes as one mesh, in values from paper.
#include <gmock/gmock.h>

#include "lustro/mesh_file.hpp"

namespace lustro {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::shared_ptr<Mesh> triangle() {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh->normals = {{0, 0, 1}, {0, 0, 1}, {0.6F, 0, 0.8F}};
  mesh->triangles = {{0, 1, 2}};
  return mesh;
}

Object placed(std::shared_ptr<const Mesh> mesh, const std::array<double, 16>& matrix) {
  Object object;
  object.mesh = std::move(mesh);
  object.matrix.m = matrix;
  return object;
}

constexpr std::array<double, 16> kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
constexpr std::array<double, 16> kStretched{2, 0, 0, 10, 0, 1, 0, 20, 0, 0, 1, 30, 0, 0, 0, 1};
constexpr std::array<double, 16> kMirrored{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

TEST(Flatten, PositionsGoByTheMatrixAndNormalsByTheInverseTranspose) {
  Scene scene;
  scene.objects = {placed(triangle(), kStretched)};
  const Mesh all = flatten_scene(scene).value();
  EXPECT_THAT(all.positions, ElementsAre(Vec3f{10, 20, 30}, Vec3f{12, 20, 30}, Vec3f{10, 21, 30}));
  EXPECT_EQ(all.normals[0], (Vec3f{0, 0, 1}));
  // (0.6 / 2, 0, 0.8) over its length sqrt(0.73)
  EXPECT_NEAR(all.normals[2].x, 0.3 / 0.8544003745, 1e-6);
  EXPECT_NEAR(all.normals[2].z, 0.8 / 0.8544003745, 1e-6);
}

TEST(Flatten, AMirroredObjectIsTurnedRound) {
  Scene scene;
  auto mesh = triangle();
  mesh->tangents.assign(3, {1, 0, 0, 1});
  scene.objects = {placed(mesh, kMirrored)};
  const Mesh all = flatten_scene(scene).value();
  EXPECT_THAT(all.triangles, ElementsAre(std::array<std::uint32_t, 3>{0, 2, 1}));
  EXPECT_EQ(all.normals[0], (Vec3f{0, 0, 1}));
  EXPECT_EQ(all.normals[2], (Vec3f{-0.6F, 0, 0.8F}));
  EXPECT_EQ(all.tangents[0], (std::array<float, 4>{-1, 0, 0, -1}));
}

TEST(Flatten, OneObjectThatIsNotMovedKeepsItsBits) {
  Scene scene;
  auto mesh = triangle();
  mesh->normals[0] = {0.3F, 0.3F, 0.3F};  // no unit
  scene.objects = {placed(mesh, kIdentity)};
  EXPECT_EQ(flatten_scene(scene).value().normals, mesh->normals);
}

TEST(Flatten, WhatOnlySomeObjectsHaveIsFilledUp) {
  auto rich = triangle();
  rich->uvs = {{0, 0}, {1, 0}, {0, 1}};
  rich->colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  rich->alphas = {0, 0.5F, 1};
  rich->tangents.assign(3, {1, 0, 0, 1});
  Material blue, green;
  blue.name = "blue";
  green.name = "green";
  rich->materials = {blue, green};
  rich->triangle_material = {1};
  Scene scene;
  scene.objects = {placed(triangle(), kIdentity), placed(rich, kIdentity), placed(rich, kIdentity)};
  Material red;
  red.name = "red";
  scene.objects[2].material = red;
  const Mesh all = flatten_scene(scene).value();
  EXPECT_EQ(all.positions.size(), 9U);
  EXPECT_EQ(all.normals.size(), 9U);
  EXPECT_THAT(all.tangents, IsEmpty());
  EXPECT_EQ(all.uvs[1], (Vec2f{0, 0}));
  EXPECT_EQ(all.uvs[4], (Vec2f{1, 0}));
  EXPECT_EQ(all.colors[2], (Vec3f{1, 1, 1}));
  EXPECT_EQ(all.colors[3], (Vec3f{1, 0, 0}));
  EXPECT_THAT(all.alphas, ElementsAre(1, 1, 1, 0, 0.5F, 1, 0, 0.5F, 1));
  EXPECT_THAT(all.triangle_material, ElementsAre(0, 2, 3));
  ASSERT_EQ(all.materials.size(), 4U);
  EXPECT_EQ(all.materials[2].name, "green");
  EXPECT_EQ(all.materials[3].name, "red");
  EXPECT_EQ(all.triangles[2], (std::array<std::uint32_t, 3>{6, 7, 8}));
}

TEST(Flatten, AFlatteningMatrixAndAMissingMeshAreErrors) {
  Scene scene;
  scene.objects = {placed(triangle(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1})};
  EXPECT_EQ(flatten_scene(scene).error().text(), "objects[0].matrix: is singular: it flattens the object");
  scene.objects[0].mesh = nullptr;
  EXPECT_EQ(flatten_scene(scene).error().text(), "objects[0]: has no mesh");
}

}  // namespace
}  // namespace lustro
