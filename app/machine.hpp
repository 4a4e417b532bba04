// What the machine can do at most, measured in a fraction of a second: how fast it copies memory, how fast it multiplies and adds.
#pragma once

namespace lustro::app {

struct MachineLimits {
  double copy_bytes_per_second = 0;  ///< read and written, both counted, buffers far larger than the caches of a core
  double operations_per_second = 0;  ///< float multiplications and additions, not fused, in the widest registers
};

/// Takes about 0.2 s.
/// threads  as for drawing, at least 1
[[nodiscard]] MachineLimits measure_machine(int threads);

}  // namespace lustro::app
