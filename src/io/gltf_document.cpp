// The document as a whole: its version, the extensions that it asks for, then its lists, each after those that it refers to.
#include "io/gltf_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "scene/nearest.hpp"

namespace lustro {
namespace {

using Json = nlohmann::json;

constexpr std::array<std::string_view, 13> kKnown{"KHR_draco_mesh_compression",
                                                  "EXT_meshopt_compression",
                                                  "KHR_mesh_quantization",
                                                  "KHR_texture_transform",
                                                  "KHR_lights_punctual",
                                                  "KHR_materials_unlit",
                                                  "KHR_materials_specular",
                                                  "KHR_materials_ior",
                                                  "KHR_materials_emissive_strength",
                                                  "EXT_texture_webp",
                                                  "EXT_mesh_gpu_instancing",
                                                  "KHR_materials_pbrSpecularGlossiness",
                                                  "KHR_xmp_json_ld"};  // the last is metadata: nothing of it could be drawn

void check_version(GltfReader& reader, const Json& root) {
  if (GltfReader::find(root, "asset") == nullptr) {
    reader.fail(root, "asset", "is missing, expected a table {...}");
    return;
  }
  const Json& asset = reader.table(root, "asset");
  const std::string version = reader.text(asset, "version");
  const std::string least = reader.text(asset, "minVersion");
  const auto is_two = [](const std::string& text) { return text == "2" || text.starts_with("2."); };
  if (!is_two(version)) {
    reader.fail(asset, "version",
                version.empty() ? std::string("is missing, expected \"2.0\"") : fmt::format("{} is not read, expected \"2.0\"", quote(version)),
                version.empty() ? ErrorKind::malformed : ErrorKind::unsupported);
  }
  if (!least.empty() && least != "2.0") {
    reader.fail(asset, "minVersion", fmt::format("{} is not read, expected \"2.0\"", quote(least)), ErrorKind::unsupported);
  }
}

void check_extensions(GltfReader& reader, const Json& root, GltfDocument& document) {
  const Json& used = reader.list(root, "extensionsUsed");
  const Json& required = reader.list(root, "extensionsRequired");
  for (const Json* list : {&used, &required}) {
    for (const Json& name : *list) {
      if (!name.is_string()) {
        reader.fail(name, "is no text, expected the name of an extension");
        return;
      }
    }
  }
  for (const Json& name : required) {
    const auto& text = name.get_ref<const std::string&>();
    if (!is_known_gltf_extension(text)) {
      reader.fail(name, fmt::format("the file requires the extension {}, which is not read", quote(text)), ErrorKind::unsupported);
    } else if (std::find(used.begin(), used.end(), name) == used.end()) {
      reader.fail(name, fmt::format("{} is required, but not listed in extensionsUsed", quote(text)));
    }
  }
  std::string ignored;
  for (const Json& name : used) {
    const auto& text = name.get_ref<const std::string&>();
    document.has_quantization = document.has_quantization || text == "KHR_mesh_quantization";
    constexpr std::size_t kLongestList = 400;
    if (!is_known_gltf_extension(text) && ignored.size() < kLongestList) {
      ignored += (ignored.empty() ? "" : ", ") + quote(text);
    }
  }
  if (!ignored.empty()) {
    document.notes.push_back({"extensionsUsed", fmt::format("{}: not read, what they say is left out", ignored)});
  }
}

}  // namespace

bool is_known_gltf_extension(std::string_view name) {
  return std::find(kKnown.begin(), kKnown.end(), name) != kKnown.end();
}

Result<GltfDocument> read_gltf_document(const Json& root, bool has_binary) {
  GltfReader reader(root);
  GltfDocument document;
  if (!root.is_object()) {
    return fail(ErrorKind::malformed, {}, "is no table {...}, as every glTF document is");
  }
  check_version(reader, root);
  check_extensions(reader, root, document);
  if (!reader.failed()) {
    read_gltf_buffers(reader, root, has_binary, document);
  }
  if (!reader.failed()) {
    read_gltf_materials(reader, root, document);
  }
  if (!reader.failed()) {
    read_gltf_meshes(reader, root, document);
  }
  if (!reader.failed()) {
    read_gltf_nodes(reader, root, document);
  }
  if (reader.failed()) {
    return tl::unexpected(reader.error());
  }
  return document;
}

}  // namespace lustro
