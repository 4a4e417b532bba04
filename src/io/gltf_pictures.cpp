// See gltf_pictures.hpp.
#include "io/gltf_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <span>

#include "image/decode_texture.hpp"
#include "io/gltf_uri.hpp"
#include "io/text.hpp"

namespace lustro {
namespace {

Result<std::shared_ptr<const Texture>> read_texture(const GltfFile& file, const GltfTextures::PictureKey& key, const ImageLimits& limits,
                                                    int threads) {
  const auto& [index, content, transfer] = key;
  const GltfImage& image = file.document.images[index];
  const std::string path = fmt::format("images[{}]", index);
  Result<FileBytes> owned;
  std::string_view bytes;
  std::string format_name = path;  // of TGA, the name alone tells
  if (image.uri != nullptr) {
    owned = read_gltf_uri(*image.uri, file.read);
    if (!owned) {
      const Error& error = owned.error();
      return file.fail_at(path + ".uri", error.where.empty() ? error.message : error.text(), error.kind);
    }
    bytes = owned->view();
    format_name = is_data_uri(*image.uri) ? path : picture_name(file.document, index);
  } else {
    bytes = file.views[image.view];
  }
  const Result<Image> pixels =
      decode_texture_image(std::as_bytes(std::span<const char>(bytes.data(), bytes.size())), format_name, content, transfer, limits);
  if (!pixels) {
    return file.fail_at(path, format_name == path ? pixels.error().message : pixels.error().text(), pixels.error().kind);
  }
  Result<std::shared_ptr<const Texture>> texture = make_texture(*pixels, threads);
  if (!texture) {
    return file.fail_at(path, texture.error().message, texture.error().kind);
  }
  return texture;
}

}  // namespace

std::string picture_name(const GltfDocument& document, std::uint32_t image) {
  const GltfImage& stated = document.images[image];
  if (stated.uri != nullptr && !is_data_uri(*stated.uri)) {
    if (const Result<std::string> path = confined_path(*stated.uri)) {
      return *path;
    }
  }
  return stated.name.empty() ? fmt::format("images[{}]", image) : stated.name;
}

GltfPicture read_gltf_picture(const GltfFile& file, const GltfTextures::PictureKey& key, const ImageLimits& limits, int threads) {
  GltfPicture picture;
  const std::string where = fmt::format("{}: images[{}]", file.name, std::get<0>(key));
  Result<std::shared_ptr<const Texture>> texture = within_memory(where, [&] { return read_texture(file, key, limits, threads); });
  if (!texture) {
    picture.error = std::move(texture).error();
    return picture;
  }
  picture.texture = *std::move(texture);
  picture.lowest = picture.highest = picture.texture->texel(0, 0, 0);
  for (int y = 0; y < picture.texture->height(); ++y) {
    for (int x = 0; x < picture.texture->width(); ++x) {
      const std::array<float, 4> texel = picture.texture->texel(0, x, y);
      for (std::size_t i = 0; i < 4; ++i) {
        picture.lowest[i] = std::min(picture.lowest[i], texel[i]);
        picture.highest[i] = std::max(picture.highest[i], texel[i]);
      }
    }
  }
  return picture;
}

}  // namespace lustro
