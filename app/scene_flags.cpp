// Flags from the table of options: see scene_flags.hpp.
#include "scene_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "io/load_environment.hpp"
#include "scene/fields.hpp"

namespace lustro::app {
namespace {

/// What a value of that kind looks like.
std::string value_name(const FieldInfo& field) {
  switch (field.kind) {
    case ValueKind::boolean:
    case ValueKind::toggle:
      return "";
    case ValueKind::integer:
    case ValueKind::number:
      return "N";
    case ValueKind::vector:
      return "X,Y,Z";
    case ValueKind::color:
    case ValueKind::color_alpha:
      return "COLOR";
    case ValueKind::word: {
      std::string words;
      for (const Word& word : field.words) {
        words += (words.empty() ? "" : "|") + std::string(word.word);
      }
      return words;
    }
    case ValueKind::terms:
      return "LIST";
    case ValueKind::lights:
      return "LIGHT";
    case ValueKind::material:
      return "MATERIAL";
    case ValueKind::table:
      return field.flag == "--fog" ? "FOG" : field.flag == "--environment" ? "FILE|COLOR" : "VALUE";
    case ValueKind::matrix:
    case ValueKind::text:
    case ValueKind::objects:
    case ValueKind::materials:
    case ValueKind::texture:
    case ValueKind::reflection:
    case ValueKind::wrap:
    case ValueKind::pair:
    case ValueKind::triple:
    case ValueKind::affine:
      return "VALUE";
  }
  return "VALUE";
}

/// How to write a value that is not just a number or a word.
std::string value_hint(const FieldInfo& field) {
  switch (field.kind) {
    case ValueKind::color:
      return "#rrggbb, or linear r,g,b";
    case ValueKind::color_alpha:
      return "#rrggbb[aa], or linear r,g,b[,a]";
    case ValueKind::lights:
      return "\"point 2,3,4 color=#fff\", \"directional -1,-1,0\", \"spot 2,3,4 -1,-1,-1 cutoff=30 falloff=2\"; replaces the scene's lights";
    case ValueKind::material:
      return "a name of `lustro materials`, or coefficients: \"jade,shininess=40\", \"diffuse=#f00\"";
    case ValueKind::table:
      if (field.flag == "--environment") {
        return "a picture of all directions, a colour, or none";
      }
      return "\"exp density=0.2 color=#abc\", \"linear start=2 end=9\", none";
    case ValueKind::terms: {
      std::string words;
      for (const Word& word : field.words) {
        words += (words.empty() ? "" : ",") + std::string(word.word);
      }
      return "some of " + words + ", or none";
    }
    default:
      return "";
  }
}

std::string capitalised(std::string_view text) {
  std::string result(text);
  if (!result.empty()) {
    result.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(result.front())));
  }
  return result;
}

std::string description_of(const FieldInfo& field) {
  std::string text = capitalised(field.kind == ValueKind::lights ? "a light" : field.help);
  if (const std::string hint = value_hint(field); !hint.empty()) {
    text += ": " + hint;
  }
  std::string facts;
  const auto add = [&facts](std::string_view fact) {
    if (!fact.empty()) {
      facts += (facts.empty() ? "" : "; ") + std::string(fact);
    }
  };
  add(field.unit);
  const bool is_color = field.kind == ValueKind::color || field.kind == ValueKind::color_alpha;
  add(is_color ? std::string() : range_text(field.range));
  add(field.default_text.empty() ? std::string() : "default: " + field.default_text);
  return facts.empty() ? text : fmt::format("{} ({})", text, facts);
}

std::string group_name(const FieldGroup& group) {
  std::string_view path = group.path;
  if (path.ends_with("[]")) {
    path.remove_suffix(2);
  }
  return path.empty() ? "Scene" : capitalised(path);
}

CLI::Option* add_field(CLI::App& app, const FieldInfo& field, const std::string& group) {
  const std::string name(field.flag);
  const std::string description = description_of(field);  // CLI11 takes a const text for a description, anything else for a variable
  CLI::Option* option = nullptr;
  if (field.kind == ValueKind::boolean || field.kind == ValueKind::toggle) {
    option = app.add_flag(fmt::format("{0},!--no-{1}", name, name.substr(2)), description);
  } else {
    option = app.add_option(name, description)->type_name(value_name(field));
    if (field.kind == ValueKind::lights) {
      option->expected(1, CLI::detail::expected_max_vector_size)->allow_extra_args(false);  // any number of times, one light each
    }
  }
  return option->group(group);
}

/// What was stated for the scene.
std::vector<std::string> values_of(const SceneFlags::Flag& flag, const SceneFlags& flags) {
  std::vector<std::string> values = flag.option->results();
  if (flags.has_two_targets && flag.name == "--target") {
    values.erase(std::remove_if(values.begin(), values.end(), is_target_word), values.end());
  }
  return values;
}

/// `800x600`, also `800X600` and `800,600`.
Result<void> apply_size(Scene& scene, const std::string& text) {
  const std::size_t split = text.find_first_of("xX,");
  if (split == std::string::npos) {
    return fail(ErrorKind::usage, "--size", fmt::format("`{}` is not WIDTHxHEIGHT, such as 800x600", text));
  }
  for (const auto& [flag, number] : {std::pair{"--width", text.substr(0, split)}, std::pair{"--height", text.substr(split + 1)}}) {
    if (const Result<void> set = set_scene_flag(scene, flag, number); !set) {
      return fail(set.error().kind, "--size", set.error().message);
    }
  }
  return {};
}

}  // namespace

bool is_target_word(std::string_view value) {
  return !value.empty() && std::isalpha(static_cast<unsigned char>(value.front())) != 0 && value.find(',') == std::string_view::npos &&
         value != "none";
}

SceneFlags add_scene_flags(CLI::App& app) {
  const std::string size_description = "Width and height in one";
  const std::string no_lights_description = "No light but the scene's ambient one, as --light none";
  SceneFlags result;
  for (const FieldGroup& group : field_groups()) {
    const std::string heading = group_name(group);
    for (const FieldInfo& field : group.fields) {
      if (field.flag.empty()) {
        continue;
      }
      if (field.flag == "--width") {
        result.size = app.add_option("--size", size_description)->type_name("WxH")->group(heading);
      }
      result.flags.push_back({std::string(field.flag), add_field(app, field, heading)});
      if (field.kind == ValueKind::lights) {
        result.no_lights = app.add_flag("--no-lights", no_lights_description)->disable_flag_override()->group(heading);
      }
    }
  }
  return result;
}

Result<void> apply_scene_flags(const SceneFlags& flags, Scene& scene) {
  if (flags.size != nullptr && flags.size->count() > 0) {
    if (const Result<void> set = apply_size(scene, flags.size->results().back()); !set) {
      return set;
    }
  }
  if (flags.no_lights != nullptr && flags.no_lights->count() > 0) {
    scene.lights.emplace();
  }
  const auto is_stated = [&flags](std::string_view name) {
    return std::any_of(flags.flags.begin(), flags.flags.end(),
                       [&](const SceneFlags::Flag& f) { return f.name == name && !values_of(f, flags).empty(); });
  };
  if (is_stated("--view")) {  // a view is asked for: where the scene's own camera stands no longer counts
    scene.camera.eye.reset();
    scene.camera.target.reset();
    scene.camera.up.reset();
    scene.camera.near.reset();
    scene.camera.far.reset();
    scene.camera.height.reset();
    if (is_stated("--eye")) {
      return fail(ErrorKind::usage, "--view", "contradicts --eye");
    }
  }
  for (const SceneFlags::Flag& flag : flags.flags) {
    const std::vector<std::string> values = values_of(flag, flags);
    if (flag.name == "--light" && !values.empty()) {
      if (flags.no_lights->count() > 0) {
        return fail(ErrorKind::usage, "--no-lights", "contradicts --light");
      }
      scene.lights.emplace();
    }
    if (flag.name == "--target" && values.size() > 1) {
      return fail(ErrorKind::usage, "--target", "may be stated only once");
    }
    for (const std::string& value : values) {
      if (const Result<void> set = set_scene_flag(scene, flag.name, value); !set) {
        return set;
      }
    }
  }
  if (is_stated("--environment") && scene.environment && !scene.environment->file.empty()) {
    auto picture = read_environment(scene.environment->file, scene.image.transfer);  // from where the command is typed
    if (!picture) {
      return fail(picture.error().kind, "--environment", picture.error().text());
    }
    scene.environment->picture = *std::move(picture);
  }
  return {};
}

}  // namespace lustro::app
