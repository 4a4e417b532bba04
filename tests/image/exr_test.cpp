#include "image/exr.hpp"

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStringVectorAttribute.h>
#include <ImfTiledOutputFile.h>

#include <limits>

#include "image/support.hpp"

namespace lustro {
namespace {

Image decoded(const std::vector<std::byte>& bytes) {
  auto image = decode_exr(bytes, "a.exr");
  EXPECT_TRUE(image) << (image ? "" : image.error().text());
  return image ? *image : Image();
}

/// A file with the given channels of one type, written by OpenEXR; channel i of pixel p holds 10 p + i.
struct Written {
  TemporaryFolder folder;
  std::string file = (folder.path() / "written.exr").string();
};

template <class T>
std::vector<std::byte> exr_file(const std::vector<std::string>& names, Imf::PixelType type, Imf::Header header, bool tiled = false) {
  const Written written;
  const Imath::Box2i window = header.dataWindow();
  const std::size_t width = static_cast<std::size_t>(window.max.x - window.min.x + 1);
  const std::size_t height = static_cast<std::size_t>(window.max.y - window.min.y + 1);
  std::vector<std::vector<T>> planes;
  Imf::FrameBuffer frame;
  for (std::size_t i = 0; i < names.size(); ++i) {
    planes.emplace_back(width * height);
    for (std::size_t p = 0; p < width * height; ++p) {
      planes.back()[p] = static_cast<T>(static_cast<float>(10 * p + i));
    }
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    header.channels().insert(names[i], Imf::Channel(type));
    frame.insert(names[i], Imf::Slice::Make(type, planes[i].data(), window, sizeof(T), sizeof(T) * width));
  }
  if (tiled) {
    header.setTileDescription(Imf::TileDescription(4, 2, Imf::ONE_LEVEL));
    Imf::TiledOutputFile out(written.file.c_str(), header);
    out.setFrameBuffer(frame);
    out.writeTiles(0, out.numXTiles() - 1, 0, out.numYTiles() - 1);
  } else {
    Imf::OutputFile out(written.file.c_str(), header);
    out.setFrameBuffer(frame);
    out.writePixels(static_cast<int>(height));
  }
  return bytes_of(written.file);
}

Imf::Header header_of(int width, int height, Imf::Compression compression = Imf::ZIP_COMPRESSION) {
  Imf::Header header(width, height);
  header.compression() = compression;
  return header;
}

TEST(Exr, EveryFloatComesBackBitForBit) {
  for (const int channels : {1, 3, 4}) {
    Image image = random_image(37, 41, channels, static_cast<unsigned>(channels));
    image.pixels[0] = std::numeric_limits<float>::infinity();
    image.pixels[5] = -1e-41F;
    image.pixels[7] = 12345.678F;
    const auto bytes = encode_exr(image, {});
    ASSERT_TRUE(bytes);
    const Image back = decoded(*bytes);
    EXPECT_EQ(back.channels, channels);
    EXPECT_EQ(back.pixels, image.pixels);
  }
}

TEST(Exr, GrayWithAlphaBecomesColourWithAlpha) {
  Image image(1, 1, 2);
  image.pixels = {0.25F, 0.5F};
  EXPECT_EQ(decoded(*encode_exr(image, {})).pixels, (std::vector<float>{0.25F, 0.25F, 0.25F, 0.5F}));
}

TEST(Exr, EqualPixelsGiveEqualBytes) {
  const Image image = random_image(64, 48, 4, 3);
  EXPECT_EQ(*encode_exr(image, {}), *encode_exr(Image(image), {}));
}

TEST(ExrLayers, StandInTheFileUnderTheirNames) {
  const Image color = random_image(9, 5, 4, 1);
  std::vector<Layer> layers(3);
  layers[0] = {"diffuse", {"R", "G", "B"}, random_image(9, 5, 3, 2), {}};
  layers[1] = {"depth", {"Z"}, random_image(9, 5, 1, 3), {}};
  layers[2] = {"object",
               {"id"},
               random_image(9, 5, 1, 4),
               {"teapot",
                "Stra\xC3\x9F"
                "e"}};
  layers[1].image.pixels[4] = std::numeric_limits<float>::infinity();
  const TemporaryFolder folder;
  const auto file = folder.path() / "layers.exr";
  ASSERT_TRUE(write_exr_layers(file, color, layers));

  Imf::InputFile in(file.c_str());
  std::vector<std::string> names;
  for (auto it = in.header().channels().begin(); it != in.header().channels().end(); ++it) {
    names.emplace_back(it.name());
    EXPECT_EQ(it.channel().type, Imf::FLOAT);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"A", "B", "G", "R", "depth.Z", "diffuse.B", "diffuse.G", "diffuse.R", "object.id"}));
  EXPECT_EQ(in.header().compression(), Imf::ZIP_COMPRESSION);
  const auto* labels = in.header().findTypedAttribute<Imf::StringVectorAttribute>("object.labels");
  ASSERT_NE(labels, nullptr);
  EXPECT_EQ(labels->value(), layers[2].labels);

  std::vector<float> depth(45), green(45);
  Imf::FrameBuffer frame;
  frame.insert("depth.Z", Imf::Slice::Make(Imf::FLOAT, depth.data(), in.header().dataWindow()));
  frame.insert("diffuse.G", Imf::Slice::Make(Imf::FLOAT, green.data(), in.header().dataWindow()));
  in.setFrameBuffer(frame);
  in.readPixels(0, 4);
  EXPECT_EQ(depth, layers[1].image.pixels);
  for (std::size_t p = 0; p < 45; ++p) {
    EXPECT_EQ(green[p], layers[0].image.pixels[3 * p + 1]);
  }
  EXPECT_EQ(read_image(file)->pixels, color.pixels);  // the picture is found among the layers
}

TEST(ExrLayers, ThatDoNotFitAreRefused) {
  const Image color = random_image(4, 4, 3, 1);
  const auto message = [&](std::vector<Layer> layers) { return encode_exr(color, layers).error().message; };
  EXPECT_EQ(message({{"depth", {"Z"}, Image(4, 3, 1), {}}}), "layer `depth` is 4 x 3 pixels of 1 channels with 1 names; the picture is 4 x 4");
  EXPECT_EQ(message({{"depth", {"Z", "W"}, Image(4, 4, 1), {}}}),
            "layer `depth` is 4 x 4 pixels of 1 channels with 2 names; the picture is 4 x 4");
  EXPECT_EQ(message({{"a", {"R"}, Image(4, 4, 1), {}}, {"a", {"R"}, Image(4, 4, 1), {}}}), "the EXR channel `a.R` would be there twice");
  EXPECT_EQ(message({{"", {"R"}, Image(4, 4, 1), {}}}), "`.R` cannot be the name of an EXR channel");
  EXPECT_EQ(encode_exr(color, std::vector<Layer>{{"", {"R"}, Image(4, 4, 1), {}}}).error().kind, ErrorKind::usage);
}

TEST(ExrReader, TakesHalfFloatAndUnsignedChannels) {
  const std::vector<std::string> rgb{"R", "G", "B"};
  const std::vector<float> expected{0, 1, 2, 10, 11, 12};
  EXPECT_EQ(decoded(exr_file<half>(rgb, Imf::HALF, header_of(2, 1))).pixels, expected);
  EXPECT_EQ(decoded(exr_file<float>(rgb, Imf::FLOAT, header_of(2, 1))).pixels, expected);
  EXPECT_EQ(decoded(exr_file<unsigned>(rgb, Imf::UINT, header_of(2, 1))).pixels, expected);
}

TEST(ExrReader, TakesEveryCompressionAndTiles) {
  for (int c = Imf::NO_COMPRESSION; c < Imf::NUM_COMPRESSION_METHODS; ++c) {
    for (const bool tiled : {false, true}) {
      const Image image = decoded(exr_file<half>({"R", "G", "B"}, Imf::HALF, header_of(7, 5, static_cast<Imf::Compression>(c)), tiled));
      ASSERT_EQ(image.width, 7);
      EXPECT_NEAR(image.at(6, 4)[1], 341.0, c >= Imf::B44_COMPRESSION ? 8.0 : 0.0) << "compression " << c << (tiled ? ", tiles" : "");
    }
  }
}

TEST(ExrReader, PicksThePictureAmongTheChannels) {
  EXPECT_EQ(decoded(exr_file<float>({"Y", "depth.Z"}, Imf::FLOAT, header_of(2, 1))).pixels, (std::vector<float>{0, 10}));
  EXPECT_EQ(decoded(exr_file<float>({"depth.Z"}, Imf::FLOAT, header_of(2, 1))).pixels, (std::vector<float>{0, 10}));
  EXPECT_EQ(decoded(exr_file<float>({"A", "R"}, Imf::FLOAT, header_of(1, 1))).pixels, (std::vector<float>{1, 0, 0, 0}));  // no G, no B: 0
  const auto none = decode_exr(exr_file<float>({"normal.X", "normal.Y"}, Imf::FLOAT, header_of(2, 1)), "a.exr");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().kind, ErrorKind::unsupported);
  EXPECT_EQ(none.error().text(), "a.exr: has no picture: channels R, G, B or Y were expected, and found were: normal.X, normal.Y");
}

TEST(ExrReader, PutsTheDataWindowIntoTheDisplayWindow) {
  using Imath::Box2i;
  using Imath::V2i;
  Imf::Header inside(Box2i(V2i(10, 20), V2i(12, 21)), Box2i(V2i(11, 21), V2i(11, 21)));  // 3 x 2 display, one pixel of data
  const Image small = decoded(exr_file<float>({"R", "G", "B"}, Imf::FLOAT, inside));
  ASSERT_EQ(small.width, 3);
  ASSERT_EQ(small.height, 2);
  EXPECT_EQ(small.pixels, (std::vector<float>{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 0, 0, 0}));
  Imf::Header overscan(Box2i(V2i(0, 0), V2i(0, 0)), Box2i(V2i(-1, -1), V2i(1, 1)));  // 1 x 1 display, 3 x 3 data
  EXPECT_EQ(decoded(exr_file<float>({"Y"}, Imf::FLOAT, overscan)).pixels, (std::vector<float>{40}));
}

TEST(ExrReader, ReadsTheFirstOfSeveralParts) {
  const Written written;
  std::vector<Imf::Header> headers(2, header_of(2, 1));
  for (std::size_t i = 0; i < 2; ++i) {
    headers[i].setName("part" + std::to_string(i));
    headers[i].setType(Imf::SCANLINEIMAGE);
    headers[i].channels().insert("Y", Imf::Channel(Imf::FLOAT));
  }
  {
    Imf::MultiPartOutputFile out(written.file.c_str(), headers.data(), 2);
    for (int i = 0; i < 2; ++i) {
      std::vector<float> plane{static_cast<float>(i) + 0.25F, static_cast<float>(i) + 0.5F};
      Imf::FrameBuffer frame;
      frame.insert("Y", Imf::Slice::Make(Imf::FLOAT, plane.data(), headers[0].dataWindow()));
      Imf::OutputPart part(out, i);
      part.setFrameBuffer(frame);
      part.writePixels(1);
    }
  }
  EXPECT_EQ(decoded(bytes_of(written.file)).pixels, (std::vector<float>{0.25F, 0.5F}));
}

TEST(ExrReader, EveryPrefixFailsCleanly) {
  const std::vector<std::byte> whole = *encode_exr(random_image(5, 40, 4, 11), {});
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::vector<std::byte> prefix(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
    const auto result = decode_exr(prefix, "a.exr");
    ASSERT_FALSE(result) << length << " of " << whole.size();
    ASSERT_EQ(result.error().kind, ErrorKind::malformed);
    ASSERT_EQ(result.error().where.substr(0, 5), "a.exr");
  }
}

TEST(ExrReader, EveryBrokenByteIsSurvived) {
  const std::vector<std::byte> whole = *encode_exr(random_image(5, 4, 3, 13), {});
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const int flip : {0x01, 0x80, 0xFF}) {
      std::vector<std::byte> broken = whole;
      broken[at] ^= static_cast<std::byte>(flip);
      const auto result = decode_exr(broken, "a.exr");
      if (!result) {
        ASSERT_FALSE(result.error().message.empty());
      }
    }
  }
}

/// Overwrites the data of the attribute `name`, whose type's name is `type`.
void patch(std::vector<std::byte>& exr, const std::string& name, const std::string& type, const std::vector<std::int32_t>& words) {
  const std::string key = name + '\0' + type + '\0';
  const std::string text(reinterpret_cast<const char*>(exr.data()), exr.size());
  const std::size_t at = text.find(key);
  ASSERT_NE(at, std::string::npos);
  std::memcpy(exr.data() + at + key.size() + 4, words.data(), words.size() * 4);
}

TEST(ExrReader, SizesAreCheckedBeforeMemoryIsTaken) {
  const auto with_size = [](std::int32_t width, std::int32_t height) {
    auto exr = *encode_exr(Image(1, 1, 4), {});
    patch(exr, "dataWindow", "box2i", {0, 0, width - 1, height - 1});
    patch(exr, "displayWindow", "box2i", {0, 0, width - 1, height - 1});
    return decode_exr(exr, "a.exr").error();
  };
  EXPECT_EQ(with_size(16385, 1).kind, ErrorKind::limit);
  EXPECT_EQ(with_size(1, 2147483647).kind, ErrorKind::limit);
  EXPECT_EQ(with_size(16384, 16384).kind, ErrorKind::malformed);
  EXPECT_THAT(with_size(16384, 16384).text(), testing::HasSubstr("states a size of 16384 x 16384 pixels, which a file of"));
  EXPECT_EQ(with_size(-5, 1).kind, ErrorKind::malformed);
}

TEST(ExrReader, AttributesHaveTheSizeOfTheirType) {
  // OpenEXR would read 16 bytes of this box whatever is stated, and take what follows for another attribute
  auto exr = *encode_exr(Image(1, 1, 4), {});
  const std::string key = std::string("dataWindow") + '\0' + "box2i" + '\0';
  const std::string text(reinterpret_cast<const char*>(exr.data()), exr.size());
  const std::size_t at = text.find(key);
  ASSERT_NE(at, std::string::npos);
  exr[at + key.size()] = std::byte{17};
  const auto result = decode_exr(exr, "a.exr");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::malformed);
  EXPECT_THAT(result.error().message, testing::HasSubstr("a valid attribute `dataWindow` was expected"));
}

TEST(ExrReader, ALargeEvenPictureIsNotTakenForABomb) {
  for (int c = Imf::NO_COMPRESSION; c < Imf::NUM_COMPRESSION_METHODS; ++c) {
    const Written written;
    Imf::Header header = header_of(1024, 1024, static_cast<Imf::Compression>(c));
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    {
      const std::vector<float> zeros(1024 * 1024);
      Imf::FrameBuffer frame;
      frame.insert("Y", Imf::Slice::Make(Imf::FLOAT, zeros.data(), header.dataWindow()));
      Imf::OutputFile out(written.file.c_str(), header);
      out.setFrameBuffer(frame);
      out.writePixels(1024);
    }
    const auto image = decode_exr(bytes_of(written.file), "a.exr");
    EXPECT_TRUE(image) << "compression " << c << ": " << image.error().text();
  }
}

TEST(ExrReader, WhatItDoesNotReadIsNamed) {
  auto deep = *encode_exr(Image(1, 1, 1), {});
  deep[5] = std::byte{0x08};
  EXPECT_EQ(decode_exr(deep, "a.exr").error().text(), "a.exr: holds deep pixels, which are not read");
  auto newer = *encode_exr(Image(1, 1, 1), {});
  newer[4] = std::byte{3};
  EXPECT_EQ(decode_exr(newer, "a.exr").error().text(), "a.exr: has version 3 of the EXR layout; version 2 is read");
  EXPECT_EQ(decode_exr(bytes_of_text("nothing"), "a.exr").error().text(),
            "a.exr: byte 4: the EXR header is broken: the number 20000630 was expected");
}

}  // namespace
}  // namespace lustro
