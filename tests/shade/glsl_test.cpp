// The cut shaders: only what the chosen model needs, with its comments, and nothing that lighting.glsl does not say.
#include "shade/glsl.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

namespace lustro {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::vector<GlslOptions> all_options() {
  std::vector<GlslOptions> all;
  for (Lighting lighting : {Lighting::constant, Lighting::lambert, Lighting::phong, Lighting::blinn_phong, Lighting::ggx}) {
    for (Interpolation interpolation : {Interpolation::flat, Interpolation::gouraud, Interpolation::phong}) {
      for (bool rich : {false, true}) {
        all.push_back({.lighting = lighting,
                       .interpolation = interpolation,
                       .projection = rich ? Projection::orthographic : Projection::perspective,
                       .two_sided = rich,
                       .normalized = rich,
                       .fog = rich,
                       .transfer = rich ? Transfer::none : Transfer::srgb});
      }
    }
  }
  return all;
}

std::string vertex(const GlslOptions& options) {
  return glsl_shader(GlslStage::vertex, options);
}
std::string fragment(const GlslOptions& options) {
  return glsl_shader(GlslStage::fragment, options);
}

TEST(GlslShader, IsThePlainTextOfItsSources) {  // so what the mirror test proves of the sources holds for every shader
  std::set<std::string> source{"#version 300 es", "const int kMaxLights = 8;"};
  for (const char* file : {"lighting.glsl", "fog.glsl", "vertex.glsl", "fragment.glsl"}) {
    std::ifstream stream(std::string(LUSTRO_SOURCE_DIR) + "/src/shade/" + file);
    ASSERT_TRUE(stream) << file;
    for (std::string line; std::getline(stream, line);) {
      source.insert(line);
    }
  }
  for (const GlslOptions& options : all_options()) {
    for (const std::string& text : {vertex(options), fragment(options)}) {
      const std::vector<std::string> lines = lines_of(text);
      EXPECT_EQ(lines.front(), "#version 300 es");
      for (std::size_t i = 1; i < lines.size(); ++i) {
        EXPECT_TRUE(source.contains(lines[i])) << lines[i];
        EXPECT_FALSE(lines[i].starts_with("#")) << lines[i];
        EXPECT_FALSE(lines[i].empty() && lines[i - 1].empty()) << "two blank lines at " << i;
      }
    }
  }
}

TEST(GlslShader, DefinesOnlyWhatItUses) {
  const std::regex definition(R"(^(?:float|vec3|Terms|LightTerms|Incident) (\w+)\(|^uniform \w+ (\w+)|^(?:flat )?out vec3 (\w+))");
  for (const GlslOptions& options : all_options()) {
    for (const std::string& text : {vertex(options), fragment(options)}) {
      for (const std::string& line : lines_of(text)) {
        std::smatch match;
        if (std::regex_search(line, match, definition)) {
          const std::string name = match[1].matched ? match[1] : match[2].matched ? match[2] : match[3];
          const std::regex word("\\b" + name + "\\b");
          EXPECT_GE(std::distance(std::sregex_iterator(text.begin(), text.end(), word), std::sregex_iterator()), 2) << name << " in\n" << text;
        }
      }
    }
  }
}

TEST(GlslShader, HoldsTheChosenModelAlone) {
  const std::string phong = fragment({.lighting = Lighting::phong});
  EXPECT_THAT(phong, HasSubstr("Phong 1975, R = 2 (N.L) N - L"));
  EXPECT_THAT(phong, HasSubstr("float r_dot_v("));
  EXPECT_THAT(phong, Not(HasSubstr("n_dot_h")));
  const std::string blinn = fragment({.lighting = Lighting::blinn_phong});
  EXPECT_THAT(blinn, HasSubstr("float n_dot_h("));
  EXPECT_THAT(blinn, Not(HasSubstr("r_dot_v")));
  EXPECT_THAT(blinn, Not(HasSubstr("reflect_about")));
  const std::string ggx = fragment({.lighting = Lighting::ggx});
  EXPECT_THAT(ggx, HasSubstr("Microfacets microfacets("));
  EXPECT_THAT(ggx, Not(HasSubstr("specular_factor")));
  EXPECT_THAT(blinn, Not(HasSubstr("microfacets")));
  EXPECT_THAT(fragment({.lighting = Lighting::lambert}), Not(HasSubstr("specular_factor")));
  EXPECT_THAT(fragment({.lighting = Lighting::constant}), Not(HasSubstr("light_count")));
}

TEST(GlslShader, KnownLightsAreWrittenOut) {
  const GlslKnownLight near{.type = LightType::point, .has_polynomial = false, .has_power = false, .has_range = false};
  const GlslKnownLight spot{.type = LightType::spot, .has_exponent = false};
  const std::string text = fragment({.known_lights = std::vector{GlslKnownLight{}, near, spot}});
  EXPECT_THAT(text, Not(HasSubstr("light_count")));
  EXPECT_THAT(text, Not(HasSubstr("KNOWN_LIGHTS")));
  EXPECT_THAT(text, HasSubstr("light0.type = kDirectional;\n  terms = add_light(terms, s, k, light0);"));
  EXPECT_THAT(
      text,
      HasSubstr("light1.type = kPoint;\n  light1.attenuation = vec3(1.0, 0.0, 0.0);\n  light1.falloff = 0.0;\n  light1.range_scale = 0.0;\n"));
  EXPECT_THAT(text, HasSubstr("light2.type = kSpot;\n  light2.exponent = 0.0;\n  terms"));
  EXPECT_THAT(fragment({.known_lights = std::vector<GlslKnownLight>{}}), Not(HasSubstr("= add_light(")));
  EXPECT_THAT(fragment({}), HasSubstr("i < light_count"));
}

TEST(GlslShader, LightsWhereTheInterpolationSays) {
  const GlslOptions flat{.interpolation = Interpolation::flat};
  const GlslOptions gouraud{.interpolation = Interpolation::gouraud};
  const GlslOptions phong{.interpolation = Interpolation::phong};
  for (const GlslOptions& options : {flat, gouraud}) {
    EXPECT_THAT(vertex(options), HasSubstr("light_surface(s, material)"));
    EXPECT_THAT(fragment(options), Not(HasSubstr("light_surface")));
  }
  EXPECT_THAT(vertex(phong), Not(HasSubstr("light_surface")));
  EXPECT_THAT(fragment(phong), HasSubstr("light_surface(s, material)"));
  EXPECT_THAT(fragment(phong), HasSubstr("normalize(surface_normal)"));
  EXPECT_THAT(vertex(gouraud), HasSubstr("clamp(sum(light_surface(s, material)), 0.0, 1.0)"));
  EXPECT_THAT(vertex(flat), Not(HasSubstr("clamp(sum(")));
  EXPECT_THAT(vertex(flat), HasSubstr("flat out vec3 front_color;"));
  EXPECT_THAT(vertex(flat), HasSubstr("in vec3 face_center;"));
}

TEST(GlslShader, TurnsTheNormalRoundWhereAskedTo) {
  for (Interpolation interpolation : {Interpolation::flat, Interpolation::gouraud, Interpolation::phong}) {
    EXPECT_THAT(fragment({.interpolation = interpolation, .two_sided = true}), HasSubstr("gl_FrontFacing"));
    EXPECT_THAT(fragment({.interpolation = interpolation}), Not(HasSubstr("gl_FrontFacing")));
  }
}

TEST(GlslShader, AddsFogTransferAndNormalizationWhereAskedTo) {
  EXPECT_THAT(fragment({.fog = true}), HasSubstr("fog_factor(fog, length(surface_position))"));
  EXPECT_THAT(fragment({}), Not(HasSubstr("fog")));
  EXPECT_THAT(fragment({.transfer = Transfer::srgb}), HasSubstr("srgb_encode(color)"));
  EXPECT_THAT(fragment({.transfer = Transfer::none}), Not(HasSubstr("srgb")));
  EXPECT_THAT(fragment({.lighting = Lighting::phong, .normalized = true}), HasSubstr("Lafortune and Willems"));
  EXPECT_THAT(fragment({.lighting = Lighting::phong}), Not(HasSubstr("lobe_normalization")));
  EXPECT_THAT(fragment({.projection = Projection::orthographic}), HasSubstr("s.to_eye = view_to_eye;"));
  EXPECT_THAT(fragment({}), HasSubstr("s.to_eye = normalize(-surface_position);"));
}

TEST(GlslShader, SumsTheChosenTermsOnly) {
  const std::string text = fragment({.terms = {.ambient = false, .diffuse = true, .specular = false, .emission = false}});
  EXPECT_THAT(text, HasSubstr("color += terms.diffuse;"));
  EXPECT_THAT(text, Not(HasSubstr("color += terms.ambient;")));
  EXPECT_THAT(text, Not(HasSubstr("color += terms.emission;")));
  EXPECT_THAT(text, Not(HasSubstr("specular_factor"))) << "without its term the highlight is not computed";
  const std::string ggx =
      fragment({.lighting = Lighting::ggx, .terms = {.ambient = false, .diffuse = true, .specular = false, .emission = false}});
  EXPECT_THAT(ggx, Not(HasSubstr("color += terms.specular;")));
  EXPECT_THAT(ggx, HasSubstr("microfacets(s, ")) << "which take their part from the diffuse one";
}

TEST(GlslShader, HasRoomForTheLightsAskedFor) {
  EXPECT_THAT(fragment({}), HasSubstr("const int kMaxLights = 8;"));
  EXPECT_THAT(fragment({.max_lights = 3}), HasSubstr("const int kMaxLights = 3;"));
  EXPECT_THAT(fragment({.max_lights = 0}), HasSubstr("const int kMaxLights = 1;"));
}

}  // namespace
}  // namespace lustro
