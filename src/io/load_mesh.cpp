// Loads a mesh file by its content, and an OBJ's libraries from the folder beside it.
#include "io/load_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "io/assimp_import.hpp"
#include "io/find_file.hpp"
#include "io/gltf_scene.hpp"
#include "io/mesh_format.hpp"
#include "io/obj.hpp"
#include "io/off.hpp"
#include "io/ply.hpp"
#include "io/ply_direct.hpp"
#include "io/read_file.hpp"
#include "io/stl.hpp"
#ifdef LUSTRO_HAS_3MF
#include "io/threemf.hpp"
#endif

namespace lustro {

namespace {

namespace fs = std::filesystem;

Result<SourceMesh> load_obj(std::string_view bytes, const fs::path& file, const LoadOptions& options, TextureCache& textures) {
  const fs::path folder = file.parent_path();
  ObjOptions obj;
  obj.transparency_is_tr = options.transparency_is_tr;
  obj.threads = options.threads;
  obj.read_library = [&](const std::string& name) -> Result<std::string> {
    const fs::path library_file = find_beside(folder, name);
    tell(options.on_file, library_file);
    const Result<FileBytes> library = read_file(library_file);
    if (!library) {
      return tl::unexpected(library.error());
    }
    return std::string(library->view());
  };
  Result<SourceMesh> mesh = parse_obj(bytes, file.string(), obj);
  if (!mesh) {
    return mesh;
  }
  const Result<Notes> notes = load_map_textures(mesh->materials, folder, options, textures);
  if (!notes) {
    return tl::unexpected(notes.error());
  }
  mesh->notes.insert(mesh->notes.end(), notes->begin(), notes->end());
  return mesh;
}

/// What assimp makes of a file, with the pictures beside it.
Result<SourceMesh> load_by_assimp(const fs::path& file, const LoadOptions& options, TextureCache& textures) {
  Result<SourceMesh> mesh = import_by_assimp(file);
  if (!mesh) {
    return mesh;
  }
  const Result<Notes> notes = load_map_textures(mesh->materials, file.parent_path(), options, textures);
  if (!notes) {
    return tl::unexpected(notes.error());
  }
  mesh->notes.insert(mesh->notes.end(), notes->begin(), notes->end());
  return mesh;
}

/// By hand, because tl::expected's own conversion leaks: it makes a default value first and constructs over it.
template <class Read>
Result<ReadMesh> as_read_mesh(Result<Read> mesh) {
  if (!mesh) {
    return tl::unexpected(std::move(mesh).error());
  }
  return *std::move(mesh);
}

Result<ReadMesh> load(const fs::path& file, const LoadOptions& options, bool for_drawing, TextureCache& textures) {
  tell(options.on_file, file);
  const Result<ByteSource> source = ByteSource::open(file);
  if (!source) {
    return tl::unexpected(source.error());
  }
  std::array<char, 4> mark{};
  if (source->read(0, mark.size(), mark.data()).starts_with("ply")) {
    if (std::optional<PlainMesh> plain = read_plain_ply(*source, for_drawing, options.threads)) {
      return *std::move(plain);
    }
  }
  const Result<FileBytes> content = source->read_all(options.threads);
  if (!content) {
    return tl::unexpected(content.error());
  }
  const std::string_view bytes = content->view();
  const std::string name = file.string();
  MeshFormat format = mesh_format_of_content(bytes);
  format = format == MeshFormat::unknown ? mesh_format_of_name(file) : format;
  switch (format) {
    case MeshFormat::obj:
      return as_read_mesh(load_obj(bytes, file, options, textures));
    case MeshFormat::ply:
      return as_read_mesh(parse_any_ply(bytes, name));
    case MeshFormat::stl:
      return as_read_mesh(parse_stl(bytes, name, options.threads));
    case MeshFormat::off:
      return as_read_mesh(parse_off(bytes, name));
    case MeshFormat::threemf:
#ifdef LUSTRO_HAS_3MF
      return as_read_mesh(parse_threemf(bytes, name));
#else
      return fail(ErrorKind::unsupported, name,
                  "is a 3MF file, which Lustro reads where libexpat (Debian: libexpat1-dev) is there when it is built");
#endif
    case MeshFormat::gltf:
    case MeshFormat::glb: {
      Result<GltfModel> model = load_gltf(file, options);
      return model ? as_read_mesh(gltf_whole_mesh(*model, options)) : tl::unexpected(std::move(model).error());
    }
    case MeshFormat::unknown:
      break;
  }
  if (assimp_reads(file)) {
    return as_read_mesh(load_by_assimp(file, options, textures));
  }
  const std::string hint =
      is_read_by_assimp_alone(file) ? "; a build of Lustro with assimp (-DLUSTRO_WITH_ASSIMP=ON) reads files of this extension" : "";
  return fail(ErrorKind::unsupported, name, fmt::format("is {}: expected {}{}", describe_content(bytes), readable_formats(), hint));
}

}  // namespace

Result<ReadMesh> read_mesh_file(const std::filesystem::path& file, const LoadOptions& options, bool for_drawing, TextureCache& textures) {
  try {
    return load(file, options, for_drawing, textures);
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::limit, file.string(), "needs more memory than there is");
  } catch (const std::exception& problem) {  // names that the system's paths cannot hold
    return fail(ErrorKind::io, file.string(), problem.what());
  }
}

Result<SourceMesh> load_mesh_file(const std::filesystem::path& file, const LoadOptions& options) {
  TextureCache textures;
  Result<ReadMesh> read = read_mesh_file(file, options, false, textures);
  if (!read) {
    return tl::unexpected(std::move(read.error()));
  }
  if (PlainMesh* const plain = std::get_if<PlainMesh>(&*read)) {
    return to_source(std::move(*plain));
  }
  return std::get<SourceMesh>(std::move(*read));
}

}  // namespace lustro
