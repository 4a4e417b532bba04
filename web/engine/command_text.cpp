// Flags by the table of options: see command_text.hpp. Every command is tried on the scene before it is told.
#include "command_text.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "scene/fields.hpp"
#include "scene/words.hpp"

namespace lustro::web {
namespace {

using Flags = std::vector<std::pair<std::string, std::string>>;

template <class T>
void add_changed(Flags& flags, const T& base, const T& now) {
  for (const Field<T>& field : fields<T>()) {
    const ValueKind kind = kind_of(field);
    const bool is_own = kind == ValueKind::lights || kind == ValueKind::objects || kind == ValueKind::material || kind == ValueKind::materials;
    if (field.flag.empty() || is_own) {
      continue;
    }
    if (std::string text = value_text(now, field); text != value_text(base, field)) {
      flags.emplace_back(field.flag, std::move(text));
    }
  }
}

/// A toggle's table: what differs from what the switch alone means.
template <class T>
void add_toggle(Flags& flags, const std::optional<T>& now) {
  if (now) {
    add_changed(flags, T{}, *now);
  }
}

template <class T>
std::string changed_keys(const T& value, const std::vector<std::string_view>& without) {
  std::string text;
  for (const Field<T>& field : fields<T>()) {
    const bool is_said = std::find(without.begin(), without.end(), field.key) != without.end() || kind_of(field) == ValueKind::table;
    if (const std::string now = value_text(value, field); !is_said && now != value_text(T{}, field)) {
      text += " " + std::string(field.key) + "=" + now;
    }
  }
  return text;
}

/// As text_values.hpp's parse_light() reads it.
std::string light_text(const Light& light) {
  std::string text = std::string(word_of(light.type));
  text += changed_keys(light, {"type", "attenuation"});
  return text + changed_keys(light.attenuation, {});
}

/// Material by its library name, where it is one, else key by key.
std::optional<std::string> material_text(const Material& material) {
  std::string text = changed_keys(material, {"name", "textures"});
  std::replace(text.begin(), text.end(), ' ', ',');
  if (const auto library = library_material(material.name)) {
    return *library == material ? std::optional(material.name) : std::nullopt;
  }
  return text.empty() ? std::nullopt : std::optional(text.substr(1));
}

Flags flags_between(const Scene& base, const Scene& scene) {
  Flags flags;
  add_changed(flags, base.image, scene.image);
  add_changed(flags, base.image.tone, scene.image.tone);
  add_changed(flags, base.camera, scene.camera);
  add_changed(flags, base.shading, scene.shading);
  add_changed(flags, base, scene);
  add_toggle(flags, scene.shadow);
  add_toggle(flags, scene.occlusion);
  add_toggle(flags, scene.ground);
  if (!scene.objects.empty() && scene.objects.front().material) {
    if (const auto text = material_text(*scene.objects.front().material)) {
      flags.emplace_back("--material", *text);
    }
  }
  if (scene.lights && scene.lights->empty()) {
    flags.emplace_back("--light", "none");
  } else if (scene.lights) {
    for (const Light& light : *scene.lights) {
      flags.emplace_back("--light", light_text(light));
    }
  }
  return flags;
}

/// What the command makes of the flags.
std::optional<Scene> with_flags(Scene scene, const Flags& flags) {
  if (std::any_of(flags.begin(), flags.end(), [](const auto& flag) { return flag.first == "--light"; })) {
    scene.lights.emplace();
  }
  for (const auto& [flag, text] : flags) {
    if (!set_scene_flag(scene, flag, text)) {
      return std::nullopt;
    }
  }
  return scene;
}

}  // namespace

std::string shell_word(std::string_view text) {
  const bool is_plain = !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_-./,:=+@%").find(c) != std::string_view::npos;
  });
  if (is_plain) {
    return std::string(text);
  }
  std::string quoted = "'";
  for (const char c : text) {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

std::optional<std::string> command_text(const std::string& input, const Scene& base, const Scene& scene, std::string_view output) {
  const Flags flags = flags_between(base, scene);
  const std::optional<Scene> drawn = with_flags(base, flags);
  if (!drawn || scene_json(*drawn) != scene_json(scene)) {
    return std::nullopt;
  }
  std::string text = "lustro render " + shell_word(input);
  for (const auto& [flag, value] : flags) {
    if (value == "true") {
      text += " " + flag;
    } else if (value == "false") {
      text += " --no-" + flag.substr(2);
    } else {
      text += " " + flag + (value.starts_with('-') ? "=" : " ") + shell_word(value);
    }
  }
  return text + " -o " + shell_word(output);
}

}  // namespace lustro::web
