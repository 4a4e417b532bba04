// `lustro hash`, `render --expect-hash`, and the flags that say who draws: nothing of it changes a bit.
#include <gmock/gmock.h>

#include "app/run_command.hpp"
#include "app/scenes.hpp"
#include "lustro/image.hpp"
#include "lustro/render.hpp"

namespace {

using namespace lustro::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;

class HashCommand : public CommandTest {
 protected:
  void SetUp() override {
    write_text(work() / "square.obj", square_obj());
    write_text(work() / "scene.json", square_scene());
  }
  /// The hash of the words' picture, without its line break.
  std::string hash_of(std::vector<std::string> words) {
    words.insert(words.begin(), "hash");
    const Outcome outcome = lustro(words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, MatchesRegex("[0-9a-f]{16}\n"));
    return outcome.out.substr(0, 16);
  }
};

TEST_F(HashCommand, IsTheHashOfTheFloatsThatRenderWrites) {
  ASSERT_EQ(lustro({"render", "scene.json", "-q", "--aov", "normal", "-o", "out.exr", "-o", "out.pfm"}).code, 0);
  const auto normal = lustro::read_image(work() / "out.normal.pfm");
  ASSERT_TRUE(normal);
  const auto json = lustro({"hash", "scene.json", "--aov", "normal,light:*", "--json"}).json();
  char digits[17];
  std::snprintf(digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(lustro::hash_image(*normal)));
  EXPECT_EQ(json["layers"]["normal"], digits);
  EXPECT_EQ(json["layers"].size(), 3U);
  EXPECT_EQ(json["hash"], hash_of({"scene.json"}));
  EXPECT_EQ(json["width"], 32);
  // The picture has an alpha, which a PFM leaves out: from an EXR it comes back whole.
  const auto color = lustro::read_image(work() / "out.exr");
  ASSERT_TRUE(color);
  lustro::Image whole(color->width, color->height, 4);
  for (int y = 0; y < whole.height; ++y) {
    for (int x = 0; x < whole.width; ++x) {
      for (std::size_t c = 0; c < 4; ++c) {
        whole.at(x, y)[c] = c < static_cast<std::size_t>(color->channels) ? color->at(x, y)[c] : 1.0F;
      }
    }
  }
  std::snprintf(digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(lustro::hash_image(whole)));
  EXPECT_EQ(json["hash"], digits);
}

TEST_F(HashCommand, WithLayersNamesEachLine) {
  const Outcome outcome = lustro({"hash", "scene.json", "--aov", "depth,light:1"});
  EXPECT_THAT(outcome.out, MatchesRegex("[0-9a-f]{16}  color\n[0-9a-f]{16}  depth\n[0-9a-f]{16}  light:1\n"));
  EXPECT_EQ(outcome.out.substr(0, 16), hash_of({"scene.json"}));
}

TEST_F(HashCommand, IsTheSameForEveryTargetEngineAndNumberOfThreads) {
  const std::vector<std::string> scene{"primitive:torus:20", "--size", "150x110", "--samples", "4", "--light", "spot 1,2,3 -1,-2,-3 cutoff=40"};
  const auto with = [&](std::vector<std::string> flags) {
    flags.insert(flags.begin(), scene.begin(), scene.end());
    return hash_of(flags);
  };
  const std::string expected = with({"--engine", "reference"});
  for (const lustro::Target target : lustro::available_targets()) {
    const std::string name(lustro::target_name(target));
    for (const char* threads : {"1", "2", "3", "7"}) {
      EXPECT_EQ(with({"--target", name, "--threads", threads}), expected) << name << " with " << threads << " threads";
    }
  }
  EXPECT_EQ(with({"--target", "auto"}), expected);
  EXPECT_NE(with({"--background", "#123456"}), expected);
}

TEST_F(HashCommand, TheTargetComesFromTheFlagThenFromTheEnvironment) {
  const auto hash = [&](const std::string& variable, std::vector<std::string> flags) {
    flags.insert(flags.begin(), {"env", "LUSTRO_TARGET=" + variable, LUSTRO_COMMAND, "hash", "scene.json"});
    return run_program(flags);
  };
  EXPECT_EQ(hash("scalar", {}).code, 0);
  EXPECT_EQ(hash("", {}).code, 0);
  const Outcome unknown = hash("avx3", {});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("LUSTRO_TARGET: \"avx3\" is no target; known are auto, scalar"));
  EXPECT_EQ(hash("avx3", {"--target", "scalar"}).code, 0);  // the flag wins
  EXPECT_EQ(run_program({"env", "LUSTRO_TARGET=avx3", LUSTRO_COMMAND, "man"}).code, 0);
}

TEST_F(HashCommand, ATargetThatTheMachineLacksIsAnError) {
  for (const char* name : {"sse4", "avx512", "neon", "wasm"}) {
    const Outcome outcome = lustro({"hash", "scene.json", "--target", name});
    const auto targets = lustro::available_targets();
    const bool is_there =
        std::any_of(targets.begin(), targets.end(), [&](lustro::Target target) { return lustro::target_name(target) == name; });
    EXPECT_EQ(outcome.code, is_there ? 0 : 5) << name;
    if (!is_there) {
      EXPECT_THAT(outcome.err, HasSubstr(std::string("--target: this machine cannot run the target ") + name));
    }
  }
}

TEST_F(HashCommand, ATargetMayBeAPointAndATargetToDrawWith) {
  const std::string straight = hash_of({"scene.json"});
  EXPECT_EQ(hash_of({"scene.json", "--target", "0,0,0", "--target", "scalar"}), straight);
  EXPECT_EQ(hash_of({"scene.json", "--target=scalar", "--target=0,0,0"}), straight);
  EXPECT_NE(hash_of({"scene.json", "--target", "0.5,0,0"}), straight);
  EXPECT_EQ(lustro({"hash", "scene.json", "--target", "0,0,0", "--target", "0,1,0"}).code, 2);
  EXPECT_EQ(lustro({"hash", "scene.json", "--target", "scalar", "--target", "auto"}).code, 2);
  EXPECT_EQ(lustro({"explain", "scene.json", "1", "1", "--target", "scalar"}).code, 2);  // there it is the camera's alone
}

TEST_F(HashCommand, RenderWritesOnlyWhatIsExpected) {
  const std::string hash = hash_of({"scene.json"});
  const Outcome right = lustro({"render", "scene.json", "-o", "out.png", "--expect-hash", hash, "--json", "-q"});
  EXPECT_EQ(right.code, 0) << right.err;
  EXPECT_EQ(right.json()["hash"], hash);
  EXPECT_TRUE(std::filesystem::remove(work() / "out.png"));
  const std::string other = (hash[0] == '0' ? "1" : "0") + hash.substr(1);
  const Outcome wrong = lustro({"render", "scene.json", "-o", "out.png", "-o", "out.exr", "--expect-hash", other});
  EXPECT_EQ(wrong.code, 1);
  EXPECT_THAT(wrong.err, HasSubstr("scene.json: the picture's hash is " + hash + ", and " + other + " was expected"));
  EXPECT_THAT(files(), ElementsAre("scene.json", "square.obj"));
  const Outcome as_json = lustro({"render", "scene.json", "-o", "out.png", "--expect-hash", other, "--json"});
  EXPECT_EQ(as_json.code, 1);
  EXPECT_EQ(as_json.json()["hash"], hash);
  EXPECT_THAT(as_json.json()["outputs"], IsEmpty());
}

TEST_F(HashCommand, AnExpectedHashIsSixteenDigits) {
  for (const char* wrong : {"0123", "0123456789abcdeg", "0x23456789abcdef", "-123456789abcdef", "0123456789abcdef0"}) {
    const Outcome outcome = lustro({"render", "scene.json", "-o", "out.png", "--expect-hash", wrong});
    EXPECT_EQ(outcome.code, 2) << wrong;
    EXPECT_THAT(outcome.err, HasSubstr("--expect-hash: "));
  }
}

TEST_F(HashCommand, AnEmptyPictureHasNoHashUnlessAllowed) {
  write_text(work() / "square.obj", behind_obj());
  EXPECT_EQ(lustro({"hash", "scene.json"}).code, 7);
  hash_of({"scene.json", "--allow-empty"});
}

TEST_F(HashCommand, ErrorsNameTheFlagThatBroughtThem) {
  const auto error = [&](std::vector<std::string> flags) {
    flags.insert(flags.begin(), {"hash", "scene.json"});
    const Outcome outcome = lustro(flags);
    EXPECT_EQ(outcome.code, 2);
    return outcome.err;
  };
  EXPECT_THAT(error({"--near", "5", "--far", "1"}), HasSubstr("error: --near: the near plane must lie before the far plane"));
  EXPECT_THAT(error({"--near", "500", "--far", "400"}), HasSubstr("error: --near: "));
  EXPECT_THAT(error({"--aov", "light:7"}), HasSubstr("error: --aov: light:7 does not exist"));
  EXPECT_THAT(error({"--eye", "0,0,0"}), HasSubstr("error: --eye: the eye is at the target"));
  EXPECT_THAT(error({"--up", "0,0,1"}), HasSubstr("error: --up: up is zero or parallel"));
}

}  // namespace
