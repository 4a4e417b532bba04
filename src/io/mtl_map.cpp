// Options and names of MTL map statements. A word is an option only if it is a known one whose arguments fit: names may hold `-s` too.
#include "io/mtl_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "image/lower_case.hpp"
#include "io/text.hpp"

namespace lustro {

namespace {

constexpr std::array kMapStatements{
    std::string_view("map_ka"),   std::string_view("map_kd"),      std::string_view("map_ks"),   std::string_view("map_ke"),
    std::string_view("map_ns"),   std::string_view("map_ni"),      std::string_view("map_d"),    std::string_view("map_tr"),
    std::string_view("map_tf"),   std::string_view("map_bump"),    std::string_view("map_disp"), std::string_view("map_decal"),
    std::string_view("map_refl"), std::string_view("bump"),        std::string_view("disp"),     std::string_view("decal"),
    std::string_view("refl"),     std::string_view("norm"),        std::string_view("map_norm"), std::string_view("map_kn"),
    std::string_view("map_pr"),   std::string_view("map_pm"),      std::string_view("map_ps"),   std::string_view("map_pc"),
    std::string_view("map_pcr"),  std::string_view("map_opacity"), std::string_view("map_rma"),  std::string_view("map_orm"),
};

bool read_switch(TextCursor& text, bool& value) {
  const std::string_view word = text.word();
  value = word == "on";
  return word == "on" || word == "off";
}

bool read_finite(TextCursor& text, float& value) {
  float found = 0;
  if (!text.number(found) || !std::isfinite(found)) {
    return false;
  }
  value = found;
  return true;
}

// One to three numbers; those that are not stated keep the default.
bool read_vector(TextCursor& text, Vec3f& value) {
  if (!read_finite(text, value.x)) {
    return false;
  }
  if (read_finite(text, value.y)) {
    static_cast<void>(read_finite(text, value.z));
  }
  return true;
}

bool read_channel(TextCursor& text, char& channel) {
  const std::string_view word = text.word();
  channel = word.size() == 1 ? word.front() : '\0';
  return word.size() == 1 && std::string_view("rgbmlz").find(channel) != std::string_view::npos;
}

bool read_resolution(TextCursor& text, int& resolution) {
  float value = 0;
  if (!read_finite(text, value) || value < 0 || value > 1'000'000) {
    return false;
  }
  resolution = static_cast<int>(value);
  return true;
}

bool read_type(TextCursor& text, std::string& type) {
  type = text.word().substr(0, 12);  // longer words are none
  return type == "sphere" || type == "cube_top" || type == "cube_bottom" || type == "cube_front" || type == "cube_back" || type == "cube_left" ||
         type == "cube_right";
}

// The option whose name was just read. False where it is none, or where its arguments do not fit; then the map may be half changed.
bool read_option(TextCursor& text, std::string_view name, TextureMap& map) {
  // clang-format off
  if (name == "-blendu" || name == "-blenu") { return read_switch(text, map.blend_u); }
  if (name == "-blendv" || name == "-blenv") { return read_switch(text, map.blend_v); }
  if (name == "-cc")      { return read_switch(text, map.color_correction); }
  if (name == "-clamp")   { return read_switch(text, map.clamp); }
  if (name == "-boost")   { return read_finite(text, map.boost); }
  if (name == "-bm")      { return read_finite(text, map.bump_multiplier); }
  if (name == "-mm")      { return read_finite(text, map.base) && read_finite(text, map.gain); }
  if (name == "-o")       { return read_vector(text, map.offset); }
  if (name == "-s")       { return read_vector(text, map.scale); }
  if (name == "-t")       { return read_vector(text, map.turbulence); }
  if (name == "-texres")  { return read_resolution(text, map.texture_resolution); }
  if (name == "-imfchan") { return read_channel(text, map.channel); }
  if (name == "-type")    { return read_type(text, map.type); }
  // clang-format on
  return false;
}

}  // namespace

bool is_map_statement(std::string_view word) {
  const std::string lower = lower_case(std::string(word.substr(0, 16)));  // longer words are none
  return word.size() <= 16 && std::find(kMapStatements.begin(), kMapStatements.end(), lower) != kMapStatements.end();
}

std::optional<TextureMap> parse_map(std::string_view statement, const std::string& rest, std::size_t line, NoteBook& notes) {
  TextureMap map;
  map.statement = statement;
  std::size_t name_begin = rest.size();
  std::size_t name_end = rest.size();
  bool name_is_open = false;

  TextCursor text(rest, {.hash_comments = false, .joined_lines = false}, line);
  while (!text.at_line_end()) {
    const std::size_t begin = rest.size() - text.remaining();
    const std::string_view word = text.word();
    if (word.front() == '-' && word.size() > 1) {
      const TextCursor behind_word = text;
      TextureMap changed = map;
      if (read_option(text, word, changed)) {
        map = std::move(changed);
        name_is_open = false;
        continue;
      }
      text = behind_word;
    }
    if (name_begin == rest.size()) {
      name_begin = begin;
      name_is_open = true;
    }
    if (!name_is_open) {
      notes.add(line, fmt::format("{}: {} behind the options is ignored", statement, shown(word)));
      continue;
    }
    name_end = rest.size() - text.remaining();
  }
  if (name_begin == rest.size()) {
    notes.add(line, fmt::format("{} names no file and is ignored", statement));
    return std::nullopt;
  }
  map.file = rest.substr(name_begin, name_end - name_begin);
  if (map.file.size() > 1 && map.file.front() == '"' && map.file.back() == '"') {
    map.file = map.file.substr(1, map.file.size() - 2);
  }
  return map;
}

}  // namespace lustro
