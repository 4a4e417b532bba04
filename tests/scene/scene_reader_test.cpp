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
  EXPECT_EQ(
      error_with(R"("": 1)"),
      "[\"\"]: unknown key (known: image, camera, shading, ambient, lights, fog, environment, shadow, occlusion, ground, materials, objects)");
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
  EXPECT_EQ(error_in_light(R"("type": "sun")"),
            "lights[2].type: unknown word \"sun\" (known: directional, point, spot, rectangle, disk, sphere)");
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

TEST(SceneReader, TexturesAreFilesOrTables) {
  const auto scene = parse_scene(R"({"materials": {"m": {"textures": {
    "diffuse": "wood.png",
    "normal": {"file": "n.png", "wrap": ["mirrored_repeat", "clamp_to_border"], "magnify": "nearest", "mip": "none", "anisotropy": 8,
               "offset": [0.5, 0], "scale": [2, 3], "rotation": 90, "uv_set": 1, "gain": 2, "base": -1},
    "opacity": {"file": "o.png", "wrap": "clamp_to_border", "border": [1, 0.5, 0.25, 0.75], "channel": "alpha", "once": true,
                "v_down": true, "matrix": [1, 2, 3, 4, 5, 6], "lod_bias": -1.5},
    "displacement": {"file": "d.png", "gain": [1, -1, 2], "base": [0, 1, 0]},
    "reflection": "sky.hdr",
    "object_space": true}}}, "objects": [{"mesh": "a", "material": "m"}]})",
                                 "scene.json");
  ASSERT_TRUE(scene) << scene.error().text();
  const StatedTextures& textures = scene->objects[0].material->stated_textures;
  EXPECT_EQ(textures.diffuse, (StatedTexture{.file = "wood.png"}));
  StatedTexture normal{.file = "n.png", .wrap = {Wrap::mirrored_repeat, Wrap::clamp_to_border}, .magnify = TextureFilter::nearest};
  normal.mip = MipFilter::none;
  normal.anisotropy = 8;
  normal.offset = {0.5F, 0};
  normal.scale = {2, 3};
  normal.rotation = 90;
  normal.uv_set = 1;
  normal.gain = {2, 2, 2};
  normal.base = {-1, -1, -1};
  EXPECT_EQ(textures.normal, normal);
  StatedTexture opacity{.file = "o.png", .wrap = {Wrap::clamp_to_border, Wrap::clamp_to_border}};
  opacity.border = {{1, 0.5F, 0.25F}};
  opacity.border_alpha = 0.75F;
  opacity.matrix = {1, 2, 3, 4, 5, 6};
  opacity.lod_bias = -1.5F;
  opacity.channel = TextureChannel::alpha;
  opacity.once = opacity.v_down = true;
  EXPECT_EQ(textures.opacity, opacity);
  EXPECT_TRUE(textures.object_space);
  EXPECT_FALSE(textures.bump);
  StatedTexture displacement{.file = "d.png"};
  displacement.gain = {1, -1, 2};
  displacement.base = {0, 1, 0};
  EXPECT_EQ(textures.displacement, displacement);
  EXPECT_EQ(textures.reflection, (StatedReflection{.picture = StatedTexture{.file = "sky.hdr"}}));
}

TEST(SceneReader, AReflectionIsASphereOrACube) {
  const auto scene = parse_scene(R"({"objects": [{"mesh": "a", "material": {"textures": {"reflection": {"shape": "cube",
    "right": "r", "left": "l", "top": "t", "bottom": "b", "front": "f", "back": {"file": "k", "gain": 2}}}}}]})");
  ASSERT_TRUE(scene) << scene.error().text();
  const auto& map = scene->objects[0].material->stated_textures.reflection;
  ASSERT_TRUE(map);
  EXPECT_EQ(map->shape, ReflectionShape::cube);
  EXPECT_FALSE(map->picture);
  EXPECT_EQ(map->right->file + map->left->file + map->top->file + map->bottom->file + map->front->file + map->back->file, "rltbfk");
  EXPECT_EQ(map->back->gain, (Vec3f{2, 2, 2}));
  const auto error_in_reflection = [](const std::string& text) {
    return error_with(R"("materials": {"m": {"textures": {"reflection": )" + text + "}}}");
  };
  const std::string path = "materials.m.textures.reflection";
  EXPECT_EQ(error_in_reflection("[]"), path + ": found an empty list, expected the name of a picture's file or a table");
  EXPECT_EQ(error_in_reflection("{}"), path + ".picture: is missing, expected the picture of a sphere");
  EXPECT_EQ(error_in_reflection(R"({"picture": "a", "left": "b"})"), path + ".left: belongs to shape cube, found shape sphere");
  EXPECT_EQ(error_in_reflection(R"({"shape": "cube", "picture": "a"})"), path + ".picture: belongs to shape sphere, found shape cube");
  EXPECT_EQ(error_in_reflection(R"({"shape": "cube", "right": "a"})"), path + ".left: is missing, expected six pictures of a cube");
}

TEST(SceneReader, AColourBesideItsTextureIsWhiteUnlessItIsStated) {
  const auto scene = parse_scene(R"({"materials": {"m": {"specular": [0, 0.5, 0], "textures": {"diffuse": "a.png", "specular": "b.png"}}},
    "objects": [{"mesh": "a", "material": "m"}]})");
  ASSERT_TRUE(scene) << scene.error().text();
  const Material& material = *scene->objects[0].material;
  EXPECT_EQ(material.name, "m");
  EXPECT_EQ(material.diffuse, (Color{{1, 1, 1}}));
  EXPECT_EQ(material.specular, (Color{{0, 0.5F, 0}}));
  EXPECT_EQ(material.ambient, Material{}.ambient);
  EXPECT_EQ(material.emission, Material{}.emission);
}

TEST(SceneReader, OpacityHasAMode) {
  const auto scene = parse_scene(R"({"objects": [{"mesh": "a", "material": {"opacity": 0.5, "alpha_mode": "mask", "alpha_cutoff": 0.25}}]})");
  ASSERT_TRUE(scene) << scene.error().text();
  EXPECT_EQ(scene->objects[0].material->alpha_mode, AlphaMode::mask);
  EXPECT_EQ(scene->objects[0].material->alpha_cutoff, 0.25F);
  EXPECT_EQ(error_with(R"("materials": {"m": {"alpha_mode": "masked"}})"),
            "materials.m.alpha_mode: unknown word \"masked\", did you mean \"mask\"? (known: blend, mask, opaque)");
}

TEST(SceneReader, WrongTexturesAreNamed) {
  const auto error_in_textures = [](const std::string& text) { return error_with(R"("materials": {"m": {"textures": {)" + text + "}}}"); };
  EXPECT_EQ(error_in_textures(R"("difuse": "a.png")"), "materials.m.textures.difuse: unknown key, did you mean \"diffuse\"?");
  EXPECT_EQ(error_in_textures(R"("bump": 3)"), "materials.m.textures.bump: found 3, expected the name of a picture's file or a table");
  EXPECT_EQ(error_in_textures(R"("bump": "")"), "materials.m.textures.bump: is missing, expected the name of a picture's file");
  EXPECT_EQ(error_in_textures(R"("bump": {"gain": 2})"), "materials.m.textures.bump.file: is missing, expected the name of a picture's file");
  EXPECT_EQ(error_in_textures(R"("bump": {"file": "a", "wrap": ["repeat"]})"),
            "materials.m.textures.bump.wrap: found a list of 1, expected a word or a list of two (repeat, mirrored_repeat, clamp_to_edge, "
            "clamp_to_border)");
  EXPECT_EQ(error_in_textures(R"("bump": {"file": "a", "matrix": [1, 0, 0, 0, 1, 0], "scale": [1, 1]})"),
            "materials.m.textures.bump: states both matrix and scale, expected matrix alone or offset, scale and rotation");
  EXPECT_EQ(error_in_textures(R"("bump": {"file": "a", "matrix": [1, 0]})"),
            "materials.m.textures.bump.matrix: found a list of 2, expected a list of six numbers, row by row");
  EXPECT_EQ(error_in_textures(R"("bump": {"file": "a", "gain": [1, 2]})"),
            "materials.m.textures.bump.gain: found a list of 2, expected a number, or a list of three [r, g, b]");
  EXPECT_EQ(error_in_textures(R"("bump": {"file": "a", "offset": [1, 1e10]})"),
            "materials.m.textures.bump.offset[1]: 10000000000 is outside -1000000000..1000000000");
  EXPECT_EQ(error_in_textures(R"("bump": {"file": "a", "anisotropy": 17})"), "materials.m.textures.bump.anisotropy: 17 is outside 1..16");
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
      } else if (group.path == "image.tone") {
        json = "{\"image\": {\"tone\": {" + key + "}}, \"objects\": []}";
        path = "image.tone." + std::string(field.key);
      } else if (group.path == "materials.*") {
        json = "{\"materials\": {\"m\": {" + key + "}}, \"objects\": []}";
        path = "materials.m." + std::string(field.key);
      } else if (group.path == "materials.*.textures") {
        json = "{\"materials\": {\"m\": {\"textures\": {" + key + "}}}, \"objects\": []}";
        path = "materials.m.textures." + std::string(field.key);
      } else if (group.path == "materials.*.textures.reflection") {
        json = "{\"materials\": {\"m\": {\"textures\": {\"reflection\": {" + key + "}}}}, \"objects\": []}";
        path = "materials.m.textures.reflection." + std::string(field.key);
      } else if (group.path == "materials.*.textures.*") {
        json = "{\"materials\": {\"m\": {\"textures\": {\"bump\": {" + key + "}}}}, \"objects\": []}";
        path = "materials.m.textures.bump." + std::string(field.key);
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
  EXPECT_EQ(checked, 76 + 3 + 12 + 18 + 8 + 3 + 6 + 3 + 7);
}

TEST(SceneReader, ShadowsAreSwitchedOrStated) {
  const auto shadow_of = [](const std::string& value) {
    const auto scene = parse_scene("{\"shadow\": " + value + R"(, "objects": [{"mesh": "a"}]})");
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().text());
    return scene ? scene->shadow : std::nullopt;
  };
  EXPECT_FALSE(shadow_of("false"));
  ASSERT_TRUE(shadow_of("true"));
  EXPECT_EQ(shadow_of("true")->size, 2048);
  EXPECT_EQ(shadow_of("{}")->softness, 0);
  EXPECT_EQ(shadow_of(R"({"size": 512, "softness": 4})")->size, 512);
  EXPECT_EQ(shadow_of(R"({"size": 512, "softness": 4})")->softness, 4);
  EXPECT_EQ(error_with(R"("shadow": 1)"), "shadow: found 1, expected true, false or a table");
  EXPECT_EQ(error_with(R"("shadow": {"size": 8193})"), "shadow.size: 8193 is outside 16..8192");
  EXPECT_EQ(error_with(R"("shadow": {"soft": 1})"), "shadow.soft: unknown key (known: size, softness)");
  EXPECT_EQ(error_in_light(R"("shadow": 0)"), "lights[2].shadow: found 0, expected true or false");
  EXPECT_EQ(error_with(R"("image": {"tone": {"operator": "filmic"}})").find("image.tone.operator: unknown word"), 0U);
}

}  // namespace
}  // namespace lustro
