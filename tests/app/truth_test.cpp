// `lustro truth`: its files, its page and its refusals.
#include <gmock/gmock.h>

#include "run_command.hpp"
#include "scenes.hpp"

namespace lustro::testing {
namespace {

using ::testing::HasSubstr;

class TruthCommand : public CommandTest {
 protected:
  void SetUp() override {
    write_text(work() / "square.obj", square_obj());
    write_text(work() / "scene.json", square_scene());
    if (lustro({"render", "scene.json", "--engine", "path", "--spp", "1", "-q", "-o", "probe.png"}).code == 5) {
      GTEST_SKIP() << "this build has no path tracer (Embree is absent)";
    }
    std::filesystem::remove(work() / "probe.png");
  }
};

TEST_F(TruthCommand, WritesAPageWithItsPicturesAndTheFigures) {
  const Outcome outcome = lustro({"truth", "scene.json", "--spp", "4", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json json = outcome.json();
  EXPECT_EQ(json["samples"], 4);
  EXPECT_EQ(json["causes"].size(), 5U);
  EXPECT_TRUE(json["error"]["rmse"].is_number());
  EXPECT_EQ(nlohmann::json::parse(file_text(work() / "scene-truth/report.json")), json);
  const std::string page = file_text(work() / "scene-truth/index.html");
  EXPECT_THAT(page, HasSubstr("<!doctype html>"));
  std::size_t pictures = 0;
  for (std::size_t at = page.find("<img src=\""); at != std::string::npos; at = page.find("<img src=\"", at + 1)) {
    const std::size_t begin = at + 10;
    EXPECT_TRUE(std::filesystem::exists(work() / "scene-truth" / page.substr(begin, page.find('"', begin) - begin)));
    ++pictures;
  }
  EXPECT_GE(pictures, 9U);
  EXPECT_EQ(page.find("http"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(work() / "scene-truth/truth.exr"));
  EXPECT_THAT(file_text(work() / "scene-truth/report.txt"), HasSubstr("by cause"));
}

TEST_F(TruthCommand, RefusesWhatItCannotMeasureAndLeavesNothing) {
  const Outcome one = lustro({"truth", "scene.json", "--spp", "1"});
  EXPECT_EQ(one.code, 2);
  EXPECT_THAT(one.err, HasSubstr("--spp"));
  const Outcome absent = lustro({"truth", "absent.json", "--spp", "2"});
  EXPECT_EQ(absent.code, 3);
  EXPECT_FALSE(std::filesystem::exists(work() / "scene-truth"));
  EXPECT_FALSE(std::filesystem::exists(work() / "absent-truth"));
  const Outcome file = lustro({"truth", "scene.json", "-o", "square.obj", "--spp", "2"});
  EXPECT_EQ(file.code, 3);
  EXPECT_THAT(file.err, HasSubstr("is a file; a folder for the report is expected"));
}

}  // namespace
}  // namespace lustro::testing
