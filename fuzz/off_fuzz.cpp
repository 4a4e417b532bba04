// OFF bytes, ascii and binary.
#include <cstddef>
#include <cstdint>

#include "check_mesh.hpp"
#include "io/off.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lustro::check_mesh(lustro::parse_off({reinterpret_cast<const char*>(data), size}, "fuzz.off"));
  return 0;
}
