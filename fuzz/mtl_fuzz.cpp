// MTL bytes, and what their map statements mean.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "check_mesh.hpp"
#include "io/map_texture.hpp"
#include "io/mtl.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using lustro::require;
  lustro::MtlOptions options;
  options.transparency_is_tr = size % 2 == 1;
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
      std::size_t notes = 0;
      const auto use = lustro::use_of_map(map, {.transparency_is_tr = options.transparency_is_tr, .illumination = material.illumination},
                                          [&](const std::string& note) { notes += note.empty() ? 0 : 1; });
      require(use || notes > 0, "a map is used, or a note says why not");
      if (use) {
        require(lustro::is_finite(use->use.gain) && lustro::is_finite(use->use.base), "a map's numbers are finite");
        require(use->use.channel <= 4, "a map's channel is one");
      }
    }
  }
  return 0;
}
