// `lustro bench`: what it reports must hang together; how fast the machine is cannot be tested.
#include <gmock/gmock.h>

#include "app/bench_report.hpp"
#include "app/run_command.hpp"
#include "app/scenes.hpp"

namespace {

using namespace lustro::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class BenchCommand : public CommandTest {
 protected:
  void SetUp() override {
    write_text(work() / "square.obj", square_obj());
    write_text(work() / "scene.json", square_scene());
  }
};

TEST_F(BenchCommand, JsonHoldsEachFrameAndItsStages) {
  const Outcome outcome = lustro({"bench", "scene.json", "--frames", "5", "--warmup", "1", "--threads", "2", "--target", "scalar", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = outcome.json();
  EXPECT_EQ(json["frames"], 5);
  EXPECT_EQ(json["all_frames_ms"].size(), 5U);
  EXPECT_EQ(json["triangles"], 2);
  EXPECT_EQ(json["width"], 32);
  EXPECT_EQ(json["height"], 24);
  EXPECT_EQ(json["samples"], 4);
  EXPECT_EQ(json["lights"], 2);
  EXPECT_EQ(json["threads"], 2);
  EXPECT_EQ(json["target"], "scalar");
  EXPECT_EQ(json["engine"], "raster");
  std::vector<double> times = json["all_frames_ms"];
  std::sort(times.begin(), times.end());
  EXPECT_EQ(json["frame_ms"]["median"], times[2]);
  EXPECT_EQ(json["frame_ms"]["min"], times[0]);
  EXPECT_GT(times[0], 0);
  EXPECT_NEAR(json["triangles_per_second"].get<double>(), 2 / times[2] * 1e3, 1e-3);
  EXPECT_NEAR(json["pixels_per_second"].get<double>(), 32 * 24 / times[2] * 1e3, 1);
  double stages = 0;
  for (const char* stage : {"prepare", "cull", "visibility", "shading"}) {
    EXPECT_LE(json["stages_ms"][stage]["min"], json["stages_ms"][stage]["median"]) << stage;
    stages += json["stages_ms"][stage]["min"].get<double>();
  }
  EXPECT_GT(stages, 0);
  EXPECT_LE(stages, times[4]);  // stages are parts of frames
  EXPECT_GT(json["machine"]["copy_bytes_per_second"], 1e8);
  EXPECT_GT(json["machine"]["operations_per_second"], 1e8);
  EXPECT_EQ(json["limits"]["shading"]["bytes"], 4 * 32 * 24);
}

TEST_F(BenchCommand, TheSceneTurnsBeforeACameraThatStands) {
  // The square faces the camera; after half a turn in 314 frames it shows its back, edge-on it covers nothing and is an error, so stop before.
  const auto front = lustro({"bench", "scene.json", "--frames", "1", "--warmup", "0", "--json"}).json();
  const auto turning = lustro({"bench", "scene.json", "--frames", "120", "--warmup", "0", "--json"}).json();
  EXPECT_EQ(front["turned_about"], nlohmann::json({0, 0, 0}));
  EXPECT_EQ(front["camera"]["eye"], nlohmann::json({0, 0, 3}));
  EXPECT_LT(turning["pixels_covered"], front["pixels_covered"]);  // seen from the side it is narrower, on the whole
  EXPECT_GT(turning["pixels_covered"].get<int>() * 2, front["pixels_covered"].get<int>());
}

TEST_F(BenchCommand, TheTableNamesEveryStage) {
  const Outcome outcome = lustro({"bench", "square.obj", "--size", "40x30", "--frames", "2"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* word :
       {"square.obj: 2 triangles, 40 x 30 pixels", "\nframe ", "\n  prepare ", "\n  cull ", "\n  visibility ", "\n  shading "}) {
    EXPECT_THAT(outcome.out, HasSubstr(word));
  }
  EXPECT_THAT(files(), ElementsAre("scene.json", "square.obj"));
}

TEST_F(BenchCommand, RefusesWhatItCannotMeasure) {
  EXPECT_EQ(lustro({"bench", "scene.json", "--frames", "0"}).code, 2);
  EXPECT_EQ(lustro({"bench", "scene.json", "--warmup", "-1"}).code, 2);
  EXPECT_EQ(lustro({"bench", "absent.obj"}).code, 3);
  write_text(work() / "square.obj", behind_obj());
  const Outcome empty = lustro({"bench", "scene.json"});
  EXPECT_EQ(empty.code, 7);
  EXPECT_THAT(empty.out, IsEmpty());
}

TEST(StageWork, IsCountedFromThePicture) {
  lustro::app::FrameFacts facts{.triangles = 256, .vertices = 150, .pixels = 1000, .pixels_covered = 100, .lights = 2, .shading = {}};
  EXPECT_EQ(lustro::app::cull_work(facts).bytes, 2 * 64);
  EXPECT_EQ(lustro::app::visibility_work(facts).bytes, 150 * 12 + 256 * 4);
  const auto phong = lustro::app::shading_work(facts);
  EXPECT_EQ(phong.bytes, 4000);
  facts.lights = 3;
  EXPECT_EQ(lustro::app::shading_work(facts).operations - phong.operations, 100 * (14 + 12 + 25 + 6));  // N.L, R and R.V, the power, the sums
  facts.shading.lighting = lustro::Lighting::lambert;
  EXPECT_LT(lustro::app::shading_work(facts).operations, phong.operations);
}

}  // namespace
