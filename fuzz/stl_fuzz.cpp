// STL bytes, ascii and binary, and the recognition of mesh formats.
#include <cstddef>
#include <cstdint>

#include "check_mesh.hpp"
#include "io/mesh_format.hpp"
#include "io/stl.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  lustro::check_mesh(lustro::parse_stl(bytes, "fuzz.stl"));
  static_cast<void>(lustro::mesh_format_of_content(bytes));
  static_cast<void>(lustro::describe_content(bytes));
  return 0;
}
