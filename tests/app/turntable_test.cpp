// `lustro turntable`: the turn itself, its time, and where it goes.
#include <gmock/gmock.h>

#include "app/run_command.hpp"
#include "app/scenes.hpp"
#include "lustro/image.hpp"

namespace {

using namespace lustro::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class TurntableCommand : public CommandTest {
 protected:
  void SetUp() override {
    write_text(work() / "square.obj", square_obj());
    write_text(work() / "scene.json", square_scene(R"(, "shading": {"two_sided": true})"));
  }
  Outcome turntable(std::vector<std::string> words) {
    words.insert(words.begin(), {"turntable", "-q"});
    return lustro(words);
  }
  [[nodiscard]] std::string bytes(const std::string& file) const { return file_text(work() / file); }
  [[nodiscard]] int covered(const std::string& file) const {
    const auto image = lustro::read_image(work() / file);
    EXPECT_TRUE(image) << file;
    int count = 0;
    for (int y = 0; image && y < image->height; ++y) {
      for (int x = 0; x < image->width; ++x) {
        count += image->channels == 4 && image->at(x, y)[3] == 0 ? 0 : 1;
      }
    }
    return count;
  }
};

TEST_F(TurntableCommand, AFolderTakesNumberedFramesOfOneTurn) {
  ASSERT_EQ(turntable({"scene.json", "-o", "out/frames", "--frames", "8", "--transparent", "--size", "64x48"}).code, 0);
  const int front = covered("out/frames/frame_0001.png"), oblique = covered("out/frames/frame_0002.png"),
            edge = covered("out/frames/frame_0003.png"), back = covered("out/frames/frame_0005.png");
  EXPECT_GT(front, 500);
  EXPECT_NEAR(back, front, front / 50);
  EXPECT_LT(oblique, front);
  EXPECT_GT(oblique, front / 2);  // cos 45
  EXPECT_LT(edge, front / 10);    // a square seen from its side
  EXPECT_TRUE(std::filesystem::exists(work() / "out/frames/frame_0008.png"));
  EXPECT_FALSE(std::filesystem::exists(work() / "out/frames/frame_0009.png"));
}

TEST_F(TurntableCommand, TheFirstFrameOfAStatedCameraIsTheRenderedPicture) {
  ASSERT_EQ(turntable({"scene.json", "-o", "out", "--frames", "3"}).code, 0);
  ASSERT_EQ(lustro({"render", "scene.json", "-q", "-o", "still.png"}).code, 0);
  EXPECT_EQ(lustro({"compare", "still.png", "out/frame_0001.png", "--tolerance", "0"}).code, 0);
}

TEST_F(TurntableCommand, AnOrbitingCameraSeesTheSameSidesBeforeLightsThatStand) {
  const auto drawn = [&](const std::string& orbit, std::vector<std::string> more) {
    more.insert(more.begin(), {"primitive:teapot", "-o", orbit, "--orbit", orbit, "--frames", "5", "--size", "80x60"});
    EXPECT_EQ(turntable(more).code, 0);
  };
  const auto same = [&](int frame) {
    const std::string name = "/frame_000" + std::to_string(frame) + ".png";
    return lustro({"compare", "object" + name, "camera" + name, "--tolerance", "3", "--max-share", "1"}).code == 0;
  };
  drawn("object", {});
  drawn("camera", {});  // the default lights go with the camera, so that nothing tells the two apart
  EXPECT_TRUE(same(1));
  EXPECT_TRUE(same(2));
  EXPECT_TRUE(same(4));
  EXPECT_EQ(lustro({"compare", "object/frame_0001.png", "object/frame_0002.png"}).code, 1);  // it does turn
  drawn("object", {"--light", "directional 1,0,0"});
  drawn("camera", {"--light", "directional 1,0,0"});
  EXPECT_TRUE(same(1));
  EXPECT_FALSE(same(3));
}

TEST_F(TurntableCommand, TheWholeTurnIsInThePicture) {
  // A long wall that is seen edge-on and, a quarter turn later, from its side.
  write_text(work() / "beam.obj", "v 0 0 -20\nv 0 0 20\nv 0 2 20\nv 0 2 -20\nf 1 2 3 4\n");
  ASSERT_EQ(turntable({"beam.obj", "-o", "out", "--frames", "8", "--view", "front", "--transparent", "--size", "100x60"}).code, 0);
  for (int i = 1; i <= 8; ++i) {
    const auto image = lustro::read_image(work() / ("out/frame_000" + std::to_string(i) + ".png"));
    ASSERT_TRUE(image);
    for (int y = 0; y < image->height; ++y) {
      EXPECT_EQ(image->at(0, y)[3], 0) << "frame " << i;
      EXPECT_EQ(image->at(99, y)[3], 0) << "frame " << i;
    }
  }
  EXPECT_GT(covered("out/frame_0003.png"), 80);
}

TEST_F(TurntableCommand, TwoOfFramesSecondsAndRateMakeTheThird) {
  const auto timing = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"scene.json", "-o", "out.apng", "--json"});
    const auto json = turntable(words).json();
    return std::pair<int, double>(json["frames"], json["frames_per_second"]);
  };
  EXPECT_EQ(timing({}), std::pair(60, 30.0));
  EXPECT_EQ(timing({"--frames", "20"}), std::pair(20, 30.0));
  EXPECT_EQ(timing({"--seconds", "0.5"}), std::pair(15, 30.0));
  EXPECT_EQ(timing({"--seconds", "0.5", "--fps", "8"}), std::pair(4, 8.0));
  EXPECT_EQ(timing({"--frames", "5", "--seconds", "2"}), std::pair(5, 2.5));
  EXPECT_EQ(turntable({"scene.json", "-o", "out.apng", "--frames", "5", "--seconds", "2", "--fps", "9"}).code, 2);
  EXPECT_EQ(turntable({"scene.json", "-o", "out.apng", "--frames", "0"}).code, 2);
  EXPECT_EQ(turntable({"scene.json", "-o", "out.apng", "--seconds", "1e9"}).code, 2);
}

TEST_F(TurntableCommand, TheNameSaysWhatItBecomes) {
  for (const auto& [name, mark] :
       std::vector<std::pair<std::string, std::string>>{{"a.apng", "acTL"}, {"a.png", "acTL"}, {"a.webp", "ANMF"}, {"a.gif", "NETSCAPE2.0"}}) {
    const Outcome outcome = turntable({"scene.json", "-o", name, "--frames", "3"});
    if (outcome.code == 5) {
      EXPECT_THAT(outcome.err, HasSubstr("this build of Lustro makes no")) << name;
      continue;
    }
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(bytes(name), HasSubstr(mark)) << name;
  }
}

TEST_F(TurntableCommand, ThreadsDoNotChangeAByte) {
  ASSERT_EQ(turntable({"primitive:torus", "-o", "one.apng", "--frames", "4", "--size", "90x70", "--threads", "1"}).code, 0);
  ASSERT_EQ(turntable({"primitive:torus", "-o", "five.apng", "--frames", "4", "--size", "90x70", "--threads", "5"}).code, 0);
  EXPECT_EQ(bytes("one.apng"), bytes("five.apng"));
}

TEST_F(TurntableCommand, AFilmIsMadeByFfmpeg) {
  // A stand-in that keeps what it is told and what it is fed.
  std::filesystem::create_directories(work() / "bin");
  write_text(work() / "bin/ffmpeg", "#!/bin/sh\necho \"$@\" > told\nfor last; do :; done\nwc -c > fed\nprintf film > \"${last#file:}\"\n");
  std::filesystem::permissions(work() / "bin/ffmpeg", std::filesystem::perms::owner_all);
  const std::string path = "PATH=" + (work() / "bin").string() + ":/usr/bin:/bin";
  const Outcome outcome =
      run_program({"env", path, LUSTRO_COMMAND, "turntable", "scene.json", "-o", "out.mp4", "--frames", "7", "--fps", "24", "-q"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(bytes("out.mp4"), "film");
  EXPECT_THAT(bytes("told"), HasSubstr("-s 32x24 -r 24 "));
  EXPECT_EQ(std::stoi(bytes("fed")), 7 * 32 * 24 * 3);
  EXPECT_THAT(files(), ElementsAre("bin", "fed", "ffmpeg", "out.mp4", "scene.json", "square.obj", "told"));
}

TEST_F(TurntableCommand, AnFfmpegThatFailsLeavesNothing) {
  std::filesystem::create_directories(work() / "bin");
  write_text(work() / "bin/ffmpeg", "#!/bin/sh\nfor last; do :; done\nprintf half > \"${last#file:}\"\necho no codec >&2\nexit 3\n");
  std::filesystem::permissions(work() / "bin/ffmpeg", std::filesystem::perms::owner_all);
  write_text(work() / "out.mp4", "mine");
  const std::string path = "PATH=" + (work() / "bin").string() + ":/usr/bin:/bin";
  const Outcome outcome =
      run_program({"env", path, LUSTRO_COMMAND, "turntable", "scene.json", "-o", "out.mp4", "--frames", "40", "--size", "400x300"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("no codec"));
  EXPECT_THAT(outcome.err, HasSubstr("ffmpeg"));
  EXPECT_EQ(bytes("out.mp4"), "mine");
  EXPECT_THAT(files(), ElementsAre("bin", "ffmpeg", "out.mp4", "scene.json", "square.obj"));
}

TEST_F(TurntableCommand, RefusesWhatCannotBecomeATurntable) {
  const Outcome absent = run_program({"env", "PATH=/nowhere", LUSTRO_COMMAND, "turntable", "scene.json", "-o", "out.mp4"});
  EXPECT_EQ(absent.code, 5);
  EXPECT_THAT(absent.err, HasSubstr("out.mp4: an MP4 is made by ffmpeg, which is not installed"));
  EXPECT_EQ(turntable({"scene.json", "-o", "out.avi"}).code, 5);
  EXPECT_EQ(turntable({"scene.json", "-o", "no/where.apng"}).code, 3);
  EXPECT_EQ(turntable({"scene.json", "-o", "out.webp", "--quality", "101"}).code, 2);
  EXPECT_EQ(turntable({"scene.json"}).code, 2);
  write_text(work() / "square.obj", "v 0 0 0\n");
  EXPECT_EQ(turntable({"scene.json", "-o", "out.apng"}).code, 7);
  EXPECT_THAT(files(), ElementsAre("scene.json", "square.obj"));
}

}  // namespace
