// 3MF packages as they are: the ZIP directory, unpacking, and what comes of it.
#include <cstddef>
#include <cstdint>

#include "check_mesh.hpp"
#include "io/threemf.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr lustro::ThreeMfLimits kLimits{.bytes = 1U << 24U, .uses = 1000, .triangles = 10000};
  lustro::check_mesh(lustro::parse_threemf({reinterpret_cast<const char*>(data), size}, "fuzz.3mf", kLimits));
  return 0;
}
