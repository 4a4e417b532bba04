// The files that OBJ and MTL files name, as exporters of many systems write them.
#pragma once

#include <filesystem>
#include <string>

#include "lustro/result.hpp"

namespace lustro {

/// The file that `name` means, seen from a folder: as written where it is relative, else (another machine's C:\models\a.mtl, or a folder that
/// did not come along) by its last part. Slashes may be of either kind. What is not there comes back as written.
[[nodiscard]] std::filesystem::path find_beside(const std::filesystem::path& folder, const std::string& name);

/// One name for one file, however its path is written: links and `..` followed as far as the file is there.
[[nodiscard]] std::string identity_of(const std::filesystem::path& file);

/// A picture's file, and what had to be overlooked to find it (empty: nothing).
struct FoundFile {
  std::filesystem::path path;
  std::string note{};
};

/// The picture that a file (MTL, scene) in `folder` names. The name may come from anyone, so nothing outside of the tree of the folder's parent
/// is looked at (`../textures/a.png` is inside); where that is the root of the file system, nothing outside of the folder. Symbolic links count
/// as what they point to. An absolute name stands for its last part, beside that file. What is not there is looked for by its last part beside
/// that file, then without regard to case, each with a note. errors  io where there is none, with what was tried
[[nodiscard]] Result<FoundFile> find_texture(const std::filesystem::path& folder, const std::string& name);

}  // namespace lustro
