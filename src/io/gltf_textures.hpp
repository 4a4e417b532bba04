// From the materials and pictures of a glTF file to materials of the classic equation with their textures.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <tuple>
#include <vector>

#include "io/gltf_mesh.hpp"
#include "io/texture_budget.hpp"
#include "lustro/scene.hpp"
#include "texture/texture.hpp"

namespace lustro {

/// A picture that was read, or why it was not.
struct GltfPicture {
  std::shared_ptr<const Texture> texture{};
  std::array<float, 4> lowest{}, highest{};  ///< of each channel
  std::optional<Error> error{};
};

/// What is read and made of one file's pictures, each once.
struct GltfTextures {
  using PictureKey = std::tuple<std::uint32_t, TextureContent, Transfer>;  ///< of `images`
  std::map<PictureKey, GltfPicture> pictures;
  std::map<std::vector<double>, std::shared_ptr<const Texture>> baked;
  std::uint64_t baked_texels = 0;
  TextureBudget budget{};
};

/// The materials that are drawn: classic_material() with its pictures, several of which are read at the same time.
///
/// Where a coefficient depends on one picture in a straight line, the picture itself is used (base colour alone; emission; normals; opacity
/// from the base colour's alpha, unless the material is opaque). Where several have a say, or a curve lies between (metal, roughness,
/// occlusion), a picture of the coefficient is made by bake_gltf(), once for each combination. What is the same in all texels is a number. A
/// picture that lies elsewhere on the surface than the one that leads (other coordinates, another transform) counts by its average, with a
/// note; so does one beyond 2^28 texels that are made.
///
/// A picture that is missing, broken or not read is left out with a note, and the factor alone drawn; of emission, nothing.
/// options   strict, transfer, threads, gltf_shading
/// errors    io, malformed, unsupported, limit: only with options.strict
[[nodiscard]] Result<std::vector<Material>> gltf_materials(const GltfFile& file, std::span<const GltfMaterialUse> uses,
                                                           const LoadOptions& options, GltfTextures& cache, Notes& notes);

}  // namespace lustro
