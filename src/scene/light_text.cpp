// Whole lights, materials and fogs as one text of a command line: names and key=value pairs, read through the table of options.
#include <fmt/format.h>

#include <vector>

#include "scene/fields.hpp"
#include "scene/nearest.hpp"
#include "scene/text_values.hpp"

namespace lustro {
namespace {

/// The parts between runs of the separators.
std::vector<std::string_view> split(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t begin = text.find_first_not_of(separators);
    if (begin == std::string_view::npos) {
      return parts;
    }
    text.remove_prefix(begin);
    const std::size_t end = text.find_first_of(separators);
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end);
  }
}

/// `key=value`; a key alone has no value.
std::pair<std::string_view, std::string_view> key_and_value(std::string_view part) {
  const std::size_t equals = part.find('=');
  return {part.substr(0, equals), equals == std::string_view::npos ? std::string_view{} : part.substr(equals + 1)};
}

/// Sets the field with that key, if T has one.
template <class T>
std::optional<Result<void>> set_key(T& object, std::string_view key, std::string_view value) {
  for (const Field<T>& field : fields<T>()) {
    if (field.key == key) {
      return set_from_text(object, field, value);
    }
  }
  return std::nullopt;
}

template <class T>
void append_keys(std::vector<std::string_view>& keys) {
  for (const Field<T>& field : fields<T>()) {
    keys.push_back(field.key);
  }
}

tl::unexpected<Error> unknown_key(std::string_view key, const std::vector<std::string_view>& known) {
  return fail(ErrorKind::usage, "", unknown_name_message("key", key, known));
}

/// One key of a light or of its attenuation; `color` is diffuse and specular.
Result<void> set_light_key(Light& light, std::string_view key, std::string_view value) {
  if (key == "color") {
    const auto color = parse_color(value);
    if (!color) {
      return fail(ErrorKind::usage, "color", color.error().message);
    }
    light.diffuse = light.specular = *color;
    return {};
  }
  if (const auto done = set_key(light, key, value)) {
    return *done;
  }
  if (const auto done = set_key(light.attenuation, key, value)) {
    return *done;
  }
  std::vector<std::string_view> known{"color"};
  append_keys<Light>(known);
  append_keys<Attenuation>(known);
  return unknown_key(key, known);
}

/// The keys that stand without a name after the type: `point POSITION`, `spot POSITION DIRECTION`, `directional DIRECTION`;
/// areas as `point` or `spot`.
std::vector<std::string_view> positional_keys(LightType type) {
  switch (type) {
    case LightType::directional:
      return {"direction"};
    case LightType::point:
    case LightType::sphere:
      return {"position"};
    case LightType::spot:
    case LightType::rectangle:
    case LightType::disk:
      return {"position", "direction"};
  }
  return {};
}

/// An error inside the text names its key; the caller adds the flag in front.
Error with_key(Error error) {
  if (!error.where.empty()) {
    error.message = fmt::format("{}: {}", error.where, error.message);
    error.where.clear();
  }
  return error;
}

}  // namespace

Result<Light> parse_light(std::string_view text) {
  const std::vector<std::string_view> parts = split(text, " \t\n\r");
  if (parts.empty()) {
    return fail(ErrorKind::usage, "", fmt::format("found nothing, expected a light: {}", word_list(words_of<LightType>())));
  }
  const auto type = parse_word<LightType>(parts[0]);
  if (!type) {
    return tl::unexpected(type.error());
  }
  Light light;
  light.type = *type;
  const std::vector<std::string_view> names = positional_keys(*type);
  std::size_t unnamed = 0;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    auto [key, value] = key_and_value(parts[i]);
    if (parts[i].find('=') == std::string_view::npos && key != "unclamped") {
      if (unnamed == names.size()) {
        return fail(ErrorKind::usage, "", fmt::format("found {}, expected key=value", quote(parts[i])));
      }
      value = key;
      key = names[unnamed++];
    }
    if (const auto done = set_light_key(light, key, value); !done) {
      return tl::unexpected(with_key(done.error()));
    }
  }
  return light;
}

Result<Material> parse_material(std::string_view text) {
  // A comma stands between keys and inside colours: what has no `=` belongs to the key before it.
  std::vector<std::string> parts;
  for (const std::string_view part : split(text, ", \t\n\r")) {
    if (parts.empty() || part.find('=') != std::string_view::npos) {
      parts.emplace_back(part);
    } else {
      parts.back() += fmt::format(",{}", part);
    }
  }
  if (parts.empty()) {
    return fail(ErrorKind::usage, "", "found nothing, expected a library material or key=value");
  }
  Material material;
  std::size_t first = 0;
  if (parts[0].find('=') == std::string::npos) {
    const auto found = library_material(parts[0]);
    if (!found) {
      std::vector<std::string_view> known;
      for (const Material& entry : material_library()) {
        known.push_back(entry.name);
      }
      return fail(ErrorKind::usage, "", unknown_name_message("material", parts[0], known));
    }
    material = *found;
    first = 1;
  }
  for (std::size_t i = first; i < parts.size(); ++i) {
    const auto [key, value] = key_and_value(parts[i]);
    const auto done = set_key(material, key, value);
    if (!done) {
      std::vector<std::string_view> known;
      append_keys<Material>(known);
      return unknown_key(key, known);
    }
    if (!*done) {
      return tl::unexpected(with_key(done->error()));
    }
  }
  return material;
}

Result<Fog> parse_fog(std::string_view text) {
  Fog fog;
  bool is_first = true;
  for (const std::string_view part : split(text, " \t\n\r")) {
    auto [key, value] = key_and_value(part);
    if (part.find('=') == std::string_view::npos) {
      if (!is_first) {
        return fail(ErrorKind::usage, "", fmt::format("found {}, expected key=value", quote(part)));
      }
      value = key;
      key = "mode";
    }
    is_first = false;
    const auto done = set_key(fog, key, value);
    if (!done) {
      std::vector<std::string_view> known;
      append_keys<Fog>(known);
      return unknown_key(key, known);
    }
    if (!*done) {
      return tl::unexpected(with_key(done->error()));
    }
  }
  if (is_first) {
    return fail(ErrorKind::usage, "", fmt::format("found nothing, expected a fog: {}", word_list(words_of<FogMode>())));
  }
  return fog;
}

}  // namespace lustro
