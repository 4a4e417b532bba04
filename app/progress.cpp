// The progress bar: see progress.hpp.
#include "progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace lustro::app {
namespace {

constexpr std::chrono::milliseconds kPatience{1000};  // shorter work needs no bar
constexpr std::chrono::milliseconds kInterval{100};
constexpr int kBarColumns = 30;

void write_terminal(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

}  // namespace

ProgressBar::ProgressBar(const Session& session, const char* label)
    : allowed_(!session.quiet && stderr_is_terminal()), label_(label), start_(Clock::now()), last_(start_) {}

ProgressBar::~ProgressBar() {
  wipe();
}

std::function<void(double)> ProgressBar::callback() {
  if (!allowed_) {
    return {};
  }
  return [this](double share) { show(share); };
}

void ProgressBar::show(double share) {
  const Clock::time_point now = Clock::now();
  if (now - start_ < kPatience || now - last_ < kInterval) {
    return;
  }
  last_ = now;
  shown_ = true;
  share = std::clamp(share, 0.0, 1.0);
  const int filled = static_cast<int>(share * kBarColumns);
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const std::string left = share > 0.02 ? fmt::format("{:.0f} s left", elapsed / share * (1 - share)) : std::string("...");
  write_terminal(fmt::format("\r\x1b[K{} [{:#<{}}{:.<{}}] {:3.0f} %  {}", label_, "", filled, "", kBarColumns - filled, share * 100, left));
}

void ProgressBar::wipe() {
  if (shown_) {
    write_terminal("\r\x1b[K");
    shown_ = false;
  }
}

}  // namespace lustro::app
