// `lustro batch`: good models are drawn beside broken and hostile ones, and what went wrong is said.
#include <gmock/gmock.h>

#include <set>

#include "app/run_command.hpp"
#include "app/sanitized.hpp"
#include "app/scenes.hpp"

namespace {

using namespace lustro::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// Work for the reference engine for far longer than any test waits.
std::string slow_scene() {
  return R"({"image": {"width": 16384, "height": 4096}, "objects": [{"mesh": "primitive:torus:48"}]})";
}

class BatchCommand : public CommandTest {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(work() / "m");
    write_text(work() / "m/square.obj", square_obj());
    write_text(work() / "m/broken.obj", "v 0 0 0\nf 1 2 99\n");
    write_text(work() / "m/tri.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  }
  Outcome batch(std::vector<std::string> words) {
    words.insert(words.begin(), {"batch", "-o", "out", "--size", "40x30"});
    return lustro(words);
  }
  [[nodiscard]] std::set<std::string> pictures() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(work() / "out")) {
      if (!entry.is_directory()) {
        names.insert(entry.path().lexically_relative(work() / "out").string());
      }
    }
    return names;
  }
  [[nodiscard]] std::string bytes(const std::string& file) const { return file_text(work() / file); }
  void age(const std::string& file, int seconds) const {
    std::filesystem::last_write_time(work() / file, std::filesystem::file_time_type::clock::now() - std::chrono::seconds(seconds));
  }
};

TEST_F(BatchCommand, DrawsWhatRenderDrawsAndListsWhatFails) {
  const Outcome outcome = batch({"m", "--material", "jade"});
  EXPECT_EQ(outcome.code, 8);
  EXPECT_THAT(outcome.err, HasSubstr("lustro: error: m/broken.obj:2: vertex index 2 is outside 1..1"));
  EXPECT_THAT(outcome.err, HasSubstr("lustro: drew 2 pictures, 1 failed"));
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(pictures(), ElementsAre("square.png", "tri.png"));
  ASSERT_EQ(lustro({"render", "m/square.obj", "-o", "alone.png", "-q", "--size", "40x30", "--material", "jade"}).code, 0);
  EXPECT_EQ(bytes("out/square.png"), bytes("alone.png"));
}

TEST_F(BatchCommand, WithoutFailuresTheCodeIsNought) {
  std::filesystem::remove(work() / "m/broken.obj");
  EXPECT_EQ(batch({"m", "-q"}).code, 0);
  EXPECT_THAT(batch({"m", "-q"}).err, IsEmpty());
}

TEST_F(BatchCommand, AnyNumberOfProcessesDrawsTheSame) {
  ASSERT_EQ(batch({"m", "primitive:torus", "--threads", "1"}).code, 8);
  const std::string torus = bytes("out/torus.png"), square = bytes("out/square.png");
  ASSERT_EQ(batch({"m", "primitive:torus", "--threads", "5"}).code, 8);
  EXPECT_EQ(bytes("out/torus.png"), torus);
  EXPECT_EQ(bytes("out/square.png"), square);
}

TEST_F(BatchCommand, JsonIsTheSummary) {
  const auto json = batch({"m", "absent.ply", "--json", "-q"}).json();
  EXPECT_EQ(json["drawn"], 2);
  EXPECT_EQ(json["failed"], 2);
  EXPECT_EQ(json["skipped"], 0);
  ASSERT_EQ(json["pictures"].size(), 2U);
  std::map<std::string, int> codes;
  for (const auto& failure : json["failures"]) {
    codes[failure["input"]] = failure["code"];
  }
  EXPECT_THAT(codes, ElementsAre(std::pair("absent.ply", 3), std::pair("m/broken.obj", 4)));
  EXPECT_GT(json["pictures_per_second"], 0);
}

TEST_F(BatchCommand, ResumeDrawsOnlyWhatIsNewOrChanged) {
  age("m/square.obj", 100);
  age("m/tri.obj", 100);
  ASSERT_EQ(batch({"m"}).code, 8);
  const auto drawn_again = [&] {
    const auto json = batch({"m", "--resume", "--json", "-q"}).json();
    std::set<std::string> names;
    for (const auto& picture : json["pictures"]) {
      names.insert(picture["input"]);
    }
    EXPECT_EQ(json["skipped"].get<std::size_t>() + names.size() + 1, 3 + (std::filesystem::exists(work() / "m/new.obj") ? 1U : 0U));
    return names;
  };
  EXPECT_THAT(drawn_again(), IsEmpty());
  age("out/tri.png", 200);  // older than its model
  EXPECT_THAT(drawn_again(), ElementsAre("m/tri.obj"));
  std::filesystem::remove(work() / "out/square.png");
  write_text(work() / "m/new.obj", square_obj());
  EXPECT_THAT(drawn_again(), ElementsAre("m/new.obj", "m/square.obj"));
}

TEST_F(BatchCommand, AModelThatNeverEndsIsStoppedAndTheOthersAreDrawn) {
  write_text(work() / "m/slow.json", slow_scene());
  write_text(work() / "m/square.json", square_scene());
  write_text(work() / "m/tri.json", square_scene());
  const Outcome outcome = lustro({"batch", "-o", "out", "m/square.json", "m/slow.json", "m/tri.json", "--engine", "reference", "--samples", "1",
                                  "--time-limit", "2.5", "--threads", "1"});
  EXPECT_EQ(outcome.code, 8);
  EXPECT_THAT(outcome.err, HasSubstr("m/slow.json: took more than 2.5 s"));
  EXPECT_THAT(pictures(), ElementsAre("square.png", "tri.png"));
}

TEST_F(BatchCommand, AModelThatWantsTooMuchMemoryIsRefusedItAndTheOthersAreDrawn) {
  if (kIsSanitized) {
    GTEST_SKIP() << "a sanitizer takes its memory beforehand";
  }
  std::string large;
  for (int i = 0; i < 300000; ++i) {
    large += "v " + std::to_string(i % 600) + " " + std::to_string(i / 600) + " 0\n";
  }
  for (int i = 1; i < 299000; ++i) {
    if (i % 600 != 0) {
      large += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 600) + "\n";
    }
  }
  write_text(work() / "m/large.obj", large);
  const Outcome limited = batch({"m", "--memory-limit", "16", "--threads", "1"});
  EXPECT_EQ(limited.code, 8);
  EXPECT_THAT(limited.err, HasSubstr("m/large.obj"));
  EXPECT_THAT(limited.err, HasSubstr("memory"));
  EXPECT_THAT(pictures(), ElementsAre("square.png", "tri.png"));
  ASSERT_EQ(batch({"m/large.obj"}).code, 0);  // without the limit it is a good model
}

TEST_F(BatchCommand, WarningsAreCountedOrListed) {
  write_text(work() / "m/square.obj", "mtllib absent.mtl\n" + square_obj());
  const Outcome counted = batch({"m"});
  EXPECT_THAT(counted.err, HasSubstr("lustro: warning: something was skipped or repaired in 1 model; --warnings lists it"));
  EXPECT_THAT(counted.err, Not(HasSubstr("absent.mtl")));
  EXPECT_THAT(batch({"m", "--warnings"}).err, HasSubstr("absent.mtl"));
  EXPECT_EQ(batch({"m", "--json", "-q"}).json()["notes"].size(), 1U);
}

TEST_F(BatchCommand, AnEmptyPictureIsAFailureUnlessItIsAllowed) {
  write_text(work() / "m/points.obj", "v 0 0 0\n");
  const Outcome refused = batch({"m/points.obj"});
  EXPECT_EQ(refused.code, 8);
  EXPECT_THAT(refused.err, HasSubstr("m/points.obj: nothing was drawn"));
  EXPECT_THAT(pictures(), IsEmpty());
  EXPECT_EQ(batch({"m/points.obj", "--allow-empty"}).code, 0);
  EXPECT_THAT(pictures(), ElementsAre("points.png"));
}

TEST_F(BatchCommand, AnInterruptLeavesWholePicturesOnly) {
  write_text(work() / "m/slow.json", slow_scene());
  write_text(work() / "m/square.json", square_scene());
  const Outcome outcome = run_program({"timeout", "-s", "INT", "2", LUSTRO_COMMAND, "batch", "m/square.json", "m/slow.json", "-o", "out",
                                       "--engine", "reference", "--samples", "1", "--threads", "1"});
  EXPECT_EQ(outcome.code, 124);
  EXPECT_THAT(outcome.err, Not(HasSubstr("fault")));
  EXPECT_THAT(pictures(), ElementsAre("square.png"));
}

TEST_F(BatchCommand, AWrongFlagIsSaidOnceAndNothingIsMade) {
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"m", "--samples", "3"},
                                                {"m", "--time-limit", "-1"},
                                                {"m", "--target", "avx3"},
                                                {"m", "--png-level", "13"},
                                                {}}) {
    const Outcome outcome = batch(wrong);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(work() / "out"));
  }
  EXPECT_EQ(lustro({"batch", "m"}).code, 2);
  EXPECT_EQ(lustro({"batch", "m", "-o", "m/tri.obj"}).code, 3);
}

}  // namespace
