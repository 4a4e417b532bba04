// MTL bytes.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "check_mesh.hpp"
#include "io/mtl.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using lustro::require;
  lustro::MtlOptions options;
  options.transparency_is_tr = size % 2 == 1;
  options.has_map = [](const std::string& name) { return name.size() % 2 == 0; };
  const lustro::Result<lustro::MtlFile> file = lustro::parse_mtl({reinterpret_cast<const char*>(data), size}, "fuzz.mtl", options);
  if (!file) {
    require(!file.error().where.empty() && !file.error().message.empty(), "an error says where and what");
    return 0;
  }
  for (const lustro::Material& material : file->materials) {
    for (const lustro::Color& color : {material.ambient, material.diffuse, material.specular, material.emission, material.transmission}) {
      require(lustro::is_finite(color.rgb) && color.rgb.x >= 0 && color.rgb.y >= 0 && color.rgb.z >= 0, "colours are finite and not negative");
    }
    require(material.opacity >= 0 && material.opacity <= 1, "opacity is in 0..1");
    require(material.shininess >= 0 && material.shininess <= 10000, "shininess is in 0..10000");
    for (const lustro::TextureMap& map : material.maps) {
      require(!map.file.empty() && !map.statement.empty(), "a map names its file");
    }
  }
  return 0;
}
