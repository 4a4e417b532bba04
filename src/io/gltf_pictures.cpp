// See gltf_pictures.hpp.
#include "io/gltf_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <vector>

#include "image/decode_texture.hpp"
#include "io/gltf_uri.hpp"
#include "io/text.hpp"
#include "parallel/parallel_for.hpp"

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

/// GltfPicture::lowest and highest.
void set_range(GltfPicture& picture, int threads) {
  const Texture& texture = *picture.texture;
  using Texel = std::array<float, 4>;
  std::vector<std::array<Texel, 2>> rows(static_cast<std::size_t>(texture.height()));
  const auto widen = [](std::array<Texel, 2>& range, const Texel& low, const Texel& high) {
    for (std::size_t c = 0; c < 4; ++c) {
      range[0][c] = std::min(range[0][c], low[c]);
      range[1][c] = std::max(range[1][c], high[c]);
    }
  };
  parallel_for(rows.size(), threads, [&](std::size_t y) {
    const Texel first = texture.texel(0, 0, static_cast<int>(y));
    std::array<Texel, 2> range{first, first};
    for (int x = 1; x < texture.width(); ++x) {
      const Texel texel = texture.texel(0, x, static_cast<int>(y));
      widen(range, texel, texel);
    }
    rows[y] = range;
  });
  for (const auto& row : rows) {
    widen(rows[0], row[0], row[1]);
  }
  picture.lowest = rows[0][0];
  picture.highest = rows[0][1];
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
  set_range(picture, threads);
  return picture;
}

}  // namespace lustro
