// The pictures of a glTF file, from wherever they lie.
#pragma once

#include <string>

#include "io/gltf_textures.hpp"

namespace lustro {

/// What messages call a picture: its file, its name, or `images[3]`.
[[nodiscard]] std::string picture_name(const GltfDocument& document, std::uint32_t image);

/// One of `images` as a texture: from a view, a data URI, or a file in the document's folder. Its format is told by its content.
/// returns  without a texture: the error, whose `where` is the file and the JSON path
[[nodiscard]] GltfPicture read_gltf_picture(const GltfFile& file, const GltfTextures::PictureKey& key, const ImageLimits& limits, int threads);

}  // namespace lustro
