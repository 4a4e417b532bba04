// Turning scenes: quarter turns on paper, and a camera that sees the whole turn.
#include "app/turning.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

#include "math/trig.hpp"
#include "scene/prepare.hpp"

namespace lustro::app {
namespace {

/// One triangle of these corners.
Scene triangle_scene(const std::array<Vec3f, 3>& corners) {
  Mesh mesh;
  mesh.positions.assign(corners.begin(), corners.end());
  mesh.triangles = {{0, 1, 2}};
  Scene scene;
  scene.shading.interpolation = Interpolation::flat;
  scene.objects.push_back({.name = "triangle", .mesh = std::make_shared<const Mesh>(std::move(mesh))});
  return scene;
}

void expect_near(const Vec3d& a, const Vec3d& b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(a.z, b.z, 1e-12);
}

TEST(Turning, AQuarterTurnSeenFromAboveIsCounterClockwise) {
  const SweptBody body{.center = {0, 5, 0}, .radius = 1, .half_height = 1};
  expect_near(turned({1, 2, 0}, body, 1, 0), {0, 2, -1});  // from the right to the back, with z towards the viewer
  expect_near(turned({0, 2, -1}, body, 1, 0), {-1, 2, 0});
  expect_near(turned({1, 2, 0}, body, 0, 1), {1, 2, 0});
}

TEST(Turning, ObjectsTurnAboutTheMiddleOfTheSceneAndKeepTheirPlaces) {
  Scene scene = triangle_scene({{{0, 0, 0}, {4, 0, 0}, {0, 2, 2}}});  // bounds 0..4, 0..2, 0..2: the axis is x = 2, z = 1
  scene.objects[0].matrix(1, 3) = 10;                                 // lifted
  const SweptBody body = swept_body(scene);
  expect_near(body.center, {2, 11, 1});
  EXPECT_NEAR(body.radius, std::sqrt(5.0), 1e-12);
  EXPECT_EQ(body.half_height, 1);
  const std::vector<Mat4> matrices = matrices_of(scene);
  turn_objects(scene, matrices, body, 1, 0);
  expect_near(transform_point(scene.objects[0].matrix, {0, 0, 0}), {1, 10, 3});
  expect_near(transform_point(scene.objects[0].matrix, {4, 0, 0}), {1, 10, -1});
  turn_objects(scene, matrices, body, 0, 1);  // from rest, not from where it stood
  EXPECT_EQ(scene.objects[0].matrix, matrices[0]);
}

TEST(Turning, AStatedTargetIsTheAxis) {
  Scene scene = triangle_scene({{{0, 0, 0}, {4, 0, 0}, {0, 2, 2}}});
  scene.camera.target = Vec3d{4, 7, 0};
  const SweptBody body = swept_body(scene);
  expect_near(body.center, {4, 1, 0});
  EXPECT_NEAR(body.radius, std::sqrt(20.0), 1e-12);
}

// What a frame would choose by its own box is chosen once: else a picture flickers as it turns.
TEST(Turning, WhatDependsOnTheBoxIsSettledForTheWholeTurn) {
  Scene scene;
  scene.occlusion.emplace();
  scene.ground.emplace();
  const SweptBody body{.center = {1, 2, 3}, .radius = 3, .half_height = 0.5};
  settle_for_turn(scene, body);
  EXPECT_DOUBLE_EQ(scene.occlusion->radius.value(), std::sqrt(6.0 * 6 + 1 + 6 * 6) / 4);
  EXPECT_DOUBLE_EQ(scene.ground->height.value(), 1.5);
  scene.occlusion->radius = 7;
  scene.ground->height = -1;
  settle_for_turn(scene, body);
  EXPECT_EQ(scene.occlusion->radius, 7);
  EXPECT_EQ(scene.ground->height, -1);
}

TEST(Turning, TheReachOfTheCylinderIsThatOfItsRims) {
  const SweptBody body{.center = {1, 2, 3}, .radius = 5, .half_height = 7};
  const std::array<Vec3d, 4> directions{Vec3d{1, 0, 0}, {0, -1, 0}, {3, 0, 4}, {3, 1, 4}};
  std::array<double, 4> reach{};
  extent_of(body).reach(directions, reach);
  EXPECT_NEAR(reach[0], 6, 1e-12);
  EXPECT_NEAR(reach[1], 5, 1e-12);
  EXPECT_NEAR(reach[2], 15 + 25, 1e-12);
  EXPECT_NEAR(reach[3], 15 + 2 + 25 + 7, 1e-12);
}

class DefiniteCamera : public ::testing::TestWithParam<Projection> {};

TEST_P(DefiniteCamera, IsTheViewWithNothingLeftOpen) {
  Scene scene = triangle_scene({{{-1, 0, -3}, {4, 0, 0}, {0, 2, 2}}});
  scene.camera.projection = GetParam();
  const SweptBody body = swept_body(scene);
  const auto before = prepare(scene);
  ASSERT_TRUE(before);
  const auto camera = definite_camera(scene.camera, scene.image, before->view, body);
  ASSERT_TRUE(camera);
  scene.camera = *camera;
  const std::vector<Mat4> matrices = matrices_of(scene);
  for (const double degrees : {0.0, 70.0, 200.0, 345.0}) {
    turn_objects(scene, matrices, body, sine_deg(degrees), cosine_deg(degrees));
    const auto after = prepare(scene);
    ASSERT_TRUE(after);
    expect_near(after->view.eye, before->view.eye);
    expect_near(after->view.forward, before->view.forward);
    expect_near(after->view.up, before->view.up);
    EXPECT_NEAR(after->view.pixels_per_unit, before->view.pixels_per_unit, 1e-9);
    // Every corner lies between the planes, however the scene stands.
    for (const Vec3f& corner : scene.objects[0].mesh->positions) {
      const Vec3d p = transform_point(scene.objects[0].matrix, vec_cast<double>(corner));
      const double depth = dot(p - after->view.eye, after->view.forward);
      EXPECT_GT(depth, after->view.near);
      EXPECT_LT(depth, after->view.far);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Projections, DefiniteCamera, ::testing::Values(Projection::perspective, Projection::orthographic),
                         [](const auto& projection) { return projection.param == Projection::perspective ? "Perspective" : "Orthographic"; });

}  // namespace
}  // namespace lustro::app
