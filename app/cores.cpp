// Processors by the process's affinity: see cores.hpp.
#include "cores.hpp"

#include <sched.h>
#include <unistd.h>

#include <algorithm>

namespace lustro::app {

int core_count() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (::sched_getaffinity(0, sizeof(set), &set) == 0) {
    return std::max(1, CPU_COUNT(&set));
  }
  return std::max(1, static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN)));  // more processors than the set can name
}

}  // namespace lustro::app
