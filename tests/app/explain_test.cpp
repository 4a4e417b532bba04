// `lustro explain`: the pixel taken apart is the pixel of the picture.
#include <gmock/gmock.h>

#include <random>

#include "app/run_command.hpp"
#include "app/scenes.hpp"
#include "lustro/image.hpp"

namespace {

using namespace lustro::testing;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ExplainCommand : public CommandTest {
 protected:
  void SetUp() override {
    write_text(work() / "square.obj", square_obj());
    write_text(work() / "scene.json", square_scene());
  }
};

TEST_F(ExplainCommand, AgreesWithRenderOnRandomPixelsToTheBit) {
  std::mt19937 random(7);
  for (const char* interpolation : {"flat", "gouraud", "phong"}) {
    const std::vector<std::string> flags{"primitive:torus:12",
                                         "--size",
                                         "64x48",
                                         "--material",
                                         "gold",
                                         "--interpolation",
                                         interpolation,
                                         "--light",
                                         "spot 1,2,3 -1,-2,-3 cutoff=40 beam=20 falloff=1",
                                         "--light",
                                         "directional -1,-1,-1"};
    std::vector<std::string> render{"render", "-q", "-o", "out.exr", "-o", "out.png"};
    render.insert(render.end(), flags.begin(), flags.end());
    const Outcome rendered = lustro(render);
    ASSERT_EQ(rendered.code, 0) << rendered.err;
    const auto floats = lustro::read_image(work() / "out.exr");
    const auto stored = lustro::read_image(work() / "out.png", lustro::Transfer::none);
    ASSERT_TRUE(floats && stored);
    for (int i = 0; i < 12; ++i) {
      const int x = static_cast<int>(random() % 64), y = static_cast<int>(random() % 48);
      std::vector<std::string> explain{"explain", "--json"};
      explain.insert(explain.end(), flags.begin(), flags.end());
      explain.insert(explain.begin() + 3, {std::to_string(x), std::to_string(y)});
      const Outcome outcome = lustro(explain);
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      const auto json = outcome.json();
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(json["color"][c].get<float>(), floats->at(x, y)[c]) << interpolation << " " << x << " " << y;
        EXPECT_EQ(json["bytes"][c].get<int>(), static_cast<int>(stored->at(x, y)[c] * 255 + 0.5F));
        float sum = 0;
        for (const char* term : {"ambient", "diffuse", "specular", "emission", "fog", "background"}) {
          sum += json[term][c].get<float>();
        }
        EXPECT_EQ(sum, floats->at(x, y)[c]);
      }
    }
  }
}

TEST_F(ExplainCommand, TellsEachLightAndEachTerm) {
  const Outcome outcome = lustro({"explain", "scene.json", "16", "12"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* part : {"pixel 16, 12 of 32 x 24", "object", "square.obj", "triangle", "barycentrics", "material", "jade", "k_d", "light 0",
                           "light 1 lamp", "N.L = ", "R.V = ", "max(R.V, 0)^n", "f = ", "scene's ambient", "= colour", "stored"}) {
    EXPECT_THAT(outcome.out, HasSubstr(part));
  }
  const Outcome blinn = lustro({"explain", "scene.json", "16", "12", "--lighting", "blinn-phong"});
  EXPECT_THAT(blinn.out, HasSubstr("N.H = "));
  EXPECT_THAT(blinn.out, HasSubstr("(L + V) / |L + V|"));
}

TEST_F(ExplainCommand, JsonHoldsValuesFromPaper) {
  // A white square facing the eye and a white lamp beside it: N = L = V = (0, 0, 1), so the diffuse term is k_d.
  const Outcome outcome = lustro({"explain", "scene.json", "16", "12", "--json", "--light", "directional 0,0,-1", "--material",
                                  "diffuse=0.25,0.5,0.75", "--projection", "orthographic"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto fragment = outcome.json()["fragments"][0];
  EXPECT_EQ(fragment["samples"], 4);
  EXPECT_EQ(fragment["coefficients"]["diffuse"]["rgb"], nlohmann::json({0.25, 0.5, 0.75}));
  const auto shading = fragment["shadings"][0];
  EXPECT_EQ(shading["normal"], nlohmann::json({0, 0, 1}));
  EXPECT_EQ(shading["lights"][0]["n_dot_l"], 1);
  EXPECT_EQ(shading["lights"][0]["attenuation"], 1);
  EXPECT_EQ(shading["lights"][0]["diffuse"], nlohmann::json({0.25, 0.5, 0.75}));
}

TEST_F(ExplainCommand, ThePixelOfTheBackgroundSaysSo) {
  const Outcome outcome = lustro({"explain", "scene.json", "0", "0", "--eye", "0,0,9"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("background, 100 % of the pixel"));
}

TEST_F(ExplainCommand, APixelOutsideIsAnErrorOfUse) {
  for (const auto& [x, y] : {std::pair{"32", "0"}, std::pair{"0", "24"}, std::pair{"-1", "3"}, std::pair{"x", "3"}}) {
    const Outcome outcome = lustro({"explain", "scene.json", x, y});
    EXPECT_EQ(outcome.code, 2) << x << " " << y << outcome.err;
    EXPECT_THAT(outcome.out, IsEmpty());
  }
}

}  // namespace
