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

std::array<double, 3> dielectric_specular(const GltfMaterial& material) {
  const double ratio = material.ior == 0 ? 1 : (material.ior - 1) / (material.ior + 1);
  std::array<double, 3> f0{};
  for (std::size_t i = 0; i < 3; ++i) {
    f0[i] = std::min(ratio * ratio * material.specular_color[i], 1.0) * material.specular;
  }
  return f0;
}

Material classic_material(const GltfMaterial& m) {
  Material result;
  result.name = m.name;
  const std::array<double, 3> base{m.base[0], m.base[1], m.base[2]};
  std::array<double, 3> diffuse{};
  std::array<double, 3> specular{};
  const std::array<double, 3> f0 = dielectric_specular(m);
  for (std::size_t i = 0; i < 3; ++i) {
    diffuse[i] = m.is_specular_glossiness ? base[i] * (1 - std::max({m.glossy_specular[0], m.glossy_specular[1], m.glossy_specular[2]}))
                                          : base[i] * (1 - m.metallic);
    specular[i] = m.is_specular_glossiness ? m.glossy_specular[i] : f0[i] + (base[i] - f0[i]) * m.metallic;
  }
  result.ambient = linear(base);
  if (m.is_specular_glossiness) {  // which has no colour of the whole: both parts together
    result.ambient =
        linear({std::min(diffuse[0] + specular[0], 1.0), std::min(diffuse[1] + specular[1], 1.0), std::min(diffuse[2] + specular[2], 1.0)});
  }
  result.diffuse = linear(diffuse);
  result.specular = linear(specular);
  result.emission = linear({m.emissive[0] * m.emissive_strength, m.emissive[1] * m.emissive_strength, m.emissive[2] * m.emissive_strength});
  result.shininess = static_cast<float>(shininess_of_roughness(m.is_specular_glossiness ? 1 - m.glossiness : m.roughness));
  result.lighting = Lighting::blinn_phong;
  if (m.is_unlit) {
    result.lighting = Lighting::constant;
    result.diffuse = linear(base);
  }
  const bool is_cut = m.alpha == GltfMaterial::Alpha::mask && !m.base_map && m.base[3] < m.alpha_cutoff;
  result.opacity = m.alpha == GltfMaterial::Alpha::blend ? static_cast<float>(m.base[3]) : is_cut ? 0.0F : 1.0F;
  return result;
}

}  // namespace lustro
