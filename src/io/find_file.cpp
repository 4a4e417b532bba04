// Looking for files by the names that other machines gave them.
#include "io/find_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <system_error>

#include "image/lower_case.hpp"
#include "io/text.hpp"

namespace lustro {
namespace {

namespace fs = std::filesystem;

constexpr int kMostEntries = 65536;  // of a folder that is looked through without regard to case

fs::path with_slashes(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  return {name};
}

bool is_file(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored);
}

/// Of this machine, or C:\ of another.
bool is_absolute_name(const std::string& name) {
  return with_slashes(name).is_absolute() || (name.size() > 1 && name[1] == ':');
}

/// The file of that name in another case; the first in the order of names where there are several.
std::optional<fs::path> find_in_other_case(const fs::path& file) {
  const std::string wanted = lower_case(file.filename().string());
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::optional<fs::path> found;
  std::error_code error;
  int entries = 0;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator() && entries < kMostEntries;
       entry.increment(error), ++entries) {
    const fs::path name = entry->path().filename();
    if (lower_case(name.string()) == wanted && is_file(entry->path()) && (!found || name < found->filename())) {
      found = file.parent_path() / name;
    }
  }
  return found;
}

/// Whether a file lies in the tree that a folder's MTL may name.
bool is_confined(const fs::path& folder, const fs::path& file) {
  std::error_code error;
  const fs::path inner = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, error);
  // absolute first: of a relative path that is not there weakly_canonical() would make nothing
  const fs::path absolute = error ? fs::path() : fs::absolute(file, error);
  const fs::path target = error ? fs::path() : fs::weakly_canonical(absolute, error);
  if (error) {
    return false;
  }
  const fs::path outer = inner.parent_path();
  const fs::path& root = outer == outer.root_path() ? inner : outer;
  return std::mismatch(root.begin(), root.end(), target.begin(), target.end()).first == root.end();
}

}  // namespace

fs::path find_beside(const fs::path& folder, const std::string& name) {
  const fs::path written = with_slashes(name);
  const bool is_absolute = is_absolute_name(name);
  if (!is_absolute && is_file(folder / written)) {
    return folder / written;
  }
  if (!is_absolute && is_file(folder / name)) {  // a backslash is a letter of names here
    return folder / name;
  }
  const fs::path last = folder / written.filename();
  return is_absolute || is_file(last) ? last : folder / written;
}

std::string identity_of(const fs::path& file) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(file, error);
  return error ? file.string() : canonical.string();
}

Result<FoundFile> find_texture(const fs::path& folder, const std::string& name) {
  const fs::path written = with_slashes(name);
  const fs::path beside = folder / written.filename();
  const bool is_absolute = is_absolute_name(name);
  std::string problem;
  if (!written.has_filename()) {
    problem = "names no file";
  } else if (is_absolute) {
    problem = "is an absolute path, which is not followed";
  } else {
    for (const fs::path& candidate : {folder / written, folder / name}) {
      if (is_file(candidate) && is_confined(folder, candidate)) {
        return FoundFile{candidate};
      }
    }
    problem = is_confined(folder, folder / written) ? "is missing" : "leads out of its folder and the one around it";
  }
  if (written.has_filename() && is_file(beside) && is_confined(folder, beside)) {
    return FoundFile{beside, fmt::format("{} {}: the file of that name beside the one that names it is used", shown(name), problem)};
  }
  for (const fs::path& candidate : {is_absolute ? beside : folder / written, beside}) {
    if (const auto other = written.has_filename() && is_confined(folder, candidate) ? find_in_other_case(candidate) : std::nullopt;
        other && is_confined(folder, *other)) {
      return FoundFile{*other,
                       fmt::format("{} {}: {}, which differs in case, is used", shown(name), problem, shown(other->filename().string()))};
    }
  }
  return fail(ErrorKind::io, "", fmt::format("{} {}", shown(name), problem));
}

}  // namespace lustro
