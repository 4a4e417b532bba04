// Answers that need no scene to be drawn: see answers.hpp.
#include "answers.hpp"

#include <array>
#include <cmath>

#include "math/trig.hpp"
#include "scene/fields.hpp"
#include "scene/words.hpp"

namespace lustro::web {
namespace {

using app::json_number;
using app::json_vector;

std::string_view kind_word(ValueKind kind) {
  constexpr std::array<std::string_view, 22> kWords{"boolean",    "integer", "number", "vector", "matrix",  "color",    "color_alpha", "word",
                                                    "terms",      "text",    "table",  "lights", "objects", "material", "materials",   "texture",
                                                    "reflection", "wrap",    "pair",   "triple", "affine",  "toggle"};
  return kWords.at(static_cast<std::size_t>(kind));
}

Json option_json(const FieldInfo& field) {
  Json json{
      {"key", field.key},           {"flag", field.flag},           {"help", field.help}, {"unit", field.unit}, {"kind", kind_word(field.kind)},
      {"optional", field.optional}, {"default", field.default_text}};
  if (field.range.lower > -kLargestNumber) {
    json["minimum"] = field.range.lower;
    json["minimumOpen"] = field.range.lower_open;
  }
  if (field.range.upper < kLargestNumber) {
    json["maximum"] = field.range.upper;
    json["maximumOpen"] = field.range.upper_open;
  }
  if (!field.range.allowed.empty()) {
    json["allowed"] = std::vector<int>(field.range.allowed.begin(), field.range.allowed.end());
  }
  Json& words = json["words"] = Json::array();
  for (const Word& word : field.words) {
    words.push_back({{"word", word.word}, {"help", word.help}});
  }
  return json;
}

}  // namespace

std::string_view kind_word(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::usage:
      return "usage";
    case ErrorKind::io:
      return "io";
    case ErrorKind::malformed:
      return "malformed";
    case ErrorKind::unsupported:
      return "unsupported";
    case ErrorKind::limit:
      return "limit";
    case ErrorKind::empty:
      return "empty";
  }
  return "usage";
}

std::string answer(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string error_answer(const Error& error) {
  return answer({{"error", {{"kind", kind_word(error.kind)}, {"where", error.where}, {"message", error.message}}}});
}

Json note_list(const Notes& notes) {
  Json list = Json::array();
  for (const Note& note : notes) {
    list.push_back(note.text());
  }
  return list;
}

Json option_groups() {
  Json groups = Json::array();
  for (const FieldGroup& group : field_groups()) {
    Json options = Json::array();
    for (const FieldInfo& field : group.fields) {
      options.push_back(option_json(field));
    }
    groups.push_back({{"path", group.path}, {"help", group.help}, {"options", std::move(options)}});
  }
  return groups;
}

Json material_table(const Material& material) {
  Scene scene;
  scene.objects.push_back({.source = "primitive:plane", .material = material});
  scene.objects.front().material->name.clear();  // else it might be said by its name
  return Json::parse(scene_json(scene))["objects"][0].value("material", Json::object());
}

Json material_list() {
  Json list = Json::array();
  for (const Material& material : material_library()) {
    list.push_back({{"name", material.name}, {"table", material_table(material)}});
  }
  return list;
}

Json view_answer(const Camera& camera, const ImageSettings& image) {
  const Vec3d forward = normalize(*camera.target - *camera.eye);
  const Vec3d right = normalize(cross(forward, *camera.up));
  const double pixels =
      camera.projection == Projection::orthographic ? image.height / *camera.height : image.height / (2 * tangent(radians(camera.fov) / 2));
  return {{"projection", word_of(camera.projection)},
          {"eye", json_vector(*camera.eye)},
          {"target", json_vector(*camera.target)},
          {"right", json_vector(right)},
          {"up", json_vector(cross(right, forward))},
          {"forward", json_vector(forward)},
          {"near", json_number(*camera.near)},
          {"far", json_number(*camera.far)},
          {"pixelsPerUnit", json_number(pixels)},
          {"width", image.width},
          {"height", image.height}};
}

Json light_list(const std::vector<Light>& lights) {
  Scene scene;
  scene.lights = lights;
  const Json stated = Json::parse(scene_json(scene)).value("lights", Json::array());
  Json list = Json::array();
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const Light& light = lights[i];
    list.push_back({{"type", word_of(light.type)},
                    {"name", light.name},
                    {"position", json_vector(light.position)},
                    {"direction", json_vector(light.direction)},
                    {"stated", stated.at(i)}});
  }
  return list;
}

}  // namespace lustro::web
