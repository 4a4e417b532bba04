// Two equal looks after one that differs: see lab_watch.hpp.
#include "lab_watch.hpp"

#include <fmt/format.h>

#include <span>
#include <utility>

#include "heap.hpp"
#include "image/hash.hpp"

namespace lustro::app {

Result<LabWatch> LabWatch::begin(std::string argument, const LoadOptions& options) {
  LabWatch watch(std::move(argument), options);
  Result<LabModel> model = read_lab_model(watch.argument_, options, watch.known_);
  if (!model) {
    return tl::unexpected(std::move(model).error());
  }
  watch.model_ = *std::move(model);
  give_back_heap();  // the scene is gone: only its files count
  return watch;
}

std::string LabWatch::stamp() const {
  return problem_.empty() ? model_.version : fmt::format("error-{:016x}", xxh64(std::as_bytes(std::span(problem_)), 0));
}

FileStates LabWatch::states_now() const {
  FileStates states;
  for (const auto& [file, state] : known_) {
    states.emplace(file, state_of(file));
  }
  return states;
}

void LabWatch::load_again() {
  FileStates states;
  Result<LabModel> model = read_lab_model(argument_, options_, states);
  // What is gone is watched on, since it may come back. (What keeps a model from being loaded was opened, and so is among the states.)
  for (const auto& [file, state] : known_) {
    if (const FileState now = state_of(file); !now.is_there) {
      states.emplace(file, now);
    }
  }
  known_ = std::move(states);
  problem_ = model ? std::string() : model.error().text();
  if (model) {
    model_ = *std::move(model);
  }
  give_back_heap();
}

bool LabWatch::look() {
  FileStates now = states_now();
  if (now == known_) {
    changing_.reset();
    return false;
  }
  if (!changing_ || *changing_ != now) {
    changing_ = std::move(now);
    return false;
  }
  changing_.reset();
  const std::string before = stamp();
  load_again();
  return stamp() != before;
}

}  // namespace lustro::app
