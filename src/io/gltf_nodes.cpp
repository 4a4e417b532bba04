// `cameras`, lights, `skins`, `nodes`, `scenes` and `animations`: what stands where, and that the nodes are trees.
#include <fmt/format.h>

#include <algorithm>

#include "io/gltf_document.hpp"
#include "math/trig.hpp"

namespace lustro {
namespace {

using Json = nlohmann::json;

constexpr NumberRange kNotNegative{.lower = 0};
constexpr NumberRange kPositive{.lower = 1.1754943508222875e-38};

void read_cameras(GltfReader& reader, const Json& root, GltfDocument& document) {
  for (const Json& json : reader.tables(root, "cameras")) {
    GltfCamera camera;
    camera.name = reader.text(json, "name");
    const std::string type = reader.text(json, "type");
    if (type != "perspective" && type != "orthographic") {
      reader.fail(json, "type", "is neither perspective nor orthographic");
      return;
    }
    camera.is_perspective = type == "perspective";
    if (GltfReader::find(json, type) == nullptr) {
      reader.fail(json, type, "is missing, expected a table {...}");
    }
    const Json& lens = reader.table(json, type);
    if (reader.failed()) {
      return;
    }
    if (camera.is_perspective) {
      camera.yfov = reader.needed_number(lens, "yfov", {1e-6, 3.14159});
      static_cast<void>(reader.number(lens, "aspectRatio", kPositive, 1));
    } else {
      camera.ymag = std::abs(reader.needed_number(lens, "ymag", {}));
      static_cast<void>(reader.needed_number(lens, "xmag", {}));
      if (camera.ymag == 0) {
        reader.fail(lens, "ymag", "is 0");
      }
    }
    camera.znear = reader.needed_number(lens, "znear", camera.is_perspective ? kPositive : kNotNegative);
    if (!camera.is_perspective || GltfReader::find(lens, "zfar") != nullptr) {
      camera.zfar = reader.needed_number(lens, "zfar", kPositive);
      if (!(*camera.zfar > camera.znear)) {
        reader.fail(lens, "zfar", fmt::format("{} is not more than znear, {}", *camera.zfar, camera.znear));
      }
    }
    document.cameras.push_back(camera);
  }
}

void read_lights(GltfReader& reader, const Json& root, GltfDocument& document) {
  const Json* extension = reader.extension(root, "KHR_lights_punctual");
  if (extension == nullptr) {
    return;
  }
  for (const Json& json : reader.tables(*extension, "lights")) {
    GltfLight light;
    light.name = reader.text(json, "name");
    light.color = reader.numbers<3>(json, "color", {1, 1, 1}, kNotNegative);
    light.intensity = reader.number(json, "intensity", kNotNegative, 1);
    const std::string type = reader.text(json, "type");
    if (type != "directional" && type != "point" && type != "spot") {
      reader.fail(json, "type", "is none of directional, point, spot");
      return;
    }
    light.kind = type == "directional" ? GltfLight::Kind::directional : type == "point" ? GltfLight::Kind::point : GltfLight::Kind::spot;
    if (GltfReader::find(json, "range") != nullptr) {
      light.range = reader.number(json, "range", kPositive, 1);
    }
    if (light.kind == GltfLight::Kind::spot) {
      const Json& spot = reader.table(json, "spot");
      light.inner = reader.number(spot, "innerConeAngle", {0, kPi / 2}, 0);
      light.outer = reader.number(spot, "outerConeAngle", {0, kPi / 2 + 1e-6}, kPi / 4);
      if (!(light.inner < light.outer)) {
        reader.fail(json, "spot", fmt::format("its innerConeAngle {} is not less than its outerConeAngle {}", light.inner, light.outer));
      }
    }
    document.lights.push_back(light);
  }
}

std::vector<std::uint32_t> read_indices(GltfReader& reader, const Json& parent, std::string_view key, std::size_t count, std::string_view what) {
  std::vector<std::uint32_t> indices;
  for (const Json& value : reader.list(parent, key)) {
    indices.push_back(reader.index_of(value, count, what));
  }
  return indices;
}

void check_accessor(GltfReader& reader, const Json& parent, std::string_view key, const GltfDocument& document, std::uint32_t index,
                    GltfType type, bool may_be_integer) {
  if (index == kGltfNone || reader.failed()) {
    return;
  }
  const GltfAccessor& accessor = document.accessors[index];
  const bool is_good = accessor.type == type && (accessor.component == GltfComponent::float32 || (may_be_integer && accessor.is_normalized));
  if (!is_good) {
    reader.fail(parent, key,
                fmt::format("accessors[{}] is {} of {}, expected {} of FLOAT{}", index, name_of(accessor.type), name_of(accessor.component),
                            name_of(type), may_be_integer ? " or normalized integers" : ""));
  }
}

void read_skins(GltfReader& reader, const Json& root, GltfDocument& document, std::size_t nodes) {
  for (const Json& json : reader.tables(root, "skins")) {
    GltfSkin skin;
    skin.joints = read_indices(reader, json, "joints", nodes, "nodes");
    if (skin.joints.empty()) {
      reader.fail(json, "joints", "is missing or empty, expected at least one node");
    }
    static_cast<void>(reader.index(json, "skeleton", nodes, "nodes"));
    skin.inverse_bind = reader.index(json, "inverseBindMatrices", document.accessors.size(), "accessors");
    check_accessor(reader, json, "inverseBindMatrices", document, skin.inverse_bind, GltfType::mat4, false);
    if (skin.inverse_bind != kGltfNone && !reader.failed() && document.accessors[skin.inverse_bind].count < skin.joints.size()) {
      reader.fail(json, "inverseBindMatrices",
                  fmt::format("accessors[{}] has {} matrices for {} joints", skin.inverse_bind, document.accessors[skin.inverse_bind].count,
                              skin.joints.size()));
    }
    document.skins.push_back(std::move(skin));
  }
}

void read_instances(GltfReader& reader, const Json& json, const GltfDocument& document, GltfNode& node) {
  const Json* extension = reader.extension(json, "EXT_mesh_gpu_instancing");
  if (extension == nullptr) {
    return;
  }
  const Json& attributes = reader.table(*extension, "attributes");
  constexpr std::array kKeys{"TRANSLATION", "ROTATION", "SCALE"};
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < kKeys.size(); ++i) {
    node.instances[i] = reader.index(attributes, kKeys[i], document.accessors.size(), "accessors");
    check_accessor(reader, attributes, kKeys[i], document, node.instances[i], i == 1 ? GltfType::vec4 : GltfType::vec3, i == 1);
    if (node.instances[i] == kGltfNone || reader.failed()) {
      continue;
    }
    const std::uint64_t own = document.accessors[node.instances[i]].count;
    if (count != 0 && own != count) {
      reader.fail(attributes, kKeys[i], fmt::format("accessors[{}] has {} elements, and another of them {}", node.instances[i], own, count));
    }
    count = own;
    node.is_instanced = true;
  }
}

GltfNode read_node(GltfReader& reader, const Json& json, const GltfDocument& document, std::size_t nodes) {
  GltfNode node;
  node.name = reader.text(json, "name");
  node.children = read_indices(reader, json, "children", nodes, "nodes");
  node.mesh = reader.index(json, "mesh", document.meshes.size(), "meshes");
  node.skin = reader.index(json, "skin", document.skins.size(), "skins");
  node.camera = reader.index(json, "camera", document.cameras.size(), "cameras");
  if (const Json* light = reader.extension(json, "KHR_lights_punctual")) {
    node.light = reader.needed_index(*light, "light", document.lights.size(), "lights");
  }
  node.translation = reader.numbers<3>(json, "translation", {0, 0, 0});
  node.rotation = reader.numbers<4>(json, "rotation", {0, 0, 0, 1}, {-1.001, 1.001});
  node.scale = reader.numbers<3>(json, "scale", {1, 1, 1});
  if (const Json* matrix = GltfReader::find(json, "matrix")) {
    const auto m = reader.numbers<16>(json, "matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    Mat4 by_rows;
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) {
        by_rows(row, column) = m[static_cast<std::size_t>(4 * column + row)];
      }
    }
    if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) {
      reader.fail(*matrix, fmt::format("its last row is {}, {}, {}, {}, expected 0, 0, 0, 1 (a matrix of columns)", m[3], m[7], m[11], m[15]));
    }
    for (const char* key : {"translation", "rotation", "scale"}) {
      if (GltfReader::find(json, key) != nullptr) {
        reader.fail(json, key, "is stated beside a matrix");
      }
    }
    node.matrix = by_rows;
  }
  const double length2 = ((node.rotation[0] * node.rotation[0] + node.rotation[1] * node.rotation[1]) + node.rotation[2] * node.rotation[2]) +
                         node.rotation[3] * node.rotation[3];
  if (!(length2 > 1e-6)) {
    reader.fail(json, "rotation", "is the quaternion 0, which turns nothing");
  }
  const Json& weights = reader.list(json, "weights");
  for (const Json& weight : weights) {
    if (!weight.is_number()) {
      reader.fail(weight, "is no number");
      break;
    }
    node.weights.push_back(weight.get<double>());
  }
  read_instances(reader, json, document, node);
  if (reader.failed() || node.mesh == kGltfNone) {
    return node;
  }
  const GltfMesh& mesh = document.meshes[node.mesh];
  if (!weights.empty() && weights.size() != mesh.primitives.front().targets.size()) {
    reader.fail(weights, fmt::format("is a list of {}, and meshes[{}] has {} targets", weights.size(), node.mesh,
                                     mesh.primitives.front().targets.size()));
  }
  return node;
}

/// Every node has at most one parent, and none is its own ancestor. Fills parents and order.
void check_trees(GltfReader& reader, const Json& nodes, GltfDocument& document) {
  const std::size_t count = document.nodes.size();
  document.parents.assign(count, kGltfNone);
  const auto child_at = [&](std::uint32_t parent, std::uint32_t child) -> const Json& {
    const std::vector<std::uint32_t>& children = document.nodes[parent].children;
    const auto k = static_cast<std::size_t>(std::find(children.begin(), children.end(), child) - children.begin());
    return nodes[parent]["children"][k];
  };
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::vector<std::uint32_t>& children = document.nodes[i].children;
    for (std::size_t k = 0; k < children.size(); ++k) {
      if (const std::uint32_t other = document.parents[children[k]]; other != kGltfNone) {
        reader.fail(nodes[i]["children"][k], fmt::format("node {} is a child of nodes[{}] already", children[k], other));
        return;
      }
      document.parents[children[k]] = i;
    }
  }
  document.order.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (document.parents[i] == kGltfNone) {
      document.order.push_back(i);
    }
  }
  for (std::size_t next = 0; next < document.order.size(); ++next) {
    const std::vector<std::uint32_t>& children = document.nodes[document.order[next]].children;
    document.order.insert(document.order.end(), children.begin(), children.end());
  }
  if (document.order.size() == count) {
    return;
  }
  std::vector<bool> is_reached(count);
  for (const std::uint32_t i : document.order) {
    is_reached[i] = true;
  }
  auto lost = static_cast<std::uint32_t>(std::find(is_reached.begin(), is_reached.end(), false) - is_reached.begin());
  for (std::size_t step = 0; step < count; ++step) {
    lost = document.parents[lost];  // now on the ring for sure
  }
  const std::uint32_t parent = document.parents[lost];
  reader.fail(child_at(parent, lost), fmt::format("node {} is its own ancestor", lost));
}

void read_scenes(GltfReader& reader, const Json& root, GltfDocument& document) {
  const Json& scenes = reader.tables(root, "scenes");
  const std::uint32_t stated = reader.index(root, "scene", scenes.size(), "scenes");
  std::vector<std::vector<std::uint32_t>> all;
  for (const Json& scene : scenes) {
    all.push_back(read_indices(reader, scene, "nodes", document.nodes.size(), "nodes"));
    if (reader.failed()) {
      return;
    }
    std::vector<bool> is_seen(document.nodes.size());
    for (std::size_t k = 0; k < all.back().size(); ++k) {
      const std::uint32_t node = all.back()[k];
      if (is_seen[node] || document.parents[node] != kGltfNone) {
        reader.fail(scene["nodes"][k], is_seen[node] ? fmt::format("node {} is listed twice", node)
                                                     : fmt::format("node {} is no root: nodes[{}] is its parent", node, document.parents[node]));
      }
      is_seen[node] = true;
    }
  }
  if (reader.failed()) {
    return;
  }
  if (!all.empty()) {
    document.roots = std::move(all[stated == kGltfNone ? 0 : stated]);
    return;
  }
  for (std::uint32_t i = 0; i < document.nodes.size(); ++i) {  // a library of things: all of them
    if (document.parents[i] == kGltfNone) {
      document.roots.push_back(i);
    }
  }
}

GltfChannel read_channel(GltfReader& reader, const Json& json, const Json& samplers, const GltfDocument& document) {
  using Path = GltfChannel::Path;
  GltfChannel channel;
  channel.sampler = reader.needed_index(json, "sampler", samplers.size(), "samplers");
  if (GltfReader::find(json, "target") == nullptr) {
    reader.fail(json, "target", "is missing, expected a table {...}");
  }
  const Json& target = reader.table(json, "target");
  channel.node = reader.index(target, "node", document.nodes.size(), "nodes");
  const std::string path = reader.text(target, "path");
  if (reader.failed()) {
    return channel;
  }
  if (path != "translation" && path != "rotation" && path != "scale" && path != "weights") {
    if (channel.node != kGltfNone) {
      reader.fail(target, "path", "is none of translation, rotation, scale, weights");
    }
    return channel;
  }
  channel.path = path == "translation" ? Path::translation : path == "rotation" ? Path::rotation : path == "scale" ? Path::scale : Path::weights;
  const Json& sampler = samplers[channel.sampler];
  channel.input = reader.needed_index(sampler, "input", document.accessors.size(), "accessors");
  channel.output = reader.needed_index(sampler, "output", document.accessors.size(), "accessors");
  check_accessor(reader, sampler, "input", document, channel.input, GltfType::scalar, false);
  const GltfType type = path == "rotation" ? GltfType::vec4 : path == "weights" ? GltfType::scalar : GltfType::vec3;
  check_accessor(reader, sampler, "output", document, channel.output, type, path == "rotation" || path == "weights");
  const std::string interpolation = reader.text(sampler, "interpolation");
  if (!interpolation.empty() && interpolation != "LINEAR" && interpolation != "STEP" && interpolation != "CUBICSPLINE") {
    reader.fail(sampler, "interpolation", "is none of LINEAR, STEP, CUBICSPLINE");
  }
  channel.interpolation = interpolation == "STEP"          ? GltfChannel::Interpolation::step
                          : interpolation == "CUBICSPLINE" ? GltfChannel::Interpolation::cubic
                                                           : GltfChannel::Interpolation::linear;
  if (reader.failed() || channel.node == kGltfNone) {
    return channel;
  }
  const GltfNode& node = document.nodes[channel.node];
  std::uint64_t per_key = channel.interpolation == GltfChannel::Interpolation::cubic ? 3 : 1;
  if (channel.path == Path::weights) {
    const std::size_t targets = node.mesh == kGltfNone ? 0 : document.meshes[node.mesh].primitives.front().targets.size();
    if (targets == 0) {
      reader.fail(target, "node", fmt::format("nodes[{}] has no mesh with targets", channel.node));
      return channel;
    }
    per_key *= targets;
  } else if (node.matrix) {
    reader.fail(target, "node", fmt::format("nodes[{}] has a matrix, which cannot be animated", channel.node));
    return channel;
  }
  const std::uint64_t keys = document.accessors[channel.input].count;
  if (document.accessors[channel.output].count != keys * per_key) {
    reader.fail(sampler, "output",
                fmt::format("accessors[{}] has {} elements, expected {} for {} keys", channel.output, document.accessors[channel.output].count,
                            keys * per_key, keys));
  }
  return channel;
}

void read_animations(GltfReader& reader, const Json& root, GltfDocument& document) {
  for (const Json& json : reader.tables(root, "animations")) {
    GltfAnimation animation;
    animation.name = reader.text(json, "name");
    const Json& samplers = reader.tables(json, "samplers");
    for (const Json& channel : reader.tables(json, "channels")) {
      animation.channels.push_back(read_channel(reader, channel, samplers, document));
      if (reader.failed()) {
        return;
      }
    }
    std::erase_if(animation.channels, [](const GltfChannel& channel) { return channel.node == kGltfNone; });
    document.animations.push_back(std::move(animation));
  }
}

}  // namespace

void read_gltf_nodes(GltfReader& reader, const Json& root, GltfDocument& document) {
  const Json& nodes = reader.tables(root, "nodes");
  read_cameras(reader, root, document);
  read_lights(reader, root, document);
  read_skins(reader, root, document, nodes.size());
  if (reader.failed()) {
    return;
  }
  for (const Json& json : nodes) {
    document.nodes.push_back(read_node(reader, json, document, nodes.size()));
    if (reader.failed()) {
      return;
    }
  }
  check_trees(reader, nodes, document);
  if (!reader.failed()) {
    read_scenes(reader, root, document);
  }
  if (!reader.failed()) {
    read_animations(reader, root, document);
  }
}

}  // namespace lustro
