// The model part of a 3MF package, put into a package without packing: what changes is the XML.
#include <cstddef>
#include <cstdint>
#include <string>

#include "check_mesh.hpp"
#include "image/inflate.hpp"
#include "io/threemf.hpp"
#include "io/write_bytes.hpp"

namespace {

/// A ZIP archive with the one part `3D/3dmodel.model`, stored.
std::string package(std::string_view xml) {
  const std::string name = "3D/3dmodel.model";
  std::string common("\x14\x00\x00\x00\x00\x00\x00\x00\x00\x00", 10);  // version, flags, stored, time, date
  lustro::append_u32(common, lustro::crc32_of(xml));
  lustro::append_u32(common, static_cast<std::uint32_t>(xml.size()));
  lustro::append_u32(common, static_cast<std::uint32_t>(xml.size()));
  lustro::append_u32(common, static_cast<std::uint32_t>(name.size()));  // of the name, and 0 of the extra field
  std::string bytes = "PK\x03\x04" + common + name;
  bytes.append(xml);
  const std::size_t directory = bytes.size();
  bytes += std::string("PK\x01\x02\x14\x00", 6) + common + std::string(14, '\0') + name;
  const std::size_t directory_bytes = bytes.size() - directory;
  bytes += std::string("PK\x05\x06\x00\x00\x00\x00\x01\x00\x01\x00", 12);
  lustro::append_u32(bytes, static_cast<std::uint32_t>(directory_bytes));
  lustro::append_u32(bytes, static_cast<std::uint32_t>(directory));
  return bytes + std::string(2, '\0');
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr lustro::ThreeMfLimits kLimits{.bytes = 1U << 24U, .uses = 1000, .triangles = 10000};
  const lustro::Result<lustro::SourceMesh> mesh =
      lustro::parse_threemf(package({reinterpret_cast<const char*>(data), size}), "fuzz.3mf", kLimits);
  lustro::check_mesh(mesh);
  return 0;
}
