// `lustro render`: what it writes, where, what it says, and how it fails.
#include "lustro/render.hpp"

#include <gmock/gmock.h>

#include "app/run_command.hpp"
#include "app/scenes.hpp"
#include "lustro/image.hpp"
#include "scene/fields.hpp"

namespace {

using namespace lustro::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

class RenderCommand : public CommandTest {
 protected:
  void SetUp() override {
    write_text(work() / "square.obj", square_obj());
    write_text(work() / "scene.json", square_scene());
  }
  [[nodiscard]] std::string bytes(const std::string& file) const { return file_text(work() / file); }
  [[nodiscard]] lustro::Image picture(const std::string& file) const {
    auto image = lustro::read_image(work() / file);
    EXPECT_TRUE(image.has_value()) << (image ? "" : image.error().text());
    return image.value_or(lustro::Image());
  }
};

/// Width and height as a PNG's header states them.
std::pair<int, int> png_size(const std::string& png) {
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      value = value * 256 + static_cast<unsigned char>(png.at(at + i));
    }
    return value;
  };
  return {number(16), number(20)};
}

TEST_F(RenderCommand, WritesThePictureThatTheSceneFileDescribes) {
  const Outcome outcome = lustro({"render", "scene.json", "-o", "out.png"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(outcome.err, StartsWith("lustro: wrote out.png (32 x 24, 2 triangles"));
  EXPECT_EQ(png_size(bytes("out.png")), std::pair(32, 24));
  EXPECT_THAT(files(), ElementsAre("out.png", "scene.json", "square.obj"));
}

TEST_F(RenderCommand, AMeshAloneBecomesAPictureBesideIt) {
  std::filesystem::create_directories(work() / "models");
  write_text(work() / "models/tri.obj", square_obj());
  const Outcome outcome = lustro({"models/tri.obj"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("wrote models/tri.png (1024 x 768"));
  EXPECT_TRUE(std::filesystem::exists(work() / "models/tri.png"));
}

TEST_F(RenderCommand, TheDefaultNameReplacesOnlyWhatLustroDrew) {
  ASSERT_EQ(lustro({"square.obj", "--size", "16x16"}).code, 0);
  ASSERT_EQ(lustro({"square.obj", "--size", "20x20"}).code, 0);
  EXPECT_EQ(png_size(bytes("square.png")), std::pair(20, 20));
  write_text(work() / "square.png", "a texture");
  const Outcome outcome = lustro({"square.obj", "--size", "16x16"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("square.png: is there already and was not drawn by Lustro"));
  EXPECT_EQ(bytes("square.png"), "a texture");
  EXPECT_EQ(lustro({"square.obj", "--size", "16x16", "-o", "square.png"}).code, 0);  // asked for by name
}

TEST_F(RenderCommand, APrimitiveNeedsNoFile) {
  EXPECT_EQ(lustro({"primitive:sphere:8", "--size", "16x16", "-q"}).code, 0);
  EXPECT_EQ(png_size(bytes("sphere-8.png")), std::pair(16, 16));
}

TEST_F(RenderCommand, FlagsMayStandBeforeTheMesh) {
  const Outcome outcome = lustro({"--size", "20x10", "square.obj", "-o", "out.png"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(png_size(bytes("out.png")), std::pair(20, 10));
}

TEST_F(RenderCommand, AnOutputAndALightTakeOneValueEach) {
  const Outcome outcome = lustro({"render", "-o", "a.png", "--light", "directional 0,0,-1", "scene.json", "-o", "b.png"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(files(), ElementsAre("a.png", "b.png", "scene.json", "square.obj"));
}

TEST_F(RenderCommand, EveryFlagOfTheTableIsInTheHelp) {
  const std::string help = lustro({"render", "--help"}).out;
  int count = 0;
  for (const lustro::FieldGroup& group : lustro::field_groups()) {
    for (const lustro::FieldInfo& field : group.fields) {
      if (!field.flag.empty()) {
        EXPECT_THAT(help, HasSubstr(" " + std::string(field.flag)));
        ++count;
      }
    }
  }
  EXPECT_GT(count, 25);
}

TEST_F(RenderCommand, AFlagDoesWhatItsKeyDoes) {
  const std::vector<std::tuple<std::string, std::vector<std::string>>> pairs{
      {R"(, "shading": {"lighting": "lambert"})", {"--lighting", "lambert"}},
      {R"(, "shading": {"interpolation": "flat", "terms": ["diffuse"]})", {"--interpolation", "flat", "--terms=diffuse"}},
      {R"(, "shading": {"two_sided": true})", {"--two-sided"}},
      {R"(, "ambient": [0.5, 0.25, 0])", {"--ambient", "0.5,0.25,0"}},
      {R"(, "fog": {"mode": "exp", "density": 0.2, "color": "#aabbcc"})", {"--fog", "exp density=0.2 color=#aabbcc"}},
  };
  for (const auto& [key, flags] : pairs) {
    write_text(work() / "keyed.json", square_scene(key));
    ASSERT_EQ(lustro({"render", "keyed.json", "-o", "keyed.png"}).code, 0) << key;
    std::vector<std::string> words{"render", "scene.json", "-o", "flagged.png"};
    words.insert(words.end(), flags.begin(), flags.end());
    const Outcome flagged = lustro(words);
    ASSERT_EQ(flagged.code, 0) << flagged.err;
    EXPECT_EQ(bytes("keyed.png"), bytes("flagged.png")) << key;
  }
}

TEST_F(RenderCommand, LightFlagsReplaceTheScenesLights) {
  const auto centre = [&](std::vector<std::string> flags) {
    flags.insert(flags.begin(),
                 {"render", "scene.json", "-q", "-o", "out.pfm", "--transfer", "none", "--material", "diffuse=1,1,1,ambient=0,0,0"});
    const Outcome outcome = lustro(flags);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return picture("out.pfm").at(16, 12)[0];
  };
  const float one = centre({"--light", "directional 0,0,-1"});
  EXPECT_NEAR(one, 1, 1e-6);  // a white surface that faces a white lamp
  EXPECT_NEAR(centre({"--light", "directional 0,0,-1", "--light", "directional 0,0,-1 color=0.5,0.5,0.5"}), 1.5, 1e-6);
  EXPECT_EQ(centre({"--no-lights"}), 0);
  const Outcome both = lustro({"render", "scene.json", "--no-lights", "--light", "directional 0,0,-1"});
  EXPECT_EQ(both.code, 2);
  EXPECT_THAT(both.err, HasSubstr("--no-lights: contradicts --light"));
}

TEST_F(RenderCommand, AViewReplacesTheScenesCamera) {
  ASSERT_EQ(lustro({"render", "scene.json", "-q", "-o", "own.png"}).code, 0);
  ASSERT_EQ(lustro({"render", "scene.json", "-q", "-o", "iso.png", "--view", "iso"}).code, 0);
  EXPECT_NE(bytes("own.png"), bytes("iso.png"));
  EXPECT_EQ(lustro({"render", "scene.json", "--view", "iso", "--eye", "1,2,3"}).code, 2);
}

TEST_F(RenderCommand, NegativeNumbersAreValuesAndNoFlags) {
  const Outcome outcome = lustro({"render", "scene.json", "-o", "out.png", "--eye", "-1,-0.5,3"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

TEST_F(RenderCommand, WritesEachFormatInOneRun) {
  const Outcome outcome = lustro({"render", "scene.json", "-o", "out.png", "-o", "out.exr", "-o", "out.pfm"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(picture("out.pfm").width, 32);
  // EXR holds the floats that PFM holds.
  const lustro::Image exr = picture("out.exr"), pfm = picture("out.pfm");
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 32; ++x) {
      EXPECT_EQ(exr.at(x, y)[1], pfm.at(x, y)[1]);
    }
  }
}

TEST_F(RenderCommand, SixteenBitsAreSixteenBits) {
  ASSERT_EQ(lustro({"render", "scene.json", "-q", "-o", "out.png", "--bits", "16"}).code, 0);
  EXPECT_EQ(bytes("out.png").at(24), 16);
  ASSERT_EQ(lustro({"render", "scene.json", "-q", "-o", "out.png"}).code, 0);
  EXPECT_EQ(bytes("out.png").at(24), 8);
  EXPECT_EQ(lustro({"render", "scene.json", "-o", "out.png", "--bits", "12"}).code, 2);
}

TEST_F(RenderCommand, ATransparentBackgroundHasNoAlpha) {
  ASSERT_EQ(lustro({"render", "scene.json", "-q", "-o", "out.png", "--transparent", "--eye", "0,0,9"}).code, 0);
  const lustro::Image image = picture("out.png");
  ASSERT_EQ(image.channels, 4);
  EXPECT_EQ(image.at(0, 0)[3], 0);
  EXPECT_EQ(image.at(16, 12)[3], 1);
}

TEST_F(RenderCommand, ALayerOfNumbersIsStoredAsItStandsAndALayerOfLightEncoded) {
  ASSERT_EQ(lustro({"render", "scene.json", "--aov", "normal,albedo", "-o", "out.png"}).code, 0);
  const auto normal = lustro::read_image(work() / "out.normal.png", lustro::Transfer::none);
  ASSERT_TRUE(normal.has_value());
  EXPECT_NEAR(normal->at(16, 12)[0], 0.5, 0.003);  // N = (0, 0, 1), shown as (N + 1) / 2
  EXPECT_NEAR(normal->at(16, 12)[1], 0.5, 0.003);
  EXPECT_EQ(normal->at(16, 12)[2], 1);
  const auto albedo = lustro::read_image(work() / "out.albedo.png", lustro::Transfer::none);
  ASSERT_TRUE(albedo.has_value());
  EXPECT_NEAR(albedo->at(16, 12)[1], 0.89, 0.003);  // jade's k_d, which is stated encoded
}

TEST_F(RenderCommand, LayersAreExrChannelsOrOnePngEach) {
  const Outcome outcome = lustro({"render", "scene.json", "--aov", "diffuse,normal,depth,light:1", "-o", "out.exr", "-o", "out.png"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::string exr = bytes("out.exr");
  for (const char* channel : {"diffuse.R", "normal.X", "depth.Z"}) {
    EXPECT_NE(exr.find(channel), std::string::npos) << channel;
  }
  EXPECT_THAT(files(), ElementsAre("out.depth.png", "out.diffuse.png", "out.exr", "out.light-1.png", "out.normal.png", "out.png", "scene.json",
                                   "square.obj"));
  // The square faces +z: (0, 0, 1) is shown as (0.5, 0.5, 1), stored as it stands.
  const auto normal = lustro::read_image(work() / "out.normal.png", lustro::Transfer::none);
  ASSERT_TRUE(normal);
  EXPECT_NEAR(normal->at(16, 12)[0], 0.5, 0.5 / 255 + 1e-6);
  EXPECT_NEAR(normal->at(16, 12)[2], 1, 1e-6);
  const Outcome wrong = lustro({"render", "scene.json", "--aov", "difuse", "-o", "wrong.exr"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("--aov"));
  EXPECT_FALSE(std::filesystem::exists(work() / "wrong.exr"));
}

TEST_F(RenderCommand, ADashIsAPngOnStandardOutputAndNothingElse) {
  ASSERT_EQ(lustro({"render", "scene.json", "-o", "out.png"}).code, 0);
  const Outcome outcome = lustro({"render", "scene.json", "-o", "-"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, bytes("out.png"));
  EXPECT_EQ(lustro({"render", "scene.json", "-o", "-", "--json"}).code, 2);
}

TEST_F(RenderCommand, ThreadsDoNotChangeABit) {
  ASSERT_EQ(lustro({"primitive:torus", "--size", "200x150", "-q", "--threads", "1", "-o", "one.exr", "--aov", "light:*"}).code, 0);
  ASSERT_EQ(lustro({"primitive:torus", "--size", "200x150", "-q", "--threads", "7", "-o", "seven.exr", "--aov", "light:*"}).code, 0);
  EXPECT_EQ(bytes("one.exr"), bytes("seven.exr"));
}

TEST_F(RenderCommand, JsonTellsWhatWasWritten) {
  const Outcome outcome = lustro({"render", "scene.json", "-o", "out.png", "--json", "-q"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  const auto json = outcome.json();
  EXPECT_EQ(json["outputs"], nlohmann::json({"out.png"}));
  EXPECT_EQ(json["width"], 32);
  EXPECT_EQ(json["triangles"], 2);
  EXPECT_GT(json["pixels_covered"], 100);
}

TEST_F(RenderCommand, ThePrintedSceneIsTheSceneWithItsFlags) {
  const Outcome printed = lustro({"render", "scene.json", "--lighting", "lambert", "--print-scene"});
  ASSERT_EQ(printed.code, 0) << printed.err;
  write_text(work() / "again.json", printed.out);
  ASSERT_EQ(lustro({"render", "again.json", "-q", "-o", "again.png"}).code, 0);
  ASSERT_EQ(lustro({"render", "scene.json", "-q", "-o", "flagged.png", "--lighting", "lambert"}).code, 0);
  EXPECT_EQ(bytes("again.png"), bytes("flagged.png"));
}

TEST_F(RenderCommand, WarningsStandOnStderrUnlessQuiet) {
  write_text(work() / "square.obj", "mtllib absent.mtl\n" + square_obj());
  const Outcome outcome = lustro({"render", "scene.json", "-o", "out.png"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("lustro: warning: "));
  EXPECT_THAT(outcome.err, HasSubstr("absent.mtl"));
  EXPECT_THAT(lustro({"render", "scene.json", "-o", "out.png", "--quiet"}).err, IsEmpty());
}

TEST_F(RenderCommand, AnEmptyPictureFailsAndLeavesNoFile) {
  write_text(work() / "square.obj", behind_obj());
  const Outcome outcome = lustro({"render", "scene.json", "-o", "out.png"});
  EXPECT_EQ(outcome.code, 7);
  EXPECT_THAT(outcome.err, HasSubstr("lustro: error: scene.json: nothing was drawn: its one triangle does not lie before the camera"));
  EXPECT_FALSE(std::filesystem::exists(work() / "out.png"));
  const Outcome allowed = lustro({"render", "scene.json", "-o", "out.png", "--allow-empty"});
  EXPECT_EQ(allowed.code, 0);
  EXPECT_THAT(allowed.err, HasSubstr("lustro: warning: scene.json: nothing was drawn"));
  EXPECT_EQ(png_size(bytes("out.png")), std::pair(32, 24));
}

TEST_F(RenderCommand, WhatIsTransparentAllOverIsSaidToBe) {
  write_text(work() / "clear.json",
             R"({"image": {"width": 32, "height": 24}, "objects": [{"mesh": "square.obj", "material": {"opacity": 0}}]})");
  const Outcome outcome = lustro({"render", "clear.json", "-o", "out.png"});
  EXPECT_EQ(outcome.code, 7);
  EXPECT_THAT(outcome.err, HasSubstr("nothing was drawn: wherever samples meet"));
  EXPECT_THAT(outcome.err, HasSubstr("it is fully transparent"));
  EXPECT_FALSE(std::filesystem::exists(work() / "out.png"));
}

TEST_F(RenderCommand, ASceneWithoutTrianglesIsEmptyToo) {
  write_text(work() / "square.obj", "v 0 0 0\n");
  EXPECT_EQ(lustro({"render", "scene.json", "-o", "out.png"}).code, 7);
  EXPECT_FALSE(std::filesystem::exists(work() / "out.png"));
  const Outcome allowed = lustro({"render", "scene.json", "-o", "out.pfm", "--allow-empty"});
  EXPECT_EQ(allowed.code, 0) << allowed.err;
  EXPECT_THAT(picture("out.pfm").at(3, 3), ElementsAre(0.1F, 0.1F, 0.12F));
}

struct Refusal {
  std::string name;
  std::vector<std::string> words;
  int code;
  std::string message;
};

void PrintTo(const Refusal& refusal, std::ostream* out) {
  *out << refusal.name;
}

class Refused : public RenderCommand, public ::testing::WithParamInterface<Refusal> {};

TEST_P(Refused, WithTheRightCodeAndWordsAndNoFile) {
  write_text(work() / "broken.json", "{\"objects\": [{\"mesh\": \"square.obj\"},]}");
  write_text(work() / "range.json", square_scene(R"(, "fog": {"mode": "exp", "density": -1})"));
  write_text(work() / "key.json", square_scene(R"(, "shadng": {})"));
  write_text(work() / "missing.json", R"({"objects": [{"mesh": "nowhere.obj"}]})");
  write_text(work() / "bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99\n");
  write_text(work() / "text.xyz", "hello\n");
  write_text(
      work() / "huge.ply",
      "ply\nformat binary_little_endian 1.0\nelement vertex 4294967295\nproperty float x\nproperty float y\nproperty float z\nend_header\n");
  const std::vector<std::string> before = files();
  const Outcome outcome = lustro(GetParam().words);
  EXPECT_EQ(outcome.code, GetParam().code) << outcome.err;
  EXPECT_THAT(outcome.err, StartsWith("lustro: error: "));
  EXPECT_THAT(outcome.err, HasSubstr(GetParam().message));
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_EQ(files(), before);
}

INSTANTIATE_TEST_SUITE_P(
    Input, Refused,
    ::testing::Values(
        Refusal{"AbsentFile", {"render", "absent.obj", "-o", "o.png"}, 3, "absent.obj: "},
        Refusal{"AbsentFileAlone", {"absent.obj"}, 3, "absent.obj: "},
        Refusal{"AbsentMesh", {"render", "missing.json", "-o", "o.png"}, 3, "nowhere.obj"},
        Refusal{"AFolder", {"render", ".", "-o", "o.png"}, 3, "folder"},
        Refusal{"AbsentOutputFolder", {"render", "scene.json", "-o", "no/where/o.png"}, 3, "there is no folder no/where"},
        Refusal{"BrokenJson", {"render", "broken.json", "-o", "o.png"}, 4, "broken.json"},
        Refusal{"NumberOutOfRange", {"render", "range.json", "-o", "o.png"}, 4, "fog.density: -1 is not 0 or more"},
        Refusal{"UnknownKey", {"render", "key.json", "-o", "o.png"}, 4, "did you mean \"shading\"?"},
        Refusal{"IndexOutside", {"render", "bad.obj", "-o", "o.png"}, 4, "bad.obj:4: "},
        Refusal{"UnknownInput", {"render", "text.xyz", "-o", "o.png"}, 5, "text.xyz"},
        Refusal{"UnknownOutput", {"render", "scene.json", "-o", "o.gif"}, 5, "o.gif: pictures are written as .png, .exr or .pfm"},
        Refusal{"HugeHeader", {"render", "huge.ply", "-o", "o.png"}, 6, "huge.ply: byte 124"},
        Refusal{"UnknownPrimitive", {"render", "primitive:teapod", "-o", "o.png"}, 2, "teapot"},
        Refusal{"UnknownFlag", {"render", "scene.json", "--lightning", "phong"}, 2, "there is no flag --lightning; did you mean --lighting?"},
        Refusal{"UnknownWord", {"render", "scene.json", "--lighting", "blin-phong"}, 2, "did you mean \"blinn-phong\"?"},
        Refusal{"UnknownMaterial", {"render", "scene.json", "--material", "jad"}, 2, "jade"},
        Refusal{"SizeWithoutX", {"render", "scene.json", "--size", "800"}, 2, "--size: `800` is not WIDTHxHEIGHT"},
        Refusal{"SizeTooLarge", {"render", "scene.json", "--size", "20000x10"}, 2, "20000 is outside 1..16384"},
        Refusal{"FovTooLarge", {"render", "scene.json", "--fov", "180"}, 2, "--fov: 180 is not more than 0 and less than 180"},
        Refusal{"NoValue", {"render", "scene.json", "--fov"}, 2, "--fov: its value is missing"},
        Refusal{"TwoValues", {"render", "scene.json", "--fov", "30", "--fov", "40"}, 2, "--fov: may be stated only once"},
        Refusal{"ASwitchWithANumber", {"render", "scene.json", "--no-lights=3"}, 2, "--no-lights: is a switch and takes no value"},
        Refusal{"BitsAsAWord", {"render", "scene.json", "--bits", "many"}, 2, "--bits: `many` is not a number"},
        Refusal{"AbsentLight", {"render", "scene.json", "--aov", "light:7", "-o", "o.exr"}, 2, "light:7"},
        Refusal{"OutputTwice", {"render", "scene.json", "-o", "o.png", "-o", "o.png"}, 2, "o.png is named twice"},
        Refusal{
            "TwoScenes", {"render", "scene.json", "square.obj", "-o", "o.png"}, 2, "`square.obj` is one argument too many; -o names the output"},
        Refusal{"NoScene", {"render"}, 2, "SCENE is required"}),
    [](const auto& refusal) { return refusal.param.name; });

TEST_F(RenderCommand, AFailureLeavesTheFileThatWasThere) {
  write_text(work() / "out.png", "mine");
  write_text(work() / "square.obj", behind_obj());
  EXPECT_EQ(lustro({"render", "scene.json", "-o", "out.png"}).code, 7);
  EXPECT_EQ(bytes("out.png"), "mine");
}

TEST_F(RenderCommand, AnInterruptLeavesNoFile) {
  const Outcome outcome = run_program({"timeout", "-s", "INT", "0.3", LUSTRO_COMMAND, "primitive:sphere:300", "--engine", "reference", "--size",
                                       "8000x8000", "--samples", "16", "-o", "o.png"});
  EXPECT_EQ(outcome.code, 124);  // timeout's own code: the command was interrupted
  EXPECT_THAT(files(), ElementsAre("scene.json", "square.obj"));
}

TEST_F(RenderCommand, TheProgressBarIsForTerminalsAndForLongWork) {
  // Far more work than the few seconds after which it is stopped.
  const auto stopped_after = [](const std::string& seconds) {
    return "timeout --foreground -s INT " + seconds +
           " " LUSTRO_COMMAND " primitive:torus:100 --engine reference --size 8000x8000 --samples 16 --threads 1 -o o.png";
  };
  EXPECT_THAT(run_program({"sh", "-c", stopped_after("1.6")}).err, IsEmpty());
  if (!has_program("script")) {
    GTEST_SKIP() << "needs script(1) for a pseudo-terminal";
  }
  const auto on_terminal = [&](const std::string& command) { return run_program({"script", "-qec", command, "/dev/null"}).out; };
  EXPECT_THAT(on_terminal(stopped_after("2.5")), HasSubstr("drawing [#"));
  EXPECT_THAT(on_terminal(stopped_after("1.6") + " --quiet"), Not(HasSubstr("drawing")));
  EXPECT_THAT(on_terminal(LUSTRO_COMMAND " scene.json -o o.png"), Not(HasSubstr("drawing")));
}

}  // namespace
