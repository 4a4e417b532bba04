// The scene as WebGL2 draws it, with the shaders that mirror the lighting equation: see lab.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "lab.hpp"
#include "scene/samples.hpp"
#include "scene/words.hpp"
#include "shade/glsl.hpp"

namespace lustro::web {
namespace {

using app::json_number;
using app::json_vector;

/// The size of the shaders' array of lights: as many as every WebGL2 has uniforms for.
constexpr std::size_t kMaxLights = 32;

/// Three rows of four as a matrix of 16, column by column.
Json matrix4(const AffineRows& rows) {
  Json list = Json::array();
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      list.push_back(json_number(rows.m[4 * row + column]));
    }
    list.push_back(column == 3 ? 1 : 0);
  }
  return list;
}

Json matrix3(const AffineRows& rows) {
  Json list = Json::array();
  for (std::size_t column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      list.push_back(json_number(rows.m[4 * row + column]));
    }
  }
  return list;
}

/// The projection, column by column: from a space with the eye as its origin and the world's orientation.
Json clip_from_eye(const View& view) {
  const bool is_perspective = view.projection == Projection::perspective;
  const Vec3d x = view.right * (2 * view.pixels_per_unit / view.width);
  const Vec3d y = view.up * (2 * view.pixels_per_unit / view.height);
  const double range = view.far - view.near;
  const double scale = is_perspective ? (view.far + view.near) / range : 2 / range;
  const double offset = is_perspective ? -2 * view.far * view.near / range : -(view.far + view.near) / range;
  const Vec3d z = view.forward * scale;
  const Vec3d w = is_perspective ? view.forward : Vec3d{};
  Json list = Json::array();
  const auto column = [&](double a, double b, double c, double d) {
    for (const double value : {a, b, c, d}) {
      list.push_back(json_number(value));
    }
  };
  column(x.x, y.x, z.x, w.x);
  column(x.y, y.y, z.y, w.y);
  column(x.z, y.z, z.z, w.z);
  column(0, 0, offset, is_perspective ? 0 : 1);
  return list;
}

int type_number(LightType type) {
  return type == LightType::directional ? 0 : type == LightType::spot ? 2 : 1;
}

Json light_json(const ShadingLight& light) {
  return {{"type", type_number(light.type)},
          {"position", json_vector(light.position)},
          {"travel", json_vector(light.travel)},
          {"ambient", json_vector(light.ambient)},
          {"diffuse", json_vector(light.diffuse)},
          {"specular", json_vector(light.specular)},
          {"attenuation", json_vector(light.attenuation)},
          {"falloff", json_number(light.falloff)},
          {"attenuation_limit", json_number(std::min(light.attenuation_limit, std::numeric_limits<float>::max()))},
          {"range_scale", json_number(light.range_scale)},
          {"cos_cutoff", json_number(light.cos_cutoff)},
          {"cos_beam", json_number(light.cos_beam)},
          {"beam_scale", json_number(light.beam_scale)},
          {"fades_quadratically", light.fade == SpotFade::quadratic},
          {"exponent", json_number(light.exponent.n)}};
}

/// What the shaders may know of a light, so that they are not made anew while its numbers change.
GlslKnownLight known_of(const ShadingLight& light) {
  return {.type = light.type == LightType::directional || light.type == LightType::spot ? light.type : LightType::point,
          .has_polynomial = !(light.attenuation == Vec3f{1, 0, 0}),
          .has_power = light.falloff != 0,
          .has_range = light.range_scale != 0,
          .has_exponent = light.exponent.n != 0,
          .has_beam = light.beam_scale != 0};
}

Json material_json(const ShadingMaterial& material) {
  const Coefficients<float>& k = material.coefficients;
  return {{"ambient", json_vector(k.ambient)},
          {"diffuse", json_vector(k.diffuse)},
          {"specular", json_vector(k.specular)},
          {"emission", json_vector(k.emission)},
          {"shininess", json_number(material.stated.shininess)}};
}

/// What the picture of the GPU does without.
Json missing_of(const Scene& scene, const PreparedScene& prepared) {
  Json missing = Json::array();
  const auto say = [&](bool is_so, const char* what) {
    if (is_so) {
      missing.push_back(what);
    }
  };
  const auto any_material = [&](auto is) { return std::any_of(prepared.materials.begin(), prepared.materials.end(), is); };
  say(any_material([](const ShadingMaterial& m) { return !(m.stated.textures == MaterialTextures{}); }), "textures");
  say(std::any_of(prepared.instances.begin(), prepared.instances.end(), [](const Instance& i) { return !i.drawable->colors.empty(); }),
      "vertex colours");
  say(any_material([](const ShadingMaterial& m) { return m.stated.opacity < 1; }), "opacity");
  say(scene.shadow.has_value() || scene.ground.has_value(), "shadows");
  say(scene.occlusion.has_value(), "occlusion");
  say(scene.ground.has_value(), "ground");
  say(scene.environment.has_value(), "environment");
  say(prepared.tone != Tone{}, "tone");
  say(prepared.shading.normals == NormalInterpolation::slerp && prepared.shading.interpolation == Interpolation::phong, "slerp");
  say(prepared.lights.size() > kMaxLights, "more than 32 lights");
  return missing;
}

/// Triangles sorted by material, and the runs that they make.
struct Parts {
  struct Run {
    std::uint32_t material = 0;
    std::size_t first = 0, count = 0;  ///< triangles
  };
  std::vector<std::uint32_t> order;
  std::vector<Run> runs;
};

Parts parts_of(const Instance& instance) {
  Parts parts;
  parts.order.resize(instance.mesh->triangles.size());
  std::iota(parts.order.begin(), parts.order.end(), 0U);
  std::stable_sort(parts.order.begin(), parts.order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return instance.material_of(a) < instance.material_of(b); });
  for (std::size_t i = 0; i < parts.order.size(); ++i) {
    const std::uint32_t material = instance.material_of(parts.order[i]);
    if (parts.runs.empty() || parts.runs.back().material != material) {
      parts.runs.push_back({material, i, 0});
    }
    ++parts.runs.back().count;
  }
  return parts;
}

void append(std::vector<float>& list, const Vec3f& v) {
  list.insert(list.end(), {v.x, v.y, v.z});
}

/// Three vertices of its own a triangle: each knows its face's centre and normal.
void fill_flat(const Mesh& mesh, const Parts& parts, Geometry& geometry) {
  for (const std::uint32_t triangle : parts.order) {
    std::array<Vec3f, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = mesh.positions[mesh.triangles[triangle][i]];
    }
    const Vec3d a = vec_cast<double>(corners[1]) - vec_cast<double>(corners[0]);
    const Vec3d b = vec_cast<double>(corners[2]) - vec_cast<double>(corners[0]);
    const Vec3d across = cross(a, b);
    const Vec3f normal = length(across) > 0 ? vec_cast<float>(normalize(across)) : Vec3f{};
    const Vec3f center = ((corners[0] + corners[1]) + corners[2]) * (1.0F / 3.0F);
    for (const Vec3f& corner : corners) {
      geometry.indices.push_back(static_cast<std::uint32_t>(geometry.positions.size() / 3));
      append(geometry.positions, corner);
      append(geometry.normals, normal);
      append(geometry.centers, center);
    }
  }
}

void fill_smooth(const Mesh& mesh, const Parts& parts, Geometry& geometry) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    append(geometry.positions, mesh.positions[i]);
    append(geometry.normals, mesh.normals[i]);
  }
  for (const std::uint32_t triangle : parts.order) {
    const auto& corners = mesh.triangles[triangle];
    geometry.indices.insert(geometry.indices.end(), corners.begin(), corners.end());
  }
}

}  // namespace

std::string Lab::gpu_scene(const PictureRequest& request, bool linear) {
  const auto scene = scene_of(request);
  if (!scene) {
    return error_answer(scene.error());
  }
  if (const auto done = prepare(*scene, gpu_meshes_, 1, gpu_scene_); !done) {
    return error_answer(done.error());
  }
  const PreparedScene& prepared = gpu_scene_;
  const View& view = prepared.view;
  linear = linear && view.samples > 1;
  const bool is_flat = prepared.shading.interpolation == Interpolation::flat;
  const std::size_t light_count = std::min(prepared.lights.size(), kMaxLights);
  Json lights = Json::array();
  for (std::size_t i = 0; i < light_count; ++i) {
    lights.push_back(light_json(prepared.lights[i]));
  }
  std::vector<GlslKnownLight> known;
  std::transform(prepared.lights.begin(), prepared.lights.begin() + static_cast<std::ptrdiff_t>(light_count), std::back_inserter(known),
                 known_of);
  std::vector<Lighting> models;
  const auto program_of = [&](Lighting model) {
    const auto at = std::find(models.begin(), models.end(), model);
    const auto place = at - models.begin();
    if (at == models.end()) {
      models.push_back(model);
    }
    return place;
  };
  gpu_instances_.clear();
  Json instances = Json::array();
  for (const Instance& instance : prepared.instances) {
    Json parts = Json::array();
    std::string runs;
    for (const Parts::Run& run : parts_of(instance).runs) {
      const ShadingMaterial& material = prepared.materials[run.material];
      parts.push_back({{"first", run.first * 3},
                       {"count", run.count * 3},
                       {"program", program_of(material.lighting)},
                       {"cull", word_of(material.cull)},
                       {"material", material_json(material)}});
    }
    const std::string key = fmt::format("{}/{}/{}/{}", generation_, static_cast<const void*>(instance.mesh), instance.has_own_materials,
                                        is_flat ? "flat" : "smooth");
    gpu_instances_[key] = &instance;
    instances.push_back({{"geometry", key},
                         {"eyeFromObject", matrix4(instance.relative_from_object)},
                         {"normalFromObject", matrix3(instance.normal_from_object)},
                         {"mirrored", instance.is_mirrored},
                         {"parts", std::move(parts)}});
  }
  Json programs = Json::array();
  for (const Lighting model : models) {
    const GlslOptions options{.lighting = model,
                              .interpolation = prepared.shading.interpolation,
                              .projection = view.projection,
                              .terms = prepared.shading.terms,
                              .two_sided = prepared.shading.two_sided,
                              .normalized = prepared.shading.normalized,
                              .fog = prepared.fog.has_value(),
                              .transfer = linear ? Transfer::none : prepared.transfer,
                              .max_lights = static_cast<int>(std::max<std::size_t>(light_count, 1)),
                              .known_lights = known};
    programs.push_back({{"lighting", word_of(model)},
                        {"vertex", glsl_shader(GlslStage::vertex, options)},
                        {"fragment", glsl_shader(GlslStage::fragment, options)}});
  }
  Json pattern = Json::array();
  for (const SampleOffset& sample : sample_pattern(view.samples)) {
    pattern.push_back({sample.x / 256.0, sample.y / 256.0});
  }
  Json json{{"width", view.width},
            {"height", view.height},
            {"pattern", pattern},
            {"clipFromEye", clip_from_eye(view)},
            {"viewToEye", json_vector(-view.ray_center)},
            {"ambientLight", json_vector(prepared.ambient)},
            {"background", {prepared.background[0], prepared.background[1], prepared.background[2], prepared.background[3]}},
            {"encoded", prepared.transfer == Transfer::srgb},
            {"linearShaders", linear},
            {"twoSided", prepared.shading.two_sided},
            {"lights", std::move(lights)},
            {"programs", std::move(programs)},
            {"instances", std::move(instances)},
            {"missing", missing_of(*scene, prepared)}};
  if (prepared.fog) {
    json["fog"] = {{"mode", static_cast<int>(prepared.fog->mode)},
                   {"density", json_number(prepared.fog->density)},
                   {"end", json_number(prepared.fog->end)},
                   {"range_scale", json_number(prepared.fog->range_scale)},
                   {"color", json_vector(prepared.fog->color)}};
  }
  return answer(json);
}

std::string Lab::gpu_geometry(const std::string& key) {
  const auto found = gpu_instances_.find(key);
  if (found == gpu_instances_.end()) {
    return error_answer({ErrorKind::usage, key, "is no geometry of the scene that was asked for last"});
  }
  geometry_ = {};
  const Instance& instance = *found->second;
  const Parts parts = parts_of(instance);
  if (gpu_scene_.shading.interpolation == Interpolation::flat) {
    fill_flat(*instance.mesh, parts, geometry_);
  } else {
    fill_smooth(*instance.mesh, parts, geometry_);
  }
  return "{}";
}

}  // namespace lustro::web
