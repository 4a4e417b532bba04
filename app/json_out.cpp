// JSON results: see json_out.hpp.
#include "json_out.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "scene/words.hpp"

namespace lustro::app {

Json json_number(float x) {
  // The shortest text of the float, read as a double, prints as that same text.
  return std::isfinite(x) ? Json(std::strtod(fmt::format("{}", x).c_str(), nullptr)) : Json(nullptr);
}

Json json_number(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

Json json_vector(const Vec3f& v) {
  return Json::array({json_number(v.x), json_number(v.y), json_number(v.z)});
}
Json json_vector(const Vec3d& v) {
  return Json::array({json_number(v.x), json_number(v.y), json_number(v.z)});
}

Json json_bounds(const Bounds& bounds) {
  if (bounds.is_empty()) {
    return nullptr;
  }
  return {{"lower", json_vector(bounds.lower)}, {"upper", json_vector(bounds.upper)}};
}

Json json_color(const Color& color) {
  return {{"rgb", json_vector(color.rgb)}, {"space", color.space == ColorSpace::encoded ? "srgb" : "linear"}};
}

Json json_material(const Material& material) {
  Json json{{"name", material.name},
            {"ambient", json_color(material.ambient)},
            {"diffuse", json_color(material.diffuse)},
            {"specular", json_color(material.specular)},
            {"emission", json_color(material.emission)},
            {"shininess", json_number(material.shininess)},
            {"opacity", json_number(material.opacity)}};
  if (material.lighting) {
    json["lighting"] = word_of(*material.lighting);
  }
  if (material.illumination) {
    json["illumination"] = *material.illumination;
  }
  if (!material.maps.empty()) {
    Json& maps = json["maps"] = Json::array();
    for (const TextureMap& map : material.maps) {
      maps.push_back({{"statement", map.statement}, {"file", map.file}});
    }
  }
  return json;
}

Json json_notes(const Notes& notes) {
  Json json = Json::array();
  for (const Note& note : notes) {
    json.push_back({{"where", note.where}, {"message", note.message}});
  }
  return json;
}

}  // namespace lustro::app
