// The scene file's keys into structs, through the table of options: kinds, ranges and words are checked here, each error with the key's path.
#include "scene/scene_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "scene/fields.hpp"
#include "scene/json_document.hpp"
#include "scene/nearest.hpp"
#include "scene/text_values.hpp"

namespace lustro {
namespace {

using nlohmann::json;

tl::unexpected<Error> fail_at(const JsonPath& path, std::string message, ErrorKind kind = ErrorKind::malformed) {
  return fail(kind, path.text(), std::move(message));
}

tl::unexpected<Error> expected_at(const JsonPath& path, std::string_view expected, const json& found) {
  return fail_at(path, fmt::format("found {}, expected {}", found_text(found), expected));
}

Result<double> read_number(const json& value, const Range& range, const JsonPath& path) {
  if (!value.is_number()) {
    return expected_at(path, "a number", value);
  }
  const auto number = value.get<double>();
  if (!range.contains(number)) {
    return fail_at(path, outside_message(range, number));
  }
  return number;
}

template <class T>
Result<void> read_table(const json& value, T& object, const JsonPath& path, const NamedMaterials& materials);

/// Reads one value, chosen by the type of the member.
struct FromJson {
  const json& value;
  const Range& range;
  const JsonPath& path;
  const NamedMaterials& materials;

  Result<void> operator()(bool& to) const {
    if (!value.is_boolean()) {
      return expected_at(path, "true or false", value);
    }
    to = value.get<bool>();
    return {};
  }

  Result<void> operator()(int& to) const {
    if (!value.is_number() || std::floor(value.get<double>()) != value.get<double>()) {
      return expected_at(path, "a whole number", value);
    }
    return number(to);
  }
  Result<void> operator()(float& to) const { return number(to); }
  Result<void> operator()(double& to) const { return number(to); }

  Result<void> operator()(Vec3d& to) const {
    const auto read = numbers(3, 3, "a list of three numbers [x, y, z]");
    if (!read) {
      return tl::unexpected(read.error());
    }
    to = {(*read)[0], (*read)[1], (*read)[2]};
    return {};
  }

  Result<void> operator()(Vec2f& to) const {
    const auto read = numbers(2, 2, "a list of two numbers [u, v]");
    if (!read) {
      return tl::unexpected(read.error());
    }
    to = {static_cast<float>((*read)[0]), static_cast<float>((*read)[1])};
    return {};
  }

  Result<void> operator()(Vec3f& to) const {
    if (value.is_number()) {
      const auto read = read_number(value, range, path);
      if (!read) {
        return tl::unexpected(read.error());
      }
      to.x = to.y = to.z = static_cast<float>(*read);
      return {};
    }
    const auto read = numbers(3, 3, "a number, or a list of three [r, g, b]");
    if (!read) {
      return tl::unexpected(read.error());
    }
    to = {static_cast<float>((*read)[0]), static_cast<float>((*read)[1]), static_cast<float>((*read)[2])};
    return {};
  }

  Result<void> operator()(std::array<float, 6>& to) const {
    const auto read = numbers(6, 6, "a list of six numbers, row by row");
    if (!read) {
      return tl::unexpected(read.error());
    }
    std::transform(read->begin(), read->end(), to.begin(), [](double number) { return static_cast<float>(number); });
    return {};
  }

  Result<void> operator()(WrapPair& to) const {
    if (!value.is_array()) {
      const auto word = read_word(value, words_of<Wrap>(), path);
      if (!word) {
        return tl::unexpected(word.error());
      }
      to.u = to.v = static_cast<Wrap>(*word);
      return {};
    }
    if (value.size() != 2) {
      return expected_at(path, fmt::format("a word or a list of two ({})", word_list(words_of<Wrap>())), value);
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const auto word = read_word(value[i], words_of<Wrap>(), path[i]);
      if (!word) {
        return tl::unexpected(word.error());
      }
      (i == 0 ? to.u : to.v) = static_cast<Wrap>(*word);
    }
    return {};
  }

  Result<void> operator()(StatedTexture& to) const {
    if (value.is_string()) {
      if (auto done = (*this)(to.file); !done) {
        return done;
      }
    } else if (!value.is_object()) {
      return expected_at(path, "the name of a picture's file or a table", value);
    } else if (auto done = stands_alone("matrix", {"offset", "scale", "rotation"}); !done) {
      return done;
    } else if (auto read = read_table(value, to, path, materials); !read) {
      return read;
    }
    if (to.file.empty()) {
      return fail_at(value.is_object() ? path / "file" : path, "is missing, expected the name of a picture's file");
    }
    return {};
  }

  /// A picture or a colour.
  Result<void> operator()(Environment& to) const {
    if (value.is_string() && !is_color_text(value.get_ref<const std::string&>())) {
      if (auto done = (*this)(to.file); !done) {
        return done;
      }
      return to.file.empty() ? fail_at(path, "is empty, expected the name of a picture's file or a colour") : Result<void>{};
    }
    if (!value.is_object()) {
      constexpr Range kColor{.lower = 0};
      return FromJson{value, kColor, path, materials}(to.color);
    }
    if (value.contains("file") && value.contains("color")) {
      return fail_at(path, "states both file and color, expected one of them");
    }
    if (auto read = read_table(value, to, path, materials); !read) {
      return read;
    }
    return value.contains("file") && to.file.empty() ? fail_at(path / "file", "is empty, expected the name of a picture's file")
                                                     : Result<void>{};
  }

  /// A sphere has its picture, a cube its six.
  Result<void> operator()(StatedReflection& to) const {
    if (value.is_string()) {
      return (*this)(to.picture);
    }
    if (!value.is_object()) {
      return expected_at(path, "the name of a picture's file or a table", value);
    }
    if (auto done = read_table(value, to, path, materials); !done) {
      return done;
    }
    const bool is_cube = to.shape == ReflectionShape::cube;
    for (const char* key : {"picture", "right", "left", "top", "bottom", "front", "back"}) {
      const bool is_of_cube = std::string_view(key) != "picture";
      if (is_of_cube == is_cube && !value.contains(key)) {
        return fail_at(path / key, fmt::format("is missing, expected {}", is_cube ? "six pictures of a cube" : "the picture of a sphere"));
      }
      if (is_of_cube != is_cube && value.contains(key)) {
        return fail_at(path / key, fmt::format("belongs to shape {}, found shape {}", is_cube ? "sphere" : "cube", word_of(to.shape)));
      }
    }
    return {};
  }

  Result<void> operator()(Mat4& to) const {
    const auto read = numbers(16, 16, "a list of 16 numbers, row by row");
    if (!read) {
      return tl::unexpected(read.error());
    }
    std::copy(read->begin(), read->end(), to.m.begin());
    return {};
  }

  Result<void> operator()(Color& to) const {
    float alpha = 1;
    return color(to, alpha, false);
  }
  Result<void> operator()(ColorAlphaRef to) const { return color(to.color, to.alpha, true); }

  Result<void> operator()(std::string& to) const {
    if (!value.is_string()) {
      return expected_at(path, "text", value);
    }
    const auto& text = value.get_ref<const std::string&>();
    if (text.find('\0') != std::string::npos) {
      return expected_at(path, "text without the character 0", value);
    }
    to = text;
    return {};
  }

  template <class E>
  requires std::is_enum_v<E> Result<void>
  operator()(E& to) const {
    const auto word = read_word(value, words_of<E>(), path);
    if (!word) {
      return tl::unexpected(word.error());
    }
    to = static_cast<E>(*word);
    return {};
  }

  Result<void> operator()(TermSet& to) const {
    if (!value.is_array()) {
      return expected_at(path, fmt::format("a list of words ({})", word_list(term_words())), value);
    }
    TermSet terms{false, false, false, false};
    for (std::size_t i = 0; i < value.size(); ++i) {
      const auto word = read_word(value[i], term_words(), path[i]);
      if (!word) {
        return tl::unexpected(word.error());
      }
      bool& kept = terms.*kTermMembers[*word];
      if (kept) {
        return fail_at(path[i], fmt::format("{} is stated twice", found_text(value[i])));
      }
      kept = true;
    }
    to = terms;
    return {};
  }

  Result<void> operator()(Attenuation& to) const {
    if (auto done = stands_alone("falloff", {"constant", "linear", "quadratic"}); !done) {
      return done;
    }
    return read_table(value, to, path, materials);
  }

  Result<void> operator()(Material& to) const {
    if (!value.is_string()) {
      if (!value.is_object()) {
        return expected_at(path, "the name of a material or a table", value);
      }
      return read_material(to);
    }
    const auto& name = value.get_ref<const std::string&>();
    if (const auto named = materials.find(name); named != materials.end()) {
      to = named->second;
      return {};
    }
    const auto found = library_material(name);
    if (!found) {
      return fail_at(path, unknown_material(name), ErrorKind::usage);
    }
    to = *found;
    return {};
  }

  template <class V>
  Result<void> operator()(std::vector<V>& to) const {
    if (!value.is_array()) {
      return expected_at(path, "a list", value);
    }
    std::vector<V> list(value.size());
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (auto done = read_table(value[i], list[i], path[i], materials); !done) {
        return done;
      }
    }
    to = std::move(list);
    return {};
  }

  template <class V>
  Result<void> operator()(std::optional<V>& to) const {
    if constexpr (kIsToggle<V>) {
      if (value.is_boolean()) {
        to = value.get<bool>() ? std::optional<V>(V{}) : std::nullopt;
        return {};
      }
      if (!value.is_object()) {
        return expected_at(path, "true, false or a table", value);
      }
    }
    V read{};
    if (auto done = (*this)(read); !done) {
      return done;
    }
    to = std::move(read);
    return {};
  }

  Result<void> operator()(std::monostate) const { return {}; }  // `materials`: read_scene() has read them

  template <class T>
  Result<void> operator()(T& to) const {
    return read_table(value, to, path, materials);
  }

 private:
  /// Its textures say what is not stated.
  Result<void> read_material(Material& to) const {
    if (const auto found = value.find("textures"); found != value.end()) {
      StatedTextures textures;
      const JsonPath place = path / "textures";
      if (auto done = FromJson{*found, range, place, materials}(textures); !done) {
        return done;
      }
      std::string name = std::move(to.name);
      to = material_with(std::move(textures));
      to.name = std::move(name);
    }
    return read_table(value, to, path, materials);
  }

  /// A key that stands in place of three others.
  [[nodiscard]] Result<void> stands_alone(const char* key, const std::array<const char*, 3>& others) const {
    for (const char* other : others) {
      if (value.is_object() && value.contains(key) && value.contains(other)) {
        return fail_at(
            path, fmt::format("states both {} and {}, expected {} alone or {}, {} and {}", key, other, key, others[0], others[1], others[2]));
      }
    }
    return {};
  }

  template <class N>
  Result<void> number(N& to) const {
    const auto read = read_number(value, range, path);
    if (!read) {
      return tl::unexpected(read.error());
    }
    to = static_cast<N>(*read);
    return {};
  }

  [[nodiscard]] Result<std::vector<double>> numbers(std::size_t least, std::size_t most, std::string_view expected) const {
    if (!value.is_array() || value.size() < least || value.size() > most) {
      return expected_at(path, expected, value);
    }
    std::vector<double> list(value.size());
    for (std::size_t i = 0; i < value.size(); ++i) {
      constexpr Range kUnit{.lower = 0, .upper = 1};
      const auto read = read_number(value[i], i == 3 && most == 4 ? kUnit : range, path[i]);
      if (!read) {
        return tl::unexpected(read.error());
      }
      list[i] = *read;
    }
    return list;
  }

  Result<void> color(Color& to, float& alpha, bool with_alpha) const {
    if (value.is_string() && is_color_text(value.get_ref<const std::string&>())) {
      const auto read = parse_color_alpha(value.get_ref<const std::string&>(), with_alpha);
      if (!read) {
        return fail_at(path, read.error().message);
      }
      to = read->color;
      alpha = read->alpha.value_or(1.0F);
      return {};
    }
    const auto read =
        numbers(3, with_alpha ? 4 : 3, with_alpha ? "a colour: [r, g, b], [r, g, b, a] or \"#rrggbb\"" : "a colour: [r, g, b] or \"#rrggbb\"");
    if (!read) {
      return tl::unexpected(read.error());
    }
    to = {{static_cast<float>((*read)[0]), static_cast<float>((*read)[1]), static_cast<float>((*read)[2])}, ColorSpace::linear};
    alpha = read->size() == 4 ? static_cast<float>((*read)[3]) : 1.0F;
    return {};
  }

  [[nodiscard]] static Result<std::uint8_t> read_word(const json& value, std::span<const Word> table, const JsonPath& path) {
    if (!value.is_string()) {
      return expected_at(path, fmt::format("a word ({})", word_list(table)), value);
    }
    const auto& text = value.get_ref<const std::string&>();
    const Word* word = find_word(table, text);
    if (word == nullptr) {
      return fail_at(path, unknown_word_message(table, text));
    }
    return word->value;
  }

  [[nodiscard]] std::string unknown_material(const std::string& name) const {
    std::vector<std::string_view> known;
    for (const auto& entry : materials) {
      if (known.size() < 100) {
        known.push_back(entry.first);
      }
    }
    for (const Material& material : material_library()) {
      known.push_back(material.name);
    }
    return unknown_name_message("material", name, known);
  }
};

/// Unknown keys are errors, with the nearest known one.
template <class T>
Result<void> check_keys(const json& value, const JsonPath& path) {
  std::vector<std::string_view> known;
  for (const Field<T>& field : fields<T>()) {
    known.push_back(field.key);
  }
  for (const auto& [key, ignored] : value.items()) {
    const bool is_known = std::find(known.begin(), known.end(), key) != known.end() || (std::is_same_v<T, Scene> && key == kSchemaKey);
    if (is_known) {
      continue;
    }
    const auto nearest = nearest_name(key, known);
    return fail_at(path / key, nearest ? fmt::format("unknown key, did you mean {}?", quote(*nearest))
                                       : fmt::format("unknown key (known: {})", fmt::join(known, ", ")));
  }
  return {};
}

template <class T>
Result<void> read_table(const json& value, T& object, const JsonPath& path, const NamedMaterials& materials) {
  if (!value.is_object()) {
    return expected_at(path, "a table {...}", value);
  }
  if (auto done = check_keys<T>(value, path); !done) {
    return done;
  }
  for (const Field<T>& field : fields<T>()) {
    const auto found = value.find(field.key);
    if (found == value.end()) {
      continue;
    }
    const JsonPath place = path / field.key;
    if (auto done = visit_value(field.value(object), FromJson{*found, field.range, place, materials}); !done) {
      return done;
    }
  }
  return {};
}

/// The materials by name: a library material or a table, each under its key.
Result<NamedMaterials> read_materials(const json& value, const JsonPath& path) {
  if (!value.is_object()) {
    return expected_at(path, "a table of materials by name", value);
  }
  NamedMaterials materials;
  const NamedMaterials none;  // they do not name each other
  constexpr Range kAny{};
  for (const auto& [name, table] : value.items()) {
    Material material;
    material.name = name;
    const JsonPath place = path / name;
    if (auto done = FromJson{table, kAny, place, none}(material); !done) {
      return tl::unexpected(done.error());
    }
    if (table.is_string()) {
      material.name = name;  // and not the library's
    }
    materials.emplace(name, std::move(material));
  }
  return materials;
}

}  // namespace

Result<Scene> read_scene(const json& document) {
  const JsonPath root;
  if (!document.is_object()) {
    return expected_at(root, "a table {\"objects\": [...]}", document);
  }
  if (const auto named = document.find(kSchemaKey); named != document.end() && !named->is_string()) {
    return expected_at(root / kSchemaKey, "text", *named);
  }
  Scene scene;
  NamedMaterials materials;
  if (const auto found = document.find("materials"); found != document.end()) {
    auto read = read_materials(*found, root / "materials");
    if (!read) {
      return tl::unexpected(read.error());
    }
    materials = *std::move(read);
  }
  if (const auto done = read_table(document, scene, root, materials); !done) {
    return tl::unexpected(done.error());
  }
  if (!document.contains("objects")) {
    return fail_at(root / "objects", "is missing, expected a list of what is drawn");
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (scene.objects[i].source.empty()) {
      const JsonPath objects = root / "objects";
      const JsonPath object = objects[i];
      return fail_at(object / "mesh", "is missing, expected a mesh file or primitive:NAME");
    }
  }
  return scene;
}

}  // namespace lustro
