// scene_json(): a scene as the text of a scene file. What is its default is left out; numbers have the fewest digits that read back bit-equal.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "lustro/scene.hpp"
#include "scene/fields.hpp"
#include "scene/text_values.hpp"

namespace lustro {
namespace {

/// The materials that stand in the file's `materials`, each under its name; all others stand in their object.
using SharedMaterials = std::map<std::string, Material>;

std::string text_json(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

template <class N>
std::string number_json(N number) {
  return std::isfinite(number) ? number_text(number) : "null";  // JSON has no such number; reading it back is an error that says where
}

std::string list_json(const std::vector<std::string>& items) {
  return fmt::format("[{}]", fmt::join(items, ", "));
}

/// Whether two materials are the same to a scene file but for their names.
bool equal_but_name(Material a, const Material& b) {
  a.name = b.name;
  return a == b;
}

/// The library material that this one is under another name.
const Material* library_twin(const Material& material) {
  for (const Material& candidate : material_library()) {
    if (equal_but_name(material, candidate)) {
      return &candidate;
    }
  }
  return nullptr;
}

template <class T>
std::string table_json(const T& object, int indent, const SharedMaterials& shared);

struct ToJson {
  int indent;  // of the line that the value stands on
  const SharedMaterials& shared;

  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(int value) const { return fmt::format("{}", value); }
  std::string operator()(float value) const { return number_json(value); }
  std::string operator()(double value) const { return number_json(value); }
  std::string operator()(const Vec3d& v) const { return list_json({number_json(v.x), number_json(v.y), number_json(v.z)}); }
  std::string operator()(const Vec2f& v) const { return list_json({number_json(v.x), number_json(v.y)}); }
  std::string operator()(const WrapPair& wrap) const {
    return wrap.u == wrap.v ? (*this)(wrap.u) : list_json({(*this)(wrap.u), (*this)(wrap.v)});
  }
  std::string operator()(const Vec3f& v) const {
    return v.x == v.y && v.y == v.z ? number_json(v.x) : list_json({number_json(v.x), number_json(v.y), number_json(v.z)});
  }
  std::string operator()(const std::array<float, 6>& matrix) const {
    std::vector<std::string> numbers;
    numbers.reserve(matrix.size());
    for (const float number : matrix) {
      numbers.push_back(number_json(number));
    }
    return list_json(numbers);
  }
  std::string operator()(const StatedReflection& map) const {
    StatedReflection plain;
    plain.picture.emplace().file = map.picture.value_or(StatedTexture{}).file;
    return map == plain ? text_json(map.picture->file) : table_json(map, indent, shared);
  }
  std::string operator()(const StatedTexture& texture) const {
    StatedTexture plain;
    plain.file = texture.file;
    return texture == plain ? text_json(texture.file) : table_json(texture, indent, shared);
  }
  std::string operator()(const Mat4& matrix) const {
    std::vector<std::string> numbers;
    for (const double number : matrix.m) {
      numbers.push_back(number_json(number));
    }
    return list_json(numbers);
  }
  std::string operator()(const Color& color) const { return color_json(color, 1); }
  std::string operator()(const ColorAlphaRef& value) const { return color_json(value.color, value.alpha); }
  std::string operator()(const std::string& value) const { return text_json(value); }
  std::string operator()(const TermSet& terms) const {
    std::vector<std::string> words;
    for (const Word& word : term_words()) {
      if (terms.*kTermMembers[word.value]) {
        words.push_back(fmt::format("\"{}\"", word.word));
      }
    }
    return list_json(words);
  }
  template <class E>
  requires std::is_enum_v<E> std::string operator()(const E& value) const { return fmt::format("\"{}\"", word_of(value)); }
  std::string operator()(const Material& material) const {
    const auto named = shared.find(material.name);
    if (named != shared.end() && named->second == material) {
      return text_json(material.name);
    }
    const bool is_hidden = named != shared.end();
    if (!is_hidden && library_material(material.name) == material) {
      return text_json(material.name);
    }
    return table_json(material, indent, shared);
  }
  template <class V>
  std::string operator()(const std::vector<V>& list) const {
    if (list.empty()) {
      return "[]";
    }
    std::vector<std::string> items;
    items.reserve(list.size());
    for (const V& item : list) {
      items.push_back(fmt::format("\n{:{}}{}", "", indent + 2, table_json(item, indent + 2, shared)));
    }
    return fmt::format("[{}\n{:{}}]", fmt::join(items, ","), "", indent);
  }
  template <class V>
  std::string operator()(const std::optional<V>& value) const {
    if constexpr (kIsToggle<V>) {
      const std::string stated = value ? (*this)(*value) : "";
      return stated == "{}" ? "true" : stated;
    }
    return value ? (*this)(*value) : "";
  }
  std::string operator()(std::monostate) const { return ""; }
  template <class T>
  std::string operator()(const T& table) const {
    return table_json(table, indent, shared);
  }

 private:
  static std::string color_json(const Color& color, float alpha) {
    if (color.space == ColorSpace::encoded) {
      return text_json(color_text(color, alpha));
    }
    std::vector<std::string> numbers{number_json(color.rgb.x), number_json(color.rgb.y), number_json(color.rgb.z)};
    if (alpha != 1.0F) {
      numbers.push_back(number_json(alpha));
    }
    return list_json(numbers);
  }
};

/// With a falloff the file has no place for the three other coefficients, with a matrix none for what it stands for, with a picture none for a
/// colour.
template <class T>
bool is_left_out(const T& object, std::string_view key) {
  if constexpr (std::is_same_v<T, Attenuation>) {
    return object.falloff && (key == "constant" || key == "linear" || key == "quadratic");
  } else if constexpr (std::is_same_v<T, StatedTexture>) {
    return object.matrix && (key == "offset" || key == "scale" || key == "rotation");
  } else if constexpr (std::is_same_v<T, Environment>) {
    return !object.file.empty() && key == "color";
  } else {
    return false;
  }
}

/// Keys that stand even where they are at their default, because a table reads badly without them.
bool is_always_stated(std::string_view key) {
  return key == "type" || key == "mode" || key == "mesh" || key == "objects";
}

std::string value_json(const ValueRef& value, int indent, const SharedMaterials& shared) {
  return visit_value(value, [&](const auto& stated) { return ToJson{indent, shared}(stated); });
}

template <class T>
std::string field_json(const T& object, const Field<T>& field, int indent, const SharedMaterials& shared) {
  T copy = object;
  return value_json(field.value(copy), indent, shared);
}

/// What a table holds that states nothing, or nothing but its textures.
template <class T>
T standard_of(const T& object) {
  if constexpr (std::is_same_v<T, Material>) {
    Material standard = material_with(object.stated_textures);
    standard.stated_textures = {};
    return standard;
  } else {
    return {};
  }
}

/// `{"key": value, ...}`, on one line unless it holds tables or lists of tables.
template <class T>
std::string table_json(const T& object, int indent, const SharedMaterials& shared) {
  const T standard = standard_of(object);
  const SharedMaterials none;
  constexpr bool kIsScene = std::is_same_v<T, Scene>;
  std::vector<std::string> lines;
  for (const Field<T>& field : fields<T>()) {
    if (kIsScene && field.key == "materials" && !shared.empty()) {
      std::vector<std::string> entries;
      for (const auto& [name, material] : shared) {
        const Material* twin = library_twin(material);
        Material unnamed = material;
        unnamed.name.clear();  // its key says it
        entries.push_back(fmt::format("\n    {}: {}", text_json(name), twin != nullptr ? text_json(twin->name) : table_json(unnamed, 4, none)));
      }
      lines.push_back(fmt::format("\"materials\": {{{}\n  }}", fmt::join(entries, ",")));
      continue;
    }
    const std::string value = field_json(object, field, indent + 2, shared);
    if (value.empty() || is_left_out(object, field.key) ||
        (!is_always_stated(field.key) && value == field_json(standard, field, indent + 2, none))) {
      continue;
    }
    lines.push_back(fmt::format("\"{}\": {}", field.key, value));
  }
  return kIsScene ? fmt::format("{{\n  {}\n}}\n", fmt::join(lines, ",\n  ")) : fmt::format("{{{}}}", fmt::join(lines, ", "));
}

}  // namespace

std::string scene_json(const Scene& scene) {
  SharedMaterials shared;
  for (const Object& object : scene.objects) {
    if (object.material && !object.material->name.empty() && library_material(object.material->name) != object.material) {
      shared.emplace(object.material->name, *object.material);  // the first of that name; another one stands in its object, with its name
    }
  }
  return table_json(scene, 0, shared);
}

}  // namespace lustro
