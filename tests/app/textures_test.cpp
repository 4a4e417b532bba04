// Scene files with textures, from the command: drawn, listed, explained, and refused where `--strict` asks for that.
#include <gmock/gmock.h>

#include <filesystem>

#include "app/exit_codes.hpp"
#include "app/run_command.hpp"
#include "app/scenes.hpp"
#include "lustro/image.hpp"

namespace {

using namespace lustro::testing;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A plane seen from above, unlit, whose picture is red on its left, blue on its right and dark in its lower row.
class TexturesCommand : public CommandTest {
 protected:
  void SetUp() override {
    lustro::Image image(2, 2, 3);
    image.pixels = {1, 0, 0, 0, 0, 1, 0.2F, 0, 0, 0, 0, 0.2F};
    ASSERT_TRUE(lustro::write_image(work() / "picture.png", image, {.transfer = lustro::Transfer::none}));
    write_text(work() / "scene.json", scene("picture.png"));
    write_text(work() / "broken.json", scene("gone.png"));
  }

  static std::string scene(const std::string& picture) {
    return R"({"image": {"width": 8, "height": 8, "samples": 1, "transfer": "none"},
      "camera": {"projection": "orthographic", "view": "top", "height": 2}, "shading": {"lighting": "constant"},
      "materials": {"card": {"textures": {"diffuse": {"file": ")" +
           picture + R"(", "magnify": "nearest"}}}},
      "objects": [{"mesh": "primitive:plane", "material": "card"}]})";
  }
};

TEST_F(TexturesCommand, APictureLiesOnTheSurfaceAsItsCoordinatesSay) {
  const Outcome outcome = lustro({"render", "scene.json", "-q", "-o", "out.png"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  const auto picture = lustro::read_image(work() / "out.png", lustro::Transfer::none);
  ASSERT_TRUE(picture);
  const auto color = [&](int x, int y) {
    const auto pixel = picture->at(x, y);
    return std::vector<float>{pixel[0], pixel[1], pixel[2]};
  };
  EXPECT_EQ(color(1, 1), (std::vector<float>{1, 0, 0}));
  EXPECT_EQ(color(6, 1), (std::vector<float>{0, 0, 1}));
  EXPECT_EQ(color(1, 6), (std::vector<float>{0.2F, 0, 0}));
  EXPECT_EQ(color(6, 6), (std::vector<float>{0, 0, 0.2F}));
}

TEST_F(TexturesCommand, InfoListsEachPictureWithItsUses) {
  write_text(work() / "many.json", R"({"materials": {"a": {"textures": {"diffuse": "picture.png", "specular": "./picture.png"}},
    "b": {"textures": {"bump": "picture.png", "diffuse": "picture.png"}}}, "objects": [{"mesh": "primitive:plane", "material": "a"},
    {"mesh": "primitive:plane", "material": "a"}, {"mesh": "primitive:plane", "material": "b"}]})");
  const Outcome outcome = lustro({"info", "many.json", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto textures = outcome.json()["textures"];
  ASSERT_EQ(textures.size(), 2U);  // as a colour, and as data
  EXPECT_EQ(textures[0]["file"], "picture.png");
  EXPECT_EQ(textures[0]["width"], 2);
  EXPECT_EQ(textures[0]["channels"], 3);
  EXPECT_EQ(textures[0]["used_by"], nlohmann::json({"a: diffuse", "a: specular", "b: diffuse"}));
  EXPECT_EQ(textures[1]["used_by"], nlohmann::json({"b: bump"}));
  const Outcome text = lustro({"info", "many.json"});
  EXPECT_THAT(text.out, HasSubstr("picture.png  2 x 2, 3 channels"));
  EXPECT_THAT(text.out, HasSubstr("b: bump"));
}

TEST_F(TexturesCommand, AMissingPictureIsAWarningAndThePlainColourIsDrawn) {
  const Outcome outcome = lustro({"render", "broken.json", "-o", "out.png"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("material \"card\": diffuse: the texture \"gone.png\" is missing; drawn without it"));
  const auto picture = lustro::read_image(work() / "out.png", lustro::Transfer::none);
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->at(4, 4)[0], 1);
  EXPECT_THAT(lustro({"info", "broken.json"}).out, HasSubstr("\"gone.png\" is missing"));
}

TEST_F(TexturesCommand, StrictFailsAndWritesNothing) {
  write_text(work() / "cut.png", "\x89PNG\r\n\x1a\n");
  write_text(work() / "cut.json", scene("cut.png"));
  for (const auto& [file, code] : {std::pair{"broken.json", lustro::ErrorKind::io}, std::pair{"cut.json", lustro::ErrorKind::malformed}}) {
    const Outcome outcome = lustro({"render", file, "--strict", "-o", "out.png"});
    EXPECT_EQ(outcome.code, static_cast<int>(lustro::app::exit_code_of(code))) << file;
    EXPECT_NE(outcome.code, 0);
    EXPECT_THAT(outcome.err, HasSubstr(file));
    EXPECT_THAT(outcome.err, HasSubstr("material \"card\""));
    EXPECT_FALSE(std::filesystem::exists(work() / "out.png")) << file;
  }
  EXPECT_EQ(lustro({"render", "scene.json", "--strict", "-q", "-o", "out.png"}).code, 0);
  EXPECT_TRUE(std::filesystem::exists(work() / "out.png"));
}

TEST_F(TexturesCommand, ExplainSaysWhatEachMapSaid) {
  const Outcome outcome = lustro({"explain", "scene.json", "6", "1", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto maps = outcome.json()["fragments"][0]["maps"];
  ASSERT_EQ(maps.size(), 1U);
  EXPECT_EQ(maps[0]["map"], "diffuse");
  EXPECT_EQ(maps[0]["name"], "picture.png");
  EXPECT_EQ(maps[0]["value"], nlohmann::json({0, 0, 1, 1}));
  EXPECT_NEAR(maps[0]["u"].get<double>(), 0.8125, 1e-4);
  EXPECT_NEAR(maps[0]["v"].get<double>(), 0.1875, 1e-4);
  const Outcome text = lustro({"explain", "scene.json", "6", "1"});
  EXPECT_THAT(text.out, HasSubstr("diffuse map"));
  EXPECT_THAT(text.out, HasSubstr("picture.png"));
}

TEST_F(TexturesCommand, WrongKeysAreNamedByTheirPath) {
  write_text(work() / "wrong.json",
             R"({"objects": [{"mesh": "primitive:plane", "material": {"textures": {"diffuse": {"file": "a.png", "wrap": "tile"}}}}]})");
  const Outcome outcome = lustro({"render", "wrong.json", "-o", "out.png"});
  EXPECT_NE(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("wrong.json: objects[0].material.textures.diffuse.wrap: unknown word \"tile\""));
  EXPECT_FALSE(std::filesystem::exists(work() / "out.png"));
}

}  // namespace
