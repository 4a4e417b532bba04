// glTF's metal-and-roughness materials as coefficients of the classic equation.
#pragma once

#include "io/gltf_document.hpp"
#include "lustro/material.hpp"

namespace lustro {

/// The classic exponent of a roughness 0..1: n = 2 / alpha^2 - 2 with alpha = roughness^2, at most 10000. It gives (N.H)^n the width of the
/// microfacet distribution with that alpha.
/// source  Walter et al. 2007, Microfacet models for refraction, on alpha_p; Karis 2013 on alpha = roughness^2
[[nodiscard]] double shininess_of_roughness(double roughness);

/// What a surface reflects at normal incidence where it is no metal, of the colour and the strength that KHR_materials_specular and _ior state.
[[nodiscard]] std::array<double, 3> dielectric_specular(const GltfMaterial& material);

/// The factors alone, without textures:
///   k_d = base (1 - metallic),  k_s = mix(0.04, base, metallic),  k_a = base,  k_e = emissive,  n as above, lighting `blinn_phong`;
///   KHR_materials_pbrSpecularGlossiness: k_d = diffuse (1 - max(specular)), k_s = specular, k_a = both, roughness = 1 - glossiness;
///   KHR_materials_unlit: lighting `constant`, k_d = base.
/// A material that is not stated has the specification's defaults: a white, rough metal.
[[nodiscard]] Material classic_material(const GltfMaterial& material);

}  // namespace lustro
