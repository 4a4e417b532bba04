// The loaders themselves say which files they open: see lab_files.hpp.
#include "lab_files.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

#include "image/hash.hpp"
#include "image/lower_case.hpp"
#include "io/text.hpp"
#include "scene_input.hpp"

namespace lustro::app {
namespace {

namespace fs = std::filesystem;

/// The endings of files that models are made of, without their dots.
constexpr std::array<std::string_view, 31> kEndings{"json", "obj", "mtl",  "ply",   "stl",    "off", "3mf", "gltf", "glb", "bin", "glbin",
                                                    "png",  "jpg", "jpeg", "jfif",  "webp",   "tga", "bmp", "dib",  "hdr", "pic", "rgbe",
                                                    "exr",  "pfm", "gif",  "glbuf", "buffer", "dat", "drc", "noff", "coff"};

std::string digits_of(std::string_view text) {
  return fmt::format("{:016x}", xxh64(std::as_bytes(std::span(text)), 0));
}

std::string version_of(const FileState& state) {
  return digits_of(fmt::format("{} {} {}", state.size, state.changed_ns, state.number));
}

bool is_hidden(const fs::path& path) {
  return std::any_of(path.begin(), path.end(), [](const fs::path& part) { return part.native().starts_with('.'); });
}

/// Whether the name is one of a file that models are made of.
bool is_of_a_model(const fs::path& path) {
  const std::string ending = lower_case(path.extension().string());
  return ending.size() > 1 && std::find(kEndings.begin(), kEndings.end(), std::string_view(ending).substr(1)) != kEndings.end();
}

/// Where a path leads when it is read without looking at the disk, as the page's engine reads it.
fs::path plain_path(const fs::path& file) {
  return fs::absolute(file).lexically_normal();
}

/// The innermost folder that holds both.
fs::path common_folder(const fs::path& a, const fs::path& b) {
  fs::path common;
  for (auto [i, j] = std::pair(a.begin(), b.begin()); i != a.end() && j != b.end() && *i == *j; ++i, ++j) {
    common /= *i;
  }
  return common;
}

std::string version_of_all(const LabModel& model) {
  std::string all = model.entry + "\n";
  for (const LabFile& file : model.files) {
    all += file.path + "\n" + file.version + "\n";
  }
  return digits_of(all);
}

/// A primitive is a scene file that nobody wrote.
Result<LabModel> model_of_primitive(const std::string& argument, const LoadOptions& options) {
  LoadOptions as_stated = options;
  as_stated.adjust = [](Scene&) { return Result<void>(); };
  const Result<LoadedScene> loaded = load_input(argument, as_stated);
  if (!loaded) {
    return tl::unexpected(loaded.error());
  }
  LabModel model{.entry = "scene.json", .files = {}, .version = {}, .notes = loaded->notes};
  LabFile file{.path = model.entry, .file = {}, .text = scene_json(loaded->scene)};
  file.size = file.text.size();
  file.version = digits_of(file.text);
  model.files.push_back(std::move(file));
  model.version = version_of_all(model);
  return model;
}

/// A mesh that a scene names by an absolute path lies nowhere on the page.
Result<void> check_names(const fs::path& entry, const Scene& scene) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const std::string& source = scene.objects[i].source;
    if (!is_primitive(source) && fs::path(source).is_absolute()) {
      return fail(ErrorKind::unsupported, fmt::format("{}: objects[{}].mesh", entry.string(), i),
                  fmt::format("{} is an absolute path, which the page cannot follow: state it relative to the scene file", shown(source)));
    }
  }
  return {};
}

/// The files by the names that the page gives them.
LabModel model_of(const fs::path& entry, const FileStates& states, Notes notes) {
  const fs::path entry_path = plain_path(entry);
  fs::path root = entry_path.parent_path();
  std::map<fs::path, const FileStates::value_type*> given;
  for (const auto& opened : states) {
    const fs::path path = plain_path(opened.first);
    if (!opened.second.is_there) {
      continue;  // loading has noted it
    }
    if (path != entry_path && !is_of_a_model(path)) {
      notes.push_back(
          {opened.first.string(), "is not given to the page: its name does not end as that of a mesh, a material, a picture or a buffer"});
      continue;
    }
    given.emplace(path, &opened);
    root = common_folder(root, path.parent_path());
  }
  LabModel model{.entry = entry_path.lexically_relative(root).generic_string(), .files = {}, .version = {}, .notes = std::move(notes)};
  for (const auto& [path, opened] : given) {
    const fs::path relative = path.lexically_relative(root);
    if (path != entry_path && is_hidden(relative)) {
      model.notes.push_back({opened->first.string(), "is not given to the page: it is hidden"});
      continue;
    }
    model.files.push_back({.path = relative.generic_string(),
                           .file = opened->first,
                           .state = opened->second,
                           .size = opened->second.size,
                           .version = version_of(opened->second)});
  }
  model.version = version_of_all(model);
  return model;
}

}  // namespace

FileState state_of(const fs::path& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) {
    return {};
  }
#if defined(__APPLE__)
  const timespec& changed = found.st_mtimespec;
#else
  const timespec& changed = found.st_mtim;
#endif
  constexpr std::int64_t kSecond = 1'000'000'000;
  return {true, static_cast<std::uint64_t>(found.st_size), changed.tv_sec * kSecond + changed.tv_nsec, found.st_ino};
}

const LabFile* LabModel::find(std::string_view path) const {
  const auto found = std::find_if(files.begin(), files.end(), [&](const LabFile& file) { return file.path == path; });
  return found == files.end() ? nullptr : &*found;
}

Result<LabModel> read_lab_model(const std::string& argument, const LoadOptions& options, FileStates& states) {
  states.clear();
  if (is_primitive(argument)) {
    return model_of_primitive(argument, options);
  }
  std::mutex mutex;
  LoadOptions watched = options;
  watched.on_file = [&](const fs::path& file) {
    const FileState state = state_of(file);  // before it is read: a change meanwhile is another state
    const std::scoped_lock lock(mutex);
    states.emplace(file, state);
  };
  watched.on_file(argument);
  const Result<LoadedScene> loaded = load_scene(argument, watched);
  if (!loaded) {
    return tl::unexpected(loaded.error());
  }
  if (const Result<void> named = check_names(argument, loaded->scene); !named) {
    return tl::unexpected(named.error());
  }
  return model_of(argument, states, loaded->notes);
}

}  // namespace lustro::app
