// PLY bytes, ascii and binary; the short way through usual files against the general one.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "check_mesh.hpp"
#include "check_same.hpp"
#include "io/ply.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes{reinterpret_cast<const char*>(data), size};
  const auto mesh = lustro::parse_ply(bytes, "fuzz.ply");
  lustro::check_same(mesh, lustro::parse_any_ply(bytes, "fuzz.ply"));
  lustro::check_mesh(mesh);
  return 0;
}
