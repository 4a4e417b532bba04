// MTL (Ramey, Rose, Tyerman 1995): coefficients as `encoded` colours, and map statements as they came.
#include <fmt/format.h>

#include <set>

#include "image/srgb.hpp"
#include "io/mesh_writers.hpp"
#include "io/write_text.hpp"

namespace lustro {
namespace {

Vec3f encoded(const Color& color) {
  if (color.space == ColorSpace::encoded) {
    return color.rgb;
  }
  return {srgb_encode(color.rgb.x), srgb_encode(color.rgb.y), srgb_encode(color.rgb.z)};
}

void append_color(std::string& text, const char* statement, const Color& color) {
  text += statement;
  append_vector(text, encoded(color));
  text += '\n';
}
void append_value(std::string& text, const char* statement, float value) {
  text += statement;
  append_number(text, value);
  text += '\n';
}

int illumination(const Material& material) {
  if (material.illumination) {
    return *material.illumination;
  }
  return material.lighting == Lighting::constant ? 0 : material.lighting == Lighting::lambert ? 1 : 2;
}

void append_option(std::string& text, const char* name, const Vec3f& value, const Vec3f& otherwise) {
  if (value != otherwise) {
    text += fmt::format(" {}", name);
    append_vector(text, value);
  }
}

std::string map_statement(const TextureMap& map, const NameFile& name_map) {
  std::string text = map.statement;
  text += map.blend_u ? "" : " -blendu off";
  text += map.blend_v ? "" : " -blendv off";
  text += map.color_correction ? " -cc on" : "";
  text += map.clamp ? " -clamp on" : "";
  text += map.boost != 0 ? fmt::format(" -boost {}", map.boost) : "";
  text += map.bump_multiplier != 1 ? fmt::format(" -bm {}", map.bump_multiplier) : "";
  text += map.base != 0 || map.gain != 1 ? fmt::format(" -mm {} {}", map.base, map.gain) : "";
  append_option(text, "-o", map.offset, {});
  append_option(text, "-s", map.scale, {1, 1, 1});
  append_option(text, "-t", map.turbulence, {});
  text += map.texture_resolution != 0 ? fmt::format(" -texres {}", map.texture_resolution) : "";
  text += map.channel != 0 ? fmt::format(" -imfchan {}", map.channel) : "";
  text += !map.type.empty() ? fmt::format(" -type {}", map.type) : "";
  return text + fmt::format(" {}\n", name_map(map.file));
}

bool has_textures(const Material& material) {
  return material.textures != MaterialTextures{};
}

}  // namespace

std::vector<std::string> material_names(const std::vector<Material>& materials) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const Material& material : materials) {
    std::string name = material.name;
    for (char& c : name) {  // what would end the name, or the line
      const auto byte = static_cast<unsigned char>(c);
      c = byte < 0x20U || byte == 0x7FU || c == '#' || c == '\\' ? '_' : c;
    }
    const std::size_t begin = name.find_first_not_of(' ');
    name = begin == std::string::npos ? "material" : name.substr(begin, name.find_last_not_of(' ') - begin + 1);
    const std::string base = name;
    for (int i = 2; !taken.insert(name).second; ++i) {
      name = fmt::format("{}_{}", base, i);
    }
    names.push_back(std::move(name));
  }
  return names;
}

MeshBytes mtl_bytes(const Mesh& mesh, const NameFile& name_map) {
  MeshBytes mtl;
  std::string& text = mtl.bytes;
  text = "# written by Lustro\n";
  const std::vector<std::string> names = material_names(mesh.materials);
  std::size_t textured = 0;
  std::size_t lit = 0;
  for (std::size_t i = 0; i < mesh.materials.size(); ++i) {
    const Material& material = mesh.materials[i];
    text += fmt::format("\nnewmtl {}\n", names[i]);
    append_color(text, "Ka", material.ambient);
    append_color(text, "Kd", material.diffuse);
    append_color(text, "Ks", material.specular);
    if (material.emission.rgb != Vec3f{}) {
      append_color(text, "Ke", material.emission);
    }
    append_value(text, "Ns", material.shininess);
    text += fmt::format("d{} {}\n", material.halo ? " -halo" : "", material.opacity);
    if (encoded(material.transmission) != Vec3f{1, 1, 1}) {
      append_color(text, "Tf", material.transmission);
    }
    if (material.refraction != 1) {
      append_value(text, "Ni", material.refraction);
    }
    if (material.sharpness != 60) {
      append_value(text, "sharpness", material.sharpness);
    }
    text += fmt::format("illum {}\n", illumination(material));
    for (const TextureMap& map : material.maps) {
      text += map_statement(map, name_map);
    }
    textured += material.maps.empty() && has_textures(material) ? 1U : 0U;
    lit += material.lighting && *material.lighting != Lighting::constant && *material.lighting != Lighting::lambert ? 1U : 0U;
  }
  if (textured != 0) {
    mtl.notes.push_back({"", fmt::format("textures of {} materials came with no file of their own and are left out", textured)});
  }
  if (lit != 0) {
    mtl.notes.push_back({"", fmt::format("MTL does not tell Phong, Blinn and GGX apart: the lighting of {} materials is left out", lit)});
  }
  return mtl;
}

}  // namespace lustro
