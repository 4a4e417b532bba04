// glTF's metal-and-roughness materials as coefficients of the classic equation.
#pragma once

#include <array>

#include "io/gltf_document.hpp"
#include "lustro/material.hpp"

namespace lustro {

/// The classic exponent of a roughness 0..1: n = 2 / alpha^2 - 2 with alpha = roughness^2, at most 10000. It gives (N.H)^n the width of the
/// microfacet distribution with that alpha.
/// source  Walter et al. 2007, Microfacet models for refraction, on alpha_p; Karis 2013 on alpha = roughness^2
[[nodiscard]] double shininess_of_roughness(double roughness);

/// What decides how one point of a surface reflects: a material's factors, times what its pictures say there.
struct GltfSurface {
  std::array<double, 3> base{1, 1, 1};
  double metallic = 1, roughness = 1;
  double ior = 1.5;
  double specular = 1;
  std::array<double, 3> specular_color{1, 1, 1};
  bool is_specular_glossiness = false;  ///< then `base` is the diffuse colour, and these two hold
  std::array<double, 3> glossy_specular{1, 1, 1};
  double glossiness = 1;
  double occlusion = 1;  ///< the share of light from everywhere that arrives
};

/// A material's factors alone.
[[nodiscard]] GltfSurface surface_of(const GltfMaterial& material);

/// What a surface reflects at normal incidence where it is no metal, of the colour and the strength that KHR_materials_specular and _ior state.
[[nodiscard]] std::array<double, 3> dielectric_specular(const GltfSurface& surface);

/// Coefficients in linear light.
struct ClassicSurface {
  std::array<double, 3> ambient{}, diffuse{}, specular{};
  double shininess = 0;
};

/// THE rule:
///   k_d = base (1 - metallic),  k_s = mix(0.04, base, metallic),  k_a = base occlusion,  n as above;
///   KHR_materials_pbrSpecularGlossiness: k_d = diffuse (1 - max(specular)), k_s = specular, k_a = both, roughness = 1 - glossiness.
[[nodiscard]] ClassicSurface classic_surface(const GltfSurface& surface);

/// The factors alone, without pictures: the rule, k_e = emissive, and KHR_materials_unlit as lighting `constant` with k_d = base. A material
/// that is not stated has the specification's defaults: a white, rough metal.
[[nodiscard]] Material classic_material(const GltfMaterial& material, GltfShading shading = GltfShading::classic);

}  // namespace lustro
