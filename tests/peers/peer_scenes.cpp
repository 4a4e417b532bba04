// Subjects, lights and cameras for the peers.
#include "peers/peer_scenes.hpp"

#include <filesystem>
#include <map>
#include <stdexcept>

#include "shared_dir.hpp"
#include "truth/tree_parts.hpp"

namespace lustro::peers {
namespace {

using truth::scaling;
using truth::translation;
using truth::turned;

std::map<std::string, std::filesystem::path> real_meshes() {
  const std::filesystem::path assets = shared_dir() / "assets";
  return {{"bunny", assets / "ply" / "stanford_bunny" / "bun_zipper.ply"},
          {"spot", assets / "obj" / "spot" / "spot_triangulated.obj"},
          {"armadillo", assets / "obj" / "armadillo" / "armadillo.obj"}};
}

Material ceramic() {
  return {.name = "ceramic",
          .ambient = {{0.15F, 0.20F, 0.25F}},
          .diffuse = {{0.35F, 0.50F, 0.60F}},
          .specular = {{0.45F, 0.40F, 0.35F}},
          .emission = {{0.01F, 0.02F, 0}},
          .shininess = 25};
}

Material brick() {
  return {.name = "brick", .ambient = {{0.2F, 0.1F, 0.1F}}, .diffuse = {{0.6F, 0.3F, 0.2F}}, .specular = {{0.2F, 0.2F, 0.25F}}, .shininess = 8};
}

/// A real mesh, moved and scaled so that it fills the box -1..1.
Object real_object(const std::filesystem::path& file) {
  static std::map<std::filesystem::path, std::shared_ptr<const Mesh>> meshes;
  std::shared_ptr<const Mesh>& mesh = meshes[file];
  if (!mesh) {
    const Result<SourceMesh> source = load_mesh_file(file);
    if (!source) {
      throw std::runtime_error(source.error().text());
    }
    Result<BuiltMesh> built = build_mesh(*source);
    if (!built) {
      throw std::runtime_error(built.error().text());
    }
    built->mesh.colors.clear();  // the shaders know none
    mesh = std::make_shared<const Mesh>(std::move(built->mesh));
  }
  const Bounds bounds = mesh->bounds();
  const Vec3d size = bounds.upper - bounds.lower;
  const double scale = 2 / std::max({size.x, size.y, size.z});
  const Vec3d center = bounds.center();
  Object object;
  object.name = file.stem().string();
  object.mesh = mesh;
  object.material = ceramic();
  object.matrix = scaling(scale, scale, scale) * translation(-center.x, -center.y, -center.z);
  return object;
}

Object primitive(const std::string& name, const Mat4& matrix, Material material) {
  Object object;
  object.name = name;
  object.source = "primitive:" + name;
  object.mesh = truth::tree_mesh(object.source);
  object.material = std::move(material);
  object.matrix = matrix;
  return object;
}

std::vector<Object> objects_of(const std::string& subject) {
  if (subject == "primitives") {
    return {primitive("sphere:32", translation(-0.9, 0.1, 0), ceramic()), primitive("torus:32", translation(0.6, 0.1, 0.7) * turned(0), brick()),
            primitive("cube", translation(0.9, -0.3, -0.9) * turned(1) * scaling(0.6, 0.6, 0.6), ceramic()),
            primitive("plane:24", translation(0, -0.95, 0) * scaling(2.5, 1, 2.5), brick())};
  }
  if (subject == "teapot") {
    return {primitive("teapot", translation(0, -0.9, 0) * scaling(0.6, 0.6, 0.6), ceramic()),
            primitive("sphere:24", translation(0.9, -0.5, 0.9) * scaling(-0.4, 0.4, 0.3), brick())};  // mirrored and stretched
  }
  return {real_object(real_meshes().at(subject))};
}

Scene stage(const std::string& subject, Projection projection) {
  Scene scene;
  scene.image = {.width = 400, .height = 300, .samples = 1, .transfer = Transfer::none, .background = {{0.1F, 0.15F, 0.2F}}};
  scene.camera.projection = projection;
  scene.camera.eye = Vec3d{1.3, 1.1, 4.2};
  scene.camera.target = Vec3d{0, 0, 0};
  scene.camera.up = Vec3d{0, 1, 0};
  scene.camera.fov = 34;
  scene.camera.near = 1;
  scene.camera.far = 12;
  if (projection == Projection::orthographic) {
    scene.camera.height = 2.7;
  }
  scene.shading.lighting = Lighting::blinn_phong;
  scene.shading.interpolation = Interpolation::gouraud;
  scene.ambient = {{0.2F, 0.2F, 0.25F}};
  scene.objects = objects_of(subject);
  return scene;
}

Light directional(Vec3d direction, Vec3f diffuse) {
  return {.type = LightType::directional,
          .direction = direction,
          .ambient = {{0.05F, 0.05F, 0.02F}},
          .diffuse = {diffuse},
          .specular = {{0.6F, 0.7F, 0.8F}}};
}

Light point(Vec3d position, Vec3f diffuse, Attenuation attenuation) {
  return {.type = LightType::point,
          .position = position,
          .ambient = {{0.02F, 0.05F, 0.04F}},
          .diffuse = {diffuse},
          .specular = {{0.8F, 0.7F, 0.6F}},
          .attenuation = attenuation};
}

Light spot(Vec3d position, Vec3d target, double cutoff, double exponent, Attenuation attenuation) {
  return {.type = LightType::spot,
          .position = position,
          .direction = target - position,
          .ambient = {{0.06F, 0.02F, 0.02F}},
          .diffuse = {{0.9F, 0.8F, 0.7F}},
          .specular = {{0.7F, 0.7F, 0.7F}},
          .attenuation = attenuation,
          .cutoff = cutoff,
          .exponent = exponent};
}

constexpr Attenuation kFading{.constant = 1, .linear = 0.1, .quadratic = 0.05, .falloff = {}, .unclamped = false};

using LightSets = std::vector<std::pair<std::string, std::vector<Light>>>;

LightSets fixed_light_sets() {
  const Light sun = directional({-0.4, -0.8, -0.6}, {0.8F, 0.8F, 0.7F});
  const Light lamp = point({1.4, 1.5, 1.8}, {0.8F, 0.7F, 0.6F}, {});
  const Light fading_lamp = point({-1.2, 1.3, 1.5}, {0.9F, 0.9F, 0.9F}, kFading);
  const Light cone = spot({0.6, 1.8, 2.4}, {0, 0, 0}, 20, 0, {});
  const Light soft_cone = spot({-1.0, 1.8, 2.2}, {0.1, 0, 0}, 50, 24, kFading);
  std::vector<Light> eight{sun,
                           lamp,
                           fading_lamp,
                           cone,
                           soft_cone,
                           directional({1, -0.2, -0.5}, {0.2F, 0.1F, 0.4F}),
                           point({0, -0.5, 2.5}, {0.1F, 0.4F, 0.2F}, {.constant = 1, .linear = 1, .quadratic = 0.5}),
                           spot({2, 0.5, 1}, {0, 0, 0}, 90, 3, {})};
  for (Light& light : eight) {
    light.diffuse.rgb = light.diffuse.rgb * 0.35F;
    light.specular.rgb = light.specular.rgb * 0.35F;
  }
  return {{"directional", {sun}},
          {"point", {lamp}},
          {"point_attenuated", {fading_lamp}},
          {"spot", {cone}},
          {"spot_exponent_attenuated", {soft_cone}},
          {"eight", eight},
          {"none", {}}};
}

LightSets shader_light_sets() {
  Light beam = spot({0.6, 1.8, 2.4}, {0, 0, 0}, 26, 2, {.falloff = 1.0});
  beam.beam = 9;
  Light close = point({0.3, 1.2, 1.3}, {0.5F, 0.4F, 0.3F}, {.falloff = 2.0, .unclamped = true});
  Light root = point({-1.4, 1.2, 1.6}, {0.9F, 0.6F, 0.8F}, {.falloff = 1.5});
  std::vector<Light> twelve;
  for (int i = 0; i < 12; ++i) {
    Light light = i % 3 == 0 ? beam : i % 3 == 1 ? close : root;
    light.position = light.position + Vec3d{0.15 * i - 0.8, 0.05 * i, 0.1 * (i % 4)};
    light.diffuse.rgb = light.diffuse.rgb * 0.15F;
    light.specular.rgb = light.specular.rgb * 0.15F;
    twelve.push_back(light);
  }
  return {{"beam", {beam}}, {"falloff_2_unclamped", {close}}, {"falloff_1.5", {root}}, {"twelve", twelve}};
}

std::vector<PeerScene> scenes_of(const std::string& subject, const LightSets& sets) {
  std::vector<PeerScene> scenes;
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    for (const auto& [name, lights] : sets) {
      PeerScene peer{subject + "/" + name + "/" + truth::word(projection), stage(subject, projection)};
      peer.scene.lights = lights;
      scenes.push_back(std::move(peer));
    }
  }
  return scenes;
}

}  // namespace

std::vector<std::string> subjects() {
  std::vector<std::string> names{"primitives", "teapot"};
  for (const auto& [name, file] : real_meshes()) {
    if (std::filesystem::exists(file)) {
      names.push_back(name);
    }
  }
  return names;
}

std::vector<PeerScene> fixed_function_scenes(const std::string& subject) {
  return scenes_of(subject, fixed_light_sets());
}

std::vector<PeerScene> shader_scenes(const std::string& subject) {
  return scenes_of(subject, shader_light_sets());
}

}  // namespace lustro::peers
