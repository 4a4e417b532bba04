#include "image/decode.hpp"

#include "image/decode_texture.hpp"
#include "image/exr.hpp"
#include "image/pfm.hpp"
#include "image/png.hpp"
#include "image/small_files.hpp"
#include "image/srgb.hpp"
#include "image/support.hpp"

namespace lustro {
namespace {

TEST(Decode, TheContentDecidesAndNotTheName) {
  const Image image = random_image(4, 3, 3, 1);
  EXPECT_EQ(decode_image(*encode_exr(image, {}), "picture.png", Transfer::srgb)->pixels, image.pixels);
  EXPECT_EQ(decode_image(encode_pfm(image), "picture.exr", Transfer::srgb)->pixels, image.pixels);
  EXPECT_LT(largest_difference(*decode_image(*encode_png(image, {.bits = 16}), "picture", Transfer::srgb), image), 1e-4F);
}

TEST(Decode, WhatIsNoImageIsNamedByTheExtension) {
  const auto text = bytes_of_text("v 1 2 3\nv 4 5 6\n");
  const auto message = [&](const char* name) { return decode_image(text, name, Transfer::srgb).error().text(); };
  EXPECT_EQ(message("a.png"), "a.png: is no PNG file: it does not begin with the PNG signature");
  EXPECT_EQ(message("a.EXR"), "a.EXR: is no EXR file: it does not begin with the number 20000630");
  EXPECT_EQ(message("a.pfm"), "a.pfm: is no PFM file: it does not begin with `PF` or `Pf`");
  EXPECT_EQ(message("a.jpeg"), "a.jpeg: is no JPEG file: it does not begin with the bytes FF D8 FF");
  EXPECT_EQ(message("a.webp"), "a.webp: is no WebP file: it does not begin with `RIFF` and `WEBP`");
  EXPECT_EQ(message("a.bmp"), "a.bmp: is no bitmap: it does not begin with `BM` and a header");
  EXPECT_EQ(message("a.hdr"), "a.hdr: is no Radiance picture: it does not begin with `#?`");
  EXPECT_EQ(message("a.obj"), "a.obj: is no image that is known: PNG, JPEG, WebP, TGA, BMP, Radiance HDR, EXR and PFM are read");
  EXPECT_EQ(decode_image(bytes_of_text("GIF89a"), "a.png", Transfer::srgb).error().text(),
            "a.png: is a GIF file: PNG, JPEG, WebP, TGA, BMP, Radiance HDR, EXR and PFM are read");
  EXPECT_EQ(decode_image({}, "a", Transfer::srgb).error().kind, ErrorKind::unsupported);
}

/// A TGA file of one pixel: (51, 102, 153) with the alpha 51.
std::vector<std::byte> one_tga_pixel() {
  std::vector<std::byte> bytes(18);
  bytes[2] = std::byte{2};
  bytes[12] = bytes[14] = std::byte{1};
  bytes[16] = std::byte{32};
  for (const int value : {153, 102, 51, 51}) {
    bytes.push_back(static_cast<std::byte>(value));
  }
  return bytes;
}

TEST(Decode, EveryFormatIsKnownByItsFirstBytes) {
  EXPECT_EQ(format_of_content(from_hex(kJpegGray)), ImageFormat::jpeg);
  EXPECT_EQ(format_of_content(from_hex(kWebpLossy)), ImageFormat::webp);
  EXPECT_EQ(format_of_content(from_hex("424d 00000000 00000000 36000000 28000000")), ImageFormat::bmp);
  EXPECT_EQ(format_of_content(bytes_of_text("BM is the beginning of a text")), ImageFormat::unknown);
  EXPECT_EQ(format_of_content(bytes_of_text("#?RADIANCE\n")), ImageFormat::hdr);
  EXPECT_EQ(format_of_content(one_tga_pixel()), ImageFormat::unknown);
  EXPECT_EQ(format_of_content(bytes_of_text("RIFF0123WAVE")), ImageFormat::unknown);
}

TEST(Decode, TgaIsKnownByItsNameOrByItsLastBytes) {
  auto bytes = one_tga_pixel();
  EXPECT_TRUE(decode_image(bytes, "a.TGA", Transfer::none));
  EXPECT_FALSE(decode_image(bytes, "a.dat", Transfer::none));
  const auto footer = bytes_of_text(std::string("\0\0\0\0\0\0\0\0TRUEVISION-XFILE.\0", 26));
  bytes.insert(bytes.end(), footer.begin(), footer.end());
  EXPECT_TRUE(decode_image(bytes, "a.dat", Transfer::none));
}

TEST(Decode, PicturesArePremultipliedAndTexturesAreNot) {
  const auto picture = decode_image(one_tga_pixel(), "a.tga", Transfer::none);
  ASSERT_TRUE(picture);
  EXPECT_THAT(picture->pixels, testing::Pointwise(testing::FloatNear(1e-7F), {0.04F, 0.08F, 0.12F, 0.2F}));
  const auto texture = decode_texture_image(one_tga_pixel(), "a.tga", TextureContent::color, Transfer::none);
  ASSERT_TRUE(texture);
  EXPECT_THAT(texture->pixels, testing::Pointwise(testing::FloatNear(1e-7F), {0.2F, 0.4F, 0.6F, 0.2F}));
}

TEST(Decode, StraightAlphaOfEveryFormatWithAlphaIsTheSame) {
  Image image(1, 1, 4);
  image.pixels = {0.1F, 0.05F, 0.2F, 0.25F};  // premultiplied: (0.4, 0.2, 0.8)
  const std::vector<float> straight{0.4F, 0.2F, 0.8F, 0.25F};
  const auto png = decode_texture_image(*encode_png(image, {.bits = 16}), "a", TextureContent::color, Transfer::srgb);
  EXPECT_THAT(png->pixels, testing::Pointwise(testing::FloatNear(1e-4F), straight));
  const auto exr = decode_texture_image(*encode_exr(image, {}), "a", TextureContent::color, Transfer::srgb);
  EXPECT_THAT(exr->pixels, testing::Pointwise(testing::FloatNear(1e-6F), straight));
  image.pixels[3] = 0;  // nothing is covered: there is no colour to be had
  EXPECT_THAT(decode_texture_image(*encode_exr(image, {}), "a", TextureContent::data, Transfer::srgb)->pixels, testing::ElementsAre(0, 0, 0, 0));
}

TEST(Decode, DataIsNeverDecodedAndColourIsByTheTransfer) {
  const Image image = random_image(3, 2, 3, 7);
  const auto bytes = *encode_png(image, {.bits = 16, .transfer = Transfer::none});
  const auto decode = [&](TextureContent content, Transfer transfer) { return *decode_texture_image(bytes, "a", content, transfer); };
  EXPECT_LT(largest_difference(decode(TextureContent::data, Transfer::srgb), image), 1e-4F);
  EXPECT_LT(largest_difference(decode(TextureContent::color, Transfer::none), image), 1e-4F);
  const Image linear = decode(TextureContent::color, Transfer::srgb);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    EXPECT_NEAR(linear.pixels[i], srgb_decode(image.pixels[i]), 1e-4);
  }
}

TEST(Decode, GrayWithAlphaHasFourChannels) {
  const Image image = image_of_bytes({1, 1, 2, {51, 102}}, Transfer::none, AlphaForm::straight);
  EXPECT_THAT(image.pixels, testing::ElementsAre(51 / 255.0F, 51 / 255.0F, 51 / 255.0F, 102 / 255.0F));
}

TEST(WriteImage, TheExtensionChoosesTheFormat) {
  const TemporaryFolder folder;
  const Image image = random_image(6, 5, 4, 2);
  for (const auto& [name, format] : {std::pair{"a.png", ImageFormat::png}, std::pair{"b.PNG", ImageFormat::png},
                                     std::pair{"c.exr", ImageFormat::exr}, std::pair{"d.pfm", ImageFormat::pfm}}) {
    ASSERT_TRUE(write_image(folder.path() / name, image));
    EXPECT_EQ(format_of_content(bytes_of(folder.path() / name)), format) << name;
    ASSERT_TRUE(read_image(folder.path() / name)) << name;
  }
  EXPECT_EQ(read_image(folder.path() / "c.exr")->pixels, image.pixels);
  EXPECT_EQ(folder.count(), 4U);
}

TEST(WriteImage, BytesBecomeTheFileThatTheirImageBecomes) {
  const TemporaryFolder folder;
  const Image image = random_image(9, 7, 4, 5);
  ASSERT_TRUE(write_image(folder.path() / "a.png", image));
  ASSERT_TRUE(write_image(folder.path() / "b.PNG", to_bytes(image, Transfer::srgb)));
  EXPECT_EQ(bytes_of(folder.path() / "a.png"), bytes_of(folder.path() / "b.PNG"));
  ByteImage bytes = to_bytes(image, Transfer::srgb);
  const auto floats = write_image(folder.path() / "c.exr", bytes);
  ASSERT_FALSE(floats);
  EXPECT_EQ(floats.error().text(), (folder.path() / "c.exr").string() + ": a picture of bytes is written as .png");
  EXPECT_EQ(floats.error().kind, ErrorKind::unsupported);
  EXPECT_EQ(write_image(folder.path() / "c.png", bytes, {.bits = 16}).error().kind, ErrorKind::usage);
  bytes.pixels.pop_back();
  EXPECT_EQ(write_image(folder.path() / "c.png", bytes).error().kind, ErrorKind::usage);
  EXPECT_EQ(write_image(folder.path() / "c.png", ByteImage()).error().kind, ErrorKind::usage);
  EXPECT_EQ(folder.count(), 2U);
}

TEST(WriteImage, PicturesThatCannotBeWrittenLeaveNoFile) {
  const TemporaryFolder folder;
  const Image image = random_image(2, 2, 3, 3);
  const auto jpeg = write_image(folder.path() / "a.jpg", image);
  ASSERT_FALSE(jpeg);
  EXPECT_EQ(jpeg.error().kind, ErrorKind::unsupported);
  EXPECT_EQ(jpeg.error().text(), (folder.path() / "a.jpg").string() + ": images are written as .png, .exr or .pfm");
  EXPECT_EQ(write_image(folder.path() / "a.png", Image()).error().kind, ErrorKind::usage);
  EXPECT_EQ(write_image(folder.path() / "a.png", image, {.bits = 12}).error().kind, ErrorKind::usage);
  Image torn = image;
  torn.pixels.pop_back();
  EXPECT_EQ(write_image(folder.path() / "a.exr", torn).error().kind, ErrorKind::usage);
  EXPECT_EQ(write_image(folder.path() / "missing" / "a.png", image).error().kind, ErrorKind::io);
  EXPECT_EQ(folder.count(), 0U);
}

TEST(ReadImage, ErrorsNameTheFile) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "cut.png";
  auto bytes = *encode_png(random_image(8, 8, 3, 4), {});
  bytes.resize(bytes.size() / 2);
  ASSERT_TRUE(write_file_atomically(file, bytes));
  const auto result = read_image(file);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::malformed);
  EXPECT_EQ(result.error().where.substr(0, file.string().size()), file.string());
}

}  // namespace
}  // namespace lustro
