// `lustro render --engine path`: its flags, what it says, and how it fails.
#include <gmock/gmock.h>

#include <chrono>
#include <future>

#include "app/run_command.hpp"
#include "app/scenes.hpp"
#include "lustro/image.hpp"

namespace {

using namespace lustro::testing;
using ::testing::HasSubstr;
using ::testing::Not;

class PathCommand : public CommandTest {
 protected:
  void SetUp() override {
    write_text(work() / "square.obj", square_obj());
    write_text(work() / "scene.json", square_scene());
    const Outcome outcome = lustro({"render", "scene.json", "--engine", "path", "--spp", "1", "-o", "probe.png"});
    if (outcome.code != 0 && outcome.err.find("without Embree") != std::string::npos) {
      GTEST_SKIP() << "this build follows no paths";
    }
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }
  [[nodiscard]] lustro::Image picture(const std::string& file) const { return lustro::read_image(work() / file).value(); }
};

TEST_F(PathCommand, SaysHowManyPathsItFollowedAndHowSureItIs) {
  const Outcome outcome =
      lustro({"render", "scene.json", "--engine", "path", "--spp", "4", "--json", "-o", "out.exr", "--aov", "variance,depth"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("4 paths a pixel, error "));
  EXPECT_THAT(outcome.out, HasSubstr("\"samples\": 4"));
  EXPECT_THAT(outcome.out, HasSubstr("\"rays\": "));
  EXPECT_EQ(picture("out.exr").width, 32);
}

// The error of one path is not known, and is not said.
TEST_F(PathCommand, OnePathHasNoError) {
  const Outcome outcome = lustro({"render", "scene.json", "--engine", "path", "--spp", "1", "--json", "-o", "out.png"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr(", 1 path a pixel, "));
  EXPECT_THAT(outcome.err, Not(HasSubstr("error")));
  EXPECT_THAT(outcome.out, HasSubstr("\"error\": null"));
}

TEST_F(PathCommand, StopsByTimeAndByError) {
  EXPECT_THAT(lustro({"render", "scene.json", "--engine", "path", "--seconds", "0.01", "-o", "out.png"}).err, HasSubstr(" a pixel"));
  EXPECT_THAT(lustro({"render", "scene.json", "--engine", "path", "--target-error", "0.5", "-o", "out.png"}).err, HasSubstr("16 paths a pixel"));
}

TEST_F(PathCommand, ThePictureIsThereLongBeforeTheEnd) {
  const std::filesystem::path file = work() / "slow.png";
  auto drawing = std::async(std::launch::async, [&] {
    return lustro({"render", "scene.json", "--engine", "path", "--seconds", "2", "--preview", "0.05", "-o", "slow.png"});
  });
  while (!std::filesystem::exists(file) && drawing.wait_for(std::chrono::milliseconds(10)) != std::future_status::ready) {
  }
  ASSERT_NE(drawing.wait_for(std::chrono::seconds(0)), std::future_status::ready);
  const lustro::Image early = picture("slow.png");  // whole, whenever it is read
  const Outcome outcome = drawing.get();
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const lustro::Image last = picture("slow.png");
  EXPECT_EQ(early.pixels.size(), last.pixels.size());
  EXPECT_NE(lustro::hash_image(early), lustro::hash_image(last));

  // It does not change what is drawn.
  ASSERT_EQ(lustro({"render", "scene.json", "--engine", "path", "--spp", "40", "--preview", "0", "-o", "quiet.exr"}).code, 0);
  ASSERT_EQ(lustro({"render", "scene.json", "--engine", "path", "--spp", "40", "--preview", "0.0001", "-o", "shown.exr"}).code, 0);
  EXPECT_EQ(lustro::hash_image(picture("quiet.exr")), lustro::hash_image(picture("shown.exr")));
  EXPECT_THAT(lustro({"render", "scene.json", "--preview", "1", "-o", "no.png"}).err, HasSubstr("--preview: belongs to --engine path"));
}

TEST_F(PathCommand, APreviewThatCannotBeWrittenFailsAsTheEndWould) {
  const auto render = [&](const char* preview) {
    return lustro({"render", "scene.json", "--engine", "path", "--spp", "40", "--preview", preview, "-o", "out.png", "--aov", "variance"});
  };
  std::filesystem::create_directories(work() / "out.variance.png");  // where the layer would go
  const Outcome end = render("0");
  const Outcome before = render("0.001");
  EXPECT_THAT(end.err, HasSubstr("out.variance.png: cannot be written"));
  EXPECT_EQ(before.code, end.code);
  EXPECT_EQ(before.err, end.err);
}

TEST_F(PathCommand, APipeGetsTheLastPictureAlone) {
  const auto bytes_through_a_pipe = [&](const std::string& preview) {
    run_program({"sh", "-c",
                 "mkfifo p.png; cat p.png > piped.png & " LUSTRO_COMMAND " render scene.json --engine path --spp 40 --preview " + preview +
                     " -o p.png; wait; rm p.png"});
    return file_text(work() / "piped.png");
  };
  const std::string end = bytes_through_a_pipe("0");
  EXPECT_FALSE(end.empty());
  EXPECT_EQ(bytes_through_a_pipe("0.0001"), end);
}

TEST_F(PathCommand, GoesOnFromWhatAFileKept) {
  const auto render = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"render", "scene.json", "--engine", "path", "--environment", "#fff"});
    return lustro(more);
  };
  ASSERT_EQ(render({"--spp", "20", "-o", "whole.exr"}).code, 0);
  EXPECT_THAT(render({"--spp", "6", "--resume", "state", "-o", "part.exr"}).err, HasSubstr(" 6 paths a pixel, "));
  const Outcome rest = render({"--spp", "20", "--resume", "state", "-o", "part.exr", "--json"});
  EXPECT_THAT(rest.err, HasSubstr("20 paths a pixel (6 of them from before), "));
  EXPECT_THAT(rest.out, HasSubstr("\"resumed\": 6"));
  EXPECT_EQ(lustro::hash_image(picture("whole.exr")), lustro::hash_image(picture("part.exr")));
  const Outcome other = render({"--spp", "20", "--resume", "state", "--bounces", "2", "-o", "other.exr"});
  EXPECT_EQ(other.code, 2) << other.err;
  EXPECT_THAT(other.err, HasSubstr("state: it belongs to another scene, or to other flags"));
  EXPECT_FALSE(std::filesystem::exists(work() / "other.exr"));
  write_text(work() / "text", "a text");
  EXPECT_THAT(render({"--resume", "text", "-o", "other.exr"}).err, HasSubstr("text: this is no state of a picture by paths"));
  EXPECT_THAT(render({"--spp", "2", "--resume", "same.png", "-o", "./same.png"}).err,
              HasSubstr("--resume: ./same.png is where the picture is written"));
  EXPECT_THAT(render({"--spp", "2", "--resume", "-", "-o", "out.png"}).err, HasSubstr("--resume: found -, expected a file"));
  EXPECT_THAT(lustro({"render", "scene.json", "--resume", "state", "-o", "out.png"}).err, HasSubstr("--resume: belongs to --engine path"));
}

TEST_F(PathCommand, AnotherSeedDrawsAnotherNoise) {
  const auto hash = [&](const char* seed) {
    EXPECT_EQ(lustro({"render", "scene.json", "--engine", "path", "--spp", "1", "--seed", seed, "--environment", "#fff", "-o", "out.exr"}).code,
              0);
    return lustro::hash_image(picture("out.exr"));
  };
  EXPECT_EQ(hash("1"), hash("1"));
  EXPECT_NE(hash("1"), hash("2"));
}

TEST_F(PathCommand, AnEnvironmentIsAColourOrAFileFromWhereTheCommandIsTyped) {
  lustro::Image sky(2, 1, 3);
  sky.pixels = {0, 0, 8, 0, 0, 8};
  std::filesystem::create_directories(work() / "skies");
  ASSERT_TRUE(lustro::write_image(work() / "skies/blue.pfm", sky));
  std::filesystem::create_directories(work() / "scenes");
  write_text(work() / "scenes/scene.json", square_scene());
  write_text(work() / "scenes/square.obj", square_obj());
  for (const char* const value : {"skies/blue.pfm", "0,0,8"}) {
    const Outcome outcome = lustro({"render", "scenes/scene.json", "--engine", "path", "--spp", "2", "--environment", value, "-o", "out.exr"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(picture("out.exr").at(0, 0)[2], 8) << value;
  }
  const Outcome missing = lustro({"render", "scene.json", "--environment", "no.hdr", "-o", "out.png"});
  EXPECT_NE(missing.code, 0);
  EXPECT_THAT(missing.err, HasSubstr("--environment: no.hdr"));
}

TEST_F(PathCommand, TheSceneFileNamesItsSky) {
  lustro::Image sky(2, 1, 3);
  sky.pixels = {0, 4, 0, 0, 4, 0};
  ASSERT_TRUE(lustro::write_image(work() / "green.pfm", sky));
  write_text(work() / "sky.json", square_scene(R"(, "environment": {"file": "green.pfm", "gain": 0.5})"));
  Outcome outcome = lustro({"render", "sky.json", "--engine", "path", "--spp", "2", "-o", "out.exr"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(picture("out.exr").at(0, 0)[1], 2);
  outcome = lustro({"render", "sky.json", "-o", "out.exr"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NEAR(picture("out.exr").at(0, 0)[1], 2, 1e-5);
  write_text(work() / "sky.json", square_scene(R"(, "environment": "none.hdr")"));
  EXPECT_THAT(lustro({"render", "sky.json", "-o", "out.png"}).err, HasSubstr("environment.file: the picture "));
}

TEST_F(PathCommand, ItsFlagsBelongToIt) {
  for (const char* const flag : {"--spp", "--seconds", "--target-error", "--bounces", "--seed"}) {
    EXPECT_THAT(lustro({"render", "scene.json", flag, "1", "-o", "out.png"}).err, HasSubstr(std::string(flag) + ": belongs to --engine path"));
  }
  EXPECT_THAT(lustro({"render", "scene.json", "--engine", "path", "--spp", "0", "-o", "out.png"}).err, HasSubstr("--spp"));
  EXPECT_THAT(lustro({"render", "scene.json", "--engine", "path", "--spp", "1", "--aov", "diffuse", "-o", "out.exr"}).err,
              HasSubstr("the layer diffuse is a part of the local model's sum"));
}

}  // namespace
