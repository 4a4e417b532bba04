// Marks of formats.
#include "io/mesh_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "image/lower_case.hpp"
#include "io/obj_statements.hpp"
#include "io/off.hpp"
#include "io/stl.hpp"
#include "io/text.hpp"

namespace lustro {

namespace {

// What people hand to a mesh renderer by mistake, or in hope.
constexpr std::array<std::pair<std::string_view, std::string_view>, 17> kOthers{{
    {"\x89PNG", "a PNG image"},
    {"\xFF\xD8\xFF", "a JPEG image"},
    {"GIF8", "a GIF image"},
    {"#?RADIANCE", "a Radiance image"},
    {"\x76\x2F\x31\x01", "an OpenEXR image"},
    {"PK\x03\x04", "a ZIP archive (USDZ, ...)"},
    {"\x1F\x8B", "gzip-compressed data"},
    {"Kaydara FBX", "an FBX file"},
    {"; FBX", "an FBX file"},
    {"BLENDER", "a Blender file"},
    {"DRACO", "a Draco file"},
    {"#usda", "a USD file"},
    {"PXR-USDC", "a USD file"},
    {"#VRML", "a VRML file"},
    {"# vtk DataFile", "a VTK file"},
    {"<?xml", "an XML file (COLLADA, X3D, ...)"},
    {"\x28\xB5\x2F\xFD", "zstd-compressed data"},
}};

bool is_ply(std::string_view bytes) {
  return bytes.starts_with("ply") && bytes.size() > 3 && (TextCursor::is_newline(bytes[3]) || TextCursor::is_blank(bytes[3]));
}

// A ZIP package that names a 3MF model; names are not packed.
bool is_threemf(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04") && bytes.find("3dmodel.model") != std::string_view::npos;
}

// JSON with an `asset` key near its start or the names of other top-level keys: not to be taken for a scene file.
bool is_gltf(std::string_view bytes) {
  TextCursor text(bytes, {.hash_comments = false, .joined_lines = false});
  text.skip_space();
  if (!text.next_is('{')) {
    return false;
  }
  const auto has = [&](std::string_view key) { return bytes.find(key) != std::string_view::npos; };
  return has("\"asset\"") && has("\"version\"");
}

bool is_obj(std::string_view bytes) {
  TextCursor text(bytes, {.hash_comments = true, .joined_lines = true});
  text.skip_space();
  const std::string_view word = text.word();
  if (!is_obj_statement(word)) {
    return false;
  }
  // A letter alone is little: a number must follow `v`, `f`, ...
  float number = 0;
  const bool needs_number = word == "v" || word == "vt" || word == "vn" || word == "vp";
  return !needs_number || text.number(number);
}

}  // namespace

MeshFormat mesh_format_of_content(std::string_view bytes) {
  if (bytes.starts_with("glTF")) {
    return MeshFormat::glb;
  }
  if (is_threemf(bytes)) {
    return MeshFormat::threemf;
  }
  if (is_ply(bytes)) {
    return MeshFormat::ply;
  }
  if (has_binary_stl_size(bytes) || is_ascii_stl(bytes)) {
    return MeshFormat::stl;
  }
  if (is_gltf(bytes)) {
    return MeshFormat::gltf;
  }
  if (is_off(bytes)) {
    return MeshFormat::off;
  }
  return is_obj(bytes) ? MeshFormat::obj : MeshFormat::unknown;
}

MeshFormat mesh_format_of_name(const std::filesystem::path& file) {
  const std::string extension = lower_case(file.extension().string());
  constexpr std::array<std::pair<std::string_view, MeshFormat>, 7> kExtensions{{
      {".obj", MeshFormat::obj},
      {".ply", MeshFormat::ply},
      {".stl", MeshFormat::stl},
      {".off", MeshFormat::off},
      {".3mf", MeshFormat::threemf},
      {".gltf", MeshFormat::gltf},
      {".glb", MeshFormat::glb},
  }};
  for (const auto& [known, format] : kExtensions) {
    if (known == extension) {
      return format;
    }
  }
  return MeshFormat::unknown;
}

bool is_read_by_assimp_alone(const std::filesystem::path& file) {
  constexpr std::array<std::string_view, 20> kExtensions{".3ds", ".ac",  ".amf", ".ase", ".b3d", ".blend", ".bvh",  ".cob", ".dae", ".dxf",
                                                         ".fbx", ".ifc", ".lwo", ".lws", ".md2", ".md3",   ".ms3d", ".wrl", ".x",   ".x3d"};
  return std::find(kExtensions.begin(), kExtensions.end(), lower_case(file.extension().string())) != kExtensions.end();
}

std::string readable_formats() {
#ifdef LUSTRO_HAS_3MF
  return "OBJ, PLY, STL, OFF, 3MF or glTF";
#else
  return "OBJ, PLY, STL, OFF or glTF";
#endif
}

std::string describe_content(std::string_view bytes) {
  if (bytes.empty()) {
    return "an empty file";
  }
  for (const auto& [mark, name] : kOthers) {
    if (bytes.starts_with(mark)) {
      return std::string(name);
    }
  }
  return fmt::format("a file that begins with {}", shown(bytes.substr(0, 16)));
}

}  // namespace lustro
