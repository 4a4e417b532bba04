// Where nodes stand, and animations at a moment.
#include "io/gltf_pose.hpp"

#include <cmath>

#include "gltf_testing.hpp"

namespace lustro {
namespace {

using Json = nlohmann::json;

constexpr double kPi = 3.14159265358979323846;

Vec3d moved(const Result<GltfModel>& model, std::size_t node, const Vec3d& p) {
  EXPECT_TRUE(model) << (model ? "" : model.error().text());
  return model ? transform_point(model->pose.world[node], p) : Vec3d{};
}

void expect_near(const Vec3d& a, const Vec3d& b) {
  EXPECT_NEAR(a.x, b.x, 1e-6);
  EXPECT_NEAR(a.y, b.y, 1e-6);
  EXPECT_NEAR(a.z, b.z, 1e-6);
}

TEST(GltfPose, ScaleThenRotationThenTranslation) {
  GltfMaker maker;
  const double h = std::sqrt(0.5);  // 90 degrees about z: x becomes y
  maker.add("nodes", {{"translation", {10, 0, 0}}, {"rotation", {0, 0, h, h}}, {"scale", {2, 3, 1}}});
  expect_near(moved(maker.model(), 0, {1, 0, 0}), {10, 2, 0});
  expect_near(moved(maker.model(), 0, {0, 1, 0}), {7, 0, 0});
}

TEST(GltfPose, AMatrixIsWrittenByColumns) {
  GltfMaker maker;
  maker.add("nodes", {{"matrix", {1, 2, 3, 0, 0, 1, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1}}});
  expect_near(moved(maker.model(), 0, {1, 0, 0}), {8, 10, 12});
}

TEST(GltfPose, ChildrenStandInTheirParents) {
  GltfMaker maker;
  maker.add("nodes", {{"translation", {0, 1, 0}}});
  maker.add("nodes", {{"children", {0}}, {"scale", {10, 10, 10}}});
  expect_near(moved(maker.model(), 0, {1, 0, 0}), {10, 10, 0});
}

/// A node whose `path` goes through `values` at the times 1, 2, 4.
GltfMaker animated(const char* path, const char* type, std::vector<float> values, const char* interpolation) {
  GltfMaker maker;
  maker.add("nodes", {{"translation", {0, 0, 5}}});
  const std::size_t input = maker.add_accessor<float>("SCALAR", {1, 2, 4});
  const std::size_t output = maker.add_accessor<float>(type, values);
  maker.add("animations", {{"name", "walk"},
                           {"samplers", {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}},
                           {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}}});
  return maker;
}

Vec3d at(const GltfMaker& maker, double time, const Vec3d& p = {0, 0, 0}) {
  return moved(maker.model({.time = time}), 0, p);
}

TEST(GltfPose, WithoutATimeNothingIsAnimated) {
  expect_near(moved(animated("translation", "VEC3", {1, 0, 0, 3, 0, 0, 7, 0, 0}, "LINEAR").model(), 0, {}), {0, 0, 5});
}

TEST(GltfPose, LinearKeysAreJoinedByLinesAndHeldOutside) {
  const GltfMaker maker = animated("translation", "VEC3", {1, 0, 0, 3, 0, 0, 7, 0, 0}, "LINEAR");
  expect_near(at(maker, 0), {1, 0, 0});
  expect_near(at(maker, 1.5), {2, 0, 0});
  expect_near(at(maker, 2), {3, 0, 0});
  expect_near(at(maker, 3.5), {6, 0, 0});
  expect_near(at(maker, 99), {7, 0, 0});
}

TEST(GltfPose, StepsHoldTheirKey) {
  const GltfMaker maker = animated("translation", "VEC3", {1, 0, 0, 3, 0, 0, 7, 0, 0}, "STEP");
  expect_near(at(maker, 1.99), {1, 0, 0});
  expect_near(at(maker, 2), {3, 0, 0});
  expect_near(at(maker, 3.99), {3, 0, 0});
  expect_near(at(maker, 4), {7, 0, 0});
}

TEST(GltfPose, CubicKeysAreHermitesWithTangentsTimesTheSpan) {
  // Key by key: arriving tangent, value, leaving tangent.
  const GltfMaker maker =
      animated("translation", "VEC3", {0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 2, 0, 0, -3, 0, 0, 5, 0, 0, 0, 0, 0}, "CUBICSPLINE");
  expect_near(at(maker, 1.5), {0.5, 0, 0});  // 0 to 1, both tangents 1: a straight line
  const double t = 0.25, td = 2;             // from 1 to 5 over two seconds, leaving by 2, arriving by -3
  const double hermite = (2 * t * t * t - 3 * t * t + 1) * 1 + td * (t * t * t - 2 * t * t + t) * 2 + (3 * t * t - 2 * t * t * t) * 5 +
                         td * (t * t * t - t * t) * -3;
  expect_near(at(maker, 2.5), {hermite, 0, 0});
}

TEST(GltfPose, RotationsTurnEvenlyTheShorterWay) {
  const auto z = [](double degrees) {
    return std::array{static_cast<float>(std::sin(degrees * kPi / 360)), static_cast<float>(std::cos(degrees * kPi / 360))};
  };
  const auto [s, c] = z(90);
  // The second key is -q: the same rotation, and the long way round for who does not look.
  GltfMaker maker = animated("rotation", "VEC4", {0, 0, 0, 1, 0, 0, -s, -c, 0, 0, 0, 1}, "LINEAR");
  maker.json["nodes"][0] = Json::object();
  for (const double share : {0.1, 1.0 / 3, 0.5, 0.9}) {
    const double angle = share * kPi / 2;
    expect_near(at(maker, 1 + share, {1, 0, 0}), {std::cos(angle), std::sin(angle), 0});
  }
}

TEST(GltfPose, WeightsAreAnimatedTogether) {
  GltfMaker maker;
  Json primitive = maker.triangle();
  primitive["targets"] = {{{"POSITION", maker.add_accessor<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1})}},
                          {{"POSITION", maker.add_accessor<float>("VEC3", {1, 0, 0, 1, 0, 0, 1, 0, 0})}}};
  maker.add_node_with(primitive);
  const std::size_t input = maker.add_accessor<float>("SCALAR", {0, 2});
  const std::size_t output = maker.add_accessor<float>("SCALAR", {0, 10, 4, 20});
  maker.add("animations", {{"samplers", {{{"input", input}, {"output", output}}}},
                           {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}});
  EXPECT_EQ(good(maker.mesh({.time = 1})).positions[0], (Vec3f{15, 0, 2}));
}

TEST(GltfPose, AnAnimationIsChosenByNumberOrName) {
  GltfMaker maker = animated("translation", "VEC3", {1, 0, 0, 3, 0, 0, 7, 0, 0}, "LINEAR");
  Json second = maker.json["animations"][0];
  second["name"] = "run";
  second["channels"][0]["target"]["path"] = "scale";
  maker.add("animations", second);
  EXPECT_EQ(moved(maker.model({.time = 2, .animation = "run"}), 0, {1, 1, 1}), (Vec3d{3, 0, 5}));
  EXPECT_EQ(moved(maker.model({.time = 2, .animation = "1"}), 0, {1, 1, 1}), (Vec3d{3, 0, 5}));
  EXPECT_EQ(moved(maker.model({.time = 2}), 0, {0, 0, 0}), (Vec3d{3, 0, 0}));
  const Error error = bad(maker.model({.animation = "jump"}));
  EXPECT_EQ(error.kind, ErrorKind::usage);
  EXPECT_EQ(error.text(), "t.gltf: has no animation \"jump\", only 0 \"walk\", 1 \"run\"");
}

TEST(GltfPose, KeysMustRise) {
  GltfMaker maker = animated("translation", "VEC3", {1, 0, 0, 3, 0, 0, 7, 0, 0}, "LINEAR");
  maker.bytes[7] = 0;  // 2 becomes tiny
  EXPECT_EQ(bad(maker.model({.time = 2})).where, "t.gltf: accessors[0]");
}

TEST(GltfPose, PlacesThatAreNotFiniteAreErrors) {
  GltfMaker maker;
  for (int i = 0; i < 12; ++i) {
    maker.add("nodes", {{"scale", {1e30, 1e30, 1e30}}, {"children", i == 11 ? Json::array() : Json::array({i + 1})}});
  }
  EXPECT_EQ(bad(maker.model()).text(), "t.gltf: nodes[1]: its place in the world is not finite");
}

}  // namespace
}  // namespace lustro
