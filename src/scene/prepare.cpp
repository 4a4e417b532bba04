// From the scene as it is stated to the scene as it is drawn.
#include "scene/prepare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/srgb.hpp"
#include "math/trig.hpp"
#include "mesh/normals.hpp"

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

ShadingMaterial prepare_material(const Material& material, const Shading& shading, Transfer transfer) {
  ShadingMaterial result;
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
  result.coefficients = {keep(terms.ambient, result.stated.ambient), keep(terms.diffuse, result.stated.diffuse),
                         keep(terms.specular, result.stated.specular), keep(terms.emission, result.stated.emission), material.shininess};
  result.lighting = material.lighting.value_or(shading.lighting);
  return result;
}

ShadingLight prepare_light(const Light& light, const View& view, Transfer transfer) {
  ShadingLight result;
  result.type = light.type;
  result.position = vec_cast<float>(light.position - view.eye);
  const double size = std::max({std::abs(light.direction.x), std::abs(light.direction.y), std::abs(light.direction.z)});
  result.travel = size > 0 ? vec_cast<float>(normalize(light.direction * (1 / size))) : Vec3f{0, 0, -1};
  result.ambient = linear_rgb(light.ambient, transfer);
  result.diffuse = linear_rgb(light.diffuse, transfer);
  result.specular = linear_rgb(light.specular, transfer);
  const Attenuation& a = light.attenuation;
  result.attenuation = vec_cast<float>(Vec3d{a.constant, a.linear, a.quadratic});
  if (a.falloff) {  // 1, 1/d and 1/d^2 are polynomials and need no power
    const double p = *a.falloff;
    result.attenuation = p == 0 ? Vec3f{1, 0, 0} : (p == 1 ? Vec3f{0, 1, 0} : Vec3f{0, 0, 1});
    result.falloff = p == 0 || p == 1 || p == 2 ? 0 : static_cast<float>(p);
  }
  result.attenuation_limit = a.unclamped ? 1e30F : 1;
  const double cos_cutoff = cosine_deg(light.cutoff);
  result.cos_cutoff = static_cast<float>(cos_cutoff);
  if (light.beam) {
    const double cos_beam = cosine_deg(*light.beam);
    result.cos_beam = static_cast<float>(cos_beam);
    result.beam_scale = static_cast<float>(1 / (cos_beam - cos_cutoff));
  }
  result.exponent = static_cast<float>(light.exponent);
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

AffineRows to_rows(const std::array<Vec3d, 3>& rows, const Vec3d& translation) {
  AffineRows result;
  const std::array<double, 3> t{translation.x, translation.y, translation.z};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<double, 4> row{rows[i].x, rows[i].y, rows[i].z, t[i]};
    for (std::size_t j = 0; j < 4; ++j) {
      result.m[4 * i + j] = static_cast<float>(row[j]);
    }
  }
  return result;
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
  instance.relative_from_object = to_rows(rows, translation);
  instance.normal_from_object = to_rows(cofactors, {});

  // Image rows: the view's axes, scaled to pixels, times the matrix; all in double, rounded once.
  const std::array<Vec3d, 3> axes{view.right * view.pixels_per_unit, view.up * -view.pixels_per_unit, view.forward};
  std::array<Vec3d, 3> image_rows;
  std::array<double, 3> offset{};
  for (std::size_t i = 0; i < 3; ++i) {
    image_rows[i] = (rows[0] * axes[i].x + rows[1] * axes[i].y) + rows[2] * axes[i].z;
    offset[i] = dot(axes[i], translation);
  }
  instance.image_from_object = to_rows(image_rows, {offset[0], offset[1], offset[2]});
  return {};
}

// The reach of all vertices that triangles use: exact, and the same in every order.
void reach_of(const Scene& scene, std::span<const Vec3d> directions, std::span<double> reach) {
  std::fill(reach.begin(), reach.end(), -std::numeric_limits<double>::infinity());
  for (const Object& object : scene.objects) {
    if (!object.mesh) {
      continue;
    }
    const Mat4& m = object.matrix;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Vec3d& d = directions[i];  // dot(d, M p) = dot(M^T d, p)
      const Vec3d local{(m(0, 0) * d.x + m(1, 0) * d.y) + m(2, 0) * d.z, (m(0, 1) * d.x + m(1, 1) * d.y) + m(2, 1) * d.z,
                        (m(0, 2) * d.x + m(1, 2) * d.y) + m(2, 2) * d.z};
      const double offset = (m(0, 3) * d.x + m(1, 3) * d.y) + m(2, 3) * d.z;
      double farthest = -std::numeric_limits<double>::infinity();
      for (const auto& triangle : object.mesh->triangles) {
        for (const std::uint32_t vertex : triangle) {
          farthest = std::max(farthest, dot(local, vec_cast<double>(object.mesh->positions[vertex])));
        }
      }
      reach[i] = std::max(reach[i], farthest + offset);
    }
  }
}

Extent extent_of(const Scene& scene) {
  Extent extent;
  constexpr std::array kAxes{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}, Vec3d{-1, 0, 0}, Vec3d{0, -1, 0}, Vec3d{0, 0, -1}};
  std::array<double, 6> reach{};
  reach_of(scene, kAxes, reach);
  extent.bounds.upper = {reach[0], reach[1], reach[2]};
  extent.bounds.lower = {-reach[3], -reach[4], -reach[5]};
  extent.reach = [&scene](std::span<const Vec3d> directions, std::span<double> out) { reach_of(scene, directions, out); };
  return extent;
}

// A hand-built mesh is checked before anything reads through its indices.
Result<void> check_mesh(const Mesh& mesh, const std::string& where) {
  const std::size_t vertices = mesh.positions.size();
  const auto fits = [vertices](std::size_t size) { return size == 0 || size == vertices; };
  if (!fits(mesh.normals.size()) || !fits(mesh.uvs.size()) || !fits(mesh.colors.size())) {
    return fail(ErrorKind::usage, where,
                fmt::format("normals, uvs and colors must be empty or have one entry for each of the {} positions", vertices));
  }
  if (!std::all_of(mesh.positions.begin(), mesh.positions.end(), [](const Vec3f& p) { return is_finite(p); })) {
    return fail(ErrorKind::usage, where, "has a position that is not finite");
  }
  for (const auto& t : mesh.triangles) {
    if (std::max({t[0], t[1], t[2]}) >= vertices) {
      return fail(ErrorKind::usage, where, fmt::format("a triangle names vertex {}, but there are {}", std::max({t[0], t[1], t[2]}), vertices));
    }
  }
  if (!mesh.triangle_material.empty() && mesh.triangle_material.size() != mesh.triangles.size()) {
    return fail(ErrorKind::usage, where, "triangle_material must be empty or have one entry for each triangle");
  }
  const std::size_t materials = std::max<std::size_t>(mesh.materials.size(), 1);
  for (const std::uint32_t m : mesh.triangle_material) {
    if (m >= materials) {
      return fail(ErrorKind::usage, where, fmt::format("a triangle names material {}, but there are {}", m, materials));
    }
  }
  return {};
}

Result<void> add_object(PreparedScene& prepared, const Scene& scene, std::size_t index) {
  const Object& object = scene.objects[index];
  const std::string where = fmt::format("objects[{}]", index);
  prepared.object_names.push_back(!object.name.empty() ? object.name : object.source);
  Instance instance;
  instance.mesh = object.mesh;
  instance.object = static_cast<std::uint32_t>(index);
  if (instance.mesh->normals.empty() && scene.shading.interpolation != Interpolation::flat) {
    instance.mesh = std::make_shared<Mesh>(with_vertex_normals(
        *object.mesh, NormalOptions{.weights = scene.shading.vertex_normals, .crease_deg = scene.shading.crease.value_or(180)}));
  }
  if (auto placed = place(instance, object.matrix, prepared.view, where); !placed) {
    return placed;
  }
  instance.colors.reserve(instance.mesh->colors.size());
  for (const Vec3f& color : instance.mesh->colors) {
    instance.colors.push_back(linear_rgb(color, ColorSpace::encoded, prepared.transfer));
  }
  const std::size_t triangles = instance.mesh->triangles.size();
  if (triangles > 0xFFFFFFFEU - prepared.triangle_count) {
    return fail(ErrorKind::limit, where, "the scene has more than 4294967294 triangles");
  }
  instance.first_triangle = prepared.triangle_count;
  prepared.triangle_count += static_cast<std::uint32_t>(triangles);

  instance.first_material = static_cast<std::uint32_t>(prepared.materials.size());
  instance.has_own_materials = !object.material && !instance.mesh->materials.empty();
  if (instance.has_own_materials) {
    for (const Material& material : instance.mesh->materials) {
      prepared.materials.push_back(prepare_material(material, scene.shading, prepared.transfer));
    }
  } else {
    prepared.materials.push_back(prepare_material(object.material.value_or(Material{}), scene.shading, prepared.transfer));
  }
  prepared.instances.push_back(std::move(instance));
  return {};
}

// Objects have meshes, meshes are sound, matrices are affine and finite: whatever follows may rely on it.
Result<void> check_objects(const Scene& scene) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    const std::string where = fmt::format("objects[{}]", i);
    if (!object.mesh) {
      return fail(ErrorKind::usage, where, object.source.empty() ? "has no mesh" : fmt::format("its mesh \"{}\" is not loaded", object.source));
    }
    if (auto checked = check_mesh(*object.mesh, where + ".mesh"); !checked) {
      return checked;
    }
    const Mat4& m = object.matrix;
    if (!std::all_of(m.m.begin(), m.m.end(), [](double value) { return std::isfinite(value); })) {
      return fail(ErrorKind::usage, where + ".matrix", "holds a number that is not finite");
    }
    if (m(3, 0) != 0 || m(3, 1) != 0 || m(3, 2) != 0 || m(3, 3) != 1) {
      return fail(ErrorKind::usage, where + ".matrix", "the last row must be 0, 0, 0, 1");
    }
  }
  return {};
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
  if (auto checked = check_image(scene.image); !checked) {
    return tl::unexpected(checked.error());
  }
  if (auto checked = check_objects(scene); !checked) {
    return tl::unexpected(checked.error());
  }
  PreparedScene prepared;
  prepared.shading = scene.shading;
  prepared.transfer = scene.image.transfer;
  auto view = make_view(scene.camera, scene.image, extent_of(scene));
  if (!view) {
    return tl::unexpected(view.error());
  }
  prepared.view = *view;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (auto added = add_object(prepared, scene, i); !added) {
      return tl::unexpected(added.error());
    }
  }
  if (prepared.triangle_count == 0) {
    return fail(ErrorKind::empty, "", scene.objects.empty() ? "the scene has no objects" : "the scene has no triangles");
  }
  prepared.stated_lights = scene.lights ? *scene.lights : default_rig(prepared.view);
  for (const Light& light : prepared.stated_lights) {
    prepared.lights.push_back(prepare_light(light, prepared.view, prepared.transfer));
  }
  prepared.ambient = linear_rgb(scene.ambient, prepared.transfer);
  if (scene.fog) {
    prepared.fog = prepare_fog(*scene.fog, prepared.transfer);
  }
  const float alpha = scene.image.transparent ? 0 : scene.image.background_alpha;
  const Vec3f background = linear_rgb(scene.image.background, prepared.transfer) * alpha;
  prepared.background = {background.x, background.y, background.z, alpha};
  if (std::any_of(prepared.materials.begin(), prepared.materials.end(), [](const ShadingMaterial& m) { return m.stated.opacity < 1; })) {
    prepared.notes.push_back({"", "materials with an opacity below 1 are drawn opaque"});
  }
  return prepared;
}

}  // namespace lustro
