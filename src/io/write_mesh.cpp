// Checks a mesh, has it turned into bytes, writes them.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <system_error>
#include <utility>

#include "io/mesh_format.hpp"
#include "io/mesh_writers.hpp"
#include "io/read_file.hpp"
#include "lustro/image.hpp"
#include "lustro/mesh_file.hpp"

namespace lustro {
namespace {

namespace fs = std::filesystem;

Result<void> check(const Mesh& mesh, const std::string& where) {
  const std::size_t vertices = mesh.positions.size();
  const auto wrong = [&where](std::string message) { return fail(ErrorKind::usage, where, std::move(message)); };
  const auto fits = [vertices](std::size_t size) { return size == 0 || size == vertices; };
  if (!fits(mesh.normals.size()) || !fits(mesh.uvs.size()) || !fits(mesh.uvs1.size()) || !fits(mesh.tangents.size()) ||
      !fits(mesh.colors.size()) || !fits(mesh.alphas.size())) {
    return wrong(fmt::format("an attribute of the mesh does not have one value for each of the {} vertices", vertices));
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      if (corner >= vertices) {
        return wrong(fmt::format("a triangle names vertex {} of {}", corner, vertices));
      }
    }
  }
  if (!mesh.triangle_material.empty() && mesh.triangle_material.size() != mesh.triangles.size()) {
    return wrong(fmt::format("{} triangles, and materials for {}", mesh.triangles.size(), mesh.triangle_material.size()));
  }
  for (const std::uint32_t material : mesh.triangle_material) {
    if (material >= std::max<std::size_t>(mesh.materials.size(), 1)) {
      return wrong(fmt::format("a triangle names material {} of {}", material, mesh.materials.size()));
    }
  }
  return {};
}

Result<void> write(const fs::path& file, const std::string& bytes) {
  return write_file_atomically(file, std::as_bytes(std::span(bytes)));
}

/// Where a map lies, seen from the folder of the written file; as it was where it is not there.
std::string name_from(const fs::path& folder, const fs::path& texture_folder, const std::string& name) {
  std::string slashes = name;
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  const fs::path from_here = texture_folder / slashes;
  std::error_code error;
  if (texture_folder.empty() || !fs::is_regular_file(from_here, error)) {
    return name;
  }
  const fs::path target = fs::weakly_canonical(from_here, error);
  const fs::path base = error ? fs::path() : fs::weakly_canonical(fs::absolute(folder.empty() ? "." : folder, error), error);
  const fs::path relative = error ? fs::path() : target.lexically_relative(base);
  return relative.empty() ? name : relative.generic_string();
}

/// A picture's bytes; empty where it cannot be read.
std::string read_map(const fs::path& texture_folder, std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  const Result<FileBytes> bytes = read_file(texture_folder / name);
  return bytes ? std::string(bytes->view()) : std::string();
}

Result<Notes> write_obj(const fs::path& file, const Mesh& mesh, const MeshWriteOptions& options) {
  fs::path library = file;
  library.replace_extension(".mtl");
  MeshBytes obj = obj_bytes(mesh, library.filename().string());
  if (has_materials(mesh)) {
    MeshBytes mtl = mtl_bytes(mesh, [&](const std::string& name) { return name_from(file.parent_path(), options.texture_folder, name); });
    if (const Result<void> written = write(library, mtl.bytes); !written) {  // first: an OBJ never names a library that is not there
      return tl::unexpected(written.error());
    }
    std::move(mtl.notes.begin(), mtl.notes.end(), std::back_inserter(obj.notes));
  }
  if (const Result<void> written = write(file, obj.bytes); !written) {
    return tl::unexpected(written.error());
  }
  return std::move(obj.notes);
}

Result<Notes> write_bytes(const fs::path& file, Result<MeshBytes> made) {
  if (!made) {
    return fail(made.error().kind, file.string(), made.error().message);
  }
  if (const Result<void> written = write(file, made->bytes); !written) {
    return tl::unexpected(written.error());
  }
  return std::move(made->notes);
}

Result<Notes> write_by_extension(const fs::path& file, const Mesh& mesh, const MeshWriteOptions& options) {
  switch (mesh_format_of_name(file)) {
    case MeshFormat::obj:
      return write_obj(file, mesh, options);
    case MeshFormat::ply:
      return write_bytes(file, ply_bytes(mesh, options.ascii));
    case MeshFormat::stl:
      return write_bytes(file, stl_bytes(mesh, options.ascii));
    case MeshFormat::glb:
      return write_bytes(file, glb_bytes(mesh, [&](const std::string& name) { return read_map(options.texture_folder, name); }));
    default:
      return fail(ErrorKind::unsupported, file.string(), "meshes are written to .obj, .ply, .stl and .glb");
  }
}

}  // namespace

Result<Notes> write_mesh(const std::filesystem::path& file, const Mesh& mesh, const MeshWriteOptions& options) {
  try {
    if (const Result<void> checked = check(mesh, file.string()); !checked) {
      return tl::unexpected(checked.error());
    }
    Result<Notes> notes = write_by_extension(file, mesh, options);
    if (notes) {
      for (Note& note : *notes) {
        note.where = file.string();
      }
    }
    return notes;
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::limit, file.string(), "needs more memory than there is");
  } catch (const std::exception& problem) {  // names that the system's paths cannot hold
    return fail(ErrorKind::io, file.string(), problem.what());
  }
}

}  // namespace lustro
