// From arguments to jobs: see batch_jobs.hpp.
#include "batch_jobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <system_error>

#include "io/mesh_format.hpp"
#include "outputs.hpp"
#include "scene_input.hpp"

namespace lustro::app {
namespace {

namespace fs = std::filesystem;

/// A model and how much of its path names its picture.
struct Model {
  std::string input;
  fs::path place;         ///< absolute, without `.` and `..`; for a primitive its picture's name
  std::size_t parts = 1;  ///< so many last parts of `place` are the name
  bool keeps_extension = false;

  [[nodiscard]] fs::path name() const {
    const std::vector<fs::path> all(place.begin(), place.end());
    fs::path result;
    for (std::size_t i = all.size() - std::min(parts, all.size()); i < all.size(); ++i) {
      result /= all[i];
    }
    if (result.is_absolute()) {
      result = result.relative_path();
    }
    return keeps_extension ? fs::path(result.string() + ".png") : result.replace_extension(".png");
  }
  [[nodiscard]] std::size_t most_parts() const { return static_cast<std::size_t>(std::distance(place.begin(), place.end())); }
};

fs::path absolute_place(const fs::path& file) {
  std::error_code ignored;
  fs::path place = fs::absolute(file, ignored).lexically_normal();
  return place.has_filename() ? place : place.parent_path();
}

bool is_drawable(const fs::path& file) {
  switch (mesh_format_of_name(file)) {
    case MeshFormat::obj:
    case MeshFormat::ply:
    case MeshFormat::stl:
    case MeshFormat::off:
    case MeshFormat::threemf:
      return true;
    case MeshFormat::gltf:
    case MeshFormat::glb:
    case MeshFormat::unknown:
      break;
  }
  return false;
}

Result<void> collect_folder(const fs::path& folder, bool recursive, std::vector<fs::path>& files) {
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  const auto cannot = [&] { return fail(ErrorKind::io, folder.string(), fmt::format("cannot be read: {}", error.message())); };
  if (error) {
    return cannot();
  }
  for (; entry != fs::directory_iterator(); entry.increment(error)) {
    if (error) {
      return cannot();
    }
    std::error_code ignored;
    if (entry->is_directory(ignored)) {
      // A link to a folder is not followed: it may lead back to where it lies.
      if (recursive && !entry->is_symlink(ignored)) {
        if (const Result<void> done = collect_folder(entry->path(), recursive, files); !done) {
          return done;
        }
      }
    } else if (is_drawable(entry->path()) && entry->is_regular_file(ignored)) {
      files.push_back(entry->path());
    }
  }
  return {};
}

Result<void> add_argument(const std::string& argument, bool recursive, std::vector<Model>& models) {
  if (is_primitive(argument)) {
    models.push_back({.input = argument, .place = default_output(argument)});
    return {};
  }
  std::error_code ignored;
  if (!fs::is_directory(argument, ignored)) {
    models.push_back({.input = argument, .place = absolute_place(argument)});
    return {};
  }
  std::vector<fs::path> files;
  if (const Result<void> done = collect_folder(argument, recursive, files); !done) {
    return done;
  }
  std::sort(files.begin(), files.end());
  const fs::path root = absolute_place(argument);
  for (const fs::path& file : files) {
    const fs::path place = absolute_place(file);
    const fs::path inside = place.lexically_relative(root);
    models.push_back({.input = file.string(), .place = place, .parts = static_cast<std::size_t>(std::distance(inside.begin(), inside.end()))});
  }
  return {};
}

Result<void> add_list(const std::string& list, bool recursive, std::vector<Model>& models) {
  std::ifstream file;
  if (list != kStdout) {
    file.open(list, std::ios::binary);
  }
  std::istream& stream = list == kStdout ? std::cin : file;
  if (!stream) {
    return fail(ErrorKind::io, list, "cannot be opened");
  }
  for (std::string line; std::getline(stream, line);) {
    if (line.ends_with('\r')) {
      line.pop_back();
    }
    if (line.empty()) {
      continue;
    }
    if (const Result<void> done = add_argument(line, recursive, models); !done) {
      return done;
    }
  }
  if (stream.bad()) {
    return fail(ErrorKind::io, list, "cannot be read");
  }
  return {};
}

/// Each model once, the first time that it is named.
void drop_repeated(std::vector<Model>& models) {
  std::set<fs::path> seen;
  models.erase(std::remove_if(models.begin(), models.end(), [&](const Model& m) { return !seen.insert(m.place).second; }), models.end());
}

/// Makes every name its own. A name grows until it is, and places differ, so this ends.
void tell_apart(std::vector<Model>& models) {
  for (bool changed = true; changed;) {
    changed = false;
    std::map<fs::path, std::vector<Model*>> groups;
    for (Model& model : models) {
      groups[model.name()].push_back(&model);
    }
    for (auto& entry : groups) {
      const std::vector<Model*>& group = entry.second;
      if (group.size() < 2) {
        continue;
      }
      const bool is_one_folder =
          std::all_of(group.begin(), group.end(), [&](const Model* m) { return m->place.parent_path() == group.front()->place.parent_path(); });
      for (Model* model : group) {
        if (is_one_folder && !model->keeps_extension) {
          model->keeps_extension = true;
          changed = true;
        } else if (!is_one_folder && model->parts < model->most_parts()) {
          ++model->parts;
          changed = true;
        }
      }
    }
  }
}

}  // namespace

Result<std::vector<BatchJob>> batch_jobs(const BatchInputs& inputs, const fs::path& output_folder) {
  std::vector<Model> models;
  for (const std::string& argument : inputs.arguments) {
    if (const Result<void> done = add_argument(argument, inputs.recursive, models); !done) {
      return tl::unexpected(done.error());
    }
  }
  if (!inputs.list.empty()) {
    if (const Result<void> done = add_list(inputs.list, inputs.recursive, models); !done) {
      return tl::unexpected(done.error());
    }
  }
  if (models.empty()) {
    return fail(ErrorKind::usage, "",
                fmt::format("there is no model to draw: no .obj, .ply, .stl, .off or .3mf file in {}",
                            inputs.list.empty() ? fmt::format("{}", fmt::join(inputs.arguments, ", ")) : inputs.list));
  }
  drop_repeated(models);
  tell_apart(models);
  std::vector<BatchJob> jobs;
  jobs.reserve(models.size());
  for (const Model& model : models) {
    jobs.push_back({model.input, output_folder / model.name()});
  }
  return jobs;
}

}  // namespace lustro::app
