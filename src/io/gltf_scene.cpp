// See gltf_scene.hpp.
#include "io/gltf_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "io/gltf_accessor.hpp"
#include "io/gltf_mesh.hpp"
#include "math/trig.hpp"
#include "scene/nearest.hpp"

namespace lustro {
namespace {

constexpr std::size_t kMostObjects = std::size_t{1} << 20U;

/// What the scene draws, a node with a mesh at a place.
struct Place {
  std::uint32_t node = 0;
  Mat4 matrix;
};

/// The nodes of the default scene, parents before their children, in the order of the file's lists.
std::vector<std::uint32_t> scene_nodes(const GltfDocument& document) {
  std::vector<std::uint32_t> nodes;
  std::vector<std::uint32_t> open(document.roots.rbegin(), document.roots.rend());
  while (!open.empty()) {
    const std::uint32_t node = open.back();
    open.pop_back();
    nodes.push_back(node);
    const std::vector<std::uint32_t>& children = document.nodes[node].children;
    open.insert(open.end(), children.rbegin(), children.rend());
  }
  return nodes;
}

/// EXT_mesh_gpu_instancing: the node's own place times each instance's.
Result<void> add_instances(GltfModel& model, std::uint32_t index, std::vector<Place>& places) {
  const GltfNode& node = model.file.document.nodes[index];
  std::array<std::vector<float>, 3> parts;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (node.instances[i] == kGltfNone) {
      continue;
    }
    Result<std::vector<float>> values = read_floats(model.file, node.instances[i]);
    if (!values) {
      return tl::unexpected(values.error());
    }
    parts[i] = std::move(*values);
    count = parts[i].size() / (i == 1 ? 4 : 3);
  }
  if (places.size() + count > kMostObjects) {
    return model.file.fail_at(fmt::format("nodes[{}].extensions.EXT_mesh_gpu_instancing", index),
                              fmt::format("the scene has more than {} objects", kMostObjects), ErrorKind::limit);
  }
  for (std::size_t i = 0; i < count; ++i) {
    std::array<double, 3> translation{0, 0, 0};
    std::array<double, 4> rotation{0, 0, 0, 1};
    std::array<double, 3> scale{1, 1, 1};
    const auto take = [&](const std::vector<float>& from, auto& to) {
      for (std::size_t k = 0; k < to.size() && !from.empty(); ++k) {
        to[k] = static_cast<double>(from[to.size() * i + k]);
      }
    };
    take(parts[0], translation);
    take(parts[1], rotation);
    take(parts[2], scale);
    places.push_back({index, model.pose.world[index] * matrix_of(translation, rotation, scale)});
  }
  return {};
}

/// Whether an object can be drawn there: prepare() asks for a finite matrix that does not flatten it.
bool is_solid(const Mat4& m) {
  const Vec3d x{m(0, 0), m(0, 1), m(0, 2)};
  const Vec3d y{m(1, 0), m(1, 1), m(1, 2)};
  const Vec3d z{m(2, 0), m(2, 1), m(2, 2)};
  double largest = 0;
  for (const Vec3d& c : {cross(y, z), cross(z, x), cross(x, y)}) {
    largest = std::max({largest, std::abs(c.x), std::abs(c.y), std::abs(c.z)});
  }
  return dot(x, cross(y, z)) != 0 && std::isnormal(largest) &&
         std::all_of(m.m.begin(), m.m.end(), [](double value) { return std::isfinite(value); });
}

/// What of the places is not drawn: points and lines have no area, and there is nothing to see without positions.
void note_skipped(GltfDocument& document, const std::vector<Place>& places) {
  std::size_t points = 0;
  std::size_t lines = 0;
  std::size_t empty = 0;
  std::size_t tinted_metals = 0;
  for (const Place& place : places) {
    for (const GltfPrimitive& primitive : document.meshes[document.nodes[place.node].mesh].primitives) {
      const bool is_area = primitive.mode >= GltfMode::triangles;
      points += primitive.mode == GltfMode::points ? 1U : 0U;
      lines += !is_area && primitive.mode != GltfMode::points ? 1U : 0U;
      empty += is_area && primitive.attributes.position == kGltfNone ? 1U : 0U;
      tinted_metals += is_drawn(primitive) && primitive.attributes.color != kGltfNone && primitive.material != kGltfNone &&
                               document.materials[primitive.material].metallic > 0
                           ? 1U
                           : 0U;
    }
  }
  const auto note = [&](std::size_t count, const char* one, const char* many, const char* what) {
    if (count > 0) {
      document.notes.push_back({{}, fmt::format("{} {} {}", count, count == 1 ? one : many, what)});
    }
  };
  note(points, "primitive of points is", "primitives of points are", "skipped: only triangles are drawn");
  note(lines, "primitive of lines is", "primitives of lines are", "skipped: only triangles are drawn");
  note(empty, "primitive", "primitives", "without POSITION skipped");
  note(tinted_metals, "primitive", "primitives", "with vertex colours drawn as no metal: the colours tint ambient and diffuse light alone");
}

Result<std::vector<Place>> places_of(GltfModel& model) {
  std::vector<Place> places;
  std::size_t flat = 0;
  for (const std::uint32_t index : scene_nodes(model.file.document)) {
    const GltfNode& node = model.file.document.nodes[index];
    if (node.mesh == kGltfNone) {
      continue;
    }
    const std::size_t first = places.size();
    if (node.skin != kGltfNone) {
      places.push_back({index, {}});  // its joints say where it is
    } else if (!node.is_instanced) {
      places.push_back({index, model.pose.world[index]});
    } else if (const Result<void> done = add_instances(model, index, places); !done) {
      return tl::unexpected(done.error());
    }
    const auto solid = std::stable_partition(places.begin() + static_cast<std::ptrdiff_t>(first), places.end(),
                                             [](const Place& place) { return is_solid(place.matrix); });
    flat += static_cast<std::size_t>(places.end() - solid);
    places.erase(solid, places.end());
  }
  note_skipped(model.file.document, places);
  if (flat > 0) {
    model.file.document.notes.push_back(
        {{}, fmt::format("{} {} flattened by {} scale: not drawn", flat, flat == 1 ? "node is" : "nodes are", flat == 1 ? "its" : "their")});
  }
  return places;
}

std::string name_of(const GltfDocument& document, std::uint32_t index) {
  const GltfNode& node = document.nodes[index];
  const std::string& of_mesh = document.meshes[node.mesh].name;
  return !node.name.empty() ? node.name : !of_mesh.empty() ? of_mesh : fmt::format("nodes[{}]", index);
}

/// Cameras as they can be chosen: each node of the scene that holds one, under the camera's name or else its own.
struct Viewer {
  std::string name;
  std::uint32_t node = 0;
};

std::vector<Viewer> viewers_of(const GltfDocument& document) {
  std::vector<Viewer> viewers;
  for (const std::uint32_t index : scene_nodes(document)) {
    const GltfNode& node = document.nodes[index];
    if (node.camera != kGltfNone) {
      const std::string& name = document.cameras[node.camera].name;
      viewers.push_back({name.empty() ? node.name : name, index});
    }
  }
  return viewers;
}

/// The camera looks along -z of its node, whose y is up; scales do not change what it sees.
Camera camera_at(const GltfCamera& stated, const Mat4& world) {
  const auto column = [&](int k) {
    const Vec3d v{world(0, k), world(1, k), world(2, k)};
    const double size = length(v);
    return size > 0 ? v * (1 / size) : v;
  };
  Camera camera;
  camera.eye = Vec3d{world(0, 3), world(1, 3), world(2, 3)};
  camera.target = *camera.eye - column(2);
  camera.up = column(1);
  camera.near = stated.znear;
  camera.far = stated.zfar;
  if (stated.is_perspective) {
    camera.fov = degrees(stated.yfov);
  } else {
    camera.projection = Projection::orthographic;
    camera.height = 2 * stated.ymag;
  }
  return camera;
}

/// A light of KHR_lights_punctual, which shines along -z of its node.
///
/// Candela and lux meet a reflectance c / pi there; ours is c, so that what arrives is divided by pi: L = (c / pi) E = c (E / pi).
Light light_at(const GltfLight& stated, const std::string& name, const Mat4& world) {
  constexpr double kBrightest = 1e30;
  using Kind = GltfLight::Kind;
  Light light;
  light.type = stated.kind == Kind::directional ? LightType::directional : stated.kind == Kind::point ? LightType::point : LightType::spot;
  light.name = name;
  const auto shine = [&](std::size_t i) { return static_cast<float>(std::min(stated.color[i] * stated.intensity / kPi, kBrightest)); };
  light.diffuse = light.specular = {{shine(0), shine(1), shine(2)}, ColorSpace::linear};
  if (light.type != LightType::point) {
    light.direction = {-world(0, 2), -world(1, 2), -world(2, 2)};
  }
  if (light.type == LightType::directional) {
    return light;
  }
  light.position = {world(0, 3), world(1, 3), world(2, 3)};
  light.attenuation.falloff = 2;
  light.attenuation.unclamped = true;
  light.attenuation.range = stated.range;
  if (light.type == LightType::spot) {
    light.cutoff = std::min(degrees(stated.outer), 90.0);
    light.beam = std::min(degrees(stated.inner), light.cutoff * (1 - 1e-9));
    light.fade = SpotFade::quadratic;
  }
  return light;
}

/// The lights of the scene's nodes; nothing where there are none.
std::optional<std::vector<Light>> lights_of(GltfModel& model) {
  const GltfDocument& document = model.file.document;
  std::optional<std::vector<Light>> lights;
  for (const std::uint32_t index : scene_nodes(document)) {
    const GltfNode& node = document.nodes[index];
    if (node.light == kGltfNone) {
      continue;
    }
    const GltfLight& stated = document.lights[node.light];
    const Light light = light_at(stated, stated.name.empty() ? node.name : stated.name, model.pose.world[index]);
    if (!lights) {
      lights.emplace();
    }
    constexpr double kShortest = 1e-30;  // what a light's direction needs
    if (light.type != LightType::point && !(length(light.direction) > kShortest)) {
      model.file.document.notes.push_back(
          {fmt::format("nodes[{}]", index), "its light has no direction, for its node is flattened: it does not shine"});
    } else {
      lights->push_back(light);
    }
  }
  return lights;
}

Notes notes_of(const GltfFile& file) {
  Notes notes;
  for (const Note& note : file.document.notes) {
    notes.push_back({note.where.empty() ? file.name : file.name + ": " + note.where, note.message});
  }
  return notes;
}

/// The mesh with its materials.
Result<SourceMesh> finished(GltfModel& model, GltfMeshBuilder& builder, const LoadOptions& options) {
  SourceMesh mesh = builder.finish();
  Result<std::vector<Material>> materials = gltf_materials(model.file, builder.material_uses(), options, model.textures, mesh.notes);
  if (!materials) {
    return tl::unexpected(std::move(materials).error());
  }
  mesh.materials = *std::move(materials);
  return mesh;
}

}  // namespace

Result<GltfModel> parse_gltf(std::string_view bytes, const std::string& name, const GltfOptions& gltf, const LoadOptions& options) {
  Result<GltfFile> file = open_gltf(bytes, name, gltf);
  if (!file) {
    return tl::unexpected(std::move(file).error());
  }
  GltfModel model;
  model.file = std::move(*file);
  Result<GltfPose> pose = pose_of(model.file, options.time, options.animation);
  if (!pose) {
    return tl::unexpected(std::move(pose).error());
  }
  model.pose = std::move(*pose);
  return model;
}

Result<GltfModel> load_gltf(const std::filesystem::path& file, const LoadOptions& options) {
  tell(options.on_file, file);
  Result<FileBytes> content = read_file(file);
  if (!content) {
    return tl::unexpected(content.error());
  }
  GltfOptions gltf;
  gltf.read = [folder = file.parent_path(), on_file = options.on_file](const std::string& path) {
    tell(on_file, folder / path);
    return read_file(folder / path);
  };
  Result<GltfModel> model = parse_gltf(content->view(), file.string(), gltf, options);
  if (model) {
    model->file.content = std::move(*content);
  }
  return model;
}

Result<LoadedScene> gltf_scene(GltfModel& model, const std::string& source, const LoadOptions& options) {
  const GltfDocument& document = model.file.document;
  const Result<std::vector<Place>> places = places_of(model);
  if (!places) {
    return tl::unexpected(places.error());
  }
  LoadedScene loaded;
  loaded.scene.shading.two_sided = true;
  loaded.scene.shading.normalized = true;  // what a material reflects then does not depend on how rough it is
  for (const Place& place : *places) {
    Object object;
    object.name = name_of(document, place.node);
    object.source = fmt::format("{}#nodes[{}]", source, place.node);
    object.matrix = place.matrix;
    loaded.scene.objects.push_back(std::move(object));
  }
  loaded.scene.lights = lights_of(model);
  const std::vector<Viewer> viewers = viewers_of(document);
  for (const Viewer& viewer : viewers) {
    loaded.cameras.push_back(viewer.name);
  }
  for (const GltfAnimation& animation : document.animations) {
    loaded.animations.push_back(animation.name);
  }
  if (!options.gltf_camera.empty()) {
    const std::optional<std::size_t> chosen = find_named(loaded.cameras, options.gltf_camera);
    if (!chosen) {
      return fail(ErrorKind::usage, model.file.name,
                  viewers.empty() ? fmt::format("has no camera {}: it has none at all", quote(options.gltf_camera))
                                  : fmt::format("has no camera {}, only {}", quote(options.gltf_camera), listed(loaded.cameras)));
    }
    const std::uint32_t node = viewers[*chosen].node;
    loaded.scene.camera = camera_at(document.cameras[document.nodes[node].camera], model.pose.world[node]);
  }
  loaded.notes = notes_of(model.file);
  return loaded;
}

Result<void> read_gltf_textures(GltfModel& model, std::span<const std::size_t> nodes, const LoadOptions& options) {
  const GltfDocument& document = model.file.document;
  std::set<GltfMaterialUse> uses;
  for (const std::size_t node : nodes) {
    if (node >= document.nodes.size() || document.nodes[node].mesh == kGltfNone) {
      continue;
    }
    for (const GltfPrimitive& primitive : document.meshes[document.nodes[node].mesh].primitives) {
      if (is_drawn(primitive)) {
        uses.insert({primitive.material, primitive.attributes.color != kGltfNone});
      }
    }
  }
  const std::vector<GltfMaterialUse> list(uses.begin(), uses.end());
  Notes notes;  // which come with the meshes
  return gltf_materials(model.file, list, options, model.textures, notes).map([](const auto&) {});
}

Result<SourceMesh> gltf_node_mesh(GltfModel& model, std::size_t node, const LoadOptions& options) {
  if (node >= model.file.document.nodes.size() || model.file.document.nodes[node].mesh == kGltfNone) {
    return model.file.fail_at(fmt::format("nodes[{}]", node), "is no node with a mesh", ErrorKind::usage);
  }
  GltfMeshBuilder builder(model.file, model.pose);
  if (const Result<void> done = builder.add(static_cast<std::uint32_t>(node), std::nullopt, SourceMesh::kNone); !done) {
    return tl::unexpected(done.error());
  }
  return finished(model, builder, options);
}

Result<SourceMesh> gltf_whole_mesh(GltfModel& model, const LoadOptions& options) {
  const Result<std::vector<Place>> places = places_of(model);
  if (!places) {
    return tl::unexpected(places.error());
  }
  GltfMeshBuilder builder(model.file, model.pose);
  for (const Place& place : *places) {
    const auto object = static_cast<std::uint32_t>(builder.mesh().objects.size());
    builder.mesh().objects.push_back(name_of(model.file.document, place.node));
    if (const Result<void> done = builder.add(place.node, place.matrix, object); !done) {
      return tl::unexpected(done.error());
    }
  }
  Result<SourceMesh> mesh = finished(model, builder, options);
  if (mesh) {
    Notes notes = notes_of(model.file);
    mesh->notes.insert(mesh->notes.begin(), notes.begin(), notes.end());
  }
  return mesh;
}

std::string gltf_mesh_key(const GltfModel& model, std::size_t index) {
  const GltfDocument& document = model.file.document;
  if (index >= document.nodes.size() || document.nodes[index].mesh == kGltfNone || document.nodes[index].skin != kGltfNone) {
    return fmt::format("nodes[{}]", index);
  }
  std::string key = fmt::format("meshes[{}]", document.nodes[index].mesh);
  if (!document.meshes[document.nodes[index].mesh].primitives.front().targets.empty()) {
    for (const double weight : model.pose.weights[index]) {
      key += fmt::format(" {}", weight);
    }
  }
  return key;
}

}  // namespace lustro
