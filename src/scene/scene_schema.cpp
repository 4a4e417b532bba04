// scene_schema(): the JSON Schema of the scene file, made from the table of options. It says what parse_scene() checks of each key by itself;
// what holds between keys (near < far, ...) only parse_scene() checks. Vocabulary: json-schema.org, draft 2020-12.
#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "lustro/scene.hpp"
#include "scene/fields.hpp"
#include "scene/scene_reader.hpp"

namespace lustro {
namespace {

using Schema = nlohmann::ordered_json;

constexpr std::string_view kHexColor = "^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$";
constexpr std::string_view kHexColorAlpha = "^#([0-9a-fA-F]{3,4}|[0-9a-fA-F]{6}|[0-9a-fA-F]{8})$";
constexpr std::string_view kCssColor = R"(^color\(srgb( +[0-9][0-9.eE+-]*){3} *\)$)";
constexpr std::string_view kCssColorAlpha = R"(^color\(srgb( +[0-9][0-9.eE+-]*){3}( */ *[0-9][0-9.eE+-]*)? *\)$)";

Schema reference(std::string_view name) {
  return {{"$ref", fmt::format("#/$defs/{}", name)}};
}

Schema number_schema(const Range& range, std::string_view type) {
  Schema schema{{"type", type}};
  if (!range.allowed.empty()) {
    schema["enum"] = std::vector<int>(range.allowed.begin(), range.allowed.end());
    return schema;
  }
  // Whole ends are written as whole numbers, as a person would.
  const auto end = [](double value) {
    return value == std::floor(value) && std::abs(value) < 1e9 ? Schema(static_cast<int>(value)) : Schema(value);
  };
  schema[range.lower_open ? "exclusiveMinimum" : "minimum"] = end(range.lower);
  schema[range.upper_open ? "exclusiveMaximum" : "maximum"] = end(range.upper);
  return schema;
}

Schema list_schema(Schema items, std::size_t least, std::size_t most) {
  return {{"type", "array"}, {"items", std::move(items)}, {"minItems", least}, {"maxItems", most}};
}

Schema color_schema(bool with_alpha) {
  const Range range{.lower = 0};
  const Range unit{.lower = 0, .upper = 1};
  Schema list = list_schema(number_schema(range, "number"), 3, 3);
  Schema forms = Schema::array({list});
  if (with_alpha) {
    Schema four{{"type", "array"}};
    four["prefixItems"] = Schema::array(
        {number_schema(range, "number"), number_schema(range, "number"), number_schema(range, "number"), number_schema(unit, "number")});
    four["minItems"] = 4;
    four["maxItems"] = 4;
    forms.push_back(four);
  }
  forms.push_back({{"type", "string"}, {"pattern", with_alpha ? kHexColorAlpha : kHexColor}});
  forms.push_back({{"type", "string"}, {"pattern", with_alpha ? kCssColorAlpha : kCssColor}});
  return {{"description", with_alpha ? "[r, g, b] or [r, g, b, a] (linear), or \"#rrggbb\" (sRGB)" : "[r, g, b] (linear) or \"#rrggbb\" (sRGB)"},
          {"anyOf", std::move(forms)}};
}

Schema words_schema(std::span<const Word> words) {
  std::vector<std::string> list;
  for (const Word& word : words) {
    list.emplace_back(word.word);
  }
  return {{"enum", list}};
}

Schema terms_schema() {
  Schema schema{{"type", "array"}, {"items", words_schema(term_words())}};
  schema["uniqueItems"] = true;
  return schema;
}

Schema text_schema() {
  return {{"type", "string"}, {"pattern", R"(^[^\u0000]*$)"}};
}

/// What stands for `mesh`: text that is not empty.
Schema mesh_schema() {
  return {{"type", "string"}, {"minLength", 1}, {"pattern", R"(^[^\u0000]*$)"}};
}

Schema table_schema(const FieldGroup& group);

Schema value_schema(const FieldInfo& field) {
  switch (field.kind) {
    case ValueKind::boolean:
      return {{"type", "boolean"}};
    case ValueKind::integer:
      return number_schema(field.range, "integer");
    case ValueKind::number:
      return number_schema(field.range, "number");
    case ValueKind::vector:
      return reference("vector");
    case ValueKind::matrix:
      return reference("matrix");
    case ValueKind::color:
      return reference("color");
    case ValueKind::color_alpha:
      return reference("color_alpha");
    case ValueKind::word:
      return words_schema(field.words);
    case ValueKind::terms:
      return terms_schema();
    case ValueKind::text:
      return field.key == "mesh" || field.key == "file" ? mesh_schema() : text_schema();
    case ValueKind::table:
      if (field.key == "environment") {
        return {{"anyOf", Schema::array({mesh_schema(), reference("color"), reference(field.key)})}};
      }
      return reference(field.key);
    case ValueKind::toggle:
      return {{"anyOf", Schema::array({{{"type", "boolean"}}, reference(field.key)})}};
    case ValueKind::lights:
      return {{"type", "array"}, {"items", reference("light")}};
    case ValueKind::objects:
      return {{"type", "array"}, {"items", reference("object")}};
    case ValueKind::material:
      return {{"anyOf", Schema::array({{{"type", "string"}}, reference("material")})}};
    case ValueKind::texture:
      return {{"anyOf", Schema::array({mesh_schema(), reference("texture")})}};
    case ValueKind::reflection:
      return {{"anyOf", Schema::array({mesh_schema(), reference("reflection")})}};
    case ValueKind::triple:
      return {{"anyOf", Schema::array({number_schema(field.range, "number"), list_schema(number_schema(field.range, "number"), 3, 3)})}};
    case ValueKind::affine:
      return list_schema(number_schema(field.range, "number"), 6, 6);
    case ValueKind::pair:
      return list_schema(number_schema(field.range, "number"), 2, 2);
    case ValueKind::wrap:
      return {{"anyOf", Schema::array({words_schema(field.words), list_schema(words_schema(field.words), 2, 2)})}};
    case ValueKind::materials: {
      std::vector<std::string> names;
      for (const Material& material : material_library()) {
        names.push_back(material.name);
      }
      const Schema either = {{"anyOf", Schema::array({{{"enum", names}}, reference("material")})}};
      return {{"type", "object"}, {"additionalProperties", either}};
    }
  }
  return {};
}

/// The help, the unit, what the words mean, and the default.
std::string description_of(const FieldInfo& field) {
  std::string text(field.help);
  if (!field.unit.empty()) {
    text += fmt::format(" ({})", field.unit);
  }
  for (std::size_t i = 0; i < field.words.size(); ++i) {
    text += fmt::format("{}{}: {}", i == 0 ? ". " : "; ", field.words[i].word, field.words[i].help);
  }
  if (!field.default_text.empty()) {
    text += fmt::format(". Default: {}", field.default_text);
  }
  return text;
}

Schema table_schema(const FieldGroup& group) {
  Schema properties = Schema::object();
  std::vector<std::string> required;
  for (const FieldInfo& field : group.fields) {
    Schema schema{{"description", description_of(field)}};
    schema.update(value_schema(field));
    properties[std::string(field.key)] = std::move(schema);
    if (field.key == "objects" || field.key == "mesh" || (field.key == "file" && group.path != "environment")) {
      required.emplace_back(field.key);
    }
  }
  Schema schema{{"type", "object"}, {"description", group.help}, {"properties", std::move(properties)}, {"additionalProperties", false}};
  if (!required.empty()) {
    schema["required"] = required;
  }
  return schema;
}

/// `lights[]` is the table `light`, `materials.*` the table `material`, ...
std::string_view table_name(std::string_view path) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kNames{{{"lights[]", "light"},
                                                                                 {"image.tone", "tone"},
                                                                                 {"lights[].attenuation", "attenuation"},
                                                                                 {"materials.*", "material"},
                                                                                 {"materials.*.textures", "textures"},
                                                                                 {"materials.*.textures.*", "texture"},
                                                                                 {"materials.*.textures.reflection", "reflection"},
                                                                                 {"objects[]", "object"}}};
  for (const auto& [from, to] : kNames) {
    if (path == from) {
      return to;
    }
  }
  return path;
}

}  // namespace

std::string scene_schema() {
  Schema definitions = Schema::object();
  const Range any;
  definitions["vector"] = list_schema(number_schema(any, "number"), 3, 3);
  definitions["matrix"] = list_schema(number_schema(any, "number"), 16, 16);
  definitions["color"] = color_schema(false);
  definitions["color_alpha"] = color_schema(true);
  Schema root;
  for (const FieldGroup& group : field_groups()) {
    if (group.path.empty()) {
      root = table_schema(group);
    } else {
      definitions[std::string(table_name(group.path))] = table_schema(group);
    }
  }
  // A falloff stands alone.
  definitions["attenuation"]["if"] = {{"required", {"falloff"}}};
  definitions["attenuation"]["then"]["properties"] = {{"constant", false}, {"linear", false}, {"quadratic", false}};
  // A picture or a colour.
  definitions["environment"]["if"] = {{"required", {"file"}}};
  definitions["environment"]["then"]["properties"] = {{"color", false}};
  // A matrix stands in place of three keys; a sphere has one picture, a cube has six.
  definitions["texture"]["if"] = {{"required", {"matrix"}}};
  definitions["texture"]["then"]["properties"] = {{"offset", false}, {"scale", false}, {"rotation", false}};
  Schema& reflection = definitions["reflection"];
  reflection["if"] = {{"properties", {{"shape", {{"const", "cube"}}}}}, {"required", {"shape"}}};
  reflection["then"] = {{"required", {"right", "left", "top", "bottom", "front", "back"}}, {"properties", {{"picture", false}}}};
  reflection["else"]["required"] = {"picture"};
  reflection["else"]["properties"] = {{"right", false}, {"left", false}, {"top", false}, {"bottom", false}, {"front", false}, {"back", false}};
  root["properties"][std::string(kSchemaKey)] = {{"description", "where editors find this schema"}, {"type", "string"}};

  Schema schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "Lustro scene file"}};
  schema.update(root);
  schema["$defs"] = std::move(definitions);
  return schema.dump(2) + "\n";
}

}  // namespace lustro
