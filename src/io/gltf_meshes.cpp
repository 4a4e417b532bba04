// `meshes`: which accessors a primitive has, and that they fit together and are of the types that their attribute may have.
#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

#include "io/gltf_document.hpp"

namespace lustro {
namespace {

using Json = nlohmann::json;
using Component = GltfComponent;

/// What an attribute's accessor may be made of. A star behind the component in the specification's table: normalised.
struct Kind {
  Component component;
  bool is_normalized;
};

constexpr Kind kFloat{Component::float32, false};
constexpr Kind kUint8{Component::uint8, false};
constexpr Kind kUint8Norm{Component::uint8, true};
constexpr Kind kUint16{Component::uint16, false};
constexpr Kind kUint16Norm{Component::uint16, true};
constexpr Kind kInt8{Component::int8, false};
constexpr Kind kInt8Norm{Component::int8, true};
constexpr Kind kInt16{Component::int16, false};
constexpr Kind kInt16Norm{Component::int16, true};

/// Types, and kinds by the specification (3.7.2.1) and by KHR_mesh_quantization.
struct Allowed {
  std::initializer_list<GltfType> types;
  std::initializer_list<Kind> kinds;
  std::initializer_list<Kind> quantized;
};

const Allowed kPositions{{GltfType::vec3}, {kFloat}, {kInt8, kInt8Norm, kUint8, kUint8Norm, kInt16, kInt16Norm, kUint16, kUint16Norm}};
const Allowed kNormals{{GltfType::vec3}, {kFloat}, {kInt8Norm, kInt16Norm}};
const Allowed kTangents{{GltfType::vec4}, {kFloat}, {kInt8Norm, kInt16Norm}};
const Allowed kUvs{{GltfType::vec2}, {kFloat, kUint8Norm, kUint16Norm}, {kInt8, kInt8Norm, kUint8, kInt16, kInt16Norm, kUint16}};
const Allowed kColors{{GltfType::vec3, GltfType::vec4}, {kFloat, kUint8Norm, kUint16Norm}, {}};
const Allowed kJoints{{GltfType::vec4}, {kUint8, kUint16}, {}};
const Allowed kWeights{{GltfType::vec4}, {kFloat, kUint8Norm, kUint16Norm}, {}};
const Allowed kIndices{{GltfType::scalar}, {kUint8, kUint16, {Component::uint32, false}}, {}};
const Allowed kTargetTangents{{GltfType::vec3}, {kFloat}, {kInt8Norm, kInt16Norm}};

std::string described(const GltfAccessor& accessor) {
  return fmt::format("{} of {}{}", name_of(accessor.type), name_of(accessor.component), accessor.is_normalized ? ", normalized" : "");
}

bool has_kind(std::initializer_list<Kind> kinds, const GltfAccessor& accessor) {
  return std::any_of(kinds.begin(), kinds.end(),
                     [&](const Kind& kind) { return kind.component == accessor.component && kind.is_normalized == accessor.is_normalized; });
}

class MeshReader {
 public:
  MeshReader(GltfReader& reader, GltfDocument& document) : reader_(reader), document_(document) {}

  GltfMesh read(const Json& json) {
    GltfMesh mesh;
    mesh.name = reader_.text(json, "name");
    const Json& primitives = reader_.tables(json, "primitives");
    if (primitives.empty()) {
      reader_.fail(json, "primitives", "is missing or empty, expected at least one");
    }
    for (const Json& primitive : primitives) {
      if (reader_.failed()) {
        return mesh;
      }
      mesh.primitives.push_back(read_primitive(primitive));
      if (mesh.primitives.back().targets.size() != mesh.primitives.front().targets.size()) {
        reader_.fail(primitive, "targets", "differ in number from those of the mesh's first primitive");
      }
    }
    const Json& weights = reader_.list(json, "weights");
    for (const Json& weight : weights) {
      mesh.weights.push_back(weight.is_number() ? weight.get<double>() : 0);
      if (!weight.is_number()) {
        reader_.fail(weight, "is no number");
      }
    }
    if (!reader_.failed() && !weights.empty() && weights.size() != mesh.primitives.front().targets.size()) {
      reader_.fail(weights, fmt::format("is a list of {}, and there are {} targets", weights.size(), mesh.primitives.front().targets.size()));
    }
    return mesh;
  }

 private:
  /// The accessor that an attribute names, of one of the kinds that it may have, with as many elements as `count` unless that is 0.
  std::uint32_t accessor(const Json& attributes, const std::string& key, const Allowed& allowed, std::uint64_t count) {
    const std::uint32_t index = reader_.index(attributes, key, document_.accessors.size(), "accessors");
    if (index == kGltfNone || reader_.failed()) {
      return index;
    }
    const GltfAccessor& accessor = document_.accessors[index];
    const bool has_type = std::find(allowed.types.begin(), allowed.types.end(), accessor.type) != allowed.types.end();
    const bool is_plain = has_kind(allowed.kinds, accessor);
    const bool is_quantized = has_kind(allowed.quantized, accessor);
    if (!has_type || !(is_plain || (is_quantized && document_.has_quantization))) {
      std::string expected;
      for (const GltfType type : allowed.types) {
        expected += fmt::format("{}{}", expected.empty() ? "" : " or ", name_of(type));
      }
      std::string kinds;
      for (const Kind& kind : allowed.kinds) {
        kinds += fmt::format("{}{}{}", kinds.empty() ? "" : " or ", name_of(kind.component), kind.is_normalized ? " normalized" : "");
      }
      reader_.fail(attributes, key,
                   fmt::format("accessors[{}] is {}, expected {} of {}{}", index, described(accessor), expected, kinds,
                               has_type && is_quantized ? ", or KHR_mesh_quantization among extensionsUsed" : ""));
    } else if (count != 0 && accessor.count != count) {
      reader_.fail(attributes, key, fmt::format("accessors[{}] has {} elements, and POSITION has {}", index, accessor.count, count));
    }
    return index;
  }

  GltfAttributes read_attributes(const Json& json, bool is_target, std::uint64_t count) {
    GltfAttributes attributes;
    attributes.position = accessor(json, "POSITION", kPositions, count);
    if (attributes.position != kGltfNone && !reader_.failed() && count == 0) {
      count = document_.accessors[attributes.position].count;
    }
    attributes.normal = accessor(json, "NORMAL", kNormals, count);
    attributes.tangent = accessor(json, "TANGENT", is_target ? kTargetTangents : kTangents, count);
    if (!is_target) {
      attributes.uvs = {accessor(json, "TEXCOORD_0", kUvs, count), accessor(json, "TEXCOORD_1", kUvs, count)};
      attributes.color = accessor(json, "COLOR_0", kColors, count);
      for (std::size_t set = 0; GltfReader::find(json, fmt::format("JOINTS_{}", set)) != nullptr && !reader_.failed(); ++set) {
        attributes.joints.push_back(accessor(json, fmt::format("JOINTS_{}", set), kJoints, count));
        attributes.weights.push_back(accessor(json, fmt::format("WEIGHTS_{}", set), kWeights, count));
        if (attributes.weights.back() == kGltfNone) {
          reader_.fail(json, fmt::format("WEIGHTS_{}", set), "is missing beside its JOINTS");
        }
      }
    }
    for (const auto& [key, value] : json.items()) {  // others are checked, and not used
      static_cast<void>(reader_.index_of(value, document_.accessors.size(), "accessors"));
    }
    return attributes;
  }

  GltfDraco read_draco(const Json& draco, const Json& primitive) {
    GltfDraco packed;
    packed.view = reader_.needed_index(draco, "bufferView", document_.views.size(), "bufferViews");
    if (GltfReader::find(draco, "attributes") == nullptr) {
      reader_.fail(draco, "attributes", "is missing, expected a table {...}");
    }
    const Json& ids = reader_.table(draco, "attributes");
    const Json& attributes = reader_.table(primitive, "attributes");
    for (const auto& [key, value] : ids.items()) {
      const auto id = static_cast<std::uint32_t>(reader_.whole(ids, key, {0, 0xFFFFFFFFU}, 0));
      const std::uint32_t index = reader_.index(attributes, key, document_.accessors.size(), "accessors");
      if (index == kGltfNone) {
        reader_.fail(ids, key, "is no attribute of the primitive");
      }
      packed.attributes.push_back({key, index, id});
    }
    return packed;
  }

  void check_corners(const Json& json, const GltfPrimitive& primitive) {
    const bool has_indices = primitive.indices != kGltfNone;
    if (!has_indices && primitive.attributes.position == kGltfNone) {
      return;
    }
    const std::uint64_t corners = document_.accessors[has_indices ? primitive.indices : primitive.attributes.position].count;
    const std::string place = has_indices ? "indices" : "attributes";
    if (primitive.mode == GltfMode::triangles && corners % 3 != 0) {
      reader_.fail(json, place, fmt::format("{} corners are no whole number of triangles", corners));
    } else if ((primitive.mode == GltfMode::triangle_strip || primitive.mode == GltfMode::triangle_fan) && corners < 3) {
      reader_.fail(json, place, fmt::format("{} corners are no triangle", corners));
    }
  }

  GltfPrimitive read_primitive(const Json& json) {
    GltfPrimitive primitive;
    if (GltfReader::find(json, "attributes") == nullptr) {
      reader_.fail(json, "attributes", "is missing, expected a table {...}");
    }
    primitive.mode = static_cast<GltfMode>(reader_.whole(json, "mode", {0, 6}, 4));
    primitive.material = reader_.index(json, "material", document_.materials.size(), "materials");
    primitive.attributes = read_attributes(reader_.table(json, "attributes"), false, 0);
    primitive.indices = accessor(json, "indices", kIndices, 0);
    const std::uint64_t count =
        primitive.attributes.position != kGltfNone && !reader_.failed() ? document_.accessors[primitive.attributes.position].count : 0;
    for (const Json& target : reader_.tables(json, "targets")) {
      primitive.targets.push_back(read_attributes(target, true, count));
    }
    if (const Json* draco = reader_.extension(json, "KHR_draco_mesh_compression"); draco != nullptr && !reader_.failed()) {
      primitive.draco = read_draco(*draco, json);
    }
    if (!reader_.failed()) {
      check_corners(json, primitive);
    }
    return primitive;
  }

  GltfReader& reader_;
  GltfDocument& document_;
};

}  // namespace

void read_gltf_meshes(GltfReader& reader, const Json& root, GltfDocument& document) {
  MeshReader meshes(reader, document);
  for (const Json& json : reader.tables(root, "meshes")) {
    if (reader.failed()) {
      return;
    }
    document.meshes.push_back(meshes.read(json));
  }
}

}  // namespace lustro
