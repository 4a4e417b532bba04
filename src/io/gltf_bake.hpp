// Pictures of a glTF material, texel by texel, as pictures of classic coefficients.
#pragma once

#include <array>
#include <memory>

#include "io/gltf_material.hpp"
#include "texture/texture.hpp"

namespace lustro {

/// What a picture says of a surface. Some pictures say two things.
enum class GltfRole : std::uint8_t { base, metallic, roughness, specular, specular_color, glossy_specular, glossiness, occlusion };
inline constexpr std::size_t kGltfRoles = 8;

/// The coefficients that pictures can drive.
enum class GltfTarget : std::uint8_t { ambient, diffuse, specular, shininess };

/// A texel's word on a surface: factors are multiplied, occlusion counts by its strength.
void apply_texel(GltfSurface& surface, GltfRole role, const std::array<double, 4>& rgba, double occlusion_strength);

/// The coefficient of a target that is a colour.
[[nodiscard]] std::array<double, 3> color_of(const ClassicSurface& classic, GltfTarget target);

struct GltfBake {
  GltfTarget target = GltfTarget::diffuse;
  GltfSurface factors;
  double occlusion_strength = 1;
  double shininess_unit = 1;  ///< exponents are stored divided by it
  std::array<std::shared_ptr<const Texture>, kGltfRoles> pictures{};
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;  ///< what lies beside the edge where a smaller picture is enlarged
};

/// Texels that the bake has: as many as the largest of its pictures.
[[nodiscard]] std::uint64_t texels_of(const GltfBake& bake);

/// The rule of classic_surface() at every texel. The size is that of the picture with the most texels; the others are looked up bilinearly.
/// errors  limit
[[nodiscard]] Result<std::shared_ptr<const Texture>> bake_gltf(const GltfBake& bake, int threads);

}  // namespace lustro
