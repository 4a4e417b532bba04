// Where the lighting equation is evaluated: once a face (flat), at its vertices (Gouraud 1971), or in the pixel (Phong 1975).
#include "reference/fragment.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "reference/face.hpp"
#include "reference/visibilities.hpp"
#include "scene/mapped_surface.hpp"
#include "scene/prepare_maps.hpp"
#include "scene/samples.hpp"
#include "shade/texturing.hpp"

namespace lustro {
namespace {

void scale_terms(Terms<float>& terms, const Vec3f& by) {
  terms.ambient = terms.ambient * by;
  terms.diffuse = terms.diffuse * by;
  terms.specular = terms.specular * by;
  terms.emission = terms.emission * by;
}

// One evaluation of the equation, and what it says of itself.
struct Evaluation {
  Terms<float> terms;
  Vec3f scene_part;
  std::vector<Vec3f> light_parts;  // filled when asked for
};

// The pixel's maps.
struct Mapped {
  WeightSlopes<float> slopes{};
  std::array<Footprint<float>, 2> at{};
  MapFactors<float> factors;
  DirectionSlopes<float> mirrored{};  // the view, where there is a reflection map
  Vec3f reflection;                   // what is seen there
};

Coefficients<float> tinted(const Face& face, const Vec3f& tint) {
  Coefficients<float> k = face.material.coefficients;
  k.ambient = k.ambient * tint;
  k.diffuse = k.diffuse * tint;
  return k;
}

// seen   visibilities_at() the pixel, wherever the light is evaluated
// after  maps of a pixel that are laid upon the light of a face or a vertex, or null: of its parts alone, the terms are left as they are
template <class N>
Evaluation evaluate(const Face& face, const Surface<float>& surface, const Coefficients<float, N>& k, std::span<const float> seen,
                    const Mapped* after, bool wants_lights, ShadingExplanation* explanation) {
  const PreparedScene& scene = face.scene;
  Evaluation result;
  if (wants_lights) {
    result.light_parts.resize(scene.lights.size());
  }
  result.terms = light_surface(
      face.material.lighting, surface, k, scene.surrounding_light(), scene.lights, scene.shading.normalized,
      [seen](std::size_t i) { return seen[i]; },
      [&](std::size_t i, const Incident<float>& in, const LightTerms<float>& part) {
        if (wants_lights) {
          LightTerms<float> mapped = part;
          if (after != nullptr) {
            mapped = {part.ambient * after->factors.ambient, part.diffuse * after->factors.diffuse, part.specular * after->factors.specular};
          }
          result.light_parts[i] = (mapped.ambient + mapped.diffuse) + mapped.specular;
        }
        if (explanation != nullptr) {
          const Vec3f& l = in.to_light;
          const Vec3f sum = l + surface.to_eye;
          explanation->lights.push_back({.light = static_cast<int>(i),
                                         .name = scene.stated_lights[i].name,
                                         .to_light = l,
                                         .reflected = reflect_about(surface.normal, l),
                                         .half = sum * (1.0F / std::max(length(sum), 1e-15F)),
                                         .distance = in.distance,
                                         .n_dot_l = dot(surface.normal, l),
                                         .r_dot_v = r_dot_v(surface, l),
                                         .n_dot_h = n_dot_h(surface, l),
                                         .attenuation = in.attenuation,
                                         .spot = in.spot,
                                         .visibility = in.visibility,
                                         .light_ambient = scene.lights[i].ambient,
                                         .light_diffuse = scene.lights[i].diffuse,
                                         .light_specular = scene.lights[i].specular,
                                         .ambient = part.ambient,
                                         .diffuse = part.diffuse,
                                         .specular = part.specular});
        }
      });
  const float openness = seen[scene.lights.size()];
  Terms<float> unlit = unlit_terms(face.material.lighting, surface.normal, k, scene.surrounding_light(), openness);
  if (after != nullptr) {
    modulate(after->factors, unlit);
  }
  result.scene_part = (unlit.ambient + unlit.diffuse) + unlit.emission;
  if (explanation != nullptr) {
    explanation->position = vec_cast<float>(vec_cast<double>(surface.position) + scene.view.eye);
    explanation->normal = surface.normal;
    explanation->to_eye = surface.to_eye;
    explanation->k_ambient = k.ambient;
    explanation->k_diffuse = k.diffuse;
    explanation->k_specular = k.specular;
    explanation->k_emission = k.emission;
    explanation->shininess = k.shininess.n;
    explanation->ambient = result.terms.ambient;
    explanation->diffuse = result.terms.diffuse;
    explanation->specular = result.terms.specular;
    explanation->emission = result.terms.emission;
    explanation->openness = openness;
    explanation->scene_ambient = face.material.lighting == Lighting::constant ? Vec3f{} : k.ambient * scene.ambient * openness;
    explanation->from_environment =
        scene.around && face.material.lighting != Lighting::constant ? light_around(*scene.around, surface.normal) : Vec3f{};
    explanation->environment = k.diffuse * explanation->from_environment * openness;
  }
  return result;
}

ShadingExplanation* add_shading(FragmentExplanation* explanation, float weight) {
  if (explanation == nullptr) {
    return nullptr;
  }
  explanation->shadings.push_back({});
  explanation->shadings.back().weight = weight;
  return &explanation->shadings.back();
}

// The maps that multiply the light of a face or its vertices: all of them, unless there is a decal. That one covers coefficients, so with it the
// light is worked out for the pixel's own; classic light is linear in them, so nothing else changes.
const Mapped* maps_after_light(const Face& face, const Mapped* mapped) {
  return face.material.maps.has(MapKind::decal) ? nullptr : mapped;
}

void explain_maps_after_light(const Mapped& after, FragmentExplanation* explanation) {
  if (explanation != nullptr) {
    explanation->maps_ambient = after.factors.ambient;
    explanation->maps_diffuse = after.factors.diffuse;
    explanation->maps_specular = after.factors.specular;
    explanation->maps_emission = after.factors.emission;
  }
}

Evaluation shade_flat(const Face& face, std::span<const float> seen, const Mapped* mapped, bool wants_lights, FragmentExplanation* explanation) {
  const Vec3f center = ((face.position(0) + face.position(1)) + face.position(2)) * (1.0F / 3.0F);
  const Surface<float> surface{center, face.face_normal(), face.scene.view.to_eye_from(center)};
  constexpr float kThird = 1.0F / 3.0F;
  Coefficients<float> k = tinted(face, face.tint({kThird, kThird, kThird}));
  const Mapped* after = maps_after_light(face, mapped);
  if (after != mapped) {
    apply_factors(face.material.maps, mapped->factors, k);
  }
  Evaluation shading = evaluate(face, surface, k, seen, after, wants_lights, add_shading(explanation, 1));
  if (after != nullptr) {
    explain_maps_after_light(*after, explanation);
    modulate(after->factors, shading.terms);
  }
  return shading;
}

// Clamped to 0..1 at the vertex: where the sum exceeds 1, all its terms are scaled down alike, so that they still sum to the colour.
Vec3f clamp_at_vertex(const Terms<float>& terms) {
  const Vec3f sum = terms.sum();
  const auto scale = [](float c) { return c > 1.0F ? 1.0F / c : 1.0F; };
  return {scale(sum.x), scale(sum.y), scale(sum.z)};
}

void scale_vertex(Evaluation& vertex, const Vec3f& by) {
  scale_terms(vertex.terms, by);
  vertex.scene_part = vertex.scene_part * by;
  for (Vec3f& part : vertex.light_parts) {
    part = part * by;
  }
}

Evaluation shade_gouraud(const Face& face, const Vec3f& weights, std::span<const float> seen, const Mapped* mapped, bool wants_lights,
                         FragmentExplanation* explanation) {
  const std::array<float, 3> w{weights.x, weights.y, weights.z};
  const Mapped* after = maps_after_light(face, mapped);
  Evaluation sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3f position = face.position(i);
    const Surface<float> surface{position, face.normal(i), face.scene.view.to_eye_from(position)};
    const Vec3f corner{i == 0 ? 1.0F : 0.0F, i == 1 ? 1.0F : 0.0F, i == 2 ? 1.0F : 0.0F};
    ShadingExplanation* shading = add_shading(explanation, w[i]);
    Coefficients<float> k = tinted(face, face.tint(corner));
    Evaluation vertex = evaluate(face, surface, k, seen, after, wants_lights, after == mapped ? shading : nullptr);
    const Vec3f by = clamp_at_vertex(vertex.terms);  // before all maps
    if (after != mapped) {
      apply_factors(face.material.maps, mapped->factors, k);
      vertex = evaluate(face, surface, k, seen, nullptr, wants_lights, shading);
    }
    scale_vertex(vertex, by);
    if (shading != nullptr) {
      shading->clamp = by;
      shading->ambient = vertex.terms.ambient;
      shading->diffuse = vertex.terms.diffuse;
      shading->specular = vertex.terms.specular;
      shading->emission = vertex.terms.emission;
    }
    const auto add = [&](Vec3f& to, const Vec3f& value) { to = i == 0 ? value * w[i] : to + value * w[i]; };
    add(sum.terms.ambient, vertex.terms.ambient);
    add(sum.terms.diffuse, vertex.terms.diffuse);
    add(sum.terms.specular, vertex.terms.specular);
    add(sum.terms.emission, vertex.terms.emission);
    add(sum.scene_part, vertex.scene_part);
    sum.light_parts.resize(vertex.light_parts.size());
    for (std::size_t l = 0; l < vertex.light_parts.size(); ++l) {
      add(sum.light_parts[l], vertex.light_parts[l]);
    }
  }
  if (after != nullptr) {
    explain_maps_after_light(*after, explanation);
    modulate(after->factors, sum.terms);
  }
  return sum;
}

Evaluation shade_phong(const Face& face, const Vec3f& weights, const Surface<float>& surface, std::span<const float> seen, const Mapped* mapped,
                       bool wants_lights, FragmentExplanation* explanation) {
  ShadingExplanation* shading = add_shading(explanation, 1);
  Coefficients<float> k = tinted(face, face.tint(weights));
  if (mapped == nullptr) {
    return evaluate(face, surface, k, seen, nullptr, wants_lights, shading);
  }
  const ShadingMaps& maps = face.material.maps;
  apply_factors(maps, mapped->factors, k);
  if (!maps.has(MapKind::shininess)) {
    return evaluate(face, surface, k, seen, nullptr, wants_lights, shading);
  }
  const Coefficients<float, LaneExponent<float>> varying{k.ambient, k.diffuse, k.specular, k.emission,
                                                         textured_shininess<TexelReader>(maps, mapped->at, k.shininess.n)};
  return evaluate(face, surface, varying, seen, nullptr, wants_lights, shading);
}

// k_s times the reflection map: what surrounds the scene is seen at the pixel, whatever the interpolation, after all clamping.
Vec3f add_reflection(const Face& face, const Mapped& mapped, Evaluation& shading) {
  const Vec3f part = reflected_surroundings(face.material.coefficients.specular, mapped.factors, mapped.reflection);
  shading.terms.specular += part;
  shading.scene_part += part;
  return part;
}

void explain_reflection(const Face& face, const Mapped& mapped, FragmentExplanation& explanation) {
  const ShadingReflection& map = face.material.reflection;
  const bool is_cube = map.shape == ReflectionShape::cube;
  const std::size_t i = is_cube ? static_cast<std::size_t>(cube_face(mapped.mirrored.at)) : 0;
  const Footprint<float> seen = is_cube ? on_cube_face(i, mapped.mirrored) : on_sphere(mapped.mirrored);
  MapExplanation part;
  part.map = is_cube ? "reflection." + std::string(cube_face_names()[i]) : "reflection";
  part.u = seen.u;
  part.v = seen.v;
  if (map.has_face(i)) {
    const ShadingMap& face_map = map.faces[i];
    const Footprint<float> at = on_map(face_map, seen);
    const MapValue<float> value = look_up<TexelReader>(face_map, seen);
    const auto& stated = face.material.stated.textures.reflection;
    part.name = stated && stated->faces[i] ? stated->faces[i]->name : "environment";  // scene/surroundings.hpp
    part.u = at.u;
    part.v = at.v;
    part.level_of_detail = size_of_footprint(face_map.sampler, face_map.width, face_map.height, at).lod;
    part.value = {value.rgb.x, value.rgb.y, value.rgb.z, value.alpha};
  }
  explanation.maps.push_back(std::move(part));
}

// The coefficients as the maps leave them, and what each map says.
void explain_maps(const Face& face, const Mapped& mapped, FragmentExplanation& explanation) {
  const ShadingMaps& maps = face.material.maps;
  for (const MapRow& row : map_rows()) {
    if (!maps.has(row.kind)) {
      continue;
    }
    const ShadingMap& map = maps[row.kind];
    const Footprint<float> at = on_map(map, mapped.at[map.uv_set]);
    const MapValue<float> value = look_up<TexelReader>(map, mapped.at[map.uv_set]);
    explanation.maps.push_back({.map = std::string(row.slot->key),
                                .name = (face.material.stated.textures.*row.slot->use)->name,
                                .u = at.u,
                                .v = at.v,
                                .level_of_detail = size_of_footprint(map.sampler, map.width, map.height, at).lod,
                                .value = {value.rgb.x, value.rgb.y, value.rgb.z, value.alpha},
                                .applies = value.applies > 0});
  }
  if (maps.reflects) {
    explain_reflection(face, mapped, explanation);
  }
  Material& k = explanation.coefficients;
  Coefficients<float> textured{k.ambient.rgb, k.diffuse.rgb, k.specular.rgb, k.emission.rgb, k.shininess};
  apply_factors(maps, mapped.factors, textured);
  k.ambient.rgb = textured.ambient;
  k.diffuse.rgb = textured.diffuse;
  k.specular.rgb = textured.specular;
  k.emission.rgb = textured.emission;
  if (maps.has(MapKind::shininess)) {
    k.shininess = textured_shininess<TexelReader>(maps, mapped.at, k.shininess).n;
  }
}

}  // namespace

Fragment shade_fragment(const PreparedScene& scene, const ScreenTriangle& t, std::int32_t px, std::int32_t py, std::span<Vec3f> light_parts,
                        FragmentExplanation* explanation) {
  const Face face = face_of(scene, t);
  const Instance& instance = face.instance;
  const ShadingMaterial& material = face.material;
  Fragment fragment;
  fragment.instance = t.instance;
  fragment.triangle = t.id - instance.first_triangle;
  fragment.material = instance.material_of(fragment.triangle);

  const Interpolants at = interpolants_at(scene.view, t, px, py);
  const float x = static_cast<float>(px) / kSubpixelUnits;
  const float y = static_cast<float>(py) / kSubpixelUnits;
  fragment.weights = at.weights;
  fragment.depth = depth_of(scene.view, at.depth_key);
  fragment.position = scene.view.point_at(x, y, fragment.depth);
  fragment.albedo = material.albedo * face.tint(at.weights);
  fragment.normal = scene.shading.interpolation == Interpolation::flat ? face.face_normal() : face.normal_at(scene.shading.normals, at.weights);

  std::optional<Mapped> maps;
  if (material.maps.has_any()) {
    const Weights<float> w{at.weights.x, at.weights.y, at.weights.z};
    maps.emplace().slopes = weight_slopes_at(scene.view, t, px, py);
    maps->at = footprints_on<float>(face, w, maps->slopes);
    maps->factors = map_factors<TexelReader>(material.maps, maps->at);
    fragment.albedo = textured_albedo(material.maps, maps->factors, fragment.albedo);
    if (material.maps.changes_normal()) {
      fragment.normal = mapped_normal<TexelReader>(face, scene.shading.normals, w, maps->slopes, maps->at, fragment.normal);
    }
    if (material.maps.reflects) {
      maps->mirrored = mirrored_view_on(face, w, maps->slopes, x, y, fragment.normal);
      maps->reflection = look_up_reflection<TexelReader>(material.reflection, maps->mirrored);
    }
  }
  const Mapped* mapped = maps ? &*maps : nullptr;

  const bool is_lit_here = scene.shading.interpolation == Interpolation::phong;
  const std::vector<float> seen = visibilities_at(face, fragment.position, is_lit_here ? fragment.normal : face.face_normal());
  Evaluation shading;
  switch (scene.shading.interpolation) {
    case Interpolation::flat:
      shading = shade_flat(face, seen, mapped, !light_parts.empty(), explanation);
      break;
    case Interpolation::gouraud:
      shading = shade_gouraud(face, at.weights, seen, mapped, !light_parts.empty(), explanation);
      break;
    case Interpolation::phong:
      shading = shade_phong(face, at.weights, {fragment.position, fragment.normal, scene.view.to_eye_at(x, y)}, seen, mapped,
                            !light_parts.empty(), explanation);
      break;
  }
  const Vec3f reflection = material.maps.reflects ? add_reflection(face, *mapped, shading) : Vec3f{};
  float clear = 1;  // the fog's factor
  if (scene.fog) {
    clear = fog_factor(*scene.fog, length(fragment.position));
    scale_terms(shading.terms, {clear, clear, clear});
    shading.scene_part = shading.scene_part * clear;
    fragment.fog = scene.fog->color * (1.0F - clear);
  }
  fragment.terms = shading.terms;
  fragment.scene_part = shading.scene_part;
  for (std::size_t l = 0; l < light_parts.size(); ++l) {
    light_parts[l] = scene.fog ? shading.light_parts[l] * clear : shading.light_parts[l];
  }

  if (explanation != nullptr) {
    explanation->object = static_cast<int>(instance.object);
    explanation->object_name = scene.object_names[instance.object];
    explanation->triangle = static_cast<int>(fragment.triangle);
    explanation->material = static_cast<int>(fragment.material);
    explanation->material_name = material.stated.name;
    explanation->front = t.is_front;
    explanation->x = x;
    explanation->y = y;
    explanation->depth = fragment.depth;
    explanation->barycentrics = fragment.weights;
    explanation->position = vec_cast<float>(vec_cast<double>(fragment.position) + scene.view.eye);
    explanation->lighting = material.lighting;
    explanation->coefficients = material.stated;
    if (mapped != nullptr) {
      explain_maps(face, *mapped, *explanation);
    }
    explanation->reflection = reflection;
    explanation->ambient = fragment.terms.ambient;
    explanation->diffuse = fragment.terms.diffuse;
    explanation->specular = fragment.terms.specular;
    explanation->emission = fragment.terms.emission;
    explanation->fog = fragment.fog;
    explanation->fog_factor = clear;
  }
  return fragment;
}

}  // namespace lustro
