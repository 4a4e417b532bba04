// The JSON Schema: whole, and of one mind with the reader (checked by python3's jsonschema where that is installed).
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "lustro/scene.hpp"
#include "scene/fields.hpp"
#include "scene_examples.hpp"

namespace lustro {
namespace {

namespace fs = std::filesystem;

nlohmann::json schema() {
  return nlohmann::json::parse(scene_schema());
}

TEST(SceneSchema, HasEveryKeyWithItsHelpAndNoOther) {
  const auto root = schema();
  EXPECT_EQ(root["$schema"], "https://json-schema.org/draft/2020-12/schema");
  const std::map<std::string_view, std::string> names{{"lights[]", "light"},
                                                      {"lights[].attenuation", "attenuation"},
                                                      {"materials.*", "material"},
                                                      {"materials.*.textures", "textures"},
                                                      {"materials.*.textures.*", "texture"},
                                                      {"materials.*.textures.reflection", "reflection"},
                                                      {"objects[]", "object"},
                                                      {"image.tone", "tone"}};
  for (const FieldGroup& group : field_groups()) {
    const auto name = names.find(group.path);
    const auto& table = group.path.empty() ? root : root["$defs"].at(name == names.end() ? std::string(group.path) : name->second);
    EXPECT_EQ(table["type"], "object");
    EXPECT_EQ(table["additionalProperties"], false);
    EXPECT_EQ(table["properties"].size(), group.fields.size() + (group.path.empty() ? 1 : 0)) << group.path;  // and $schema
    for (const FieldInfo& field : group.fields) {
      const auto& property = table["properties"].at(std::string(field.key));
      EXPECT_TRUE(property["description"].get<std::string>().starts_with(field.help)) << field.key;
    }
  }
}

TEST(SceneSchema, SaysRangesWordsAndWhatIsRequired) {
  const auto root = schema();
  EXPECT_EQ(root["required"], nlohmann::json::array({"objects"}));
  const auto& definitions = root["$defs"];
  EXPECT_EQ(definitions["object"]["required"], nlohmann::json::array({"mesh"}));
  EXPECT_EQ(definitions["light"]["properties"]["cutoff"]["minimum"], 0);
  EXPECT_EQ(definitions["light"]["properties"]["cutoff"]["maximum"], 90);
  EXPECT_EQ(definitions["camera"]["properties"]["fov"]["exclusiveMaximum"], 180);
  EXPECT_EQ(definitions["image"]["properties"]["samples"]["enum"], nlohmann::json::array({1, 2, 4, 8, 16}));
  EXPECT_EQ(definitions["shading"]["properties"]["lighting"]["enum"],
            nlohmann::json::array({"constant", "lambert", "phong", "blinn-phong", "ggx"}));
  EXPECT_EQ(definitions["matrix"]["minItems"], 16);
}

TEST(SceneSchema, EveryReferenceExists) {
  const auto root = schema();
  const auto flat = root.flatten();
  int references = 0;
  for (const auto& [path, value] : flat.items()) {
    if (path.ends_with("/$ref")) {
      const std::string target = value.get<std::string>().substr(1);
      EXPECT_TRUE(root.contains(nlohmann::json::json_pointer(target))) << target;
      ++references;
    }
  }
  EXPECT_GT(references, 15);
}

/// Scenes, one key at a time, on both sides of each rule that concerns one key alone. The reader says which are good.
std::vector<std::string> small_scenes() {
  std::vector<std::string> scenes{kExampleScene, "{}", "[]", R"({"objects": [{}]})", R"({"objects": [{"mesh": ""}]})", R"({"objects": 1})"};
  const auto with = [&](const std::string& key) { scenes.push_back("{" + key + R"(, "objects": [{"mesh": "a"}]})"); };
  const auto light = [&](const std::string& keys) { with("\"lights\": [{" + keys + "}]"); };
  const auto object = [&](const std::string& keys) { scenes.push_back(R"({"objects": [{"mesh": "a", )" + keys + "}]}"); };
  for (const char* width : {"0", "1", "16384", "16385", "4.0", "4.5", "\"4\"", "null", "true", "1e3"}) {
    with(std::string("\"image\": {\"width\": ") + width + "}");
  }
  for (const char* samples : {"0", "1", "2", "3", "4", "8", "16", "32", "4.0"}) {
    with(std::string("\"image\": {\"samples\": ") + samples + "}");
  }
  for (const char* color : {"[1, 1, 1]",
                            "[1, 1]",
                            "[1, 1, 1, 1]",
                            "[1, 1, 1, 2]",
                            "[0, 0, -1]",
                            "[0, 0, 9]",
                            "[0, 0, 1e39]",
                            "\"#fff\"",
                            "\"#ffff\"",
                            "\"#fffff\"",
                            "\"#ffffff\"",
                            "\"#ffffff00\"",
                            "\"#ggg\"",
                            "\"red\"",
                            "1",
                            "\"color(srgb 1 0.5 0)\"",
                            "\"color(srgb 1 0.5 0 / 1)\"",
                            "\"color(srgb 1)\"",
                            "\"color(srgb 1 -1 0)\"",
                            "\"1,1,1\""}) {
    with(std::string("\"image\": {\"background\": ") + color + "}");
    with(std::string("\"ambient\": ") + color);
  }
  for (const char* fov : {"0", "1e-3", "179.9", "180", "-1", "\"x\""}) {
    with(std::string("\"camera\": {\"fov\": ") + fov + "}");
  }
  for (const char* eye : {"[1, 2, 3]", "[1, 2]", "[1, 2, 3, 4]", "[1, 2, \"3\"]", "[1, 2, 1e39]", "3", "null"}) {
    with(std::string("\"camera\": {\"eye\": ") + eye + "}");
  }
  for (const char* angle : {"-0.1", "0", "90", "90.1", "180", "180.1"}) {
    light(std::string("\"cutoff\": ") + angle);
    with(std::string("\"shading\": {\"crease\": ") + angle + "}");
  }
  for (const char* word : {"\"phong\"", "\"blinn-phong\"", "\"flat\"", "\"lambert\"", "\"constant\"", "\"\"", "1"}) {
    with(std::string("\"shading\": {\"lighting\": ") + word + "}");
    with(std::string("\"shading\": {\"interpolation\": ") + word + "}");
    object(std::string("\"material\": {\"lighting\": ") + word + "}");
  }
  const auto texture = [&](const std::string& keys) { object("\"material\": {\"textures\": {\"bump\": {" + keys + "}}}"); };
  for (const char* keys : {"", "\"file\": \"\"", "\"file\": 1", "\"file\": \"a\", \"wrap\": \"repeat\"", "\"file\": \"a\", \"wrap\": \"tile\"",
                           "\"file\": \"a\", \"wrap\": [\"repeat\", \"mirrored_repeat\"]", "\"file\": \"a\", \"wrap\": [\"repeat\"]",
                           "\"file\": \"a\", \"gain\": 2", "\"file\": \"a\", \"gain\": [1, 2, 3]", "\"file\": \"a\", \"gain\": [1, 2]",
                           "\"file\": \"a\", \"offset\": [1, 2]", "\"file\": \"a\", \"offset\": [1, 2e9]", "\"file\": \"a\", \"offset\": 1",
                           "\"file\": \"a\", \"matrix\": [1, 0, 0, 0, 1, 0]", "\"file\": \"a\", \"matrix\": [1, 0, 0, 0, 1]",
                           "\"file\": \"a\", \"matrix\": [1, 0, 0, 0, 1, 0], \"rotation\": 3", "\"file\": \"a\", \"uv_set\": 2",
                           "\"file\": \"a\", \"border\": [0, 0, 0, 0.5]", "\"file\": \"a\", \"lod_bias\": -17"}) {
    texture(keys);
  }
  for (const char* map :
       {"\"a\"", "\"\"", "3", "{}", R"({"picture": "a"})", R"({"shape": "sphere", "picture": {"file": "a"}})", R"({"picture": "a", "top": "b"})",
        R"({"shape": "cube"})", R"({"shape": "cone", "picture": "a"})",
        R"({"shape": "cube", "right": "a", "left": "b", "top": "c", "bottom": "d", "front": "e", "back": "f"})",
        R"({"shape": "cube", "right": "a", "left": "b", "top": "c", "bottom": "d", "front": "e"})",
        R"({"shape": "cube", "right": "a", "left": "b", "top": "c", "bottom": "d", "front": "e", "back": "f", "picture": "g"})"}) {
    object(std::string("\"material\": {\"textures\": {\"reflection\": ") + map + "}}");
  }
  for (const char* key : {R"("alpha_mode": "mask")", R"("alpha_mode": "Mask")", R"("alpha_cutoff": 1)", R"("alpha_cutoff": 1.1)",
                          R"("textures": {})", R"("textures": "a")", R"("textures": {"bump": "a"})", R"("textures": {"object_space": 1})"}) {
    object("\"material\": {" + std::string(key) + "}");
  }
  for (const char* terms : {"[]", "[\"diffuse\"]", "[\"diffuse\", \"diffuse\"]", "[\"light\"]", "\"diffuse\"", "[1]"}) {
    with(std::string("\"shading\": {\"terms\": ") + terms + "}");
  }
  for (const char* attenuation :
       {"{}", "{\"falloff\": 2}", "{\"falloff\": 2, \"linear\": 1}", "{\"falloff\": 2, \"unclamped\": true}", "{\"falloff\": -1}",
        "{\"linear\": 1, \"quadratic\": 2, \"constant\": 0}", "{\"linear\": -1}", "{\"range\": 1}", "2", "[]"}) {
    light(std::string("\"type\": \"point\", \"attenuation\": ") + attenuation);
  }
  for (const char* matrix : {"[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]", "[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0]", "[]", "\"1\""}) {
    object(std::string("\"matrix\": ") + matrix);
  }
  for (const char* shininess : {"-1", "0", "10000", "10001"}) {
    object(std::string("\"material\": {\"shininess\": ") + shininess + "}");
  }
  for (const char* key : {"\"ligths\": []",
                          "\"lights\": []",
                          "\"lights\": null",
                          "\"lights\": [1]",
                          "\"$schema\": \"x\"",
                          "\"$schema\": 1",
                          "\"fog\": {}",
                          "\"shadow\": true",
                          "\"shadow\": {}",
                          "\"shadow\": {\"size\": 15}",
                          "\"shadow\": {\"softness\": 1.5}",
                          "\"shadow\": 0",
                          "\"image\": {\"tone\": {\"operator\": \"agx\"}}",
                          "\"image\": {\"tone\": \"agx\"}",
                          "\"fog\": null",
                          "\"fog\": {\"mode\": \"exp2\", \"density\": 0}",
                          "\"fog\": {\"density\": -1}",
                          "\"materials\": {\"a\": \"jade\", \"b\": {}}",
                          "\"materials\": {\"a\": \"jada\"}",
                          "\"materials\": {\"a\": 1}",
                          "\"materials\": []",
                          "\"camera\": []",
                          "\"camera\": {\"Fov\": 3}"}) {
    with(key);
  }
  object("\"name\": \"x\"");
  object("\"name\": \"a\\u0000b\"");
  object("\"name\": 1");
  object("\"material\": \"ruby\"");
  object("\"material\": 1");
  return scenes;
}

TEST(SceneSchema, AgreesWithTheReader) {
  const fs::path folder = fs::path(testing::TempDir()) / "lustro_schema";
  fs::remove_all(folder);
  fs::create_directories(folder / "scenes");
  std::ofstream(folder / "schema.json") << scene_schema();
  int number = 0;
  int good = 0;
  const auto add = [&](const std::string& text) {
    const bool is_good = parse_scene(text).has_value();
    good += is_good ? 1 : 0;
    std::ofstream(folder / "scenes" / ((is_good ? "good" : "bad") + std::to_string(number++) + ".json")) << text;
  };
  for (const std::string& scene : small_scenes()) {
    add(scene);
  }
  for (const auto& entry : fs::directory_iterator(fs::path(LUSTRO_SOURCE_DIR) / "examples" / "scenes")) {
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    add(text.str());
  }
  EXPECT_GT(good, 60);
  EXPECT_GT(number - good, 60);

  const std::string script = (fs::path(LUSTRO_SOURCE_DIR) / "tests" / "scene" / "check_schema.py").string();
  const std::string command = "python3 '" + script + "' '" + (folder / "schema.json").string() + "' '" + (folder / "scenes").string() + "' 2>&1";
  const int status = std::system(command.c_str());
  fs::remove_all(folder);
  if (WIFEXITED(status) && (WEXITSTATUS(status) == 77 || WEXITSTATUS(status) == 127)) {
    GTEST_SKIP() << "needs python3 with jsonschema";
  }
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace lustro
