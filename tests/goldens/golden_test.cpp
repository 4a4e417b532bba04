// Small pictures of the example scenes and models, drawn by the command and compared by the command, exactly.
//
// After a change that is meant:  LUSTRO_UPDATE_GOLDENS=1 build/release/tests/test_goldens      and look at tests/goldens/pictures
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#ifndef LUSTRO_COMMAND

TEST(Goldens, AreDrawnByTheCommand) {
  GTEST_SKIP() << "the command is not built";
}

#else

#include "app/run_command.hpp"

namespace {

using lustro::testing::CommandTest;
using lustro::testing::Outcome;

struct Golden {
  std::string name;
  std::string source;  ///< from the root of the project
  std::vector<std::string> flags;
  std::string layer;  ///< the name of an AOV that is compared as well, or nothing
};

const std::vector<Golden>& goldens() {
  static const std::vector<Golden> list{
      {"hero", "examples/scenes/hero.json", {}, ""},
      {"chessmen", "examples/scenes/chessmen.json", {}, ""},
      {"cornell", "examples/scenes/cornell.json", {}, ""},
      {"gems", "examples/scenes/gems.json", {}, ""},
      {"mist", "examples/scenes/mist.json", {}, ""},
      {"stage", "examples/scenes/stage.json", {}, ""},
      {"teapot_flat", "primitive:teapot", {"--interpolation", "flat", "--material", "brass"}, ""},
      {"teapot_gouraud", "primitive:teapot", {"--interpolation", "gouraud", "--material", "brass", "--transfer", "none"}, ""},
      {"teapot_phong", "primitive:teapot", {"--lighting", "blinn-phong", "--material", "brass", "--samples", "16", "--transparent"}, "normal"},
      {"spot",
       "assets/spot/spot_triangulated.obj",
       {"--view", "iso", "--light", "point 1,2,2 color=#fda falloff=1.5", "--light", "directional -1,-1,0 color=#246"},
       "depth"},
      {"torus_slerp", "primitive:torus:6", {"--normals", "slerp", "--normalized", "--projection", "orthographic", "--bits", "16"}, "object"},
  };
  return list;
}

std::filesystem::path root() {
  return LUSTRO_SOURCE_DIR;
}

class Goldens : public CommandTest, public ::testing::WithParamInterface<Golden> {
 protected:
  /// The committed picture is the drawn one, to the last bit.
  void check(const std::string& file) {
    const std::filesystem::path golden = root() / "tests" / "goldens" / "pictures" / file;
    if (std::getenv("LUSTRO_UPDATE_GOLDENS") != nullptr) {
      std::filesystem::copy_file(work() / file, golden, std::filesystem::copy_options::overwrite_existing);
      return;
    }
    const Outcome compared = lustro({"compare", golden.string(), file, "--tolerance", "0"});
    EXPECT_EQ(compared.code, 0) << file << " has changed; if that was meant, see the top of " << __FILE__ << "\n"
                                << compared.out << compared.err;
  }
};

TEST_P(Goldens, AreDrawnExactly) {
  const Golden& golden = GetParam();
  const std::string source = golden.source.starts_with("primitive:") ? golden.source : (root() / golden.source).string();
  std::vector<std::string> words{"render", source, "-o", golden.name + ".png", "--size", "128x96"};
  words.insert(words.end(), golden.flags.begin(), golden.flags.end());
  if (!golden.layer.empty()) {
    words.insert(words.end(), {"--aov", golden.layer});
  }
  const Outcome drawn = lustro(words);
  ASSERT_EQ(drawn.code, 0) << drawn.err;
  check(golden.name + ".png");
  if (!golden.layer.empty()) {
    check(golden.name + "." + golden.layer + ".png");
  }
}

INSTANTIATE_TEST_SUITE_P(Each, Goldens, ::testing::ValuesIn(goldens()), [](const auto& param) { return param.param.name; });

TEST_F(CommandTest, CompareSeesOneStepInOnePixel) {
  const std::string square = "f 1 2 3\n";
  lustro::testing::write_text(work() / "a.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\n" + square);
  const std::vector<std::string> flags{"--size", "128x96", "--lighting", "constant", "--transfer", "none", "--samples", "1"};
  const auto draw = [&](const std::string& file, const std::string& background) {
    std::vector<std::string> words{"render", "a.obj", "-o", file, "--background", background};
    words.insert(words.end(), flags.begin(), flags.end());
    return lustro(words).code;
  };
  ASSERT_EQ(draw("a.png", "#101010"), 0);
  ASSERT_EQ(draw("b.png", "#101110"), 0);
  EXPECT_EQ(lustro({"compare", "a.png", "a.png", "--tolerance", "0"}).code, 0);
  EXPECT_EQ(lustro({"compare", "a.png", "b.png", "--tolerance", "0"}).code, 1);
}

}  // namespace

#endif
