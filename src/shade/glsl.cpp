// Cuts a shader from the marked regions of the .glsl files: #ifdef, #ifndef, #else and #endif over the words of one set of options, and
// #include.
#include "shade/glsl.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

namespace lustro {
namespace {

constexpr std::string_view kLighting =
#include "shade/lighting.glsl.inc"
    ;
constexpr std::string_view kFog =
#include "shade/fog.glsl.inc"
    ;
constexpr std::string_view kVertex =
#include "shade/vertex.glsl.inc"
    ;
constexpr std::string_view kFragment =
#include "shade/fragment.glsl.inc"
    ;

using Words = std::vector<std::string_view>;

// The regions that these options keep.
Words words_of(const GlslOptions& options) {
  Words words;
  const auto add = [&words](bool is_on, std::string_view word) {
    if (is_on) {
      words.push_back(word);
    }
  };
  const bool is_constant = options.lighting == Lighting::constant;
  const bool is_ggx = options.lighting == Lighting::ggx;  // its diffuse part depends on the highlight, which stays where its term is off
  const bool has_highlight = !is_constant && options.lighting != Lighting::lambert && (options.terms.specular || is_ggx);
  add(is_constant, "CONSTANT");
  add(!is_constant && !has_highlight, "LAMBERT");
  add(has_highlight && options.lighting == Lighting::phong, "PHONG");
  add(has_highlight && options.lighting == Lighting::blinn_phong, "BLINN_PHONG");
  add(is_ggx, "GGX");
  add(options.normalized, "NORMALIZED");

  add(options.terms.ambient && !is_constant, "AMBIENT");
  add(options.terms.diffuse, "DIFFUSE");
  add(has_highlight && options.terms.specular, "SPECULAR");
  add(options.terms.emission && !is_constant, "EMISSION");

  const bool is_per_vertex = options.interpolation != Interpolation::phong;
  add(options.interpolation == Interpolation::flat, "FLAT");
  add(options.interpolation == Interpolation::gouraud, "GOURAUD");
  add(is_per_vertex, "PER_VERTEX");
  add(!is_per_vertex, "PHONG_INTERPOLATION");
  add(!is_per_vertex || options.fog, "POSITION");

  add(options.projection == Projection::orthographic, "ORTHOGRAPHIC");
  add(options.two_sided, "TWO_SIDED");
  add(options.known_lights.has_value() && !is_constant, "KNOWN_LIGHTS");
  add(options.fog, "FOG");
  add(options.transfer == Transfer::srgb, "SRGB");
  return words;
}

bool take_prefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) {
    return false;
  }
  text.remove_prefix(prefix.size());
  return true;
}

// A light's own line of the sum. Members that do nothing become constants, which every compiler folds.
std::string sum_of_known(const std::vector<GlslKnownLight>& lights) {
  std::string text;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const GlslKnownLight& known = lights[i];
    const std::string name = "light" + std::to_string(i);
    const auto state = [&](bool is_so, std::string_view what) {
      if (is_so) {
        text += "  " + name + "." + std::string(what) + ";\n";
      }
    };
    const bool is_spot = known.type == LightType::spot;
    const bool is_far = known.type == LightType::directional;
    text += "  ShadingLight " + name + " = lights[" + std::to_string(i) + "];\n";
    state(true, is_far ? "type = kDirectional" : is_spot ? "type = kSpot" : "type = kPoint");
    state(!is_far && !known.has_polynomial && !known.has_power, "attenuation = vec3(1.0, 0.0, 0.0)");
    state(!is_far && !known.has_power, "falloff = 0.0");
    state(!is_far && !known.has_range, "range_scale = 0.0");
    state(is_spot && !known.has_exponent, "exponent = 0.0");
    state(is_spot && !known.has_beam, "beam_scale = 0.0");
    text += "  terms = add_light(terms, s, k, " + name + ");\n";
  }
  return text;
}

class Cutter {
 public:
  Cutter(const Words& words, const GlslOptions& options) : words_(words), options_(options) {}

  void cut(std::string_view text) {
    std::vector<bool> open;  // one an enclosing region: whether it is kept
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      std::string_view line = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      if (take_prefix(line, "#ifdef ")) {
        open.push_back(has(line));
      } else if (take_prefix(line, "#ifndef ")) {
        open.push_back(!has(line));
      } else if (line == "#else") {
        open.back() = !open.back();
      } else if (line == "#endif") {
        open.pop_back();
      } else if (std::find(open.begin(), open.end(), false) == open.end()) {
        keep(line);
      }
    }
  }

  [[nodiscard]] std::string take() { return std::move(out_); }

 private:
  [[nodiscard]] bool has(std::string_view word) const { return std::find(words_.begin(), words_.end(), word) != words_.end(); }

  void keep(std::string_view line) {
    if (line == R"(#include "lighting.glsl")") {
      cut(kLighting);
    } else if (line == R"(#include "fog.glsl")") {
      cut(kFog);
    } else if (take_prefix(line, "const int kMaxLights")) {
      out_ += "const int kMaxLights = " + std::to_string(std::max(options_.max_lights, 1)) + ";\n";
    } else if (line == "  KNOWN_LIGHTS") {
      out_ += sum_of_known(*options_.known_lights);
    } else if (!line.empty() || !out_.ends_with("\n\n")) {  // never two blank lines
      out_ += line;
      out_ += '\n';
    }
  }

  const Words& words_;
  const GlslOptions& options_;
  std::string out_ = "#version 300 es\n";
};

}  // namespace

std::string glsl_shader(GlslStage stage, const GlslOptions& options) {
  const Words words = words_of(options);
  Cutter cutter(words, options);
  cutter.cut(stage == GlslStage::vertex ? kVertex : kFragment);
  return cutter.take();
}

}  // namespace lustro
