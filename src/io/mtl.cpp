// Reads MTL statement by statement. What the format leaves open is decided here, and said in a note: Tr against d, unknown statements, ranges.
#include "io/mtl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "image/lower_case.hpp"
#include "io/limits.hpp"
#include "io/mtl_map.hpp"
#include "io/note_book.hpp"
#include "io/text.hpp"

namespace lustro {

namespace {

// A material and what only its end can decide.
struct OpenMaterial {
  Material material;
  std::optional<float> dissolve;      // d
  std::optional<float> transparency;  // Tr
  std::size_t transparency_line = 0, illumination_line = 0;
  bool states_ambient = false, states_diffuse = false, states_specular = false, states_emission = false;
};

class MtlReader {
 public:
  MtlReader(std::string_view bytes, const std::string& file, const MtlOptions& options)
      : text_(bytes, {.hash_comments = true, .joined_lines = true}), file_(file), options_(options), notes_(file) {}

  Result<MtlFile> read();

 private:
  bool read_statement(std::string_view word);
  bool read_surface(std::string_view word, OpenMaterial& open);
  bool begin_material();
  void read_map(std::string_view word, Material& material);
  bool read_color(std::string_view word, Color& color);
  bool read_clamped(std::string_view word, float low, float high, float& value);
  bool read_dissolve(OpenMaterial& open);
  bool read_illumination(OpenMaterial& open);
  void settle_illumination(OpenMaterial& open);
  static void settle_map_colors(OpenMaterial& open);
  Material settle(OpenMaterial& open);

  bool error(ErrorKind kind, std::string message) {
    error_ = Error{kind, at_line(file_, text_.line()), std::move(message)};
    return false;
  }
  bool expected_number(std::string_view word) {
    const std::string_view found = text_.word();
    return error(ErrorKind::malformed,
                 fmt::format("{} expects a finite number, found {}", word, found.empty() ? "the end of the line" : shown(found)));
  }

  TextCursor text_;
  const std::string& file_;
  const MtlOptions& options_;
  NoteBook notes_;
  std::vector<OpenMaterial> materials_;
  std::map<std::string, std::size_t, std::less<>> index_;  // name to material
  std::optional<std::size_t> current_;
  std::optional<Error> error_;
};

bool is_pbr_statement(std::string_view word) {
  return word == "Pr" || word == "Pm" || word == "Ps" || word == "Pc" || word == "Pcr" || word == "aniso" || word == "anisor";
}

Result<MtlFile> MtlReader::read() {
  for (; !text_.at_end(); text_.next_line()) {
    const std::string_view word = text_.word();
    if (!word.empty() && !read_statement(word)) {
      return tl::unexpected(std::move(*error_));
    }
  }
  MtlFile file;
  file.materials.reserve(materials_.size());
  for (OpenMaterial& open : materials_) {
    file.materials.push_back(settle(open));
  }
  file.notes = notes_.notes();
  return file;
}

bool MtlReader::read_statement(std::string_view word) {
  if (word == "newmtl") {
    return begin_material();
  }
  if (!current_) {
    notes_.add(text_.line(), "statements before the first newmtl are ignored");
    return true;
  }
  OpenMaterial& open = materials_[*current_];
  if (is_map_statement(word)) {
    read_map(word, open.material);
    return true;
  }
  if (is_pbr_statement(word)) {
    notes_.add(text_.line(), "statements of physically based shading (Pr, Pm, Ps, Pc, Pcr, aniso, anisor) are ignored");
    return true;
  }
  return read_surface(word, open);
}

bool MtlReader::read_surface(std::string_view word, OpenMaterial& open) {
  Material& material = open.material;
  // clang-format off
  if (word == "Ka") { open.states_ambient = true; return read_color(word, material.ambient); }
  if (word == "Kd") { open.states_diffuse = true; return read_color(word, material.diffuse); }
  if (word == "Ks") { open.states_specular = true; return read_color(word, material.specular); }
  if (word == "Ke") { open.states_emission = true; return read_color(word, material.emission); }
  if (word == "Tf") { return read_color(word, material.transmission); }
  if (word == "Ns") { return read_clamped(word, 0, 10000, material.shininess); }
  if (word == "Ni") { return read_clamped(word, 0.001F, 10, material.refraction); }
  if (word == "sharpness") { return read_clamped(word, 0, 1000, material.sharpness); }
  if (word == "illum") { return read_illumination(open); }
  if (word == "d")  { return read_dissolve(open); }
  // clang-format on
  if (word == "Tr") {
    open.transparency_line = text_.line();
    return read_clamped(word, 0, 1, open.transparency.emplace());
  }
  if (word != "map_aat") {  // anti-aliasing of textures on or off: no map, and nothing here
    notes_.add(text_.line(), fmt::format("unknown statement {} is ignored", shown(word)));
  }
  return true;
}

bool MtlReader::begin_material() {
  const std::size_t line = text_.line();
  std::string name = to_utf8(text_.rest_of_line());
  const auto [known, is_new] = index_.emplace(name, materials_.size());
  if (is_new) {
    if (materials_.size() == kMostMaterials) {
      return error(ErrorKind::limit, fmt::format("more than {} materials", kMostMaterials));
    }
    materials_.emplace_back();
  } else {
    materials_[known->second] = OpenMaterial{};
    notes_.add(line, fmt::format("material {} is stated again: the last one counts", shown(name)));
  }
  current_ = known->second;
  materials_[*current_].material.name = std::move(name);
  return true;
}

void MtlReader::read_map(std::string_view word, Material& material) {
  const std::size_t line = text_.line();
  std::optional<TextureMap> map = parse_map(word, text_.rest_of_line(), line, notes_);
  if (!map) {
    return;
  }
  map->library = file_;
  material.maps.push_back(std::move(*map));
}

// `r [g b]`: green and blue default to red.
bool MtlReader::read_color(std::string_view word, Color& color) {
  const std::string_view kind = text_.peek_word();
  if (kind == "spectral" || kind == "xyz") {
    return error(ErrorKind::unsupported, fmt::format("{} as a {} colour: only red, green and blue numbers are read", word, kind));
  }
  float red = 0;
  if (!text_.number(red) || !std::isfinite(red)) {
    return expected_number(word);
  }
  Vec3f rgb{red, red, red};
  for (float* channel : {&rgb.y, &rgb.z}) {
    if (!text_.at_line_end() && (!text_.number(*channel) || !std::isfinite(*channel))) {
      return expected_number(word);
    }
  }
  if (rgb.x < 0 || rgb.y < 0 || rgb.z < 0) {
    notes_.add(text_.line(), fmt::format("{}: colours below 0 become 0", word));
    rgb = {std::max(rgb.x, 0.0F), std::max(rgb.y, 0.0F), std::max(rgb.z, 0.0F)};
  }
  color = {rgb, ColorSpace::encoded};
  return true;
}

bool MtlReader::read_clamped(std::string_view word, float low, float high, float& value) {
  float found = 0;
  if (!text_.number(found) || !std::isfinite(found)) {
    return expected_number(word);
  }
  if (found < low || found > high) {
    notes_.add(text_.line(), fmt::format("{}: values outside {}..{} are clamped", word, low, high));
  }
  value = std::clamp(found, low, high);
  return true;
}

bool MtlReader::read_dissolve(OpenMaterial& open) {
  if (text_.peek_word() == "-halo") {
    static_cast<void>(text_.word());
    open.material.halo = true;
  }
  return read_clamped("d", 0, 1, open.dissolve.emplace());
}

bool MtlReader::read_illumination(OpenMaterial& open) {
  Material& material = open.material;
  std::int64_t model = 0;
  if (!text_.integer(model)) {
    const std::string_view found = text_.word();
    return error(ErrorKind::malformed,
                 fmt::format("illum expects a whole number 0..10, found {}", found.empty() ? "the end of the line" : shown(found)));
  }
  if (model < 0 || model > 10) {
    notes_.add(text_.line(), fmt::format("illum {} is outside 0..10 and is ignored", model));
    return true;
  }
  open.illumination_line = text_.line();
  material.illumination = static_cast<int>(model);
  material.lighting = model == 0 ? std::optional(Lighting::constant) : model == 1 ? std::optional(Lighting::lambert) : std::nullopt;
  return true;
}

// What illum 3 to 9 ask for beyond the reflection map, which is drawn; and who draws it.
std::string_view demand_of_illumination(int model) {
  switch (model) {
    case 3:
      return "traced reflections, which the path tracer alone draws";
    case 4:
      return "traced reflections, which the path tracer alone draws, and highlights that hide what lies behind, which are not drawn";
    case 5:
      return "traced reflections by Fresnel, which the path tracer alone draws";
    case 6:
      return "traced reflections and refraction, which the path tracer alone draws";
    case 7:
      return "traced reflections and refraction by Fresnel, which the path tracer alone draws";
    case 9:
      return "highlights that hide what lies behind, which are not drawn";
    default:
      return {};
  }
}

// Models 3 to 9 are model 2 with reflections. Model 10 is black, as opaque as its shadow is dark: scene/ground.hpp.
void MtlReader::settle_illumination(OpenMaterial& open) {
  Material& material = open.material;
  const int model = material.illumination.value_or(2);
  const std::string_view demand = demand_of_illumination(model);
  if (demand.empty()) {
    return;
  }
  const bool has_map = std::ranges::any_of(material.maps, [](const TextureMap& map) { return lower_case(map.statement).ends_with("refl"); });
  notes_.add(open.illumination_line, fmt::format("illum {} asks for {}: {}{}", model, demand, model == 9 ? "" : "elsewhere ",
                                                 has_map ? "its reflection map is drawn" : "drawn as illum 2"));
}

// A map multiplies its colour. Where the file does not state one, OpenGL's default would only dim the map, or hide it.
void MtlReader::settle_map_colors(OpenMaterial& open) {
  Material& material = open.material;
  const auto settle_one = [&](bool is_stated, Color& color, std::string_view statement) {
    const auto is_its_map = [&](const TextureMap& map) {
      return std::equal(map.statement.begin(), map.statement.end(), statement.begin(), statement.end(),
                        [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
    };
    if (!is_stated && std::any_of(material.maps.begin(), material.maps.end(), is_its_map)) {
      color = {{1, 1, 1}, ColorSpace::encoded};
    }
  };
  settle_one(open.states_ambient, material.ambient, "map_ka");
  settle_one(open.states_diffuse, material.diffuse, "map_kd");
  settle_one(open.states_specular, material.specular, "map_ks");
  settle_one(open.states_emission, material.emission, "map_ke");
}

// Tr is not in the specification. Most writers mean 1 - d by it, some (3ds Max) d itself: the caller says which. A d beside it is clear and
// wins.
Material MtlReader::settle(OpenMaterial& open) {
  Material& material = open.material;
  if (open.dissolve) {
    material.opacity = *open.dissolve;
    if (open.transparency) {
      notes_.add(open.transparency_line, "Tr beside d is ignored: d states the opacity");
    }
  } else if (open.transparency) {
    material.opacity = options_.transparency_is_tr ? *open.transparency : 1 - *open.transparency;
  }
  settle_illumination(open);
  settle_map_colors(open);
  return std::move(material);
}

}  // namespace

Result<MtlFile> parse_mtl(std::string_view bytes, const std::string& file, const MtlOptions& options) {
  return MtlReader(bytes, file, options).read();
}

}  // namespace lustro
