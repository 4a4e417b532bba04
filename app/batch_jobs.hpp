// What a batch draws and where each picture goes: folders unfolded, lists read, names that would clash told apart by their folders.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lustro/result.hpp"

namespace lustro::app {

struct BatchJob {
  std::string input;             ///< as load_scene_argument() takes it
  std::filesystem::path output;  ///< inside the output folder
};

struct BatchInputs {
  std::vector<std::string> arguments;  ///< files, folders, primitives
  std::string list;                    ///< a file with one of them a line; `-`: standard input; empty: none
  bool recursive = false;              ///< folders with their folders
};

/// One job for each model, each once, in the order of the arguments; the models of a folder (by their extensions) in the order of their names.
/// `models/a/chair.obj` of the folder `models` becomes `a/chair.png`; a file named alone `chair.png`. Where two pictures would have one name,
/// both are led by as many of their folders as tell them apart, and models that differ only in their extension keep it: `chair.obj.png`.
///
/// errors  io where a folder or the list cannot be read; usage where there is no model at all
[[nodiscard]] Result<std::vector<BatchJob>> batch_jobs(const BatchInputs& inputs, const std::filesystem::path& output_folder);

}  // namespace lustro::app
