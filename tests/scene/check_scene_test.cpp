// What must hold between the keys of a scene.
#include "scene/check_scene.hpp"

#include <gtest/gtest.h>

namespace lustro {
namespace {

std::string error_of(const Scene& scene) {
  const auto done = check_scene(scene);
  return done ? "" : done.error().text();
}

/// The message of a scene file with one more key beside `objects`.
std::string error_with(const std::string& key) {
  const auto scene = parse_scene("{" + key + R"(, "objects": [{"mesh": "primitive:cube"}]})", "s");
  return scene ? "" : scene.error().text();
}

TEST(CheckScene, FindsNothingInTheDefaults) {
  EXPECT_EQ(error_of(Scene{}), "");
  Scene scene;
  scene.lights.emplace(3);
  scene.fog.emplace();
  scene.objects.resize(2);
  EXPECT_EQ(error_of(scene), "");
}

TEST(CheckScene, NearIsBeforeFar) {
  EXPECT_EQ(error_with(R"("camera": {"near": 2, "far": 1})"), "s: camera.near: 2 is not less than far, 1");
  EXPECT_EQ(error_with(R"("camera": {"near": 2, "far": 2})"), "s: camera.near: 2 is not less than far, 2");
  EXPECT_EQ(error_with(R"("camera": {"near": 2, "far": 2.5})"), "");
  EXPECT_EQ(error_with(R"("camera": {"near": 0})"), "s: camera.near: 0 is not more than 0, as a perspective camera needs");
  EXPECT_EQ(error_with(R"("camera": {"near": 0, "projection": "orthographic"})"), "");
}

TEST(CheckScene, BeamIsInsideCutoff) {
  EXPECT_EQ(error_with(R"("lights": [{"type": "spot", "beam": 45}])"), "s: lights[0].beam: 45 is not less than cutoff, 45");
  EXPECT_EQ(error_with(R"("lights": [{}, {"type": "spot", "beam": 30, "cutoff": 20}])"), "s: lights[1].beam: 30 is not less than cutoff, 20");
  EXPECT_EQ(error_with(R"("lights": [{"type": "spot", "beam": 44.9}])"), "");
}

TEST(CheckScene, DirectionsAreNotZero) {
  EXPECT_EQ(error_with(R"("lights": [{"direction": [0, 0, 0]}])"),
            "s: lights[0].direction: [0, 0, 0] has no direction, expected a vector that is not 0");
  EXPECT_EQ(error_with(R"("lights": [{"type": "spot", "direction": [0, 0, 1e-200]}])"),
            "s: lights[0].direction: [0, 0, 1e-200] has no direction, expected a vector that is not 0");
  EXPECT_EQ(error_with(R"("lights": [{"direction": [0, 0, 1e-20]}])"), "");
  EXPECT_EQ(error_with(R"("lights": [{"type": "point", "direction": [0, 0, 0]}])"), "");  // it has none
  EXPECT_EQ(error_with(R"("camera": {"up": [0, 0, 0]})"), "s: camera.up: [0, 0, 0] has no direction, expected a vector that is not 0");
}

TEST(CheckScene, TheCameraLooksSomewhereWithItsHeadUp) {
  EXPECT_EQ(error_with(R"("camera": {"eye": [1, 2, 3], "target": [1, 2, 3]})"),
            "s: camera.target: [1, 2, 3] is where the eye stands, expected another place");
  EXPECT_EQ(error_with(R"("camera": {"eye": [0, 5, 0], "target": [0, 0, 0], "up": [0, 1, 0]})"),
            "s: camera.up: [0, 1, 0] lies along the view from eye to target, expected another direction");
  EXPECT_EQ(error_with(R"("camera": {"eye": [0, 5, 0], "target": [0, 0, 0], "up": [0, -3, 0]})"),
            "s: camera.up: [0, -3, 0] lies along the view from eye to target, expected another direction");
  EXPECT_EQ(error_with(R"("camera": {"eye": [0, 5, 0], "target": [0, 0, 0], "up": [0, 0, -1]})"), "");
  EXPECT_EQ(error_with(R"("camera": {"eye": [0, 5, 0.01], "target": [0, 0, 0], "up": [0, 1, 0]})"), "");
  EXPECT_EQ(error_with(R"("camera": {"eye": [0, 5, 0], "up": [0, 1, 0]})"), "");  // the target is not known yet
}

TEST(CheckScene, AnAttenuationIsNotNothing) {
  EXPECT_EQ(error_with(R"("lights": [{"type": "point", "attenuation": {"constant": 0}}])"),
            "s: lights[0].attenuation: constant, linear and quadratic are all 0, expected one that is not");
  EXPECT_EQ(error_with(R"("lights": [{"type": "point", "attenuation": {"constant": 0, "quadratic": 1}}])"), "");
}

TEST(CheckScene, LinearFogEndsBehindItsStart) {
  EXPECT_EQ(error_with(R"("fog": {"mode": "linear", "start": 3, "end": 3})"), "s: fog.end: 3 is not more than start, 3");
  EXPECT_EQ(error_with(R"("fog": {"mode": "linear", "start": 3})"), "s: fog.end: 1 is not more than start, 3");
  EXPECT_EQ(error_with(R"("fog": {"mode": "exp", "start": 3})"), "");
}

TEST(CheckScene, MatricesAreAffine) {
  Scene scene;
  scene.objects.resize(2);
  scene.objects[1].matrix(3, 0) = 5;
  EXPECT_EQ(error_of(scene),
            "objects[1].matrix: its last row is 5, 0, 0, 1, expected 0, 0, 0, 1 (a row-major matrix moves by its fourth column)");
  scene.objects[1].matrix(3, 0) = 0;
  scene.objects[1].matrix(0, 3) = 5;
  EXPECT_EQ(error_of(scene), "");
}

TEST(UnusedKeys, AreThoseThatChangeNothing) {
  const auto notes_of = [](const std::string& json) {
    std::string text;
    for (const Note& note : unused_keys(parse_scene(json).value())) {
      text += note.text() + "; ";
    }
    return text;
  };
  EXPECT_EQ(notes_of(R"({"objects": []})"), "");
  EXPECT_EQ(notes_of(R"({"lights": [{"type": "point", "cutoff": 20, "beam": 10, "exponent": 2, "direction": [1, 0, 0]}], "objects": []})"),
            "lights[0].direction: changes nothing with a point light; lights[0].cutoff: changes nothing with a point light; "
            "lights[0].beam: changes nothing with a point light; lights[0].exponent: changes nothing with a point light; ");
  EXPECT_EQ(notes_of(R"({"lights": [{}, {"position": [1, 0, 0], "attenuation": {"falloff": 2}}], "objects": []})"),
            "lights[1].position: changes nothing with a directional light; lights[1].attenuation: changes nothing with a directional light; ");
  EXPECT_EQ(
      notes_of(R"({"lights": [{"type": "spot", "cutoff": 20, "beam": 10, "position": [1, 0, 0], "direction": [1, 0, 0]}], "objects": []})"), "");
  EXPECT_EQ(notes_of(R"({"camera": {"height": 2}, "objects": []})"), "camera.height: changes nothing with a perspective camera; ");
  EXPECT_EQ(notes_of(R"({"camera": {"projection": "orthographic", "fov": 20}, "objects": []})"),
            "camera.fov: changes nothing with an orthographic camera; ");
}

}  // namespace
}  // namespace lustro
