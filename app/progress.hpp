// A progress bar on stderr, for people only: it appears where stderr is a terminal and the work takes over a second, and it wipes itself away.
#pragma once

#include <chrono>
#include <functional>

#include "report.hpp"

namespace lustro::app {

class ProgressBar {
 public:
  ProgressBar(const Session& session, const char* label);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// What RenderOptions::progress wants; empty where no bar may appear. Refers to this bar.
  [[nodiscard]] std::function<void(double)> callback();
  /// Takes the bar off the terminal, before something else is said there.
  void wipe();

 private:
  using Clock = std::chrono::steady_clock;
  void show(double share);

  bool allowed_;
  bool shown_ = false;
  const char* label_;
  Clock::time_point start_;
  Clock::time_point last_;
};

}  // namespace lustro::app
