// Documents that are wrong: every value in turn, and the message names its JSON path.
#include "io/gltf_document.hpp"

#include <filesystem>
#include <functional>
#include <set>

#include "gltf_testing.hpp"
#include "io/read_file.hpp"
#include "shared_dir.hpp"

namespace lustro {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

/// A document that has something of everything.
GltfMaker everything() {
  GltfMaker maker;
  maker.json["extensionsUsed"] = {"KHR_lights_punctual",    "KHR_texture_transform",           "KHR_materials_unlit",
                                  "KHR_materials_specular", "KHR_materials_emissive_strength", "KHR_materials_pbrSpecularGlossiness"};
  maker.json["extensionsRequired"] = {"KHR_texture_transform"};
  maker.json["scene"] = 0;
  maker.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"}, {"intensity", 2}, {"range", 5}, {"color", {1, 0.5, 0}}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.2}}}},
      {{"type", "directional"}, {"name", "sun"}, {"intensity", 2}},
      {{"type", "point"}, {"range", 1}}};
  Json primitive = maker.triangle();
  Json& attributes = primitive["attributes"];
  attributes["NORMAL"] = maker.add_accessor<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
  attributes["TEXCOORD_0"] = maker.add_accessor<float>("VEC2", {0, 0, 1, 0, 0, 1});
  attributes["JOINTS_0"] = maker.add_accessor<std::uint8_t>("VEC4", std::vector<std::uint8_t>(12));
  attributes["WEIGHTS_0"] = maker.add_accessor<float>("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  primitive["indices"] = maker.add_accessor<std::uint16_t>("SCALAR", {0, 1, 2});
  primitive["targets"] = {{{"POSITION", maker.add_accessor<float>("VEC3", std::vector<float>(9))}}};
  primitive["material"] = 0;
  primitive["mode"] = 4;
  const std::size_t sparse = attributes["POSITION"];
  maker.json["accessors"][sparse]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", maker.add_view<std::uint8_t>({1})}, {"byteOffset", 0}, {"componentType", 5121}}},
      {"values", {{"bufferView", maker.add_view<float>({2, 0, 0})}, {"byteOffset", 0}}}};
  maker.json["accessors"][sparse]["byteOffset"] = 0;
  maker.json["accessors"][sparse]["min"] = {0, 0, 0};
  const Json use{{"index", 0}, {"texCoord", 0}, {"extensions", {{"KHR_texture_transform", {{"offset", {0, 0}}, {"rotation", 0.5}}}}}};
  Json scaled = use;
  scaled["scale"] = 0.5;
  maker.json["images"] = {{{"uri", "a.png"}, {"mimeType", "image/png"}},
                          {{"bufferView", maker.add_view<std::uint8_t>({0x89, 'P', 'N', 'G'})}, {"mimeType", "image/png"}, {"name", "broken"}}};
  maker.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9985}}};
  maker.json["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 1}}};
  maker.json["materials"] = {{{"pbrMetallicRoughness",
                               {{"baseColorFactor", {1, 1, 1, 1}},
                                {"metallicFactor", 0.5},
                                {"roughnessFactor", 0.5},
                                {"baseColorTexture", use},
                                {"metallicRoughnessTexture", use}}},
                              {"normalTexture", scaled},
                              {"occlusionTexture", {{"index", 1}, {"strength", 0.5}}},
                              {"emissiveTexture", {{"index", 1}, {"texCoord", 0}}},
                              {"emissiveFactor", {0, 0, 0}},
                              {"alphaMode", "MASK"},
                              {"alphaCutoff", 0.5},
                              {"doubleSided", true},
                              {"extensions",
                               {{"KHR_materials_specular",
                                 {{"specularFactor", 0.5},
                                  {"specularColorFactor", {1, 1, 1}},
                                  {"specularTexture", {{"index", 0}}},
                                  {"specularColorTexture", {{"index", 1}}}}},
                                {"KHR_materials_emissive_strength", {{"emissiveStrength", 2}}}}}},
                             {{"extensions",
                               {{"KHR_materials_pbrSpecularGlossiness",
                                 {{"glossinessFactor", 0.5},
                                  {"diffuseFactor", {1, 1, 1, 1}},
                                  {"specularFactor", {0, 0, 0}},
                                  {"diffuseTexture", {{"index", 0}}},
                                  {"specularGlossinessTexture", {{"index", 0}}}}}}}}};
  maker.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}, {"zfar", 10}, {"aspectRatio", 1}}}},
                           {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0}, {"zfar", 10}}}}};
  maker.json["meshes"] = {{{"primitives", {primitive}}, {"weights", {0.5}}, {"name", "m"}}};
  maker.json["skins"] = {{{"joints", {1}},
                          {"skeleton", 1},
                          {"inverseBindMatrices", maker.add_accessor<float>("MAT4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1})}}};
  maker.json["nodes"] = {
      {{"mesh", 0}, {"skin", 0}, {"children", {1}}, {"weights", {1}}, {"name", "n"}},
      {{"camera", 0}, {"translation", {1, 0, 0}}, {"rotation", {0, 0, 0, 1}}, {"scale", {1, 1, 1}}},
      {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}};
  maker.json["scenes"] = {{{"nodes", {0, 2}}}};
  const std::size_t input = maker.add_accessor<float>("SCALAR", {0, 1});
  const std::size_t output = maker.add_accessor<float>("VEC3", {0, 0, 0, 1, 1, 1});
  maker.json["animations"] = {{{"samplers", {{{"input", input}, {"output", output}, {"interpolation", "LINEAR"}}}},
                               {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}}}};
  maker.json["buffers"] = {{{"byteLength", maker.bytes.size()}, {"uri", "data:;base64," + base64(maker.bytes)}}};
  return maker;
}

/// A JSON pointer as our messages write it.
std::string path_of(const Json::json_pointer& pointer, const Json& root) {
  std::string text;
  std::vector<std::string> steps;
  for (Json::json_pointer p = pointer; !p.empty(); p.pop_back()) {
    steps.insert(steps.begin(), p.back());
  }
  Json::json_pointer walked;
  for (const std::string& step : steps) {
    text = root.at(walked).is_array() ? text + "[" + step + "]" : text.empty() ? step : text + "." + step;
    walked.push_back(step);
  }
  return text;
}

std::vector<Json::json_pointer> leaves_of(const Json& root) {
  std::vector<Json::json_pointer> leaves;
  const Json flat = root.flatten();
  for (const auto& [pointer, value] : flat.items()) {
    leaves.emplace_back(pointer);
  }
  return leaves;
}

bool is_free(const std::string& path) {  // what nobody reads
  return path.find("extras") != std::string::npos || path.find("generator") != std::string::npos || path.find("copyright") != std::string::npos;
}

using Load = std::function<Result<SourceMesh>(const Json&)>;

/// Each leaf in turn becomes something of another type.
void expect_wrong_types_are_named(const Json& root, const Load& load) {
  ASSERT_TRUE(load(root)) << load(root).error().text();
  for (const Json::json_pointer& leaf : leaves_of(root)) {
    const std::string path = path_of(leaf, root);
    const Json value = root.at(leaf);
    if (is_free(path)) {
      continue;
    }
    for (const Json& wrong :
         {Json(true), Json("x"), Json(1), Json(nullptr), Json(Json::array()), Json(Json::object()), Json(Json::array({"x"}))}) {
      const bool is_same_kind = wrong.type() == value.type() || (wrong.is_number() && value.is_number()) ||
                                (wrong.is_array() && value.is_array()) || (wrong.is_object() && value.is_object());
      if (is_same_kind) {
        continue;
      }
      Json changed = root;
      changed[leaf] = wrong;
      const Result<SourceMesh> mesh = load(changed);
      ASSERT_FALSE(mesh) << path << " as " << wrong;
      EXPECT_THAT(mesh.error().where, StartsWith("t.gltf: ")) << path << " as " << wrong << ": " << mesh.error().text();
      const std::string parent = path.substr(0, path.find_last_of(".["));  // where a list is short, the list is named
      EXPECT_TRUE(mesh.error().where.find(path) != std::string::npos ||
                  (!parent.empty() && mesh.error().where.find(parent) != std::string::npos))
          << path << " as " << wrong << ": " << mesh.error().text();
    }
  }
}

/// Each index, count, offset, length and code in turn becomes one that cannot be.
void expect_wrong_numbers_are_named(const Json& root, const Load& load) {
  const std::set<std::string> keys{
      "bufferView", "buffer", "byteOffset", "byteLength", "byteStride", "count",     "componentType", "mesh",     "material",
      "node",       "scene",  "sampler",    "source",     "input",      "output",    "camera",        "skin",     "indices",
      "index",      "target", "mode",       "wrapS",      "wrapT",      "magFilter", "minFilter",     "skeleton", "light",
      "POSITION",   "NORMAL", "TANGENT",    "TEXCOORD_0", "JOINTS_0",   "WEIGHTS_0", "COLOR_0",       "texCoord", "inverseBindMatrices"};
  const std::set<std::string> lists{"nodes", "children", "joints"};
  std::size_t changes = 0;
  for (const Json::json_pointer& leaf : leaves_of(root)) {
    const std::string key = leaf.back();
    const bool is_listed = leaf.parent_pointer() != Json::json_pointer() && lists.contains(leaf.parent_pointer().back());
    if (!root.at(leaf).is_number() || (!keys.contains(key) && !is_listed)) {
      continue;
    }
    for (const Json& wrong : {Json(-1), Json(1e300), Json(0.5), Json(4294967295U), Json(18446744073709551615U)}) {
      Json changed = root;
      changed[leaf] = wrong;
      const Result<SourceMesh> mesh = load(changed);
      const std::string path = path_of(leaf, root);
      ASSERT_FALSE(mesh) << path << " as " << wrong;
      const std::string parent = path.substr(0, path.find_last_of(".["));
      EXPECT_THAT(mesh.error().where, HasSubstr(parent)) << path << " as " << wrong << ": " << mesh.error().text();
      ++changes;
    }
  }
  EXPECT_GT(changes, 50U);
}

Result<SourceMesh> load_text(const std::string& text, const GltfOptions& options = {}) {
  Result<GltfModel> model = parse_gltf(text, "t.gltf", options, {});
  return model ? gltf_whole_mesh(*model) : tl::unexpected(model.error());
}

TEST(GltfDocument, EveryValueOfAnotherTypeIsNamed) {
  expect_wrong_types_are_named(everything().json, [](const Json& json) { return load_text(json.dump()); });
}

TEST(GltfDocument, EveryIndexCountOffsetAndCodeThatCannotBeIsNamed) {
  expect_wrong_numbers_are_named(everything().json, [](const Json& json) { return load_text(json.dump()); });
}

/// The document of an asset, GLB or not, and its files.
struct Asset {
  std::filesystem::path file;
  Json json;
  std::string binary;
};

std::vector<Asset> assets() {
  std::vector<Asset> all;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(shared_dir() / "assets" / "gltf")) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".gltf") {
      all.push_back({entry.path(), Json::parse(read_file(entry.path())->view()), {}});
    }
  }
  return all;
}

Load loader_of(const Asset& asset) {
  GltfOptions options;
  options.read = [folder = asset.file.parent_path()](const std::string& path) { return read_file(folder / path); };
  return [options](const Json& json) { return load_text(json.dump(), options); };
}

TEST(GltfDocument, WhatIsWrongInAnyAssetIsNamed) {
  LUSTRO_REQUIRE_SHARED();
  std::size_t seen = 0;
  for (const Asset& asset : assets()) {
    if (std::filesystem::file_size(asset.file) > 5000) {
      continue;  // the same kinds of values in larger numbers
    }
    SCOPED_TRACE(asset.file);
    expect_wrong_types_are_named(asset.json, loader_of(asset));
    expect_wrong_numbers_are_named(asset.json, loader_of(asset));
    ++seen;
  }
  EXPECT_GT(seen, 12U);
}

TEST(GltfDocument, BuffersCutShortAreNamed) {
  LUSTRO_REQUIRE_SHARED();
  for (const Asset& asset : assets()) {
    SCOPED_TRACE(asset.file);
    for (const std::size_t cut : {1U, 7U, 100U}) {
      GltfOptions options;
      options.read = [&](const std::string& path) {
        Result<FileBytes> bytes = read_file(asset.file.parent_path() / path);
        if (bytes) {
          bytes->size -= std::min<std::size_t>(cut, bytes->size);
        }
        return bytes;
      };
      Json json = asset.json;
      for (Json& buffer : json["buffers"]) {
        auto uri = buffer["uri"].get<std::string>();
        const auto length = buffer["byteLength"].get<std::size_t>();
        const std::size_t kept = uri.find(',') + 1 + (length > cut ? (length - cut) / 3 * 4 : 0);
        buffer["uri"] = uri.starts_with("data:") ? uri.substr(0, kept) : uri;
      }
      const Result<SourceMesh> mesh = load_text(json.dump(), options);
      ASSERT_FALSE(mesh);
      EXPECT_EQ(mesh.error().where, "t.gltf: buffers[0].byteLength");
    }
  }
}

TEST(GltfDocument, ExtensionsThatAreWrongAreNamed) {
  GltfMaker maker = everything();
  maker.json["extensionsRequired"][0] = "KHR_texture_transformX";
  EXPECT_EQ(bad(load_text(maker.json.dump())).text(),
            "t.gltf: extensionsRequired[0]: the file requires the extension \"KHR_texture_transformX\", which is not read");
  EXPECT_EQ(bad(load_text(maker.json.dump())).kind, ErrorKind::unsupported);
  maker.json["extensionsRequired"][0] = "KHR_draco_mesh_compression";
  EXPECT_EQ(bad(load_text(maker.json.dump())).where, "t.gltf: extensionsRequired[0]");
  maker.json.erase("extensionsRequired");
  maker.json["extensionsUsed"][0] = "EXT_odd";
  EXPECT_EQ(bad(load_text(maker.json.dump())).text(), "t.gltf: extensions.KHR_lights_punctual: is stated, but not listed in extensionsUsed");
  maker = everything();
  maker.json["extensionsUsed"].push_back("EXT_odd");
  EXPECT_THAT(texts(good(load_text(maker.json.dump())).notes), testing::Contains(HasSubstr("\"EXT_odd\": not read")));
}

TEST(GltfDocument, NodesAreTrees) {
  GltfMaker maker = everything();
  maker.json["nodes"][1]["children"] = {0};
  EXPECT_EQ(bad(load_text(maker.json.dump())).text(), "t.gltf: nodes[0].children[0]: node 1 is its own ancestor");
  maker.json["nodes"][1]["children"] = {1};
  EXPECT_EQ(bad(load_text(maker.json.dump())).text(), "t.gltf: nodes[1].children[0]: node 1 is a child of nodes[0] already");
  maker.json["nodes"][1].erase("children");
  maker.json["nodes"][2]["children"] = {1};
  EXPECT_EQ(bad(load_text(maker.json.dump())).text(), "t.gltf: nodes[2].children[0]: node 1 is a child of nodes[0] already");
  maker.json["nodes"][2]["children"] = {2};
  EXPECT_EQ(bad(load_text(maker.json.dump())).text(), "t.gltf: nodes[2].children[0]: node 2 is its own ancestor");
  maker = everything();
  maker.json["scenes"][0]["nodes"] = {0, 1};
  EXPECT_EQ(bad(load_text(maker.json.dump())).text(), "t.gltf: scenes[0].nodes[1]: node 1 is no root: nodes[0] is its parent");
}

TEST(GltfDocument, OtherVersionsAreRefused) {
  GltfMaker maker;
  maker.json["asset"]["version"] = "1.0";
  EXPECT_EQ(bad(maker.mesh()).kind, ErrorKind::unsupported);
  EXPECT_EQ(bad(maker.mesh()).text(), "t.gltf: asset.version: \"1.0\" is not read, expected \"2.0\"");
  maker.json.erase("asset");
  EXPECT_EQ(bad(maker.mesh()).where, "t.gltf: asset");
}

TEST(GltfDocument, TheMalformedSamplesFailByName) {
  LUSTRO_REQUIRE_SHARED();
  const std::map<std::string, std::string> expected{{"integer-out-of-bounds", "bufferViews[0].byteLength: 1e+300 is outside"},
                                                    {"invalid-buffer-index", "bufferViews[1].buffer: 1 is outside 0..0"},
                                                    {"invalid-buffer-view-index", "bufferViews[0].buffer: 0 is outside: there are no buffers"},
                                                    {"invalid-primitive-indices", "bufferViews[0].buffer: 0 is outside: there are no buffers"}};
  for (const auto& [name, message] : expected) {
    const std::filesystem::path file = shared_dir() / "assets" / "malformed" / (name + ".gltf");
    EXPECT_THAT(bad(load_mesh_file(file)).text(), StartsWith(file.string() + ": " + message));
  }
}

}  // namespace
}  // namespace lustro
