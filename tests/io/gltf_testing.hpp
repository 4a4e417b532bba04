// Small glTF documents for tests: numbers become bytes of one buffer, and the buffer a data URI.
#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "io/gltf_scene.hpp"
#include "io_testing.hpp"

namespace lustro {

inline std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? kDigits[bits >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

/// A document in the making. Every add_ returns the index.
struct GltfMaker {
  using Json = nlohmann::json;
  Json json{{"asset", {{"version", "2.0"}}}};
  std::string bytes;

  std::size_t add(const char* list, Json value) {
    json[list].push_back(std::move(value));
    return json[list].size() - 1;
  }

  template <class T>
  std::size_t add_view(const std::vector<T>& values, int stride = 0) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    Json view{{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", values.size() * sizeof(T)}};
    if (stride != 0) {
      view["byteStride"] = stride;
    }
    const std::size_t begin = bytes.size();
    bytes.resize(begin + values.size() * sizeof(T));
    std::memcpy(bytes.data() + begin, values.data(), values.size() * sizeof(T));
    return add("bufferViews", view);
  }

  template <class T>
  static int component() {
    return std::is_same_v<T, float>           ? 5126
           : std::is_same_v<T, std::uint32_t> ? 5125
           : std::is_same_v<T, std::uint16_t> ? 5123
           : std::is_same_v<T, std::int16_t>  ? 5122
           : std::is_same_v<T, std::uint8_t>  ? 5121
                                              : 5120;
  }

  static std::size_t parts_of(const std::string& type) {
    return type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
  }

  template <class T>
  std::size_t add_accessor(const std::string& type, const std::vector<T>& values, bool normalized = false) {
    Json accessor{
        {"bufferView", add_view(values)}, {"componentType", component<T>()}, {"count", values.size() / parts_of(type)}, {"type", type}};
    if (normalized) {
      accessor["normalized"] = true;
    }
    return add("accessors", accessor);
  }

  /// A mesh of one primitive and a node that shows it.
  std::size_t add_node_with(Json primitive, Json node = Json::object()) {
    node["mesh"] = add("meshes", {{"primitives", Json::array({std::move(primitive)})}});
    return add("nodes", std::move(node));
  }

  [[nodiscard]] std::string text() const {
    Json whole = json;
    if (!bytes.empty()) {
      whole["buffers"] = Json::array({{{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}}});
    }
    return whole.dump();
  }

  [[nodiscard]] Result<GltfModel> model(const LoadOptions& options = {}) const { return parse_gltf(text(), "t.gltf", {}, options); }

  /// All that it draws in one mesh.
  [[nodiscard]] Result<SourceMesh> mesh(const LoadOptions& options = {}) const {
    Result<GltfModel> made = model(options);
    return made ? gltf_whole_mesh(*made) : tl::unexpected(made.error());
  }

  /// A triangle (0,0,0) (1,0,0) (0,1,0) without normals.
  [[nodiscard]] Json triangle() { return {{"attributes", {{"POSITION", add_accessor<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})}}}}; }
};

}  // namespace lustro
