// OBJ bytes, in small parts and line by line; the material library that they name is a small fixed one.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "check_mesh.hpp"
#include "check_same.hpp"
#include "io/obj.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lustro::ObjOptions options;
  options.read_library = [](const std::string& name) -> lustro::Result<std::string> {
    if (name.ends_with("missing.mtl")) {
      return lustro::fail(lustro::ErrorKind::io, name, "is missing");
    }
    return std::string("newmtl red\nKd 1 0 0\nmap_Kd red.png\nnewmtl Material\nillum 1\nTr 0.5\n");
  };
  options.threads = 1;
  options.part_bytes = 48;
  const std::string_view bytes{reinterpret_cast<const char*>(data), size};
  const auto mesh = lustro::parse_obj(bytes, "fuzz.obj", options);
  lustro::check_same(mesh, lustro::parse_obj_line_by_line(bytes, "fuzz.obj", options));
  lustro::check_mesh(mesh);
  return 0;
}
