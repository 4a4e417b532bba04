#include "image/pfm.hpp"

#include <bit>
#include <limits>

#include "image/support.hpp"

namespace lustro {
namespace {

std::string float_bytes(std::vector<float> values, bool little) {
  std::string out;
  for (const float v : values) {
    const auto bits = std::bit_cast<std::uint32_t>(v);
    for (int i = 0; i < 4; ++i) {
      out += static_cast<char>((bits >> (8 * (little ? i : 3 - i))) & 0xFF);
    }
  }
  return out;
}

TEST(Pfm, TheFileIsAHeaderAndRowsFromTheBottom) {
  Image image(1, 2, 1);
  image.pixels = {1.0F, 2.0F};  // the top row first
  const std::vector<std::byte> expected = bytes_of_text("Pf\n1 2\n-1.0\n" + float_bytes({2.0F, 1.0F}, true));
  EXPECT_EQ(encode_pfm(image), expected);
}

TEST(Pfm, EveryFloatComesBackInBothByteOrders) {
  const std::vector<float> values{0.0F, -1.5F, 1e30F, 1e-40F, std::numeric_limits<float>::infinity(), 0.1F};
  for (const bool little : {true, false}) {
    const std::string text = std::string("PF\n2 1\n") + (little ? "-1" : "1") + "\n" + float_bytes(values, little);
    const auto image = decode_pfm(bytes_of_text(text), "a.pfm");
    ASSERT_TRUE(image) << image.error().text();
    EXPECT_EQ(image->channels, 3);
    EXPECT_EQ(image->pixels, values);
  }
}

TEST(Pfm, RowsAndColumnsComeBackWhereTheyWere) {
  for (const int channels : {1, 3}) {
    const Image image = random_image(5, 3, channels, 1);
    const auto back = decode_pfm(encode_pfm(image), "a.pfm");
    ASSERT_TRUE(back);
    EXPECT_EQ(back->pixels, image.pixels);
  }
}

TEST(Pfm, AlphaIsLeftOutAndTheColoursStandOverBlack) {
  const Image image = random_image(3, 2, 4, 2);
  const auto back = decode_pfm(encode_pfm(image), "a.pfm");
  ASSERT_TRUE(back);
  ASSERT_EQ(back->channels, 3);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(back->at(x, y)[c], image.at(x, y)[c]);
      }
    }
  }
}

TEST(Pfm, TheScaleMultiplies) {
  const auto image = decode_pfm(bytes_of_text("Pf 1 1 -2.5 " + float_bytes({3.0F}, true)), "a.pfm");
  ASSERT_TRUE(image);
  EXPECT_EQ(image->pixels[0], 7.5F);
}

TEST(Pfm, ErrorsNameThePlaceAndWhatWasFound) {
  const auto message = [](const std::string& text) { return decode_pfm(bytes_of_text(text), "a.pfm").error().text(); };
  EXPECT_EQ(message("P6 1 1 1 "), "a.pfm: byte 0: is no PFM file: `PF` or `Pf` and a space or line end were expected");
  EXPECT_EQ(message("PF\nwide 1\n-1\n"), "a.pfm: byte 3: the width was expected, and `wide` was found");
  EXPECT_EQ(message("PF\n1 1x\n-1\n"), "a.pfm: byte 5: the height was expected, and `1x` was found");
  EXPECT_EQ(message("PF\n1 1\n0\n"), "a.pfm: byte 7: the scale, a number other than 0, was expected, and `0` was found");
  EXPECT_EQ(message("PF\n1 1\nnan\n"), "a.pfm: byte 7: the scale, a number other than 0, was expected, and `nan` was found");
  EXPECT_EQ(message("PF\n1 1\n-1\nabc"), "a.pfm: byte 13: the file ends after 3 of the 12 bytes of its pixels");
  EXPECT_EQ(message("PF\n0 1\n-1\n"), "a.pfm: states a size of 0 x 1 pixels; both must be at least 1");
  EXPECT_EQ(message("PF\n16385 1\n-1\n"), "a.pfm: states a size of 16385 x 1 pixels; at most 16384 x 16384 are read");
  EXPECT_EQ(message("PF\n99999999999999999999 1\n-1\n"), "a.pfm: byte 3: the width was expected, and `99999999999999999999` was found");
}

TEST(Pfm, AHeaderThatClaimsMuchTakesNoMemory) {
  const auto result = decode_pfm(bytes_of_text("PF\n16384 16384\n-1\nshort"), "a.pfm");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::malformed);
}

TEST(Pfm, EveryPrefixFailsCleanly) {
  const std::vector<std::byte> whole = encode_pfm(random_image(3, 2, 3, 3));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::vector<std::byte> prefix(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
    const auto result = decode_pfm(prefix, "a.pfm");
    ASSERT_FALSE(result) << length;
    ASSERT_EQ(result.error().kind, ErrorKind::malformed);
  }
}

}  // namespace
}  // namespace lustro
