// The files that a model is made of, as the lab's page is given them: the file that the command names, and those that loading it opens.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lustro/result.hpp"
#include "lustro/scene.hpp"

namespace lustro::app {

/// What is seen of a file without reading it.
struct FileState {
  bool is_there = false;  ///< a regular file
  std::uint64_t size = 0;
  std::int64_t changed_ns = 0;  ///< since 1970
  std::uint64_t number = 0;     ///< the file system's: another file of the same name has another one
  friend bool operator==(const FileState&, const FileState&) = default;
};

[[nodiscard]] FileState state_of(const std::filesystem::path& file);

/// Files as they were before they were read.
using FileStates = std::map<std::filesystem::path, FileState>;

struct LabFile {
  std::string path;            ///< as the page knows it: relative, with `/`, without `..`
  std::filesystem::path file;  ///< where it lies; empty: `text` is the file
  std::string text{};
  FileState state{};       ///< when it was read
  std::uint64_t size = 0;  ///< bytes
  std::string version{};   ///< 16 hexadecimal digits; other ones where the file is another
};

struct LabModel {
  std::string entry;  ///< the path of the file that the command named
  std::vector<LabFile> files;
  std::string version;  ///< of all of them
  Notes notes{};        ///< of loading, and what the page is not given

  [[nodiscard]] const LabFile* find(std::string_view path) const;
};

/// Loads what the argument names (a scene file, a mesh file, a primitive), as `lustro render` does, and says which files that took.
///
/// Paths are relative to the innermost folder that holds all of them, so that `../meshes/a.obj` in `scenes/a.json` leads from `scenes/a.json` to
/// `meshes/a.obj` on the page as on disk. Of what the entry names (anybody may have written it) only files are given whose names end as those of
/// meshes, materials, pictures and buffers do, and which are not hidden.
///
/// states  all files that were opened, with a file that could not be opened, also where loading fails: what to watch
/// errors  as load_scene(); unsupported where a scene names a mesh by an absolute path, which a page cannot follow
[[nodiscard]] Result<LabModel> read_lab_model(const std::string& argument, const LoadOptions& options, FileStates& states);

}  // namespace lustro::app
