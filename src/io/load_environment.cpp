// An environment's picture is read as a texture's is, but stays as it is: it has no mip levels.
#include "io/load_environment.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "image/decode_texture.hpp"
#include "io/find_file.hpp"
#include "io/read_file.hpp"

namespace lustro {
namespace {

constexpr const char* kWhere = "environment.file";

Image rgb_of(const Image& image) {
  Image rgb(image.width, image.height, 3);
  const auto step = static_cast<std::size_t>(image.channels);
  for (std::size_t from = 0, to = 0; to < rgb.pixels.size(); from += step, to += 3) {
    for (std::size_t c = 0; c < 3; ++c) {
      const float value = image.pixels[from + (step < 3 ? 0 : c)];
      rgb.pixels[to + c] = value > 0 ? std::min(value, 1e30F) : 0;  // light is never negative, nor what is no number
    }
  }
  return rgb;
}

}  // namespace

Result<std::shared_ptr<const Image>> read_environment(const std::filesystem::path& file, Transfer transfer) {
  const Result<FileBytes> bytes = read_file(file);
  if (!bytes) {
    return tl::unexpected(bytes.error());
  }
  const auto image = decode_texture_image(std::as_bytes(std::span(bytes->view())), file.string(), TextureContent::color, transfer);
  if (!image) {
    return tl::unexpected(image.error());
  }
  return std::make_shared<const Image>(rgb_of(*image));
}

Result<Notes> load_environment(Environment& environment, const std::filesystem::path& folder, const LoadOptions& options) {
  Notes notes;
  if (environment.file.empty() || environment.picture != nullptr) {
    return notes;
  }
  const Result<FoundFile> found = find_texture(folder, environment.file);
  if (!found) {
    return fail(found.error().kind, kWhere, "the picture " + found.error().message);
  }
  if (!found->note.empty()) {
    notes.push_back({kWhere, "the picture " + found->note});
  }
  tell(options.on_file, found->path);
  auto picture = read_environment(found->path, options.transfer);
  if (!picture) {
    return fail(picture.error().kind, kWhere, picture.error().text());
  }
  environment.picture = *std::move(picture);
  return notes;
}

}  // namespace lustro
