// What the scene file's reader refuses, and the words with which it does.
#include "scene/scene_reader.hpp"

#include <gtest/gtest.h>

#include "lustro/scene.hpp"
#include "scene/fields.hpp"
#include "scene_examples.hpp"

namespace lustro {
namespace {

/// The message that a scene fails with; empty where it does not fail.
std::string error_of(const std::string& json) {
  const auto scene = parse_scene(json, "scene.json");
  return scene ? "" : scene.error().text();
}

/// The message for one more key beside `objects`, without the file's name.
std::string error_with(const std::string& key) {
  const std::string text = error_of("{" + key + R"(, "objects": [{"mesh": "primitive:cube"}]})");
  return text.starts_with("scene.json: ") ? text.substr(12) : text;
}

std::string error_in_light(const std::string& keys) {
  return error_with("\"lights\": [{}, {}, {" + keys + "}]");
}

std::string error_in_object(const std::string& keys) {
  const std::string text = error_of(R"({"objects": [{"mesh": "a"}, {)" + keys + "}]}");
  return text.starts_with("scene.json: ") ? text.substr(12) : text;
}

TEST(SceneReader, NamesTheFileAndTheKeysPath) {  // the example of the contract
  EXPECT_EQ(error_of(R"({"lights": [{}, {}, {"cutoff": 120}], "objects": []})"), "scene.json: lights[2].cutoff: 120 is outside 0..90");
}

TEST(SceneReader, RefusesUnknownKeysAndSuggestsTheNearest) {
  EXPECT_EQ(error_with(R"("ligths": [])"), "ligths: unknown key, did you mean \"lights\"?");
  EXPECT_EQ(error_with(R"("camera": {"Fov": 3})"), "camera.Fov: unknown key, did you mean \"fov\"?");
  EXPECT_EQ(error_in_light(R"("cuttoff": 3)"), "lights[2].cuttoff: unknown key, did you mean \"cutoff\"?");
  EXPECT_EQ(error_in_light(R"("attenuation": {"fallof": 3})"), "lights[2].attenuation.fallof: unknown key, did you mean \"falloff\"?");
  EXPECT_EQ(error_with(R"("fog": {"kind": "exp"})"), "fog.kind: unknown key (known: mode, density, start, end, color)");
  EXPECT_EQ(error_in_object(R"("mesh": "a", "transform": [])"), "objects[1].transform: unknown key (known: mesh, name, material, matrix)");
  EXPECT_EQ(error_with(R"("materials": {"old gold": {"difuse": 1}})"), "materials[\"old gold\"].difuse: unknown key, did you mean \"diffuse\"?");
  EXPECT_EQ(error_with(R"("": 1)"), "[\"\"]: unknown key (known: image, camera, shading, ambient, lights, fog, materials, objects)");
  EXPECT_EQ(error_with(R"("image": {"$schema": ""})").substr(0, 26), "image.$schema: unknown key");
}

TEST(SceneReader, RefusesWrongTypes) {
  EXPECT_EQ(error_with(R"("image": {"width": "wide"})"), "image.width: found \"wide\", expected a whole number");
  EXPECT_EQ(error_with(R"("image": {"width": 4.5})"), "image.width: found 4.5, expected a whole number");
  EXPECT_EQ(error_with(R"("image": {"width": null})"), "image.width: found null, expected a whole number");
  EXPECT_EQ(error_with(R"("image": [])"), "image: found an empty list, expected a table {...}");
  EXPECT_EQ(error_with(R"("image": {"transparent": 1})"), "image.transparent: found 1, expected true or false");
  EXPECT_EQ(error_with(R"("camera": {"eye": [1, 2]})"), "camera.eye: found a list of 2, expected a list of three numbers [x, y, z]");
  EXPECT_EQ(error_with(R"("camera": {"eye": [1, 2, "3"]})"), "camera.eye[2]: found \"3\", expected a number");
  EXPECT_EQ(error_with(R"("camera": {"eye": "1,2,3"})"), "camera.eye: found \"1,2,3\", expected a list of three numbers [x, y, z]");
  EXPECT_EQ(error_with(R"("camera": {"fov": true})"), "camera.fov: found true, expected a number");
  EXPECT_EQ(error_with(R"("shading": {"lighting": 1})"),
            "shading.lighting: found 1, expected a word (constant, lambert, phong, blinn-phong, ggx)");
  EXPECT_EQ(error_with(R"("shading": {"terms": "diffuse"})"),
            "shading.terms: found \"diffuse\", expected a list of words (ambient, diffuse, specular, emission)");
  EXPECT_EQ(error_with(R"("lights": {})"), "lights: found an empty table, expected a list");
  EXPECT_EQ(error_with(R"("lights": null)"), "lights: found null, expected a list");
  EXPECT_EQ(error_with(R"("lights": [3])"), "lights[0]: found 3, expected a table {...}");
  EXPECT_EQ(error_with(R"("materials": [])"), "materials: found an empty list, expected a table of materials by name");
  EXPECT_EQ(error_with(R"("materials": {"a": 3})"), "materials.a: found 3, expected the name of a material or a table");
  EXPECT_EQ(error_in_object(R"("mesh": 3)"), "objects[1].mesh: found 3, expected text");
  EXPECT_EQ(error_in_object(R"("mesh": "a", "matrix": [1, 0, 0, 0])"),
            "objects[1].matrix: found a list of 4, expected a list of 16 numbers, row by row");
  EXPECT_EQ(error_in_object(R"("mesh": "a", "name": {"x": 1})"), "objects[1].name: found a table of 1, expected text");
  EXPECT_EQ(error_in_object("\"mesh\": \"a\\u0000b\""), "objects[1].mesh: found \"a\\x00b\", expected text without the character 0");
  EXPECT_EQ(error_of("[]"), "scene.json: found an empty list, expected a table {\"objects\": [...]}");
  EXPECT_EQ(error_of("3"), "scene.json: found 3, expected a table {\"objects\": [...]}");
}

TEST(SceneReader, RefusesWhatIsOutsideItsRange) {
  EXPECT_EQ(error_with(R"("image": {"width": 0})"), "image.width: 0 is outside 1..16384");
  EXPECT_EQ(error_with(R"("image": {"width": -5})"), "image.width: -5 is outside 1..16384");
  EXPECT_EQ(error_with(R"("image": {"height": 16385})"), "image.height: 16385 is outside 1..16384");
  EXPECT_EQ(error_with(R"("image": {"width": 18446744073709551617})"), "image.width: 1.8446744073709552e+19 is outside 1..16384");
  EXPECT_EQ(error_with(R"("image": {"samples": 3})"), "image.samples: 3 is not 1, 2, 4, 8 or 16");
  EXPECT_EQ(error_with(R"("image": {"samples": 32})"), "image.samples: 32 is not 1, 2, 4, 8 or 16");
  EXPECT_EQ(error_with(R"("image": {"background": [0, 0, 0, 1.5]})"), "image.background[3]: 1.5 is outside 0..1");
  EXPECT_EQ(error_with(R"("camera": {"fov": 0})"), "camera.fov: 0 is not more than 0 and less than 180");
  EXPECT_EQ(error_with(R"("camera": {"fov": 180})"), "camera.fov: 180 is not more than 0 and less than 180");
  EXPECT_EQ(error_with(R"("camera": {"height": 0})"), "camera.height: 0 is not more than 0");
  EXPECT_EQ(error_with(R"("camera": {"near": -1})"), "camera.near: -1 is not 0 or more");
  EXPECT_EQ(error_with(R"("camera": {"far": 0})"), "camera.far: 0 is not more than 0");
  EXPECT_EQ(error_with(R"("camera": {"eye": [0, 1e39, 0]})"), "camera.eye[1]: 1e+39 is too large, the largest number is 3.4028235e+38");
  EXPECT_EQ(error_with(R"("shading": {"crease": 180.5})"), "shading.crease: 180.5 is outside 0..180");
  EXPECT_EQ(error_with(R"("shading": {"crease": -1})"), "shading.crease: -1 is outside 0..180");
  EXPECT_EQ(error_in_light(R"("cutoff": 90.001)"), "lights[2].cutoff: 90.001 is outside 0..90");
  EXPECT_EQ(error_in_light(R"("cutoff": -0.001)"), "lights[2].cutoff: -0.001 is outside 0..90");
  EXPECT_EQ(error_in_light(R"("beam": -1)"), "lights[2].beam: -1 is outside 0..90");
  EXPECT_EQ(error_in_light(R"("exponent": 10001)"), "lights[2].exponent: 10001 is outside 0..10000");
  EXPECT_EQ(error_in_light(R"("exponent": -1)"), "lights[2].exponent: -1 is outside 0..10000");
  EXPECT_EQ(error_in_light(R"("diffuse": [0, -0.1, 0])"), "lights[2].diffuse[1]: -0.1 is not 0 or more");
  EXPECT_EQ(error_in_light(R"("attenuation": {"linear": -1})"), "lights[2].attenuation.linear: -1 is not 0 or more");
  EXPECT_EQ(error_in_light(R"("attenuation": {"falloff": -1})"), "lights[2].attenuation.falloff: -1 is not 0 or more");
  EXPECT_EQ(error_with(R"("fog": {"density": -1})"), "fog.density: -1 is not 0 or more");
  EXPECT_EQ(error_with(R"("ambient": [1, 1, 1e40])"), "ambient[2]: 1e+40 is too large, the largest number is 3.4028235e+38");
  EXPECT_EQ(error_in_object(R"("mesh": "a", "material": {"shininess": -1})"), "objects[1].material.shininess: -1 is outside 0..10000");
  EXPECT_EQ(error_in_object(R"("mesh": "a", "material": {"shininess": 10000.5})"), "objects[1].material.shininess: 10000.5 is outside 0..10000");
  EXPECT_EQ(error_in_object(R"("mesh": "a", "material": {"opacity": 1.1})"), "objects[1].material.opacity: 1.1 is outside 0..1");
}

TEST(SceneReader, RefusesBadColours) {
  EXPECT_EQ(error_with(R"("ambient": "red")"), "ambient: found \"red\", expected a colour: [r, g, b] or \"#rrggbb\"");
  EXPECT_EQ(error_with(R"("ambient": "#12345")"), "ambient: found \"#12345\", expected a colour: #rgb, #rrggbb or three numbers r,g,b");
  EXPECT_EQ(error_with(R"("ambient": "1,1,1")"), "ambient: found \"1,1,1\", expected a colour: [r, g, b] or \"#rrggbb\"");
  EXPECT_EQ(error_with(R"("ambient": [1, 1, 1, 1])"), "ambient: found a list of 4, expected a colour: [r, g, b] or \"#rrggbb\"");
  EXPECT_EQ(error_with(R"("ambient": 0.5)"), "ambient: found 0.5, expected a colour: [r, g, b] or \"#rrggbb\"");
  EXPECT_EQ(error_with(R"("image": {"background": [1, 1]})"),
            "image.background: found a list of 2, expected a colour: [r, g, b], [r, g, b, a] or \"#rrggbb\"");
}

TEST(SceneReader, RefusesUnknownWordsAndSuggestsTheNearest) {
  EXPECT_EQ(error_with(R"("shading": {"lighting": "blin-phong"})"),
            "shading.lighting: unknown word \"blin-phong\", did you mean \"blinn-phong\"? (known: constant, lambert, phong, blinn-phong, ggx)");
  EXPECT_EQ(error_in_light(R"("type": "sun")"), "lights[2].type: unknown word \"sun\" (known: directional, point, spot)");
  EXPECT_EQ(error_with(R"("shading": {"terms": ["diffuse", "ambeint"]})"),
            "shading.terms[1]: unknown word \"ambeint\", did you mean \"ambient\"? (known: ambient, diffuse, specular, emission)");
  EXPECT_EQ(error_with(R"("shading": {"terms": ["diffuse", "diffuse"]})"), "shading.terms[1]: \"diffuse\" is stated twice");
}

TEST(SceneReader, RefusesUnknownMaterials) {
  const auto scene = parse_scene(R"({"materials": {"red": {}}, "objects": [{"mesh": "a", "material": "jaed"}]})", "scene.json");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().kind, ErrorKind::usage);
  EXPECT_EQ(scene.error().text().substr(0, 109),
            "scene.json: objects[0].material: unknown material \"jaed\", did you mean \"jade\"? (known: red, emerald, jade, ob");
  EXPECT_EQ(error_with(R"("materials": {"a": "b"})").substr(0, 33), "materials.a: unknown material \"b\"");
  EXPECT_EQ(error_with(R"("materials": {"a": "ruby", "b": "a"})").substr(0, 33), "materials.b: unknown material \"a\"");  // no chains
}

TEST(SceneReader, NeedsObjectsAndTheirMeshes) {
  EXPECT_EQ(error_of("{}"), "scene.json: objects: is missing, expected a list of what is drawn");
  EXPECT_EQ(error_in_object(R"("material": "jade")"), "objects[1].mesh: is missing, expected a mesh file or primitive:NAME");
  EXPECT_EQ(error_in_object(R"("mesh": "")"), "objects[1].mesh: is missing, expected a mesh file or primitive:NAME");
}

TEST(SceneReader, ReadsOneOfTwoAttenuations) {
  EXPECT_EQ(error_in_light(R"("attenuation": {"falloff": 2, "linear": 0})"),
            "lights[2].attenuation: states both falloff and linear, expected falloff alone or constant, linear and quadratic");
  EXPECT_EQ(error_in_light(R"("attenuation": {"falloff": 2, "unclamped": true})"), "");
}

TEST(SceneReader, EveryKeyOfTheTableRefusesAWrongTypeAtItsPath) {
  int checked = 0;
  for (const FieldGroup& group : field_groups()) {
    for (const FieldInfo& field : group.fields) {
      // A list of a list fits no key.
      const std::string key = "\"" + std::string(field.key) + "\": [[[]]]";
      std::string json;
      std::string path;
      if (group.path.empty()) {
        json = field.key == "objects" ? "{" + key + "}" : "{" + key + R"(, "objects": []})";
        path = std::string(field.key);
      } else if (group.path == "lights[]") {
        json = "{\"lights\": [{" + key + "}], \"objects\": []}";
        path = "lights[0]." + std::string(field.key);
      } else if (group.path == "lights[].attenuation") {
        json = "{\"lights\": [{\"attenuation\": {" + key + "}}], \"objects\": []}";
        path = "lights[0].attenuation." + std::string(field.key);
      } else if (group.path == "materials.*") {
        json = "{\"materials\": {\"m\": {" + key + "}}, \"objects\": []}";
        path = "materials.m." + std::string(field.key);
      } else if (group.path == "objects[]") {
        json = "{\"objects\": [{" + key + "}]}";
        path = "objects[0]." + std::string(field.key);
      } else {
        json = "{\"" + std::string(group.path) + "\": {" + key + "}, \"objects\": []}";
        path = std::string(group.path) + "." + std::string(field.key);
      }
      const std::string message = error_of(json);
      EXPECT_TRUE(message.starts_with("scene.json: " + path)) << json << " -> " << message;
      ++checked;
    }
  }
  EXPECT_EQ(checked, 68);
}

}  // namespace
}  // namespace lustro
