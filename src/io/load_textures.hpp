// From the pictures that materials name to textures: each file is read once, several at the same time.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "io/texture_budget.hpp"
#include "lustro/image.hpp"
#include "lustro/material.hpp"
#include "lustro/result.hpp"
#include "lustro/scene.hpp"

namespace lustro {

/// A picture that was read, or why it was not.
struct TextureFile {
  std::shared_ptr<const Texture> texture{};
  int channels = 0;
  bool holds_normals = false;
  std::optional<Error> error{};
};

/// Pictures by file and by what their numbers mean. One for all meshes of a scene.
class TextureCache {
 public:
  /// file, TextureContent, Transfer, the channel that becomes the alpha of a decal
  using Key = std::tuple<std::string, TextureContent, Transfer, char>;
  std::map<Key, TextureFile> files;
  TextureBudget budget{};
};

/// Fills Material::textures from Material::maps, as use_of_map() reads them. `folder` is the mesh file's; names are looked for from the folder
/// of the MTL file that states them, by find_texture().
///
/// A picture that is missing, broken, not read or beyond the budget leaves its map out, so that the plain coefficient is drawn, with a note;
/// with options.strict it is an error. A `bump` picture that holds normals (holds_normals()) becomes the normal map, with a note, unless there
/// is one. options   transparency_is_tr, strict, transfer, threads errors    io, malformed, unsupported, limit: only with options.strict
[[nodiscard]] Result<Notes> load_map_textures(std::span<Material> materials, const std::filesystem::path& folder, const LoadOptions& options,
                                              TextureCache& cache);

/// Fills Material::textures from Material::stated_textures, whose files are found by find_texture() from `folder`, the scene file's; what is
/// filled already stays. A picture that cannot be had leaves its map out, with a note; with options.strict it is an error.
/// where  what notes and errors call the material
[[nodiscard]] Result<Notes> load_stated_textures(Material& material, const std::string& where, const std::filesystem::path& folder,
                                                 const LoadOptions& options, TextureCache& cache);

/// Whether a picture holds normals of a tangent frame and no heights: it has colours, on the whole more blue than red and green by a tenth, and
/// nine tenths of the texels that are looked at (64 x 64, evenly spread), read as 2 rgb - 1, point out of the surface with a length of 0.8
/// to 1.2.
[[nodiscard]] bool holds_normals(const Image& data);

}  // namespace lustro
