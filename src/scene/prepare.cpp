// From the scene as it is stated to the scene as it is drawn.
#include "scene/prepare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/srgb.hpp"
#include "math/power.hpp"
#include "math/trig.hpp"
#include "scene/displacement.hpp"
#include "scene/ground.hpp"
#include "scene/prepare_maps.hpp"

namespace lustro {
namespace {

Vec3f linear_rgb(const Vec3f& rgb, ColorSpace space, Transfer transfer) {
  if (space == ColorSpace::linear || transfer == Transfer::none) {
    return rgb;
  }
  return {srgb_decode(rgb.x), srgb_decode(rgb.y), srgb_decode(rgb.z)};
}
Vec3f linear_rgb(const Color& color, Transfer transfer) {
  return linear_rgb(color.rgb, color.space, transfer);
}

void prepare_material(const Material& material, const Shading& shading, Transfer transfer, ShadingMaterial& result) {
  result.stated = material;
  const auto decode = [transfer](const Color& color) { return Color{linear_rgb(color, transfer), ColorSpace::linear}; };
  result.stated.ambient = decode(material.ambient);
  result.stated.diffuse = decode(material.diffuse);
  result.stated.specular = decode(material.specular);
  result.stated.emission = decode(material.emission);
  result.stated.transmission = decode(material.transmission);
  const TermSet& terms = shading.terms;
  const auto keep = [](bool on, const Color& color) { return on ? color.rgb : Vec3f{}; };
  result.albedo = result.stated.diffuse.rgb;
  result.lighting = material.lighting.value_or(shading.lighting);
  result.cull = material.cull.value_or(shading.cull);
  const bool has_specular = terms.specular || result.lighting == Lighting::ggx;  // whose k_s takes from the diffuse part; the lights' own is 0
  result.coefficients = {keep(terms.ambient, result.stated.ambient), keep(terms.diffuse, result.stated.diffuse),
                         keep(has_specular, result.stated.specular), keep(terms.emission, result.stated.emission), material.shininess};
  if (catches_shadows(material)) {
    result.lighting = Lighting::constant;
    result.coefficients = {};
    result.albedo = {};
  }
}

Vec3f unit_direction(const Vec3d& direction) {
  const double size = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
  return size > 0 ? vec_cast<float>(normalize(direction * (1 / size))) : Vec3f{0, 0, -1};
}

ShadingLight prepare_light(const Light& light, const View& view, const TermSet& terms, Transfer transfer) {
  ShadingLight result;
  result.type = light.type;
  result.position = vec_cast<float>(light.position - view.eye);
  result.travel = unit_direction(light.direction);
  result.ambient = linear_rgb(light.ambient, transfer);
  result.diffuse = linear_rgb(light.diffuse, transfer);
  result.specular = terms.specular ? linear_rgb(light.specular, transfer) : Vec3f{};
  const Attenuation& a = light.attenuation;
  result.attenuation = vec_cast<float>(Vec3d{a.constant, a.linear, a.quadratic});
  if (a.falloff) {  // 1, 1/d and 1/d^2 are polynomials and need no power
    const double p = *a.falloff;
    result.attenuation = p == 0 ? Vec3f{1, 0, 0} : (p == 1 ? Vec3f{0, 1, 0} : Vec3f{0, 0, 1});
    result.falloff = p == 0 || p == 1 || p == 2 ? 0 : static_cast<float>(p);
  }
  result.attenuation_limit = a.unclamped ? 1e30F : 1;
  result.range_scale = a.range ? static_cast<float>(1 / *a.range) : 0;
  const double cos_cutoff = cosine_deg(light.cutoff);
  result.cos_cutoff = static_cast<float>(cos_cutoff);
  if (light.beam) {
    const double cos_beam = cosine_deg(*light.beam);
    result.cos_beam = static_cast<float>(cos_beam);
    result.fade = light.fade;
    const double least = light.fade == SpotFade::quadratic ? 0.001 : 0;  // as KHR_lights_punctual has it
    result.beam_scale = static_cast<float>(1 / std::max(cos_beam - cos_cutoff, least));
  }
  result.exponent = static_cast<float>(light.exponent);
  return result;
}

// The light without a size that lights as this one does from far away: a flat patch of area A and radiance L is a spot with the cosine's falloff
// and the colour L A / pi, a ball of radius r a point with the colour L r^2; both fall with 1 / d^2.
Light stand_in_of(const Light& light) {
  Light result = light;
  result.attenuation = {.constant = 0, .linear = 0, .quadratic = 1, .falloff = {}, .unclamped = true, .range = {}};
  result.cutoff = 90;
  result.beam.reset();
  result.exponent = 1;
  result.type = light.type == LightType::sphere ? LightType::point : LightType::spot;
  return result;
}

float strength_of_stand_in(const Light& light) {
  switch (light.type) {
    case LightType::rectangle:
      return static_cast<float>(static_cast<double>(light.size.x) * static_cast<double>(light.size.y) / kPi);
    case LightType::disk:  // A = pi r^2
    case LightType::sphere:
      return static_cast<float>(light.radius * light.radius);
    default:
      return 1;
  }
}

AreaLight prepare_area(const Light& light, const ShadingLight& shading, std::uint32_t index, const View& view) {
  AreaLight area;
  area.type = light.type;
  area.light = index;
  area.center = vec_cast<float>(light.position - view.eye);
  area.normal = shading.travel;
  area.radius = static_cast<float>(light.radius);
  area.half_width = light.size.x * 0.5F;
  area.half_height = light.size.y * 0.5F;
  area.diffuse = shading.diffuse;
  area.specular = shading.specular;
  const Vec3d normal = vec_cast<double>(area.normal);
  Vec3d x = light.x_axis.value_or(cross(Vec3d{0, 1, 0}, normal));
  x = x - normal * dot(normal, x);
  if (!(dot(x, x) > 1e-12 * dot(light.x_axis.value_or(Vec3d{1, 0, 0}), light.x_axis.value_or(Vec3d{1, 0, 0})))) {
    x = cross(Vec3d{0, 0, 1}, normal);  // it faces up or down: any level edge will do
  }
  area.x_axis = unit_direction(x);
  area.y_axis = vec_cast<float>(cross(normal, vec_cast<double>(area.x_axis)));
  return area;
}

void add_light(PreparedScene& prepared, const Light& light, const TermSet& terms) {
  if (!is_area(light.type)) {
    prepared.lights.push_back(prepare_light(light, prepared.view, terms, prepared.transfer));
    return;
  }
  ShadingLight shading = prepare_light(stand_in_of(light), prepared.view, terms, prepared.transfer);
  prepared.area_lights.push_back(prepare_area(light, shading, static_cast<std::uint32_t>(prepared.lights.size()), prepared.view));
  const float strength = strength_of_stand_in(light);
  shading.diffuse = shading.diffuse * strength;
  shading.specular = shading.specular * strength;
  prepared.lights.push_back(shading);
}

Result<PreparedEnvironment> prepare_environment(const Environment& environment, Transfer transfer) {
  PreparedEnvironment result;
  result.visible = environment.visible;
  result.cosine = static_cast<float>(cosine_deg(environment.rotation));
  result.sine = static_cast<float>(sine_deg(environment.rotation));
  result.picture = environment.picture;
  result.color = environment.gain;
  if (environment.picture == nullptr) {
    result.color = linear_rgb(environment.color, transfer) * environment.gain;
  } else if (const Image& picture = *environment.picture; picture.channels != 3 || picture.width < 1 || picture.height < 1) {
    return fail(ErrorKind::usage, "environment",
                fmt::format("its picture is {} x {} with {} channels, expected at least one pixel of three", picture.width, picture.height,
                            picture.channels));
  }
  return result;
}

ShadingFog prepare_fog(const Fog& fog, Transfer transfer) {
  ShadingFog result;
  result.mode = fog.mode;
  result.density = static_cast<float>(fog.density);
  result.end = static_cast<float>(fog.end);
  result.range_scale = static_cast<float>(1 / (fog.end - fog.start));
  result.color = linear_rgb(fog.color, transfer);
  return result;
}

// Rows of equal length at right angles, to the last digits of a float: a rotation, perhaps with a reflection, and one scale for all axes.
bool keeps_angles(const std::array<Vec3d, 3>& rows) {
  constexpr double kTolerance = 1e-6;
  const double square = dot(rows[0], rows[0]);
  const auto equal = [square](double a, double b) { return std::abs(a - b) <= kTolerance * square; };
  return equal(dot(rows[1], rows[1]), square) && equal(dot(rows[2], rows[2]), square) && equal(dot(rows[0], rows[1]), 0) &&
         equal(dot(rows[1], rows[2]), 0) && equal(dot(rows[2], rows[0]), 0);
}

// The matrices of one object. The cofactor matrix is the inverse transpose times the determinant; only its direction matters.
Result<void> place(Instance& instance, const Mat4& m, const View& view, const std::string& where) {
  const std::array<Vec3d, 3> rows{Vec3d{m(0, 0), m(0, 1), m(0, 2)}, Vec3d{m(1, 0), m(1, 1), m(1, 2)}, Vec3d{m(2, 0), m(2, 1), m(2, 2)}};
  const Vec3d translation = Vec3d{m(0, 3), m(1, 3), m(2, 3)} - view.eye;

  std::array<Vec3d, 3> cofactors{cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])};
  const double determinant = dot(rows[0], cofactors[0]);
  double largest = 0;
  for (const Vec3d& c : cofactors) {
    largest = std::max({largest, std::abs(c.x), std::abs(c.y), std::abs(c.z)});
  }
  if (determinant == 0 || !std::isnormal(largest)) {
    return fail(ErrorKind::usage, where + ".matrix", "is singular: it flattens the object");
  }
  for (Vec3d& c : cofactors) {
    c = c * ((determinant < 0 ? -1 : 1) / largest);
  }
  instance.is_mirrored = determinant < 0;
  instance.size = power(static_cast<float>(std::clamp(std::abs(determinant), 1e-30, 1e30)), Exponent(1.0F / 3));
  instance.is_similarity = keeps_angles(cofactors);
  if (instance.is_similarity) {
    for (Vec3d& c : cofactors) {
      c = normalize(c);
    }
    const Vec3d& v = view.projection == Projection::perspective ? -translation : view.forward;
    instance.eye = ((rows[0] * v.x + rows[1] * v.y) + rows[2] * v.z) * (1 / dot(rows[0], rows[0]));
  }
  instance.relative_from_object = to_rows(rows, translation);
  instance.normal_from_object = to_rows(cofactors, {});
  instance.world_from_object = m;
  instance.image_from_object = image_rows(m, view);
  return {};
}

// The largest dot(direction, p) over the vertices that triangles use. Clusters whose box cannot reach farther than what was found are passed
// over, which changes nothing: a maximum is exact, and the same in every order.
double reach_of(const Clusters& clusters, const Mesh& mesh, const Vec3d& direction) {
  const auto bound = [&](const auto& box) {
    const auto farther = [](double d, float lower, float upper) {
      return std::max(d * static_cast<double>(lower), d * static_cast<double>(upper));
    };
    const Vec3d parts{farther(direction.x, box.lower.x, box.upper.x), farther(direction.y, box.lower.y, box.upper.y),
                      farther(direction.z, box.lower.z, box.upper.z)};
    constexpr double kRounding = 1e-14;
    return ((parts.x + parts.y) + parts.z) + kRounding * ((std::abs(parts.x) + std::abs(parts.y)) + std::abs(parts.z));
  };
  double farthest = -std::numeric_limits<double>::infinity();
  const auto look_into = [&](std::size_t group) {
    const std::size_t end = std::min((group + 1) * Clusters::kGroup, clusters.clusters.size());
    for (std::size_t c = group * Clusters::kGroup; c < end; ++c) {
      const Cluster& cluster = clusters.clusters[c];
      if (!(bound(cluster) > farthest)) {
        continue;
      }
      for (std::uint32_t i = 0; i < cluster.vertices; ++i) {
        farthest = std::max(farthest, dot(direction, vec_cast<double>(mesh.positions[clusters.vertices[cluster.first_vertex + i]])));
      }
    }
  };
  std::size_t promising = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t group = 0; group < clusters.groups.size(); ++group) {
    if (const double reach = bound(clusters.groups[group]); reach > most) {
      most = reach;
      promising = group;
    }
  }
  if (!clusters.groups.empty()) {
    look_into(promising);  // first, so that the others are passed over
  }
  for (std::size_t group = 0; group < clusters.groups.size(); ++group) {
    if (bound(clusters.groups[group]) > farthest) {
      look_into(group);
    }
  }
  return farthest;
}

// Of the scene's own objects: without the ground.
void reach_of(const Scene& scene, std::span<const Instance> instances, std::span<const Vec3d> directions, std::span<double> reach) {
  std::fill(reach.begin(), reach.end(), -std::numeric_limits<double>::infinity());
  for (std::size_t o = 0; o < scene.objects.size(); ++o) {
    const Mat4& m = scene.objects[o].matrix;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Vec3d& d = directions[i];  // dot(d, M p) = dot(M^T d, p)
      const Vec3d local{(m(0, 0) * d.x + m(1, 0) * d.y) + m(2, 0) * d.z, (m(0, 1) * d.x + m(1, 1) * d.y) + m(2, 1) * d.z,
                        (m(0, 2) * d.x + m(1, 2) * d.y) + m(2, 2) * d.z};
      const double offset = (m(0, 3) * d.x + m(1, 3) * d.y) + m(2, 3) * d.z;
      reach[i] = std::max(reach[i], reach_of(instances[o].drawable->clusters, *instances[o].mesh, local) + offset);
    }
  }
}

// Refers to both arguments.
Extent extent_of(const Scene& scene, const std::vector<Instance>& instances) {
  Extent extent;
  constexpr std::array kAxes{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}, Vec3d{-1, 0, 0}, Vec3d{0, -1, 0}, Vec3d{0, 0, -1}};
  std::array<double, 6> reach{};
  reach_of(scene, instances, kAxes, reach);
  extent.bounds.upper = {reach[0], reach[1], reach[2]};
  extent.bounds.lower = {-reach[3], -reach[4], -reach[5]};
  extent.reach = [&scene, &instances](std::span<const Vec3d> directions, std::span<double> out) { reach_of(scene, instances, directions, out); };
  return extent;
}

// Completes the instance of an object, of which the mesh is known. `materials` counts those that are prepared.
Result<void> add_object(PreparedScene& prepared, const Scene& scene, const Object& object, std::size_t index, std::size_t& materials) {
  const std::string where = fmt::format("objects[{}]", index);
  prepared.object_names[index] = !object.name.empty() ? object.name : object.source;
  Instance& instance = prepared.instances[index];
  if (auto placed = place(instance, object.matrix, prepared.view, where); !placed) {
    return placed;
  }
  if (!instance.drawable->note.empty()) {
    prepared.notes.push_back({where, instance.drawable->note});
  }
  const std::size_t triangles = instance.mesh->triangles.size();
  if (triangles > 0xFFFFFFFEU - prepared.triangle_count) {
    return fail(ErrorKind::limit, where, "the scene has more than 4294967294 triangles");
  }
  instance.first_triangle = prepared.triangle_count;
  prepared.triangle_count += static_cast<std::uint32_t>(triangles);

  instance.first_material = static_cast<std::uint32_t>(materials);
  instance.has_own_materials = !object.material && !instance.mesh->materials.empty();
  const auto add = [&](const Material& material) {
    if (materials == prepared.materials.size()) {
      prepared.materials.emplace_back();
    }
    ShadingMaterial& shading = prepared.materials[materials++];
    prepare_material(material, scene.shading, prepared.transfer, shading);
    shading.maps = prepare_maps(material, *instance.mesh, scene.shading, where, prepared.notes);
    shading.opacity = prepare_opacity(material, *instance.drawable, where, prepared.notes);
    instance.alpha_modes |= bit_of(shading.opacity.mode);
    shading.maps.reflects = prepare_reflection(material, scene.shading, where, prepared.notes, shading.reflection);
  };
  if (instance.has_own_materials) {
    std::for_each(instance.mesh->materials.begin(), instance.mesh->materials.end(), add);
  } else if (object.material) {
    add(*object.material);
  } else {
    add({});
  }
  const auto own = std::span<const ShadingMaterial>(prepared.materials).subspan(instance.first_material, materials - instance.first_material);
  instance.has_mixed_culling = std::any_of(own.begin(), own.end(), [&](const ShadingMaterial& m) { return m.cull != own[0].cull; });
  instance.cull = instance.has_mixed_culling ? Culling::none : own[0].cull;
  return {};
}

// Whether faces of the object may be left out by the side that is seen.
bool culls(const Object& object, const Shading& shading) {
  const auto does = [&](const Material& material) { return material.cull.value_or(shading.cull) != Culling::none; };
  if (object.material) {
    return does(*object.material);
  }
  if (object.mesh->materials.empty()) {
    return shading.cull != Culling::none;
  }
  return std::any_of(object.mesh->materials.begin(), object.mesh->materials.end(), does);
}

// The object has a mesh, the mesh is sound, the matrix is affine and finite: whatever follows may rely on it.
Result<void> check_object(const Scene& scene, const Object& object, MeshCache& cache, int threads, std::vector<Instance>& instances) {
  const std::size_t index = instances.size();
  const std::string where = fmt::format("objects[{}]", index);
  if (!object.mesh) {
    return fail(ErrorKind::usage, where, object.source.empty() ? "has no mesh" : fmt::format("its mesh \"{}\" is not loaded", object.source));
  }
  const MeshDemand demand{.normals = {.weights = scene.shading.vertex_normals, .crease_deg = scene.shading.crease.value_or(180)},
                          .wants_normals = scene.shading.interpolation != Interpolation::flat,
                          .encoded_colors = scene.image.transfer != Transfer::none,
                          .wants_cones = culls(object, scene.shading),
                          .tangents = tangents_for(object, scene.shading),
                          .displacement = displacement_of(object)};
  auto drawable = cache.get(object.mesh, demand, threads, where + ".mesh");
  if (!drawable) {
    return tl::unexpected(drawable.error());
  }
  Instance& instance = instances.emplace_back();
  instance.mesh = (*drawable)->mesh.get();
  instance.drawable = *std::move(drawable);
  instance.object = static_cast<std::uint32_t>(index);
  const Mat4& m = object.matrix;
  if (!std::all_of(m.m.begin(), m.m.end(), [](double value) { return std::isfinite(value); })) {
    return fail(ErrorKind::usage, where + ".matrix", "holds a number that is not finite");
  }
  if (m(3, 0) != 0 || m(3, 1) != 0 || m(3, 2) != 0 || m(3, 3) != 1) {
    return fail(ErrorKind::usage, where + ".matrix", "the last row must be 0, 0, 0, 1");
  }
  return {};
}

// Surfaces that show shadows alone are there for nothing where there are none.
void note_idle_catchers(PreparedScene& prepared) {
  const auto idle = std::find_if(prepared.materials.begin(), prepared.materials.end(),
                                 [](const ShadingMaterial& material) { return material.opacity.catches > 0; });
  if (idle != prepared.materials.end() && !prepared.looks_beyond()) {
    const std::string& name = idle->stated.name;
    prepared.notes.push_back(
        {"materials", fmt::format("{} shows nothing but the shadows on it, and the scene has none: `shadow` switches them on",
                                  name.empty() ? "one without a name" : fmt::format("\"{}\"", name))});
  }
}

Result<void> check_image(const ImageSettings& image) {
  if (image.width < 1 || image.height < 1 || image.width > 16384 || image.height > 16384) {
    return fail(ErrorKind::usage, "image", fmt::format("the size {} x {} is outside 1..16384", image.width, image.height));
  }
  if (image.samples != 1 && image.samples != 2 && image.samples != 4 && image.samples != 8 && image.samples != 16) {
    return fail(ErrorKind::usage, "image.samples", fmt::format("{} is none of 1, 2, 4, 8, 16", image.samples));
  }
  return {};
}

}  // namespace

Result<PreparedScene> prepare(const Scene& scene) {
  MeshCache cache(ClusterUse::once);
  PreparedScene prepared;
  return prepare(scene, cache, 0, prepared).map([&] { return std::move(prepared); });
}

Result<void> prepare(const Scene& scene, MeshCache& cache, int threads, PreparedScene& prepared) {
  prepared.instances.clear();
  prepared.lights.clear();
  prepared.area_lights.clear();
  prepared.notes.clear();
  prepared.triangle_count = 0;
  if (auto checked = check_image(scene.image); !checked) {
    return tl::unexpected(checked.error());
  }
  for (const Object& object : scene.objects) {
    if (auto checked = check_object(scene, object, cache, threads, prepared.instances); !checked) {
      return checked;
    }
  }
  prepared.shading = scene.shading;
  prepared.transfer = scene.image.transfer;
  prepared.tone = scene.image.tone;
  const Extent extent = extent_of(scene, prepared.instances);
  auto view = make_view(scene.camera, scene.image, extent);
  if (!view) {
    return tl::unexpected(view.error());
  }
  prepared.view = *view;
  std::optional<Object> ground;
  if (scene.ground && !extent.bounds.is_empty()) {
    ground = make_ground(*scene.ground, scene.camera, extent.bounds, prepared.view);  // scene/ground.cpp
    if (auto checked = check_object(scene, *ground, cache, threads, prepared.instances); !checked) {
      return checked;
    }
  }
  cache.forget_unused();
  prepared.object_names.resize(prepared.instances.size());
  std::size_t materials = 0;
  for (std::size_t i = 0; i < prepared.instances.size(); ++i) {
    const Object& object = i < scene.objects.size() ? scene.objects[i] : *ground;
    if (auto added = add_object(prepared, scene, object, i, materials); !added) {
      return added;
    }
  }
  prepared.materials.resize(materials);
  if (prepared.triangle_count == 0) {
    return fail(ErrorKind::empty, "", scene.objects.empty() ? "the scene has no objects" : "the scene has no triangles");
  }
  if (scene.lights) {
    prepared.stated_lights = *scene.lights;
  } else {
    const auto rig = default_rig(prepared.view);
    prepared.stated_lights.assign(rig.begin(), rig.end());
  }
  for (const Light& light : prepared.stated_lights) {
    add_light(prepared, light, scene.shading.terms);
  }
  prepared.environment.reset();
  prepared.around.reset();
  prepared.sky.reset();
  if (scene.environment) {
    auto environment = prepare_environment(*scene.environment, prepared.transfer);
    if (!environment) {
      return tl::unexpected(environment.error());
    }
    prepared.environment = *std::move(environment);
  }
  prepared.shadows.clear();
  if (scene.shadow || scene.ground) {
    for (std::size_t i = 0; i < prepared.lights.size(); ++i) {
      prepared.lights[i].has_shadow = prepared.stated_lights[i].shadow;
    }
    if (auto planned = plan_shadows(scene.shadow.value_or(ShadowSettings{}), prepared.lights, extent, prepared.view.eye, prepared.shadows);
        !planned) {
      return planned;
    }
  }
  prepared.occlusion.clear();
  if (scene.occlusion) {
    if (auto planned = plan_occlusion(*scene.occlusion, extent, prepared.view.eye, prepared.occlusion); !planned) {
      return planned;
    }
  }
  note_idle_catchers(prepared);
  prepared.ambient = linear_rgb(scene.ambient, prepared.transfer);
  prepared.fog = scene.fog ? std::optional(prepare_fog(*scene.fog, prepared.transfer)) : std::nullopt;
  const float alpha = scene.image.transparent ? 0 : scene.image.background_alpha;
  const Vec3f background = linear_rgb(scene.image.background, prepared.transfer) * alpha;
  prepared.background = {background.x, background.y, background.z, alpha};
  return {};
}

}  // namespace lustro
