// `lustro glsl` as a user meets it.
#include <gmock/gmock.h>

#include "app/run_command.hpp"

namespace lustro::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

using GlslCommand = CommandTest;

TEST_F(GlslCommand, PrintsBothShaders) {
  const Outcome outcome = lustro({"glsl"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("// ==== vertex shader ====\n#version 300 es\n"));
  EXPECT_THAT(outcome.out, HasSubstr("// ==== fragment shader ====\n#version 300 es\n"));
  EXPECT_THAT(outcome.out, HasSubstr("float r_dot_v("));
}

TEST_F(GlslCommand, PrintsOneStageReadyForACompiler) {
  const Outcome outcome = lustro({"glsl", "--stage", "fragment", "--lighting", "blinn-phong", "--transfer", "none", "--fog", "--two-sided"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("#version 300 es\n"));
  EXPECT_THAT(outcome.out, HasSubstr("float n_dot_h("));
  EXPECT_THAT(outcome.out, HasSubstr("fog_factor"));
  EXPECT_THAT(outcome.out, HasSubstr("gl_FrontFacing"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("srgb_encode")));
}

TEST_F(GlslCommand, WritesAPairOfFiles) {
  const Outcome outcome = lustro({"glsl", "--interpolation", "gouraud", "-o", "toon"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(files(), ElementsAre("toon.frag", "toon.vert"));
  EXPECT_THAT(file_text(work() / "toon.vert"), HasSubstr("clamp(sum(light_surface("));
  EXPECT_THAT(file_text(work() / "toon.frag"), StartsWith("#version 300 es\n"));
  if (has_program("glslangValidator")) {
    EXPECT_EQ(run_program({"glslangValidator", "-l", "toon.vert", "toon.frag"}).code, 0);
  }
}

TEST_F(GlslCommand, KeepsTheChosenTerms) {
  const Outcome outcome = lustro({"glsl", "--stage", "fragment", "--terms", "diffuse,emission", "--max-lights", "2"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("color += terms.diffuse;\n  color += terms.emission;"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("color += terms.ambient;")));
  EXPECT_THAT(outcome.out, HasSubstr("const int kMaxLights = 2;"));
}

TEST_F(GlslCommand, SpeaksJson) {
  const nlohmann::json json = lustro({"glsl", "--stage", "vertex", "--json"}).json();
  EXPECT_THAT(json.at("vertex").get<std::string>(), StartsWith("#version 300 es\n"));
  EXPECT_FALSE(json.contains("fragment"));
}

TEST_F(GlslCommand, RefusesWhatItDoesNotKnow) {
  const Outcome word = lustro({"glsl", "--lighting", "blin-phong"});
  EXPECT_EQ(word.code, 2);
  EXPECT_THAT(word.err, HasSubstr("blinn-phong"));
  EXPECT_EQ(lustro({"glsl", "--max-lights", "0"}).code, 2);
  EXPECT_EQ(lustro({"glsl", "--terms", "diffuse,shiny"}).code, 2);
  const Outcome absent = lustro({"glsl", "-o", "missing/folder/toon"});
  EXPECT_EQ(absent.code, 3);
  EXPECT_THAT(absent.err, HasSubstr("missing/folder/toon.vert"));
}

}  // namespace
}  // namespace lustro::testing
