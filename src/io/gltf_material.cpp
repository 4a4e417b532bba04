// See gltf_material.hpp.
#include "io/gltf_material.hpp"

#include <algorithm>

namespace lustro {
namespace {

Color linear(const std::array<double, 3>& rgb) {
  return {{static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])}, ColorSpace::linear};
}

}  // namespace

double shininess_of_roughness(double roughness) {
  constexpr double kMost = 10000;
  const double alpha2 = (roughness * roughness) * (roughness * roughness);
  return alpha2 * (kMost + 2) <= 2 ? kMost : std::max(2 / alpha2 - 2, 0.0);
}

GltfSurface surface_of(const GltfMaterial& m) {
  GltfSurface surface;
  surface.base = {m.base[0], m.base[1], m.base[2]};
  surface.metallic = m.metallic;
  surface.roughness = m.roughness;
  surface.ior = m.ior;
  surface.specular = m.specular;
  surface.specular_color = m.specular_color;
  surface.is_specular_glossiness = m.is_specular_glossiness;
  surface.glossy_specular = m.glossy_specular;
  surface.glossiness = m.glossiness;
  return surface;
}

std::array<double, 3> dielectric_specular(const GltfSurface& surface) {
  const double ratio = surface.ior == 0 ? 1 : (surface.ior - 1) / (surface.ior + 1);
  std::array<double, 3> f0{};
  for (std::size_t i = 0; i < 3; ++i) {
    f0[i] = std::min(ratio * ratio * surface.specular_color[i], 1.0) * surface.specular;
  }
  return f0;
}

ClassicSurface classic_surface(const GltfSurface& s) {
  ClassicSurface classic;
  const std::array<double, 3> f0 = dielectric_specular(s);
  const double strongest = std::max({s.glossy_specular[0], s.glossy_specular[1], s.glossy_specular[2]});
  for (std::size_t i = 0; i < 3; ++i) {
    if (s.is_specular_glossiness) {  // which has no colour of the whole: both parts together
      classic.diffuse[i] = s.base[i] * (1 - strongest);
      classic.specular[i] = s.glossy_specular[i];
      classic.ambient[i] = std::min(classic.diffuse[i] + classic.specular[i], 1.0) * s.occlusion;
    } else {
      classic.diffuse[i] = s.base[i] * (1 - s.metallic);
      classic.specular[i] = f0[i] + (s.base[i] - f0[i]) * s.metallic;
      classic.ambient[i] = s.base[i] * s.occlusion;
    }
  }
  classic.shininess = shininess_of_roughness(s.is_specular_glossiness ? 1 - s.glossiness : s.roughness);
  return classic;
}

Material classic_material(const GltfMaterial& m, GltfShading shading) {
  Material result;
  result.name = m.name;
  const ClassicSurface classic = classic_surface(surface_of(m));
  result.ambient = linear(classic.ambient);
  result.diffuse = linear(classic.diffuse);
  result.specular = linear(classic.specular);
  result.shininess = static_cast<float>(classic.shininess);
  result.emission = linear({m.emissive[0] * m.emissive_strength, m.emissive[1] * m.emissive_strength, m.emissive[2] * m.emissive_strength});
  result.lighting = shading == GltfShading::ggx ? Lighting::ggx : Lighting::blinn_phong;
  if (m.is_unlit) {
    result.lighting = Lighting::constant;
    result.diffuse = linear({m.base[0], m.base[1], m.base[2]});
  }
  if (!m.is_double_sided) {
    result.cull = Culling::back;
  }
  using Alpha = GltfMaterial::Alpha;
  result.alpha_mode = m.alpha == Alpha::blend ? AlphaMode::blend : m.alpha == Alpha::mask ? AlphaMode::mask : AlphaMode::opaque;
  result.alpha_cutoff = static_cast<float>(m.alpha_cutoff);
  result.opacity = m.alpha == Alpha::opaque ? 1.0F : static_cast<float>(m.base[3]);
  return result;
}

}  // namespace lustro
