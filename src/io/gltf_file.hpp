// A glTF file with its bytes: JSON or GLB, the document, its buffers and what of them is packed.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "image/limits.hpp"
#include "io/gltf_document.hpp"
#include "io/read_file.hpp"
#include "lustro/result.hpp"

namespace lustro {

struct GltfOptions {
  /// The bytes of a file beside the document, by its path relative to the document's folder.
  std::function<Result<FileBytes>(const std::string& path)> read = {};

  ImageLimits image_limits = {};  ///< of pictures

  /// Numbers that meshes may take beyond what the file's own bytes account for: shared data that many nodes repeat.
  std::uint64_t spare_values = std::uint64_t{1} << 28U;
};

struct GltfFile {
  std::string name;                      ///< for messages
  bool is_binary = false;                ///< GLB
  std::unique_ptr<nlohmann::json> tree;  ///< the document's URIs lie in it
  GltfDocument document;
  FileBytes content;                      ///< of the file itself, where the caller leaves it here; `buffers` may point into it
  std::vector<FileBytes> owned;           ///< what else `buffers` and `views` point into
  std::vector<std::string_view> buffers;  ///< as long as the document states
  std::vector<std::string_view> views;    ///< unpacked
  std::uint64_t values_left = 0;          ///< see GltfOptions::spare_values
  std::function<Result<FileBytes>(const std::string& path)> read;  ///< GltfOptions::read, for pictures
  ImageLimits image_limits{};

  /// An error at a JSON path of this file.
  [[nodiscard]] tl::unexpected<Error> fail_at(const std::string& path, std::string message, ErrorKind kind = ErrorKind::malformed) const {
    return fail(kind, path.empty() ? name : name + ": " + path, std::move(message));
  }

  /// Takes memory for `count` numbers from what is granted.
  /// errors  limit
  [[nodiscard]] Result<void> take(std::uint64_t count, const std::string& path);
};

/// What a URI holds: data, or a file beside the document.
/// errors  malformed, io; without a place where the file says none
[[nodiscard]] Result<FileBytes> read_gltf_uri(const std::string& uri, const std::function<Result<FileBytes>(const std::string& path)>& read);

/// bytes  stay where they are as long as the result is used
/// errors  malformed, unsupported, limit, io; `where` is the file and the JSON path, `duck.gltf: accessors[3].bufferView`, or the byte
[[nodiscard]] Result<GltfFile> open_gltf(std::string_view bytes, const std::string& name, const GltfOptions& options);

}  // namespace lustro
