// `lustro compare`: measures, tolerance, exit codes, heatmap.
#include <gmock/gmock.h>

#include <cmath>

#include "app/run_command.hpp"
#include "lustro/image.hpp"

namespace {

using namespace lustro::testing;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class CompareCommand : public CommandTest {
 protected:
  /// A gray picture of 20 x 10 pixels; the first `count` pixels are brighter by `steps` of 255.
  void write_picture(const std::string& name, int count = 0, int steps = 0) const {
    lustro::Image image(20, 10, 3);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      image.pixels[i] = static_cast<float>(100 + (static_cast<int>(i) < 3 * count ? steps : 0)) / 255.0F;
    }
    ASSERT_TRUE(lustro::write_image(work() / name, image, {.transfer = lustro::Transfer::none}));
  }
};

TEST_F(CompareCommand, EqualPicturesAreEqual) {
  write_picture("a.png");
  write_picture("b.png");
  const Outcome outcome = lustro({"compare", "a.png", "b.png", "--tolerance", "0"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("the pictures are equal"));
  EXPECT_THAT(outcome.out, HasSubstr("PSNR       infinite"));
  const auto json = lustro({"compare", "a.png", "b.png", "--json"}).json();
  EXPECT_EQ(json["equal"], true);
  EXPECT_EQ(json["psnr"], nullptr);
  EXPECT_EQ(json["flip"], 0.0);
}

TEST_F(CompareCommand, MeasuresAreThoseOfPaper) {
  write_picture("a.png");
  write_picture("b.png", 8, 51);  // 8 of 200 pixels differ by 51/255 = 0.2
  const Outcome outcome = lustro({"compare", "a.png", "b.png", "--json"});
  EXPECT_EQ(outcome.code, 1);
  const auto json = outcome.json();
  EXPECT_NEAR(json["max"], 0.2, 1e-6);
  EXPECT_NEAR(json["mean"], 0.2 * 0.04, 1e-6);
  EXPECT_NEAR(json["rmse"], 0.2 * std::sqrt(0.04), 1e-6);
  EXPECT_NEAR(json["psnr"], -20 * std::log10(0.04), 1e-3);
  EXPECT_NEAR(json["share_over"], 0.04, 1e-9);
  EXPECT_EQ(json["within_tolerance"], false);
  EXPECT_GT(json["flip"], 0);
}

TEST_F(CompareCommand, TheToleranceCountsStepsAndTheShareCountsPercent) {
  write_picture("a.png");
  write_picture("b.png", 8, 3);
  EXPECT_EQ(lustro({"compare", "a.png", "b.png"}).code, 1);                      // default: 2 steps
  EXPECT_EQ(lustro({"compare", "a.png", "b.png", "--tolerance", "3"}).code, 0);  // not more than 3
  EXPECT_EQ(lustro({"compare", "a.png", "b.png", "--tolerance", "2.5"}).code, 1);
  EXPECT_EQ(lustro({"compare", "a.png", "b.png", "--tolerance", "0", "--max-share", "4"}).code, 0);  // 8 of 200 are 4 %
  EXPECT_EQ(lustro({"compare", "a.png", "b.png", "--tolerance", "0", "--max-share", "3.9"}).code, 1);
}

TEST_F(CompareCommand, QuietSaysNothingButTheCode) {
  write_picture("a.png");
  write_picture("b.png", 8, 51);
  const Outcome outcome = lustro({"compare", "a.png", "b.png", "-q"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(outcome.err, IsEmpty());
}

TEST_F(CompareCommand, TheHeatmapShowsWhere) {
  write_picture("a.png");
  write_picture("b.png", 8, 100);
  EXPECT_EQ(lustro({"compare", "a.png", "b.png", "--heatmap", "heat.png"}).code, 1);
  const auto heat = lustro::read_image(work() / "heat.png");
  ASSERT_TRUE(heat);
  EXPECT_EQ(heat->width, 20);
  EXPECT_EQ(heat->height, 10);
  const auto brightness = [&](int x, int y) { return heat->at(x, y)[0] + heat->at(x, y)[static_cast<std::size_t>(heat->channels > 1 ? 1 : 0)]; };
  EXPECT_GT(brightness(2, 0), brightness(18, 9));
}

TEST_F(CompareCommand, FailsInWords) {
  write_picture("a.png");
  ASSERT_TRUE(lustro::write_image(work() / "small.png", lustro::Image(4, 4, 3)));
  write_text(work() / "text.png", "no picture");
  const Outcome sizes = lustro({"compare", "a.png", "small.png"});
  EXPECT_EQ(sizes.code, 2);
  EXPECT_THAT(sizes.err, HasSubstr("the sizes differ: a.png has 20 x 10 pixels, small.png 4 x 4"));
  EXPECT_EQ(lustro({"compare", "a.png", "absent.png"}).code, 3);
  EXPECT_EQ(lustro({"compare", "a.png", "text.png"}).code, 4);
  EXPECT_EQ(lustro({"compare", "a.png"}).code, 2);
  EXPECT_EQ(lustro({"compare", "a.png", "a.png", "--tolerance", "-1"}).code, 2);
  EXPECT_EQ(lustro({"compare", "a.png", "a.png", "--max-share", "101"}).code, 2);
  EXPECT_EQ(lustro({"compare", "a.png", "a.png", "--tolerance", "two"}).code, 2);
}

TEST_F(CompareCommand, APictureThatClaimsTooMuchIsALimit) {
  // A PNG's signature and header with its checksum: 100000 x 100000 pixels.
  std::string png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\1\x86\xa0\0\1\x86\xa0\x08\x02\0\0\0", 29);
  png += "\x27\x30\x9c\x9f";
  write_text(work() / "huge.png", png);
  write_picture("a.png");
  const Outcome outcome = lustro({"compare", "a.png", "huge.png"});
  EXPECT_EQ(outcome.code, 6) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("huge.png"));
}

}  // namespace
