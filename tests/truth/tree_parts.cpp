// Geometries, cameras, materials and lights of the tree. Numbers are chosen so that channels, coefficients and lights can be told apart, that
// few pixels are burnt out, and that each attenuation passes 1 somewhere on the objects.
#include "truth/tree_parts.hpp"

#include <array>

namespace lustro::truth {
namespace {

Material glossy() {
  return {.name = "glossy",
          .ambient = {{0.20F, 0.15F, 0.10F}},
          .diffuse = {{0.70F, 0.50F, 0.30F}},
          .specular = {{0.40F, 0.50F, 0.60F}},
          .emission = {{0.02F, 0.03F, 0.01F}},
          .shininess = 20};
}

Material satin() {
  return {.name = "satin",
          .ambient = {{0.1F, 0.2F, 0.3F}},
          .diffuse = {{0.25F, 0.45F, 0.65F}},
          .specular = {{0.3F, 0.2F, 0.25F}},
          .shininess = 4.5F};
}

Material encoded_stone() {
  return {.name = "stone",
          .ambient = {{0.135F, 0.2225F, 0.1575F}, ColorSpace::encoded},
          .diffuse = {{0.54F, 0.79F, 0.63F}, ColorSpace::encoded},
          .specular = {{0.62F, 0.51F, 0.42F}, ColorSpace::encoded},
          .shininess = 76.8F};
}

Object object(const char* source, Mat4 matrix, Material material) {
  return {.name = material.name, .source = source, .mesh = tree_mesh(source), .material = std::move(material), .matrix = matrix};
}

std::vector<Object> objects_of(std::size_t place) {
  switch (place) {
    case 0:  // two curved things over a floor of large triangles
      return {object("primitive:sphere:16", translation(-0.7, 0.1, 0), glossy()),
              object("primitive:torus:16", translation(0.9, 0, 0.2) * turned(0), encoded_stone()),
              object("primitive:plane:3", translation(0, -0.9, 0) * scaling(3, 1, 3), satin())};
    case 1:  // hard edges, and a sphere that the cube cuts
      return {object("primitive:cube", turned(1) * turned(0) * scaling(0.7, 0.7, 0.7), satin()),
              object("primitive:sphere:12", translation(0.5, 0.6, 0.5) * scaling(0.6, 0.6, 0.6), encoded_stone())};
    default:  // normals that need the inverse transpose
      return {object("primitive:sphere:16", turned(2) * scaling(1.3, 0.6, 0.8), glossy()),
              object("primitive:torus:16", turned(1) * turned(0) * scaling(1.4, 1.4, 0.9), satin())};
  }
}

Light directional_light() {
  return {.type = LightType::directional,
          .name = "sun",
          .direction = {-0.4, -0.8, -0.6},
          .ambient = {{0.05F, 0.04F, 0.06F}},
          .diffuse = {{0.9F, 0.85F, 0.8F}},
          .specular = {{0.8F, 0.9F, 0.7F}}};
}

Light point_light(const Attenuation& attenuation) {
  return {.type = LightType::point,
          .name = "lamp",
          .position = {0.45, 0.85, 1.05},
          .ambient = {{0.03F, 0.05F, 0.02F}},
          .diffuse = {{0.8F, 0.7F, 0.6F}},
          .specular = {{0.5F, 0.6F, 0.7F}},
          .attenuation = attenuation};
}

Light spot_light(const Attenuation& attenuation) {
  return {.type = LightType::spot,
          .name = "spot",
          .position = {-0.5, 0.95, 1.15},
          .direction = {0.5, -0.95, -1.2},
          .ambient = {{0.02F, 0.02F, 0.05F}},
          .diffuse = {{0.7F, 0.9F, 0.8F}},
          .specular = {{0.7F, 0.5F, 0.6F}},
          .attenuation = attenuation,
          .cutoff = 40,
          .exponent = 12};
}

Light beam_light(const Attenuation& attenuation) {
  Light light = spot_light(attenuation);
  light.name = "beam";
  light.position = {0.2, 1.2, 0.95};
  light.direction = {-0.1, -1.2, -0.9};
  light.cutoff = 42;
  light.beam = 18;
  light.exponent = 1.5;
  return light;
}

void scale_colors(Light& light, float factor) {
  for (Color* color : {&light.ambient, &light.diffuse, &light.specular}) {
    color->rgb = color->rgb * factor;
  }
}

std::vector<Light> several_lights(const Attenuation& attenuation) {
  std::vector<Light> lights{directional_light(), point_light(attenuation), spot_light(attenuation), beam_light(attenuation),
                            point_light(attenuation)};
  lights[4].position = {-1.5, -0.3, 1.8};
  lights[4].diffuse = {{0.2F, 0.4F, 0.9F}, ColorSpace::encoded};
  for (Light& light : lights) {
    scale_colors(light, 0.4F);
  }
  return lights;
}

}  // namespace

const std::vector<NamedAttenuation>& attenuations() {
  static const std::vector<NamedAttenuation> list{
      {"none", {}},
      {"polynomial", {.constant = 0.4, .linear = 0.2, .quadratic = 0.3}},
      {"falloff_1", {.falloff = 1.0}},
      {"falloff_2", {.falloff = 2.0}},
      {"falloff_1.5", {.falloff = 1.5}},
      {"unclamped", {.falloff = 2.0, .unclamped = true}},
      {"unclamped_polynomial", {.constant = 0.4, .linear = 0.2, .quadratic = 0.1, .unclamped = true}},
  };
  return list;
}

const std::vector<LightKind>& light_kinds() {
  static const std::vector<LightKind> list{
      {"directional", [](const Attenuation&) { return std::vector<Light>{directional_light()}; }},
      {"point", [](const Attenuation& a) { return std::vector<Light>{point_light(a)}; }},
      {"spot_exponent", [](const Attenuation& a) { return std::vector<Light>{spot_light(a)}; }},
      {"spot_beam", [](const Attenuation& a) { return std::vector<Light>{beam_light(a)}; }},
      {"several", several_lights},
  };
  return list;
}

std::size_t geometry_count() {
  return 3;
}

TreeScene base_scene(std::size_t place, Projection projection) {
  TreeScene entry;
  entry.geometry = std::to_string(place) + "/" + word(projection);
  Scene& scene = entry.scene;
  scene.image = {.width = 96, .height = 72, .samples = 1, .background = {{0.1F, 0.2F, 0.3F}}};
  scene.camera.projection = projection;
  scene.camera.eye = Vec3d{1.1, 1.4, 3.9};
  scene.camera.target = Vec3d{0.05, -0.1, 0};
  scene.camera.up = Vec3d{0.1, 1, 0};
  scene.camera.near = 0.5;
  scene.camera.far = 20;
  scene.camera.fov = 38;
  if (projection == Projection::orthographic) {
    scene.camera.height = 2.9;
  }
  scene.ambient = {{0.2F, 0.25F, 0.15F}};
  scene.lights = std::vector<Light>{directional_light()};
  scene.objects = objects_of(place);
  return entry;
}

Mat4 translation(double x, double y, double z) {
  return {{1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z, 0, 0, 0, 1}};
}

Mat4 scaling(double x, double y, double z) {
  return {{x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1}};
}

Mat4 turned(int axis) {
  Mat4 matrix;
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  matrix(a, a) = 0.8;
  matrix(a, b) = -0.6;
  matrix(b, a) = 0.6;
  matrix(b, b) = 0.8;
  return matrix;
}

const char* word(Lighting model) {
  switch (model) {
    case Lighting::constant:
      return "constant";
    case Lighting::lambert:
      return "lambert";
    case Lighting::phong:
      return "phong";
    case Lighting::ggx:
      return "ggx";
    case Lighting::blinn_phong:
      break;
  }
  return "blinn-phong";
}

const char* word(Interpolation interpolation) {
  switch (interpolation) {
    case Interpolation::flat:
      return "flat";
    case Interpolation::gouraud:
      return "gouraud";
    case Interpolation::phong:
      break;
  }
  return "phong";
}

const char* word(Projection projection) {
  return projection == Projection::perspective ? "perspective" : "orthographic";
}

}  // namespace lustro::truth
