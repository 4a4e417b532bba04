// See gltf_file.hpp. GLB is the container of the specification's section 4: a header and chunks, little endian.
#include "io/gltf_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/gltf_meshopt.hpp"
#include "io/gltf_uri.hpp"
#include "scene/json_document.hpp"

namespace lustro {
namespace {

struct Parts {
  std::string_view json;
  std::string_view binary;
  bool has_binary = false;
};

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  }
  return word;
}

Result<Parts> parts_of(std::string_view bytes, const std::string& name) {
  constexpr std::size_t kHeader = 12;
  constexpr std::size_t kChunkHeader = 8;
  constexpr std::uint32_t kJson = 0x4E4F534A;
  constexpr std::uint32_t kBinary = 0x004E4942;
  const auto broken = [&](std::size_t at, std::string message, ErrorKind kind = ErrorKind::malformed) {
    return fail(kind, fmt::format("{}: byte {}", name, at), std::move(message));
  };
  if (bytes.size() < kHeader + kChunkHeader) {
    return broken(bytes.size(), "the GLB header is cut short");
  }
  if (const std::uint32_t version = word_at(bytes, 4); version != 2) {
    return broken(4, fmt::format("GLB version {} is not read, expected 2", version), ErrorKind::unsupported);
  }
  const std::uint32_t length = word_at(bytes, 8);
  if (length > bytes.size()) {
    return broken(8, fmt::format("the header states {} bytes, and there are {}", length, bytes.size()));
  }
  bytes = bytes.substr(0, length);
  Parts parts;
  std::size_t at = kHeader;
  for (std::size_t chunk = 0; at < bytes.size(); ++chunk) {
    if (bytes.size() - at < kChunkHeader) {
      return broken(at, "a chunk's header is cut short");
    }
    const std::uint32_t size = word_at(bytes, at);
    const std::uint32_t kind = word_at(bytes, at + 4);
    if (size > bytes.size() - at - kChunkHeader) {
      return broken(at, fmt::format("a chunk states {} bytes, and {} are left", size, bytes.size() - at - kChunkHeader));
    }
    const std::string_view content = bytes.substr(at + kChunkHeader, size);
    if (chunk == 0 && kind != kJson) {
      return broken(at + 4, "the first chunk is not JSON");
    }
    if (chunk == 0) {
      parts.json = content;
    } else if (chunk == 1 && kind == kBinary) {
      parts.binary = content;
      parts.has_binary = true;
    }
    at += kChunkHeader + size;
  }
  return parts;
}

/// A buffer's bytes, all that there are.
Result<std::string_view> bytes_of(GltfFile& file, std::size_t index, const Parts& parts, const GltfOptions& options) {
  const GltfBuffer& buffer = file.document.buffers[index];
  const std::string path = fmt::format("buffers[{}].uri", index);
  if (buffer.uri == nullptr) {
    return index == 0 && parts.has_binary ? parts.binary : std::string_view();
  }
  Result<FileBytes> bytes = read_gltf_uri(*buffer.uri, options.read);
  if (!bytes) {
    const Error& error = bytes.error();
    return file.fail_at(path, error.where.empty() ? error.message : error.text(), error.kind);
  }
  file.owned.push_back(std::move(*bytes));
  return file.owned.back().view();
}

Result<void> read_buffers(GltfFile& file, const Parts& parts, const GltfOptions& options) {
  for (std::size_t i = 0; i < file.document.buffers.size(); ++i) {
    const GltfBuffer& buffer = file.document.buffers[i];
    if (buffer.is_fallback && !(i == 0 && parts.has_binary)) {
      file.buffers.emplace_back();
      continue;
    }
    const Result<std::string_view> bytes = bytes_of(file, i, parts, options);
    if (!bytes) {
      return tl::unexpected(bytes.error());
    }
    if (bytes->size() < buffer.length) {
      return file.fail_at(fmt::format("buffers[{}].byteLength", i),
                          fmt::format("{} bytes are stated, and there are {}", buffer.length, bytes->size()));
    }
    file.buffers.push_back(bytes->substr(0, static_cast<std::size_t>(buffer.length)));
  }
  return {};
}

// Offsets and lengths that were checked against the bytes, so that they fit any machine's size.
std::string_view part_of(std::string_view bytes, std::uint64_t offset, std::uint64_t length) {
  return bytes.substr(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
}

Result<void> unpack_views(GltfFile& file) {
  std::uint64_t left = std::uint64_t{1} << 20U;
  for (const std::string_view buffer : file.buffers) {
    left += 256 * buffer.size();  // a byte unpacks to 64 at most; the rest is for bytes that several views share
  }
  for (std::size_t i = 0; i < file.document.views.size(); ++i) {
    const GltfView& view = file.document.views[i];
    if (!view.meshopt) {
      const std::string_view buffer = file.buffers[view.buffer];
      file.views.push_back(buffer.empty() ? buffer : part_of(buffer, view.offset, view.length));
      continue;
    }
    const std::string path = fmt::format("bufferViews[{}].extensions.EXT_meshopt_compression", i);
    if (view.length > left) {
      return file.fail_at(path, "unpacks to more than the file's bytes can hold", ErrorKind::limit);
    }
    left -= view.length;
    Result<FileBytes> unpacked =
        unpack_meshopt(part_of(file.buffers[view.meshopt->buffer], view.meshopt->offset, view.meshopt->length), *view.meshopt);
    if (!unpacked) {
      return file.fail_at(path, unpacked.error().message, unpacked.error().kind);
    }
    file.owned.push_back(std::move(*unpacked));
    file.views.push_back(file.owned.back().view());
  }
  return {};
}

}  // namespace

Result<FileBytes> read_gltf_uri(const std::string& uri, const std::function<Result<FileBytes>(const std::string& path)>& read) {
  if (is_data_uri(uri)) {
    return decode_data_uri(uri);
  }
  const Result<std::string> relative = confined_path(uri);
  if (!relative) {
    return tl::unexpected(relative.error());
  }
  if (!read) {
    return fail(ErrorKind::io, {}, "no file beside the document is read here");
  }
  return read(*relative);
}

Result<void> GltfFile::take(std::uint64_t count, const std::string& path) {
  if (count > values_left) {
    return fail_at(path, "asks for more numbers than the file's bytes account for: its data are repeated too often", ErrorKind::limit);
  }
  values_left -= count;
  return {};
}

Result<GltfFile> open_gltf(std::string_view bytes, const std::string& name, const GltfOptions& options) {
  GltfFile file;
  file.name = name;
  file.is_binary = bytes.starts_with("glTF");
  Parts parts{bytes, {}, false};
  if (file.is_binary) {
    const Result<Parts> found = parts_of(bytes, name);
    if (!found) {
      return tl::unexpected(found.error());
    }
    parts = *found;
  }
  Result<nlohmann::json> tree = parse_json(parts.json, name);
  if (!tree) {
    return tl::unexpected(tree.error());
  }
  file.tree = std::make_unique<nlohmann::json>(std::move(*tree));
  Result<GltfDocument> document = read_gltf_document(*file.tree, parts.has_binary);
  if (!document) {
    return file.fail_at(document.error().where, document.error().message, document.error().kind);
  }
  file.document = std::move(*document);
  if (const Result<void> done = read_buffers(file, parts, options); !done) {
    return tl::unexpected(done.error());
  }
  if (const Result<void> done = unpack_views(file); !done) {
    return tl::unexpected(done.error());
  }
  file.values_left = options.spare_values;
  file.read = options.read;
  file.image_limits = options.image_limits;
  for (const std::string_view buffer : file.buffers) {
    file.values_left += 16 * buffer.size();
  }
  return file;
}

}  // namespace lustro
