// What approximations cost, on scenes where it is known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "approximation/faceted.hpp"
#include "lustro/approximation.hpp"

namespace lustro {
namespace {

using Cause = ApproximationCause;

template <class T>
T good(Result<T> result) {
  EXPECT_TRUE(result) << result.error().text();
  return *std::move(result);
}

std::shared_ptr<const Mesh> primitive(const std::string& name) {
  return std::make_shared<const Mesh>(good(build_mesh(good(make_primitive(name)))).mesh);
}

Object object(const std::string& name, const Vec3f& diffuse, const Vec3d& at = {0, 0, 0}, double size = 1) {
  Object result;
  result.mesh = primitive(name);
  result.material = Material{.ambient = {{0, 0, 0}}, .diffuse = {diffuse}};
  result.matrix.m = {size, 0, 0, at.x, 0, size, 0, at.y, 0, 0, size, at.z, 0, 0, 0, 1};
  return result;
}

/// A floor and a lamp above it, seen from above.
Scene floor_scene() {
  Scene scene;
  scene.image = {.width = 32, .height = 24, .samples = 4, .background = {{0, 0, 0}}};
  scene.camera.eye = Vec3d{0, 3, 3};
  scene.camera.target = Vec3d{0, 0, 0};
  scene.ambient = {{0, 0, 0}};
  scene.lights = {Light{.type = LightType::point, .position = {0.5, 2, 0.5}}};
  scene.objects = {object("plane", {0.5F, 0.5F, 0.5F}, {0, 0, 0}, 4)};
  return scene;
}

ApproximationReport measured(const Scene& scene, int samples = 16) {
  return good(measure_approximations(scene, {.threads = 2, .path = {.samples = samples}}));
}

const CauseError& of(const ApproximationReport& report, Cause cause) {
  return report.causes[static_cast<std::size_t>(cause)];
}

bool has_paths() {
  Scene scene = floor_scene();
  const Result<ApproximationReport> report = measure_approximations(scene, {.path = {.samples = 2}});
  return report || report.error().kind != ErrorKind::unsupported;
}

#define LUSTRO_REQUIRE_PATHS()                                          \
  if (!has_paths()) {                                                   \
    GTEST_SKIP() << "this build has no path tracer (Embree is absent)"; \
  }

TEST(PictureErrorTest, FiguresFromPaper) {
  Image a(2, 1, 4), b(2, 1, 4);
  a.pixels = {0.5F, 0.5F, 0.5F, 1, 0, 0, 0, 1};
  b.pixels = {0.5F, 0.5F, 0.5F, 1, 0.5F, 0.5F, 0.5F, 1};
  const PictureError error = good(picture_error(a, b, 0.25, Transfer::none, {}));
  EXPECT_NEAR(error.rmse, std::sqrt(0.25 / 2), 1e-12);
  EXPECT_NEAR(error.luminance, 0.25 / 0.25, 1e-6);
  EXPECT_NEAR(error.bias, 0.25 / 0.25, 1e-6);
  EXPECT_NEAR(good(picture_error(b, a, 0.25, Transfer::none, {})).bias, -1, 1e-6);
  EXPECT_GT(error.flip, 0.05);
  EXPECT_EQ(good(picture_error(a, a, 1, Transfer::srgb, {})).flip, 0);
  EXPECT_NEAR(mean_luminance(b), 0.5, 1e-6);
  EXPECT_FALSE(picture_error(a, Image(1, 1, 4), 1, Transfer::none, {}));
}

TEST(Faceted, EveryTriangleHasItsOwnNormal) {
  const auto sphere = primitive("sphere:8");
  const Mesh mesh = good(faceted(*sphere));
  ASSERT_EQ(mesh.triangles.size(), sphere->triangles.size());
  ASSERT_EQ(mesh.positions.size(), 3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    EXPECT_EQ(mesh.positions[b], sphere->positions[sphere->triangles[t][1]]);
    EXPECT_EQ(mesh.normals[a], mesh.normals[c]);
    EXPECT_NEAR(dot(mesh.normals[a], mesh.positions[b] - mesh.positions[a]), 0, 1e-6);
    EXPECT_GT(dot(mesh.normals[a], mesh.positions[a]), 0.5F);
  }
}

TEST(Measure, OnAFloorUnderALampTheLocalPictureIsTheTruth) {
  LUSTRO_REQUIRE_PATHS();
  const ApproximationReport report = measured(floor_scene(), 64);
  EXPECT_LT(report.error.rmse, 0.004 + 3 * report.noise.rmse);
  EXPECT_LT(std::abs(report.error.bias), 0.002 + 3 * report.noise.bias);
  EXPECT_FALSE(of(report, Cause::interpolation).applies);
  EXPECT_FALSE(of(report, Cause::ambient).applies);
  EXPECT_EQ(of(report, Cause::mesh_normals).error.rmse, 0);
  ASSERT_EQ(report.terms.size(), 1U);
  EXPECT_EQ(report.terms[0].term, AovKind::diffuse);
}

TEST(Measure, AShadowIsTheShadowsFault) {
  LUSTRO_REQUIRE_PATHS();
  Scene scene = floor_scene();
  scene.objects.push_back(object("cube", {0, 0, 0}, {0, 1, 0}, 0.3));  // black: it lights nothing
  const ApproximationReport report = measured(scene);
  EXPECT_LT(of(report, Cause::shadows).error.bias, -0.02);
  EXPECT_LT(std::abs(of(report, Cause::interreflection).error.bias), 0.005 + 3 * of(report, Cause::interreflection).noise.bias);
}

TEST(Measure, ACornerLightsItself) {
  LUSTRO_REQUIRE_PATHS();
  Scene scene = floor_scene();
  Object wall = object("plane", {0.8F, 0.8F, 0.8F});
  wall.matrix.m = {4, 0, 0, 0, 0, 0, 4, 2, 0, -4, 0, -1, 0, 0, 0, 1};  // upright behind the lamp, facing it
  scene.shading.two_sided = true;
  scene.objects.push_back(wall);
  const ApproximationReport report = measured(scene, 64);
  EXPECT_GT(of(report, Cause::interreflection).error.bias, 0.01);
}

TEST(Measure, AConstantAmbientIsTooMuchWhereNothingReflects) {
  LUSTRO_REQUIRE_PATHS();
  Scene scene = floor_scene();
  scene.ambient = {{0.2F, 0.2F, 0.2F}};
  scene.objects[0].material->ambient = {{0.5F, 0.5F, 0.5F}};
  const ApproximationReport report = measured(scene);
  ASSERT_TRUE(of(report, Cause::ambient).applies);
  EXPECT_LT(of(report, Cause::ambient).error.bias, -0.05);
  EXPECT_EQ(report.terms[0].term, AovKind::ambient);
  EXPECT_LT(report.terms[0].error.bias, -0.05);
}

TEST(Measure, TheChainOfCausesAddsUpToTheWhole) {
  LUSTRO_REQUIRE_PATHS();
  Scene scene = floor_scene();
  scene.ambient = {{0.2F, 0.2F, 0.2F}};
  scene.objects.push_back(object("sphere:6", {0.5F, 0.2F, 0.2F}, {0, 0.6, 0}, 0.6));
  scene.objects[1].material->specular = {{0.5F, 0.5F, 0.5F}};
  scene.objects[1].material->ambient = {{0.3F, 0.3F, 0.3F}};
  scene.objects[1].material->shininess = 20;
  scene.shading.interpolation = Interpolation::gouraud;
  const ApproximationReport report = measured(scene);
  double sum = 0;
  for (const CauseError& cause : report.causes) {
    EXPECT_TRUE(cause.applies);
    sum += cause.cause == Cause::mesh_normals ? 0 : cause.error.bias;
  }
  EXPECT_NEAR(sum, report.error.bias, 1e-5);
  EXPECT_EQ(of(report, Cause::interpolation).before.pixels, report.local.pixels);
  EXPECT_EQ(of(report, Cause::interreflection).after.pixels, report.truth.pixels);
  EXPECT_GT(of(report, Cause::interpolation).error.rmse, 0.005);
  EXPECT_GT(of(report, Cause::mesh_normals).error.rmse, 0.005);
  EXPECT_EQ(report.samples, 16);
  EXPECT_GT(report.rays, 0U);
  EXPECT_EQ(report.terms.size(), 3U);
}

TEST(Measure, ReportsTheSameForAnyNumberOfThreads) {
  LUSTRO_REQUIRE_PATHS();
  const Scene scene = floor_scene();
  const ApproximationReport one = good(measure_approximations(scene, {.threads = 1, .path = {.samples = 4}}));
  const ApproximationReport three = good(measure_approximations(scene, {.threads = 3, .path = {.samples = 4}}));
  EXPECT_EQ(one.truth.pixels, three.truth.pixels);
  EXPECT_EQ(one.error.flip, three.error.flip);
}

TEST(Measure, OneSampleCannotTellItsNoise) {
  const auto report = measure_approximations(floor_scene(), {.path = {.samples = 1}});
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().kind, ErrorKind::usage);
}

TEST(Measure, ProgressRunsFromNothingToAll) {
  LUSTRO_REQUIRE_PATHS();
  double last = 0;
  ApproximationOptions options{.threads = 1, .path = {.samples = 4}};
  options.progress = [&](double share) {
    EXPECT_GE(share, last - 1e-9);
    EXPECT_LE(share, 1 + 1e-9);
    last = share;
  };
  good(measure_approximations(floor_scene(), options));
  EXPECT_NEAR(last, 1, 0.01);
}

}  // namespace
}  // namespace lustro
