// How much of a loop's work is done, told from any thread.
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>

namespace lustro {

/// Calls `report`, if there is one, with the share of steps that are done, 0..1, one call at a time.
class Progress {
 public:
  Progress(const std::function<void(double)>& report, std::size_t total) : report_(report), total_(total) {}
  void step() {
    if (report_) {
      const std::lock_guard lock(mutex_);
      report_(static_cast<double>(++done_) / static_cast<double>(total_));
    }
  }

 private:
  const std::function<void(double)>& report_;
  std::size_t total_;
  std::size_t done_ = 0;
  std::mutex mutex_;
};

}  // namespace lustro
