// Where the lighting equation is evaluated: once a face (flat), at its vertices (Gouraud 1971), or in the pixel (Phong 1975).
#include "reference/fragment.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/samples.hpp"
#include "shade/interpolation.hpp"

namespace lustro {
namespace {

// One triangle of a mesh with all that its shading asks for.
struct Face {
  const PreparedScene& scene;
  const Instance& instance;
  const ShadingMaterial& material;
  std::array<std::uint32_t, 3> vertices;
  float side;  // -1 where the back is seen and lit with its normals turned round

  [[nodiscard]] Vec3f position(std::size_t i) const { return instance.relative_from_object(instance.mesh->positions[vertices[i]]); }

  // A vertex's normal, world.
  [[nodiscard]] Vec3f normal(std::size_t i) const {
    const Vec3f n = instance.normal_from_object(instance.mesh->normals[vertices[i]]);
    return (instance.is_similarity ? n : normalize(n)) * side;
  }

  // A similarity turns all normals alike, so that they are interpolated as the mesh has them and turned once.
  [[nodiscard]] Vec3f normal_at(NormalInterpolation mode, const Vec3f& w) const {
    const Weights<float> weights{w.x, w.y, w.z};
    if (!instance.is_similarity) {
      return interpolate_normal<float>(mode, {normal(0), normal(1), normal(2)}, weights, face_normal());
    }
    const std::vector<Vec3f>& n = instance.mesh->normals;
    return instance.normal_from_object(
               interpolate_normal<float>(mode, {n[vertices[0]], n[vertices[1]], n[vertices[2]]}, weights, normalize(object_normal()))) *
           side;
  }

  // The face's normal of any length, from the object's own coordinates, where edges have all their digits; scaled, so that tiny faces do not
  // underflow.
  [[nodiscard]] Vec3f object_normal() const {
    const Vec3f& a = instance.mesh->positions[vertices[0]];
    const Vec3f ab = instance.mesh->positions[vertices[1]] - a;
    const Vec3f ac = instance.mesh->positions[vertices[2]] - a;
    const float size = std::max({std::abs(ab.x), std::abs(ab.y), std::abs(ab.z), std::abs(ac.x), std::abs(ac.y), std::abs(ac.z)});
    const float scale = 1.0F / size;
    return cross(ab * scale, ac * scale);
  }
  [[nodiscard]] Vec3f face_normal() const { return normalize(instance.normal_from_object(object_normal())) * side; }

  // Vertex colours multiply the ambient and the diffuse coefficient.
  [[nodiscard]] Vec3f tint(const Vec3f& w) const {
    if (instance.drawable->colors.empty()) {
      return {1, 1, 1};
    }
    return weighted_sum<float>(
        {instance.drawable->colors[vertices[0]], instance.drawable->colors[vertices[1]], instance.drawable->colors[vertices[2]]},
        {w.x, w.y, w.z});
  }
};

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

Evaluation evaluate(const Face& face, const Surface<float>& surface, const Vec3f& tint, bool wants_lights, ShadingExplanation* explanation) {
  const PreparedScene& scene = face.scene;
  Coefficients<float> k = face.material.coefficients;
  k.ambient = k.ambient * tint;
  k.diffuse = k.diffuse * tint;

  Evaluation result;
  if (wants_lights) {
    result.light_parts.resize(scene.lights.size());
  }
  result.terms = light_surface(face.material.lighting, surface, k, scene.ambient, scene.lights, scene.shading.normalized,
                               [&](std::size_t i, const Incident<float>& in, const LightTerms<float>& part) {
                                 if (wants_lights) {
                                   result.light_parts[i] = (part.ambient + part.diffuse) + part.specular;
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
                                                                  .ambient = part.ambient,
                                                                  .diffuse = part.diffuse,
                                                                  .specular = part.specular});
                                 }
                               });
  if (face.material.lighting != Lighting::constant) {
    result.scene_part = k.ambient * scene.ambient + k.emission;
  } else {
    result.scene_part = k.diffuse;  // unlit: no light brings it
  }
  if (explanation != nullptr) {
    explanation->position = vec_cast<float>(vec_cast<double>(surface.position) + scene.view.eye);
    explanation->normal = surface.normal;
    explanation->to_eye = surface.to_eye;
    explanation->ambient = result.terms.ambient;
    explanation->diffuse = result.terms.diffuse;
    explanation->specular = result.terms.specular;
    explanation->emission = result.terms.emission;
    explanation->scene_ambient = face.material.lighting == Lighting::constant ? Vec3f{} : k.ambient * scene.ambient;
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

Evaluation shade_flat(const Face& face, bool wants_lights, FragmentExplanation* explanation) {
  const Vec3f center = ((face.position(0) + face.position(1)) + face.position(2)) * (1.0F / 3.0F);
  const Surface<float> surface{center, face.face_normal(), face.scene.view.to_eye_from(center)};
  constexpr float kThird = 1.0F / 3.0F;
  return evaluate(face, surface, face.tint({kThird, kThird, kThird}), wants_lights, add_shading(explanation, 1));
}

// Clamped to 0..1 at the vertex: where the sum exceeds 1, all its terms are scaled down alike, so that they still sum to the colour.
void clamp_at_vertex(Evaluation& vertex) {
  const Vec3f sum = vertex.terms.sum();
  const auto scale = [](float c) { return c > 1.0F ? 1.0F / c : 1.0F; };
  const Vec3f by{scale(sum.x), scale(sum.y), scale(sum.z)};
  scale_terms(vertex.terms, by);
  vertex.scene_part = vertex.scene_part * by;
  for (Vec3f& part : vertex.light_parts) {
    part = part * by;
  }
}

Evaluation shade_gouraud(const Face& face, const Vec3f& weights, bool wants_lights, FragmentExplanation* explanation) {
  const std::array<float, 3> w{weights.x, weights.y, weights.z};
  Evaluation sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3f position = face.position(i);
    const Surface<float> surface{position, face.normal(i), face.scene.view.to_eye_from(position)};
    const Vec3f corner{i == 0 ? 1.0F : 0.0F, i == 1 ? 1.0F : 0.0F, i == 2 ? 1.0F : 0.0F};
    ShadingExplanation* shading = add_shading(explanation, w[i]);
    Evaluation vertex = evaluate(face, surface, face.tint(corner), wants_lights, shading);
    clamp_at_vertex(vertex);
    if (shading != nullptr) {
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
  return sum;
}

Evaluation shade_phong(const Face& face, const Vec3f& weights, const Surface<float>& surface, bool wants_lights,
                       FragmentExplanation* explanation) {
  return evaluate(face, surface, face.tint(weights), wants_lights, add_shading(explanation, 1));
}

}  // namespace

Fragment shade_fragment(const PreparedScene& scene, const ScreenTriangle& t, std::int32_t px, std::int32_t py, std::span<Vec3f> light_parts,
                        FragmentExplanation* explanation) {
  const Instance& instance = scene.instances[t.instance];
  Fragment fragment;
  fragment.instance = t.instance;
  fragment.triangle = t.id - instance.first_triangle;
  fragment.material = instance.material_of(fragment.triangle);
  const ShadingMaterial& material = scene.materials[fragment.material];
  const Face face{scene, instance, material, instance.mesh->triangles[fragment.triangle], scene.shading.two_sided && !t.is_front ? -1.0F : 1.0F};

  const Interpolants at = interpolants_at(scene.view, t, px, py);
  const float x = static_cast<float>(px) / kSubpixelUnits;
  const float y = static_cast<float>(py) / kSubpixelUnits;
  fragment.weights = at.weights;
  fragment.depth = depth_of(scene.view, at.depth_key);
  fragment.position = scene.view.point_at(x, y, fragment.depth);
  fragment.albedo = material.albedo * face.tint(at.weights);
  fragment.normal = scene.shading.interpolation == Interpolation::flat ? face.face_normal() : face.normal_at(scene.shading.normals, at.weights);

  Evaluation shading;
  switch (scene.shading.interpolation) {
    case Interpolation::flat:
      shading = shade_flat(face, !light_parts.empty(), explanation);
      break;
    case Interpolation::gouraud:
      shading = shade_gouraud(face, at.weights, !light_parts.empty(), explanation);
      break;
    case Interpolation::phong:
      shading =
          shade_phong(face, at.weights, {fragment.position, fragment.normal, scene.view.to_eye_at(x, y)}, !light_parts.empty(), explanation);
      break;
  }
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
