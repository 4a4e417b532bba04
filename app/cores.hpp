// How many threads there are to have.
#pragma once

namespace lustro::app {

/// The processors that this process may run on, at least 1.
[[nodiscard]] int core_count();

/// What a number of threads means: 0 is one a core.
[[nodiscard]] inline int threads_meant(int threads) {
  return threads > 0 ? threads : core_count();
}

}  // namespace lustro::app
