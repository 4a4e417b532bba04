// Cameras: what is stated, what is framed, and what a pixel sees.
#include "scene/view.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lustro {
namespace {

Bounds box(Vec3d lower, Vec3d upper) {
  Bounds bounds;
  bounds.include(lower);
  bounds.include(upper);
  return bounds;
}
View view_of(const Camera& camera, const Bounds& bounds, int width = 400, int height = 300) {
  auto view = make_view(camera, {.width = width, .height = height}, extent_of(bounds));
  EXPECT_TRUE(view) << (view ? "" : view.error().text());
  return view ? *view : View{};
}

// Where a world point lands on the image, pixels, and its depth; written anew from the definition of a camera.
struct Landing {
  double x, y, depth;
};
Landing land(const View& view, const Vec3d& world) {
  const Vec3d p = world - view.eye;
  const double depth = dot(p, view.forward);
  const double scale = view.projection == Projection::perspective ? view.pixels_per_unit / depth : view.pixels_per_unit;
  return {view.width / 2.0 + dot(p, view.right) * scale, view.height / 2.0 - dot(p, view.up) * scale, depth};
}

TEST(View, AStatedPerspectiveCameraShowsItsVerticalFieldOfView) {
  Camera camera{.eye = Vec3d{0, 0, 5}, .target = Vec3d{0, 0, 0}, .fov = 60, .near = 0.1, .far = 10};
  const View view = view_of(camera, box({-1, -1, -1}, {1, 1, 1}));
  const double top = 5 * std::tan(30 * 3.14159265358979 / 180);
  const Vec3f p = view.point_at<float>(200, 0, 5);
  EXPECT_NEAR(static_cast<double>(p.y), top, 1e-6);
  EXPECT_NEAR(static_cast<double>(p.x), 0, 1e-9);
  EXPECT_NEAR(static_cast<double>(p.z), -5, 1e-9);
  EXPECT_GT(view.point_at<float>(399, 150, 5).x, 0) << "x grows to the right";
  EXPECT_EQ(view.near, 0.1);
  EXPECT_EQ(view.far, 10);
}

TEST(View, AnOrthographicCameraShowsItsHeightAndLooksTheSameWayEverywhere) {
  Camera camera{.projection = Projection::orthographic, .eye = Vec3d{0, 0, 5}, .target = Vec3d{0, 0, 0}, .height = 4.0};
  const View view = view_of(camera, box({-1, -1, -1}, {1, 1, 1}));
  EXPECT_NEAR(static_cast<double>(view.point_at<float>(200, 0, 3).y), 2, 1e-6);
  EXPECT_NEAR(static_cast<double>(view.point_at<float>(200, 0, 3).z), -3, 1e-6);
  EXPECT_EQ(view.to_eye_at<float>(3, 7), view.to_eye_at<float>(390, 290));
  EXPECT_EQ(view.to_eye_at<float>(3, 7), view.to_eye_from(Vec3f{9, 9, -9}));
}

TEST(View, VPointsFromThePixelToTheEye) {
  Camera camera{.eye = Vec3d{1, 2, 5}, .target = Vec3d{0, 0, 0}};
  const View view = view_of(camera, box({-1, -1, -1}, {1, 1, 1}));
  const Vec3f p = view.point_at<float>(37, 211, 4);
  EXPECT_NEAR(dot(normalize(p), view.to_eye_at<float>(37, 211)), -1, 1e-6F);
  EXPECT_NEAR(length(view.to_eye_at<float>(37, 211) - view.to_eye_from(p)), 0, 1e-6F);
}

TEST(View, EveryPresetFramesEverythingTightly) {
  const Bounds bounds = box({100, -3, 7}, {103, 4, 9});
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    for (int preset = 0; preset < 8; ++preset) {
      for (const auto& [width, height] : {std::pair{400, 300}, std::pair{200, 600}}) {
        const View view = view_of({.projection = projection, .view = static_cast<ViewPreset>(preset)}, bounds, width, height);
        double reach = 0;
        for (unsigned i = 0; i < 8; ++i) {
          const Landing at = land(view, {(i & 1U) != 0 ? 103.0 : 100.0, (i & 2U) != 0 ? 4.0 : -3.0, (i & 4U) != 0 ? 9.0 : 7.0});
          reach = std::max({reach, std::abs(at.x / width - 0.5) * 2, std::abs(at.y / height - 0.5) * 2});
          EXPECT_GE(at.depth, view.near);
          EXPECT_LE(at.depth, view.far);
        }
        EXPECT_LE(reach, 1) << "preset " << preset;
        EXPECT_NEAR(reach, 1 / 1.08, 0.001) << "preset " << preset;
      }
    }
  }
}

TEST(View, PresetsLookFromTheirSide) {
  const Bounds bounds = box({-1, -1, -1}, {1, 1, 1});
  EXPECT_EQ(view_of({.view = ViewPreset::front}, bounds).forward, (Vec3d{0, 0, -1}));
  EXPECT_EQ(view_of({.view = ViewPreset::right}, bounds).forward, (Vec3d{-1, 0, 0}));
  EXPECT_EQ(view_of({.view = ViewPreset::top}, bounds).forward, (Vec3d{0, -1, 0}));
  EXPECT_EQ(view_of({.view = ViewPreset::top}, bounds).up, (Vec3d{0, 0, -1}));
  EXPECT_GT(view_of({}, bounds).eye.y, 0) << "three-quarter looks down a little";
}

TEST(View, NamedViewsTurnWithUp) {
  const Bounds bounds = box({-1, -1, -1}, {1, 1, 1});
  const View front = view_of({.view = ViewPreset::front, .up = Vec3d{0, 0, 2}}, bounds);
  EXPECT_NEAR(length(front.forward - Vec3d{0, 1, 0}), 0, 1e-12) << "as in CAD";
  EXPECT_NEAR(length(front.up - Vec3d{0, 0, 1}), 0, 1e-12);
  const View top = view_of({.view = ViewPreset::top, .up = Vec3d{0, 0, 1}}, bounds);
  EXPECT_NEAR(length(top.forward - Vec3d{0, 0, -1}), 0, 1e-12);
  EXPECT_NEAR(length(top.up - Vec3d{0, 1, 0}), 0, 1e-12);
  const View below = view_of({.view = ViewPreset::front, .up = Vec3d{0, -1, 0}}, bounds);
  EXPECT_NEAR(length(below.up - Vec3d{0, -1, 0}), 0, 1e-12);
}

TEST(View, ImpossibleCamerasAreErrors) {
  const Bounds bounds = box({-1, -1, -1}, {1, 1, 1});
  const auto error_of = [&](const Camera& camera) {
    const auto view = make_view(camera, {}, extent_of(bounds));
    return view ? std::string("no error") : view.error().where;
  };
  EXPECT_EQ(error_of({.eye = Vec3d{1, 1, 1}, .target = Vec3d{1, 1, 1}}), "camera.eye");
  EXPECT_EQ(error_of({.eye = Vec3d{0, 5, 0}, .target = Vec3d{0, 0, 0}, .up = Vec3d{0, 1, 0}}), "camera.up");
  EXPECT_EQ(error_of({.near = 5.0, .far = 4.0}), "camera.near");
  EXPECT_EQ(error_of({.near = -1.0, .far = 4.0}), "camera.near");
  EXPECT_EQ(error_of({.eye = Vec3d{0, 5, 0}, .target = Vec3d{0, 0, 0}}), "no error")
      << "without an up of its own a camera may look straight down";
}

TEST(View, APointAndAnEmptySceneStillGiveACamera) {
  EXPECT_TRUE(std::isfinite(view_of({}, box({2, 2, 2}, {2, 2, 2})).eye.x));
  EXPECT_TRUE(std::isfinite(view_of({}, Bounds{}).eye.x));
  EXPECT_TRUE(std::isfinite(view_of({.projection = Projection::orthographic}, Bounds{}).pixels_per_unit));
}

TEST(View, AFlatSceneSeenStraightOnLiesWellBetweenThePlanes) {
  for (const double distance : {0.01, 3.0, 1e4}) {
    const Camera camera{.projection = Projection::orthographic, .eye = Vec3d{0, 0, distance}, .target = Vec3d{0, 0, 0}};
    const View view = view_of(camera, box({-1, -1, 0}, {1, 1, 0}));
    const auto depth = static_cast<float>(distance);
    EXPECT_GT(depth - view.depth_near, 1e-6F * depth) << distance;
    EXPECT_GT(view.depth_far - depth, 1e-6F * depth) << distance;
  }
}

TEST(View, AnEyeInsideTheSceneHasAPositiveNearPlane) {
  const View view = view_of({.eye = Vec3d{0, 0, 0}, .target = Vec3d{0, 0, -1}}, box({-10, -10, -10}, {10, 10, 10}));
  EXPECT_GT(view.near, 0);
  EXPECT_LT(view.near, 0.01);
  EXPECT_GE(view.far, 10);
}

TEST(View, TheDefaultRigComesFromAboveTheCamerasLeftShoulder) {
  const View view = view_of({.view = ViewPreset::right}, box({-1, -1, -1}, {1, 1, 1}));
  const std::array<Light, 3> rig = default_rig(view);
  ASSERT_EQ(rig.size(), 3U);
  EXPECT_LT(dot(rig[0].direction, view.up), 0);
  EXPECT_GT(dot(rig[0].direction, view.right), 0) << "the key light stands on the left and shines to the right";
  EXPECT_GT(dot(rig[0].direction, view.forward), 0);
  EXPECT_LT(dot(rig[2].direction, view.forward), 0) << "the rim light stands behind";
}

}  // namespace
}  // namespace lustro
