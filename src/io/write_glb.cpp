// Binary glTF 2.0 (Khronos, section 4): one node, one primitive a material, floats as they are.
//
// glTF has no classic materials. The base colour is the diffuse one, nothing is metal, and the exponent n becomes a roughness:
// alpha^2 = 2 / (n + 2) for Blinn's, for Phong's with 4 n, whose highlight is as wide; roughness = sqrt(alpha) (Walter et al. 2007).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "image/srgb.hpp"
#include "io/mesh_writers.hpp"
#include "io/write_bytes.hpp"

namespace lustro {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962;
constexpr int kElementBuffer = 34963;
constexpr int kClampToEdge = 33071;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

Vec3f linear(const Color& color) {
  if (color.space == ColorSpace::linear) {
    return color.rgb;
  }
  return {srgb_decode(color.rgb.x), srgb_decode(color.rgb.y), srgb_decode(color.rgb.z)};
}
float clamped(float x) {
  return x > 0 ? std::min(x, 1.0F) : 0.0F;
}
Json numbers(const Vec3f& v) {
  return {v.x, v.y, v.z};
}

/// The picture's type by its content; empty where glTF has no place for it.
std::string_view mime_type(std::string_view bytes) {
  return bytes.starts_with("\x89PNG\r\n\x1A\n") ? "image/png" : bytes.starts_with("\xFF\xD8\xFF") ? "image/jpeg" : "";
}

class GlbWriter {
 public:
  GlbWriter(const Mesh& mesh, const ReadFile& read_map) : mesh_(mesh), read_map_(read_map) {}

  Result<MeshBytes> write();

 private:
  void add_primitive(std::optional<std::uint32_t> material, const std::vector<std::uint32_t>& triangles);
  void add_materials();
  Json material_json(const Material& material);
  std::optional<Json> base_texture(const Material& material);
  std::optional<std::size_t> image_of(const std::string& file);
  std::size_t add_view(const std::string& bytes, int target);
  std::size_t add_accessor(const std::string& bytes, int component, const char* type, std::size_t count, int target);
  void use_extension(const char* name);

  template <class T, class Append>
  std::string gathered(const std::vector<T>& values, const std::vector<std::uint32_t>& order, const Append& append) const {
    std::string bytes;
    for (const std::uint32_t v : order) {
      append(bytes, values[v]);
    }
    return bytes;
  }

  const Mesh& mesh_;
  const ReadFile& read_map_;
  Json json_;
  std::string binary_;
  std::map<std::string, std::optional<std::size_t>> images_;  // by file, once each
  std::size_t other_maps_ = 0, missing_maps_ = 0, textures_ = 0;
};

std::size_t GlbWriter::add_view(const std::string& bytes, int target) {
  binary_.resize((binary_.size() + 3) / 4 * 4, '\0');
  Json view{{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}};
  if (target != 0) {
    view["target"] = target;
  }
  binary_ += bytes;
  json_["bufferViews"].push_back(std::move(view));
  return json_["bufferViews"].size() - 1;
}

std::size_t GlbWriter::add_accessor(const std::string& bytes, int component, const char* type, std::size_t count, int target) {
  const std::size_t view = add_view(bytes, target);
  json_["accessors"].push_back({{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
  return json_["accessors"].size() - 1;
}

void GlbWriter::use_extension(const char* name) {
  Json& used = json_["extensionsUsed"];
  if (std::find(used.begin(), used.end(), name) == used.end()) {
    used.push_back(name);
  }
}

/// The triangles of one material, with the vertices that they use: all in their order where there is one primitive only.
void GlbWriter::add_primitive(std::optional<std::uint32_t> material, const std::vector<std::uint32_t>& triangles) {
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> number(mesh_.positions.size(), SourceMesh::kNone);
  const bool has_all = triangles.size() == mesh_.triangles.size();
  for (std::uint32_t v = 0; has_all && v < mesh_.positions.size(); ++v) {
    number[v] = v;
    order.push_back(v);
  }
  std::string indices;
  for (const std::uint32_t t : triangles) {
    for (const std::uint32_t v : mesh_.triangles[t]) {
      if (number[v] == SourceMesh::kNone) {
        number[v] = static_cast<std::uint32_t>(order.size());
        order.push_back(v);
      }
      append_u32(indices, number[v]);
    }
  }
  const auto append_vector = [](std::string& bytes, const auto& value) { append_f32(bytes, value); };
  Json attributes;
  const std::size_t positions = add_accessor(gathered(mesh_.positions, order, append_vector), kFloat, "VEC3", order.size(), kArrayBuffer);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Vec3f low{kInfinity, kInfinity, kInfinity}, high{-kInfinity, -kInfinity, -kInfinity};
  for (const std::uint32_t v : order) {
    const Vec3f& p = mesh_.positions[v];
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  json_["accessors"][positions]["min"] = numbers(low);
  json_["accessors"][positions]["max"] = numbers(high);
  attributes["POSITION"] = positions;
  const auto add = [&](const char* name, const auto& values, const char* type, const auto& append) {
    if (!values.empty()) {
      attributes[name] = add_accessor(gathered(values, order, append), kFloat, type, order.size(), kArrayBuffer);
    }
  };
  add("NORMAL", mesh_.normals, "VEC3", append_vector);
  add("TANGENT", mesh_.tangents, "VEC4", [](std::string& bytes, const std::array<float, 4>& t) {
    for (const float x : t) {
      append_f32(bytes, x);
    }
  });
  add("TEXCOORD_0", mesh_.uvs, "VEC2", append_vector);
  add("TEXCOORD_1", mesh_.uvs1, "VEC2", append_vector);
  if (!mesh_.colors.empty() || !mesh_.alphas.empty()) {
    std::string colors;
    for (const std::uint32_t v : order) {
      append_f32(colors, mesh_.colors.empty() ? Vec3f{1, 1, 1} : linear({mesh_.colors[v], ColorSpace::encoded}));
      if (!mesh_.alphas.empty()) {
        append_f32(colors, clamped(mesh_.alphas[v]));
      }
    }
    attributes["COLOR_0"] = add_accessor(colors, kFloat, mesh_.alphas.empty() ? "VEC3" : "VEC4", order.size(), kArrayBuffer);
  }
  Json primitive{{"attributes", std::move(attributes)},
                 {"indices", add_accessor(indices, kUnsignedInt, "SCALAR", 3 * triangles.size(), kElementBuffer)}};
  if (material) {
    primitive["material"] = *material;
  }
  json_["meshes"][0]["primitives"].push_back(std::move(primitive));
}

std::optional<std::size_t> GlbWriter::image_of(const std::string& file) {
  const auto [known, is_new] = images_.try_emplace(file);
  if (!is_new) {
    return known->second;
  }
  const std::string bytes = read_map_(file);
  const std::string_view type = mime_type(bytes);
  if (!type.empty()) {
    const std::size_t view = add_view(bytes, 0);
    json_["images"].push_back({{"bufferView", view}, {"mimeType", type}});
    known->second = json_["images"].size() - 1;
  }
  return known->second;
}

/// The diffuse map with its place on the surface: MTL's v goes up, glTF's down.
std::optional<Json> GlbWriter::base_texture(const Material& material) {
  std::optional<Json> texture;
  for (const TextureMap& map : material.maps) {
    if (map.statement != "map_Kd" || texture) {
      ++other_maps_;
      continue;
    }
    const std::optional<std::size_t> image = image_of(map.file);
    if (!image) {
      ++missing_maps_;
      continue;
    }
    Json use{{"source", *image}};
    if (map.clamp) {
      json_["samplers"].push_back({{"wrapS", kClampToEdge}, {"wrapT", kClampToEdge}});
      use["sampler"] = json_["samplers"].size() - 1;
    }
    json_["textures"].push_back(std::move(use));
    use_extension("KHR_texture_transform");
    texture = Json{
        {"index", json_["textures"].size() - 1},
        {"extensions", {{"KHR_texture_transform", {{"offset", {map.offset.x, 1 - map.offset.y}}, {"scale", {map.scale.x, -map.scale.y}}}}}}};
  }
  return texture;
}

Json GlbWriter::material_json(const Material& material) {
  const Vec3f base = linear(material.diffuse);
  const bool is_glossy = material.specular.rgb != Vec3f{};
  const bool is_of_h = material.lighting == Lighting::blinn_phong || material.lighting == Lighting::ggx;
  const float exponent = is_of_h ? material.shininess : 4 * material.shininess;
  const float roughness = is_glossy ? std::sqrt(std::sqrt(2 / (exponent + 2))) : 1.0F;
  Json surface{{"baseColorFactor", {clamped(base.x), clamped(base.y), clamped(base.z), clamped(material.opacity)}},
               {"metallicFactor", 0},
               {"roughnessFactor", roughness}};
  if (std::optional<Json> texture = base_texture(material)) {
    surface["baseColorTexture"] = *std::move(texture);
  }
  textures_ += material.maps.empty() && material.textures != MaterialTextures{} ? 1U : 0U;
  Json json{{"name", material.name}, {"pbrMetallicRoughness", std::move(surface)}, {"doubleSided", material.cull != Culling::back}};
  const Vec3f emission = linear(material.emission);
  const float strength = std::max({emission.x, emission.y, emission.z, 1.0F});
  if (emission != Vec3f{}) {
    json["emissiveFactor"] = {clamped(emission.x / strength), clamped(emission.y / strength), clamped(emission.z / strength)};
  }
  if (strength > 1) {
    json["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", strength}};
    use_extension("KHR_materials_emissive_strength");
  }
  if (material.lighting == Lighting::constant) {
    json["extensions"]["KHR_materials_unlit"] = Json::object();
    use_extension("KHR_materials_unlit");
  }
  if (material.opacity < 1 || !mesh_.alphas.empty()) {
    json["alphaMode"] = "BLEND";
  }
  return json;
}

void GlbWriter::add_materials() {
  Json materials = Json::array();  // beside json_, to which a material may add keys
  for (const Material& material : mesh_.materials) {
    materials.push_back(material_json(material));
  }
  if (mesh_.materials.empty()) {  // glTF's own default is a metal that hides its backs
    materials.push_back(material_json(Material{}));
  }
  json_["materials"] = std::move(materials);
}

Result<MeshBytes> GlbWriter::write() {
  json_["asset"] = {{"version", "2.0"}, {"generator", "Lustro"}};
  json_["scene"] = 0;
  if (mesh_.triangles.empty()) {  // a mesh without primitives is none
    json_["scenes"].push_back(Json::object());
  } else {
    json_["scenes"].push_back({{"nodes", Json::array({0})}});
    json_["nodes"].push_back({{"mesh", 0}});
    const std::size_t count = std::max<std::size_t>(mesh_.materials.size(), 1);
    std::vector<std::vector<std::uint32_t>> triangles(count);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      triangles[mesh_.triangle_material.empty() ? 0 : mesh_.triangle_material[t]].push_back(t);
    }
    for (std::uint32_t material = 0; material < count; ++material) {
      if (!triangles[material].empty()) {
        add_primitive(material, triangles[material]);
      }
    }
    add_materials();
  }
  binary_.resize((binary_.size() + 3) / 4 * 4, '\0');
  if (!binary_.empty()) {
    json_["buffers"].push_back({{"byteLength", binary_.size()}});
  }
  std::string text = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::uint64_t size = 12 + 8 + text.size() + (binary_.empty() ? 0 : 8 + binary_.size());
  if (size > 0xFFFFFFFFU) {
    return fail(ErrorKind::limit, "", fmt::format("{} bytes, and GLB counts to {}", size, 0xFFFFFFFFU));
  }
  MeshBytes glb{"glTF", {}};
  append_u32(glb.bytes, 2);
  append_u32(glb.bytes, static_cast<std::uint32_t>(size));
  append_u32(glb.bytes, static_cast<std::uint32_t>(text.size()));
  append_u32(glb.bytes, kJsonChunk);
  glb.bytes += text;
  if (!binary_.empty()) {
    append_u32(glb.bytes, static_cast<std::uint32_t>(binary_.size()));
    append_u32(glb.bytes, kBinaryChunk);
    glb.bytes += binary_;
  }
  if (has_materials(mesh_)) {
    glb.notes.push_back(
        {"", "glTF has no classic materials: diffuse is the base colour, the exponent a roughness; ambient and specular are left out"});
  }
  const auto say = [&glb](std::size_t times, const char* what) {
    if (times != 0) {
      glb.notes.push_back({"", fmt::format("{} {}", times, what)});
    }
  };
  say(other_maps_, "maps are no diffuse ones and are left out");
  say(missing_maps_, "diffuse maps are no PNG or JPEG files that can be read, and are left out");
  say(textures_, "materials have textures that came with no file of their own: they are left out");
  return glb;
}

}  // namespace

Result<MeshBytes> glb_bytes(const Mesh& mesh, const ReadFile& read_map) {
  return GlbWriter(mesh, read_map).write();
}

}  // namespace lustro
