// Requests first, in the order of the materials; then the files, in parallel; then what each request makes of its file, in order again.
#include "io/load_textures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "image/decode_texture.hpp"
#include "io/find_file.hpp"
#include "io/map_texture.hpp"
#include "io/note_book.hpp"
#include "io/read_file.hpp"
#include "io/text.hpp"
#include "texture/slots.hpp"

namespace lustro {
namespace {

namespace fs = std::filesystem;

/// Notes by the file that they are about, in the order of those files.
class BookShelf {
 public:
  void add(const std::string& where, const std::string& message) {
    auto book = std::ranges::find(books_, where, &std::pair<std::string, NoteBook>::first);
    if (book == books_.end()) {
      books_.emplace_back(where, NoteBook(where));
      book = books_.end() - 1;
    }
    book->second.add(0, message);
  }
  [[nodiscard]] Notes notes() const {
    Notes all;
    for (const auto& [where, book] : books_) {
      const Notes notes = book.notes();
      all.insert(all.end(), notes.begin(), notes.end());
    }
    return all;
  }

 private:
  std::vector<std::pair<std::string, NoteBook>> books_;
};

struct Request {
  Material* material = nullptr;
  MapUse map;
  std::string where;      // the MTL file, or the material of a scene
  std::string statement;  // map_Kd; diffuse
  TextureCache::Key key{};
};

/// An alpha of the channel r, g, b or l (luminance).
Image with_alpha_of(const Image& image, char channel) {
  Image out(image.width, image.height, 4);
  const auto step = static_cast<std::size_t>(image.channels);
  for (std::size_t from = 0, to = 0; from < image.pixels.size(); from += step, to += 4) {
    const auto value = [&](std::size_t c) { return image.pixels[from + (step < 3 ? 0 : c)]; };
    for (std::size_t c = 0; c < 3; ++c) {
      out.pixels[to + c] = value(c);
    }
    const float luminance = step < 3 ? value(0) : 0.2126F * value(0) + 0.7152F * value(1) + 0.0722F * value(2);
    out.pixels[to + 3] = channel == 'r' ? value(0) : channel == 'g' ? value(1) : channel == 'b' ? value(2) : luminance;
  }
  return out;
}

Result<TextureFile> read_texture(const TextureCache::Key& key, const ImageLimits& limits, int threads) {
  const auto& [name, content, transfer, alpha] = key;
  const Result<FileBytes> bytes = read_file(name);
  if (!bytes) {
    return tl::unexpected(bytes.error());
  }
  auto image = decode_texture_image(std::as_bytes(std::span(bytes->view())), name, content, transfer, limits);
  if (!image) {
    return tl::unexpected(std::move(image).error());
  }
  TextureFile file;
  file.channels = image->channels;
  file.holds_normals = content == TextureContent::data && holds_normals(*image);
  auto texture = make_texture(alpha != 0 ? with_alpha_of(*image, alpha) : *image, threads);
  if (!texture) {
    return fail(texture.error().kind, name, texture.error().message);
  }
  file.texture = *std::move(texture);
  return file;
}

/// A request for a file of that name; what is not there is a note, or an error with `strict`.
Result<void> add_request(Request request, const fs::path& folder, const std::string& name, const LoadOptions& options, BookShelf& books,
                         std::vector<Request>& requests) {
  const Result<FoundFile> found = find_texture(folder, name);
  if (!found) {
    const std::string message = fmt::format("{}: the texture {}", request.statement, found.error().message);
    if (options.strict) {
      return fail(found.error().kind, request.where, message);
    }
    books.add(request.where, message + "; drawn without it");
    return {};
  }
  if (!found->note.empty()) {
    books.add(request.where, fmt::format("{}: the texture {}", request.statement, found->note));
  }
  tell(options.on_file, found->path);
  request.key = {identity_of(found->path), request.map.slot->content, options.transfer, request.map.alpha_of_decal};
  requests.push_back(std::move(request));
  return {};
}

/// Reads what the cache does not have, several files at the same time.
void read_files(const std::vector<Request>& requests, int threads, TextureCache& cache) {
  std::vector<std::pair<const TextureCache::Key*, TextureFile*>> jobs;
  for (const Request& request : requests) {
    const auto [entry, is_new] = cache.files.try_emplace(request.key);
    if (is_new) {
      jobs.emplace_back(&entry->first, &entry->second);
    }
  }
  const auto read = [&](std::size_t i, int own_threads) {
    const auto& [key, file] = jobs[i];
    const std::string& name = std::get<0>(*key);
    auto texture = within_memory(name, [&, key = key] { return read_texture(*key, cache.budget.limits(), own_threads); });
    if (texture) {
      *file = *std::move(texture);
    } else {
      file->error = std::move(texture).error();
    }
  };
  TextureBudget::in_order(jobs.size(), threads, read, [&](std::size_t i) {
    const auto& [key, file] = jobs[i];
    if (!file->error) {
      file->error = cache.budget.take(*file->texture, std::get<0>(*key));
    }
    if (file->error) {
      file->texture = nullptr;
    }
  });
}

/// Where the use of a texture stands in its material; null for a reflection map beside one of the other shape.
std::optional<TextureUse>* place_of(Material& material, const MapUse& map) {
  if (map.slot->use != nullptr) {
    return &(material.textures.*map.slot->use);
  }
  std::optional<ReflectionMap>& reflection = material.textures.reflection;
  if (!reflection) {
    reflection.emplace().shape = map.shape;
  }
  return reflection->shape == map.shape ? &reflection->faces[map.face] : nullptr;
}

/// What only the picture decides: which channel is meant, and whether a bump map holds heights.
void settle(Request& request, const TextureFile& file, BookShelf& books) {
  TextureUse& use = request.map.use;
  use.texture = file.texture;
  const std::string shown_name = shown(use.name);
  if (request.map.may_be_normals && file.holds_normals) {
    if (request.material->textures.normal) {
      books.add(request.where,
                fmt::format("{}: {} holds normals, and the material has a normal map: it is left out", request.statement, shown_name));
      return;
    }
    books.add(request.where, fmt::format("{}: {} holds normals and no heights: it is used as a normal map", request.statement, shown_name));
    use.gain = {request.map.gain, request.map.gain, request.map.gain};
    use.base = {request.map.base, request.map.base, request.map.base};
    tilt_normals(use, request.map.bump_multiplier);
    use.channel = 0;
    request.material->textures.normal = std::move(use);
    return;
  }
  if (request.map.slot->is_scalar && !request.map.states_channel) {
    const bool is_opacity = request.map.slot->key == "opacity";
    use.channel = file.channels == 1 ? std::uint8_t{0} : is_opacity && file.channels == 4 ? std::uint8_t{3} : std::uint8_t{4};
    if (use.channel == 3) {
      books.add(request.where, fmt::format("{}: {} has an alpha, which is used, and not its colours", request.statement, shown_name));
    }
  }
  std::optional<TextureUse>* const place = place_of(*request.material, request.map);
  if (place == nullptr) {
    books.add(request.where, fmt::format("{}: {} is left out: a material reflects a sphere or a cube, and the first one counts",
                                         request.statement, shown_name));
    return;
  }
  std::optional<TextureUse>& slot = *place;
  if (slot) {
    books.add(request.where,
              fmt::format("{}: a material that states two maps for its {} has the last one", request.statement, request.map.slot->key));
  }
  slot = std::move(use);
}

Error with_context(const Request& request, const Error& error) {
  return {error.kind, error.where.empty() ? request.where : error.where,
          fmt::format("{} ({} of {})", error.message, request.statement, request.where)};
}

Result<Notes> finish(std::vector<Request>& requests, const LoadOptions& options, TextureCache& cache, BookShelf& books) {
  read_files(requests, options.threads, cache);
  for (Request& request : requests) {
    const TextureFile& file = cache.files.at(request.key);
    if (!file.error) {
      settle(request, file, books);
      continue;
    }
    if (options.strict) {
      return tl::unexpected(with_context(request, *file.error));
    }
    books.add(request.where, fmt::format("{}: the texture {}; drawn without it", request.statement, file.error->text()));
  }
  return books.notes();
}

}  // namespace

bool holds_normals(const Image& data) {
  if (data.channels < 3) {
    return false;
  }
  constexpr int kLooks = 64;
  const int columns = std::min(data.width, kLooks);
  const int rows = std::min(data.height, kLooks);
  double red = 0, green = 0, blue = 0;
  int normals = 0;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const auto texel = data.at(i * data.width / columns, j * data.height / rows);
      red += static_cast<double>(texel[0]);
      green += static_cast<double>(texel[1]);
      blue += static_cast<double>(texel[2]);
      const Vec3f n{texel[0] * 2 - 1, texel[1] * 2 - 1, texel[2] * 2 - 1};
      const float squared = n.x * n.x + n.y * n.y + n.z * n.z;
      normals += n.z > 0 && squared >= 0.64F && squared <= 1.44F ? 1 : 0;
    }
  }
  const double looks = static_cast<double>(columns) * rows;
  return blue >= red + 0.1 * looks && blue >= green + 0.1 * looks && normals >= 0.9 * looks;
}

Result<Notes> load_map_textures(std::span<Material> materials, const fs::path& folder, const LoadOptions& options, TextureCache& cache) {
  BookShelf books;
  std::vector<Request> requests;
  for (Material& material : materials) {
    for (const TextureMap& map : material.maps) {
      const auto note = [&](const std::string& message) { books.add(map.library, message); };
      auto use = use_of_map(map, {options.transparency_is_tr, options.transfer, material.illumination}, note);
      if (!use) {
        continue;
      }
      const fs::path library_folder = map.library.empty() ? folder : find_beside(folder, map.library).parent_path();
      Request request{&material, *std::move(use), map.library, map.statement};
      if (auto added = add_request(std::move(request), library_folder, map.file, options, books, requests); !added) {
        return tl::unexpected(std::move(added).error());
      }
    }
  }
  // a bump map that turns out to hold normals gives way to a stated normal map, wherever that stands
  std::stable_partition(requests.begin(), requests.end(), [](const Request& request) { return !request.map.may_be_normals; });
  return finish(requests, options, cache, books);
}

Result<Notes> load_stated_textures(Material& material, const std::string& where, const fs::path& folder, const LoadOptions& options,
                                   TextureCache& cache) {
  BookShelf books;
  std::vector<Request> requests;
  const StatedTextures& stated = material.stated_textures;
  const auto ask = [&](const StatedTexture& texture, const TextureSlot& slot, std::string key, std::size_t face = 0) -> Result<void> {
    Request request{&material, use_of_stated(texture, slot, options.transfer), where, std::move(key)};
    request.map.shape = &slot == &kReflectionSlot ? stated.reflection->shape : ReflectionShape{};
    request.map.face = face;
    return add_request(std::move(request), folder, texture.file, options, books, requests);
  };
  material.textures.normal_is_object_space = material.textures.normal_is_object_space || stated.object_space;
  for (const TextureSlot& slot : kTextureSlots) {
    const std::optional<StatedTexture>& texture = stated.*slot.stated;
    if (!texture || material.textures.*slot.use) {
      continue;
    }
    if (auto done = ask(*texture, slot, std::string(slot.key)); !done) {
      return tl::unexpected(std::move(done).error());
    }
  }
  if (stated.reflection && !material.textures.reflection) {
    const StatedReflection& map = *stated.reflection;
    const std::array faces{&map.right, &map.left, &map.top, &map.bottom, &map.front, &map.back};
    const bool is_cube = map.shape == ReflectionShape::cube;
    for (std::size_t face = 0; face < (is_cube ? faces.size() : 1); ++face) {
      const std::optional<StatedTexture>& texture = is_cube ? *faces[face] : map.picture;
      if (!texture) {
        continue;
      }
      if (auto done = ask(*texture, kReflectionSlot, fmt::format("reflection.{}", is_cube ? kCubeFaces[face] : "picture"), face); !done) {
        return tl::unexpected(std::move(done).error());
      }
    }
  }
  return finish(requests, options, cache, books);
}

}  // namespace lustro
