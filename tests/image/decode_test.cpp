#include "image/decode.hpp"

#include "image/exr.hpp"
#include "image/pfm.hpp"
#include "image/png.hpp"
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
  EXPECT_EQ(message("a.obj"), "a.obj: is neither a PNG nor an EXR nor a PFM file");
  EXPECT_EQ(decode_image({}, "a", Transfer::srgb).error().kind, ErrorKind::unsupported);
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
