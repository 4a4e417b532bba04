// See prepare_maps.hpp.
#include "scene/prepare_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/add_note.hpp"
#include "scene/ground.hpp"

namespace lustro {
namespace {

constexpr std::array kRows{
    MapRow{MapKind::ambient, texture_slot("ambient")},     MapRow{MapKind::diffuse, texture_slot("diffuse")},
    MapRow{MapKind::specular, texture_slot("specular")},   MapRow{MapKind::emission, texture_slot("emission")},
    MapRow{MapKind::shininess, texture_slot("shininess")}, MapRow{MapKind::decal, texture_slot("decal")},
    MapRow{MapKind::bump, texture_slot("bump")},           MapRow{MapKind::normal, texture_slot("normal")},
};
static_assert(kRows.size() == kMapKinds);

// What only the equation at the pixel itself can use.
bool is_of_the_pixel(MapKind kind) {
  return kind == MapKind::shininess || kind == MapKind::bump || kind == MapKind::normal;
}

bool is_of_a_term_that_is_off(MapKind kind, const TermSet& terms, Lighting lighting) {
  switch (kind) {
    case MapKind::ambient:
      return !terms.ambient;
    case MapKind::specular:
      return !terms.specular && lighting != Lighting::ggx;  // which takes it from the diffuse part, too
    case MapKind::emission:
      return !terms.emission;
    default:  // the diffuse one is the albedo, too
      return false;
  }
}

std::optional<std::string> why_not_drawn(const TextureUse& use, const Mesh& mesh) {
  if (!use.texture) {
    return "it has no texture";
  }
  if (use.uv_set > 1 || (use.uv_set == 0 ? mesh.uvs : mesh.uvs1).empty()) {
    return fmt::format("the mesh has no texture coordinates {}", use.uv_set);
  }
  return {};
}

std::string name_of(const Material& material) {
  return material.name.empty() ? "the material" : fmt::format("material \"{}\"", material.name);
}

}  // namespace

ShadingMap prepare_map(const TextureUse& use) {
  ShadingMap map;
  map.texels = use.texture->layout();
  map.width = static_cast<float>(use.texture->width());
  map.height = static_cast<float>(use.texture->height());
  map.sampler = use.sampler;
  map.sampler.anisotropy = std::clamp(use.sampler.anisotropy, 1, 16);
  map.sampler.lod_bias = std::isfinite(use.sampler.lod_bias) ? std::clamp(use.sampler.lod_bias, -16.0F, 16.0F) : 0.0F;
  map.uv_set = use.uv_set;
  map.channel = use.channel;
  map.leaves_outside = use.leaves_outside;
  map.uv_matrix = use.uv_matrix;
  map.has_matrix = use.uv_matrix != ShadingMap().uv_matrix;
  map.gain = use.gain;
  map.base = use.base;
  return map;
}

std::span<const MapRow> map_rows() {
  return kRows;
}

std::optional<TangentOptions> tangents_for(const Object& object, const Shading& shading) {
  if (shading.interpolation != Interpolation::phong) {
    return {};
  }
  const auto of = [](const Material& material) -> std::optional<TangentOptions> {
    const std::optional<TextureUse>& use = material.textures.normal;
    if (!use || !use->texture || material.textures.normal_is_object_space) {
      return {};
    }
    const std::array<float, 6>& m = use->uv_matrix;
    return TangentOptions{use->uv_set, {m[0], m[1], m[3], m[4]}};
  };
  if (object.material) {
    return of(*object.material);
  }
  for (const Material& material : object.mesh->materials) {
    if (const auto options = of(material)) {
      return options;
    }
  }
  return {};
}

ShadingMaps prepare_maps(const Material& material, const Mesh& mesh, const Shading& shading, const std::string& where, Notes& notes) {
  const MaterialTextures& textures = material.textures;
  ShadingMaps maps;
  maps.decal_on_ambient = shading.terms.ambient;
  maps.decal_on_diffuse = shading.terms.diffuse;
  maps.normal_is_object_space = textures.normal_is_object_space;
  for (const MapRow& row : kRows) {
    const std::optional<TextureUse>& use = textures.*row.slot->use;
    if (!use || is_of_a_term_that_is_off(row.kind, shading.terms, material.lighting.value_or(shading.lighting))) {
      continue;
    }
    const auto leave_out = [&](const std::string& why) {
      add_note(notes, {where, fmt::format("its {} map is left out: {}", row.slot->key, why)});
    };
    if (const std::optional<std::string> why = why_not_drawn(*use, mesh)) {
      leave_out(*why);
    } else if (shading.interpolation != Interpolation::phong && is_of_the_pixel(row.kind)) {
      leave_out("it needs interpolation phong");
    } else if (row.kind == MapKind::normal && !textures.normal_is_object_space && mesh.tangents.empty()) {
      leave_out("the mesh has no tangents");
    } else {
      maps[row.kind] = prepare_map(*use);
      maps.present |= 1U << static_cast<unsigned>(row.kind);
      maps.uv_sets |= 1U << use->uv_set;
    }
  }
  if (textures.displacement) {  // it is in the mesh by now, where it could be
    if (const std::optional<std::string> why = why_not_drawn(*textures.displacement, mesh)) {
      add_note(notes, {where, fmt::format("its displacement map is left out: {}", *why)});
    }
  }
  return maps;
}

ShadingOpacity prepare_opacity(const Material& material, const DrawableMesh& drawable, const std::string& where, Notes& notes) {
  ShadingOpacity result;
  if (catches_shadows(material)) {
    result.mode = AlphaMode::blend;
    result.opacity = 0;
    result.catches = std::clamp(material.opacity, 0.0F, 1.0F);
    return result;
  }
  if (material.alpha_mode == AlphaMode::opaque) {
    return result;
  }
  result.opacity = std::clamp(material.opacity, 0.0F, 1.0F);
  result.cutoff = material.alpha_cutoff;
  result.has_vertex_alphas = drawable.has_alphas;
  if (const std::optional<TextureUse>& use = material.textures.opacity) {
    if (const std::optional<std::string> why = why_not_drawn(*use, *drawable.mesh)) {
      add_note(notes, {where, fmt::format("its opacity map is left out: {}", *why)});
    } else {
      result.has_map = true;
      result.map = prepare_map(*use);
    }
  }
  result.has_halo = material.halo && (result.opacity < 1 || !result.is_uniform());
  const bool is_mask = material.alpha_mode == AlphaMode::mask;
  if (!result.is_uniform() || !(result.opacity >= (is_mask ? material.alpha_cutoff : 1.0F))) {
    result.mode = material.alpha_mode;
  }
  if (result.is_uniform() && (is_mask ? result.opacity < material.alpha_cutoff : !(result.opacity > 0))) {
    add_note(notes, {where, fmt::format("{} has the opacity {}: it is not seen", name_of(material), result.opacity)});
  }
  return result;
}

std::span<const std::string_view, 6> cube_face_names() {
  return kCubeFaces;
}

bool prepare_reflection(const Material& material, const Shading& shading, const std::string& where, Notes& notes, ShadingReflection& result) {
  const Lighting lighting = material.lighting.value_or(shading.lighting);
  if (!material.textures.reflection || !shading.terms.specular || lighting == Lighting::constant || lighting == Lighting::lambert) {
    return false;
  }
  const ReflectionMap& stated = *material.textures.reflection;
  const bool is_cube = stated.shape == ReflectionShape::cube;
  result.shape = stated.shape;
  result.present = 0;
  std::string missing;
  for (std::size_t i = 0; i < (is_cube ? result.faces.size() : 1); ++i) {
    if (!stated.faces[i] || !stated.faces[i]->texture) {
      missing += fmt::format("{}{}", missing.empty() ? "" : ", ", is_cube ? cube_face_names()[i] : "sphere");
      continue;
    }
    ShadingMap& face = result.faces[i] = prepare_map(*stated.faces[i]);
    face.leaves_outside = false;
    face.sampler.wrap_u = is_cube ? Wrap::clamp_to_edge : Wrap::repeat;  // how the pictures meet is the shape's matter
    face.sampler.wrap_v = Wrap::clamp_to_edge;
    result.present |= 1U << i;
  }
  if (result.present == 0) {
    add_note(notes, {where, "its reflection map is left out: it has no texture"});
  } else if (!missing.empty()) {
    add_note(notes, {where, fmt::format("its reflection map is black where it has no texture: {}", missing)});
  }
  return result.present != 0;
}

}  // namespace lustro
