// Whether the files of a model change, and what they are then. Knows no clock: who owns it calls look() from time to time.
#pragma once

#include <optional>
#include <string>

#include "lab_files.hpp"

namespace lustro::app {

class LabWatch {
 public:
  /// Loads the model for the first time.
  /// errors  as read_lab_model()
  [[nodiscard]] static Result<LabWatch> begin(std::string argument, const LoadOptions& options);

  /// The model as it last could be loaded.
  [[nodiscard]] const LabModel& model() const { return model_; }
  /// Why it cannot be loaded as it is now; empty: it can.
  [[nodiscard]] const std::string& problem() const { return problem_; }
  /// What is known now, in a word that changes when it does: the model's version, or that of the problem.
  [[nodiscard]] std::string stamp() const;

  /// Looks at the files. One that is another than it was at the look before may be half written: a change counts when the next look finds
  /// everything as this one did. Then the model is loaded again.
  /// returns  whether stamp() has changed
  bool look();

 private:
  LabWatch(std::string argument, LoadOptions options) : argument_(std::move(argument)), options_(std::move(options)) {}
  [[nodiscard]] FileStates states_now() const;
  void load_again();

  std::string argument_;
  LoadOptions options_;
  LabModel model_;
  std::string problem_;
  FileStates known_;                    // of the files that are watched, as they were when they were read
  std::optional<FileStates> changing_;  // at the last look, where they were others
};

}  // namespace lustro::app
