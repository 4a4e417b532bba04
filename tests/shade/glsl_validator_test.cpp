// Every combination of model, interpolation and stage passes Khronos' reference compiler, glslangValidator, and links with its partner.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "shade/glsl.hpp"

namespace lustro {
namespace {

/// What a command prints, and whether it succeeded.
struct Outcome {
  bool success = false;
  std::string output;
};

Outcome run(const std::string& command) {
  Outcome outcome;
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) {
    return outcome;
  }
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) {
    outcome.output += buffer.data();
  }
  outcome.success = pclose(pipe) == 0;
  return outcome;
}

class GlslValidator : public testing::TestWithParam<std::tuple<Lighting, Interpolation>> {
 protected:
  void SetUp() override {
    if (!run("glslangValidator --version").success) {
      GTEST_SKIP() << "needs glslangValidator (Debian: glslang-tools)";
    }
    const auto [lighting, interpolation] = GetParam();
    folder_ = std::filesystem::path(testing::TempDir()) / ("lustro_glsl_" + std::to_string(getpid()) + "_" +
                                                           std::to_string(static_cast<int>(lighting) * 3 + static_cast<int>(interpolation)));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const GlslOptions& options, const std::string& rest = "") const {
    std::ofstream(folder_ / (name + ".vert")) << glsl_shader(GlslStage::vertex, options);
    std::ofstream(folder_ / (name + ".frag")) << glsl_shader(GlslStage::fragment, options) << rest;
  }
  [[nodiscard]] Outcome compile_all() const { return run("cd '" + folder_.string() + "' && glslangValidator *.vert *.frag"); }
  [[nodiscard]] Outcome link(const std::string& name) const {
    return run("cd '" + folder_.string() + "' && glslangValidator -l " + name + ".vert " + name + ".frag");
  }

  std::filesystem::path folder_;
};

TEST_P(GlslValidator, AcceptsEveryCombination) {
  const auto [lighting, interpolation] = GetParam();
  const std::vector<GlslKnownLight> known{{.type = LightType::directional},
                                          {.type = LightType::point, .has_polynomial = false, .has_power = false},
                                          {.type = LightType::spot, .has_range = false}};
  for (unsigned bits = 0; bits < 64; ++bits) {
    const auto bit = [bits](unsigned i) { return (bits >> i & 1U) != 0; };
    write(std::to_string(bits), {.lighting = lighting,
                                 .interpolation = interpolation,
                                 .projection = bit(0) ? Projection::orthographic : Projection::perspective,
                                 .terms = {.specular = !bit(1)},
                                 .two_sided = bit(2),
                                 .normalized = bit(3),
                                 .fog = bit(4),
                                 .transfer = bit(5) ? Transfer::none : Transfer::srgb,
                                 .known_lights = bit(5) == bit(0) ? std::optional(known) : std::nullopt});
  }
  const Outcome compiled = compile_all();
  EXPECT_TRUE(compiled.success) << compiled.output;
  for (const char* pair : {"0", "12", "29", "63"}) {
    const Outcome linked = link(pair);
    EXPECT_TRUE(linked.success) << linked.output;
  }
}

TEST_P(GlslValidator, RefusesABrokenShader) {  // the validator is there and looks
  const auto [lighting, interpolation] = GetParam();
  write("broken", {.lighting = lighting, .interpolation = interpolation}, "float broken() { return true; }\n");
  EXPECT_FALSE(compile_all().success);
  EXPECT_FALSE(link("broken").success);
}

INSTANTIATE_TEST_SUITE_P(Models, GlslValidator,
                         testing::Combine(testing::Values(Lighting::constant, Lighting::lambert, Lighting::phong, Lighting::blinn_phong,
                                                          Lighting::ggx),
                                          testing::Values(Interpolation::flat, Interpolation::gouraud, Interpolation::phong)));

}  // namespace
}  // namespace lustro
