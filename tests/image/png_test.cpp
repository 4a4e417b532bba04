#include "image/png.hpp"

#include <libdeflate.h>
#include <spng.h>

#include <cstdlib>
#include <memory>
#include <optional>
#include <string_view>

#include "image/srgb.hpp"
#include "image/support.hpp"

namespace lustro {
namespace {

struct Chunk {
  std::string type;
  std::vector<std::byte> data;
};

std::uint32_t u32_at(const std::vector<std::byte>& bytes, std::size_t at) {
  std::uint32_t v = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    v = (v << 8) | static_cast<std::uint32_t>(bytes[at + i]);
  }
  return v;
}

std::vector<Chunk> chunks_of(const std::vector<std::byte>& png) {
  std::vector<Chunk> chunks;
  for (std::size_t at = 8; at + 12 <= png.size();) {
    const std::size_t length = u32_at(png, at);
    const auto* begin = png.data() + at;
    EXPECT_EQ(u32_at(png, at + 8 + length), libdeflate_crc32(0, begin + 4, length + 4));
    chunks.push_back({std::string(reinterpret_cast<const char*>(begin) + 4, 4), std::vector<std::byte>(begin + 8, begin + 8 + length)});
    at += 12 + length;
  }
  return chunks;
}

std::string types_of(const std::vector<Chunk>& chunks) {
  std::string types;
  for (const Chunk& chunk : chunks) {
    types += chunk.type + " ";
  }
  return types;
}

/// A file of any kind, by libspng's own encoder. `data` as libspng takes it: packed bits, 16 bits in the machine's order.
std::vector<std::byte> spng_file(spng_ihdr header, const void* data, std::size_t size, const spng_plte* palette = nullptr,
                                 const spng_trns* trns = nullptr) {
  spng_ctx* context = spng_ctx_new(SPNG_CTX_ENCODER);
  spng_set_option(context, SPNG_ENCODE_TO_BUFFER, 1);
  EXPECT_EQ(spng_set_ihdr(context, &header), 0);
  if (palette != nullptr) {
    spng_plte copy = *palette;
    EXPECT_EQ(spng_set_plte(context, &copy), 0);
  }
  if (trns != nullptr) {
    spng_trns copy = *trns;
    EXPECT_EQ(spng_set_trns(context, &copy), 0);
  }
  EXPECT_STREQ(spng_strerror(spng_encode_image(context, data, size, SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE)), spng_strerror(0));
  std::size_t length = 0;
  int error = 0;
  void* png = spng_get_png_buffer(context, &length, &error);
  EXPECT_EQ(error, 0);
  std::vector<std::byte> bytes(length);
  std::memcpy(bytes.data(), png, length);
  std::free(png);
  spng_ctx_free(context);
  return bytes;
}

Image decoded(const std::vector<std::byte>& png, Transfer transfer = Transfer::none) {
  auto image = decode_png(png, "a.png", transfer);
  EXPECT_TRUE(image) << (image ? "" : image.error().text());
  return image ? *image : Image();
}

TEST(PngWriter, TheHeaderAndTheChunksAreWhatTheOptionsSay) {
  const auto file = encode_png(random_image(3, 2, 4, 1), {.bits = 16});
  ASSERT_TRUE(file);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(file->data()), 8), "\x89PNG\r\n\x1a\n");
  const auto chunks = chunks_of(*file);
  EXPECT_EQ(types_of(chunks), "IHDR sRGB tEXt IDAT IEND ");
  const std::vector<int> header{0, 0, 0, 3, 0, 0, 0, 2, 16, 6, 0, 0, 0};
  for (std::size_t i = 0; i < header.size(); ++i) {
    EXPECT_EQ(static_cast<int>(chunks[0].data[i]), header[i]) << i;
  }
  const auto plain = encode_png(random_image(3, 2, 4, 1), {.transfer = Transfer::none});
  EXPECT_EQ(types_of(chunks_of(*plain)), "IHDR tEXt IDAT IEND ");
}

TEST(PngWriter, AlphaIsLeftOutOnlyWhereItIsStoredAsOneEverywhere) {
  const auto color_type = [](const Image& image, int bits = 8) {
    return static_cast<int>(chunks_of(*encode_png(image, {.bits = bits}))[0].data[9]);
  };
  Image image(2, 1, 4);
  image.pixels = {0.1F, 0.2F, 0.3F, 1.0F, 0.4F, 0.5F, 0.6F, 1.0F};
  EXPECT_EQ(color_type(image), 2);
  EXPECT_EQ(color_type(image, 16), 2);
  image.pixels[7] = 0.999F;  // 254.7 of 255, 65469 of 65535
  EXPECT_EQ(color_type(image), 2);
  EXPECT_EQ(color_type(image, 16), 6);
  image.pixels[7] = 0.99F;
  EXPECT_EQ(color_type(image), 6);
  EXPECT_EQ(color_type(random_image(2, 2, 3, 1)), 2);
  EXPECT_EQ(color_type(random_image(2, 2, 2, 1)), 4);
  EXPECT_EQ(color_type(random_image(2, 2, 1, 1)), 0);
}

TEST(PngWriter, EqualPixelsGiveEqualBytes) {
  const Image image = random_image(67, 31, 4, 5);
  for (const int bits : {8, 16}) {
    EXPECT_EQ(*encode_png(image, {.bits = bits}), *encode_png(Image(image), {.bits = bits}));
  }
}

/// What libspng (with zlib) reads, its checksums checked.
std::vector<std::uint8_t> stored_in(const std::vector<std::byte>& png) {
  spng_ctx* context = spng_ctx_new(0);
  spng_set_crc_action(context, SPNG_CRC_ERROR, SPNG_CRC_ERROR);
  spng_set_png_buffer(context, png.data(), png.size());
  std::size_t size = 0;
  EXPECT_EQ(spng_decoded_image_size(context, SPNG_FMT_PNG, &size), 0);
  std::vector<std::uint8_t> stored(size);
  EXPECT_EQ(spng_decode_image(context, stored.data(), stored.size(), SPNG_FMT_PNG, 0), 0);
  EXPECT_EQ(spng_decode_chunks(context), 0);
  spng_ctx_free(context);
  return stored;
}

TEST(PngWriter, AnIndependentDecoderReadsTheStoredBytes) {
  for (const int channels : {1, 2, 3, 4}) {
    const Image image = random_image(33, 17, channels, static_cast<unsigned>(channels));
    for (const std::optional<int> level : {std::optional<int>(), std::optional(0), std::optional(1), std::optional(6), std::optional(12)}) {
      const auto png = encode_png(image, {.png_level = level});
      ASSERT_TRUE(png);
      EXPECT_EQ(stored_in(*png), to_bytes(image, Transfer::srgb).pixels) << channels << " channels at level " << level.value_or(-1);
    }
  }
}

/// A picture as rendered ones are: flat, smooth, edged and noisy parts; alpha, where there is one, mostly full.
ByteImage random_bytes(RandomBits& random, int width, int height, int channels) {
  ByteImage image{.width = width, .height = height, .channels = channels, .pixels = {}};
  const std::uint32_t cell = 1 + random() % 64;
  const std::uint32_t noise = random() % 3 == 0 ? 1 + random() % 256 : 1;
  const std::uint32_t slope = random() % 5;
  const std::uint32_t seed = random();
  const bool is_opaque = random() % 2 == 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint32_t part = (static_cast<std::uint32_t>(x) / cell * 7 + static_cast<std::uint32_t>(y) / cell * 13 + seed) % 5;
      for (int c = 0; c < channels; ++c) {
        std::uint32_t v = 40 * part + static_cast<std::uint32_t>(c);
        v += part < 2 ? 0 : (slope * static_cast<std::uint32_t>(x + y * c)) / 4;
        v += part == 4 ? random() % noise : 0;
        const bool is_alpha = channels % 2 == 0 && c == channels - 1;
        image.pixels.push_back(is_alpha && (is_opaque || part != 0) ? std::uint8_t{255} : static_cast<std::uint8_t>(v));
      }
    }
  }
  return image;
}

/// What is expected to be stored: without an alpha that says nothing.
std::vector<std::uint8_t> without_idle_alpha(const ByteImage& image) {
  const auto step = static_cast<std::size_t>(image.channels);
  std::vector<std::uint8_t> kept;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    if (step % 2 == 1 || i % step != step - 1) {
      kept.push_back(image.pixels[i]);
    } else if (image.pixels[i] != 255) {
      return image.pixels;
    }
  }
  return kept;
}

TEST(PngWriter, SizesAroundTheEdgesOfStripsComeBack) {
  RandomBits random(21);
  constexpr int kStrip = 128 << 10;
  for (const int channels : {1, 2, 3, 4}) {
    for (const int width : {1, 2, 5, 500, 16384}) {
      const int rows = std::max(1, kStrip / (width * channels + 1));
      for (const int height : {1, 2, rows - 1, rows, rows + 1, 2 * rows, 2 * rows + 1}) {
        if (height < 1 || height > 16384) {
          continue;
        }
        const ByteImage image = random_bytes(random, width, height, channels);
        const auto png = encode_png(image, {});
        ASSERT_TRUE(png);
        ASSERT_EQ(stored_in(*png), without_idle_alpha(image)) << width << " x " << height << " x " << channels;
      }
    }
  }
}

TEST(PngWriter, RandomPicturesComeBackTheSameFromAnyNumberOfThreads) {
  RandomBits random(22);
  std::size_t most_strips = 0;
  for (int round = 0; round < 60; ++round) {
    const int channels = 1 + static_cast<int>(random() % 4);
    const ByteImage image = random_bytes(random, 1 + static_cast<int>(random() % 700), 1 + static_cast<int>(random() % 700), channels);
    const auto png = encode_png(image, {.threads = 1});
    ASSERT_TRUE(png);
    const auto chunks = chunks_of(*png);
    most_strips = std::max(most_strips, chunks.size() - 4);
    ASSERT_EQ(stored_in(*png), without_idle_alpha(image)) << round;
    for (const int threads : {0, 2, 3, 7}) {
      ASSERT_EQ(*encode_png(image, {.threads = threads}), *png) << threads << " threads";
    }
  }
  EXPECT_GE(most_strips, 8U);  // or nothing was shown
}

TEST(PngWriter, LevelsAndSixteenBitsDoNotDependOnThreadsEither) {
  const Image image = random_image(300, 500, 4, 23);
  for (const WriteOptions& options : {WriteOptions{.bits = 16}, WriteOptions{.png_level = 3}, WriteOptions{.bits = 16, .png_level = 3}}) {
    std::vector<std::vector<std::byte>> files;
    for (const int threads : {1, 2, 3, 7}) {
      WriteOptions with = options;
      with.threads = threads;
      files.push_back(*encode_png(image, with));
      ASSERT_EQ(files.back(), files.front());
    }
    EXPECT_LE(largest_difference(decoded(files.front(), Transfer::srgb), image), options.bits == 16 ? 1e-4F : 2e-2F);
  }
}

TEST(PngWriter, BytesBecomeTheFileThatTheirImageBecomes) {
  for (const int channels : {1, 2, 3, 4}) {
    Image image = random_image(120, 90, channels, 24);
    for (const Transfer transfer : {Transfer::srgb, Transfer::none}) {
      for (const std::optional<int> level : {std::optional<int>(), std::optional(6)}) {
        const WriteOptions options{.transfer = transfer, .png_level = level};
        EXPECT_EQ(*encode_png(to_bytes(image, transfer), options), *encode_png(image, options));
      }
    }
  }
  EXPECT_EQ(encode_png(ByteImage{1, 1, 1, {0}}, {.bits = 16}).error().kind, ErrorKind::usage);
}

TEST(PngWriter, TheFastPackerIsNearTheSlowOneAndNeverLargerThanItsInput) {
  // a shaded ball on an even ground
  constexpr int kSize = 400;
  ByteImage ball{.width = kSize, .height = kSize, .channels = 3, .pixels = std::vector<std::uint8_t>(std::size_t{3} * kSize * kSize, 30)};
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const float u = static_cast<float>(x - 200) / 150;
      const float v = static_cast<float>(y - 200) / 150;
      if (const float depth2 = 1 - u * u - v * v; depth2 > 0) {
        const float light = std::max(0.0F, 0.6F * std::sqrt(depth2) - 0.5F * u - 0.6F * v);
        for (std::size_t c = 0; c < 3; ++c) {
          ball.pixels[static_cast<std::size_t>(y * kSize + x) * 3 + c] =
              static_cast<std::uint8_t>(40 + light * (200 - 40 * static_cast<float>(c)));
        }
      }
    }
  }
  EXPECT_LT(encode_png(ball, {})->size(), encode_png(ball, {.png_level = 1})->size() * 5 / 4);
  RandomBits random(25);
  ByteImage noise{.width = 300, .height = 700, .channels = 3, .pixels = std::vector<std::uint8_t>(std::size_t{3} * 300 * 700)};
  std::generate(noise.pixels.begin(), noise.pixels.end(), [&] { return static_cast<std::uint8_t>(random() >> 11); });
  const auto png = encode_png(noise, {});
  EXPECT_LT(png->size(), noise.pixels.size() + 700 + 300);  // a filter's number a row, chunks, blocks
  EXPECT_EQ(stored_in(*png), noise.pixels);
}

TEST(PngWriter, BitsAndLevelsOutOfRangeAreRefused) {
  const Image image = random_image(2, 2, 3, 1);
  for (const WriteOptions& options : {WriteOptions{.bits = 4}, WriteOptions{.png_level = 13}, WriteOptions{.png_level = -1}}) {
    const auto result = encode_png(image, options);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::usage);
  }
  EXPECT_EQ(encode_png(image, {.bits = 4}).error().message, "a PNG has 8 or 16 bits a channel, not 4");
}

TEST(Png, WhatIsWrittenComesBackWithinHalfAStep) {
  for (const int channels : {1, 3, 4}) {
    const Image image = random_image(40, 30, channels, 7);
    EXPECT_LE(largest_difference(decoded(*encode_png(image, {.bits = 16, .transfer = Transfer::none})), image), 0.51F / 65535 * 2);
    EXPECT_LE(largest_difference(decoded(*encode_png(image, {.bits = 8, .transfer = Transfer::none})), image), 0.51F / 255 * 2);
    // the slope of the decoding curve is at most 2.28
    EXPECT_LE(largest_difference(decoded(*encode_png(image, {.bits = 16}), Transfer::srgb), image), 2.3F * 0.51F / 65535 * 2);
  }
}

TEST(Png, StoredBytesComeBackExactlyThroughReadingAndWriting) {
  for (const Transfer transfer : {Transfer::none, Transfer::srgb}) {
    const auto first = encode_png(random_image(64, 64, 3, 9), {.transfer = transfer});
    const auto second = encode_png(decoded(*first, transfer), {.transfer = transfer});
    EXPECT_EQ(*first, *second);
  }
}

TEST(PngReader, GrayOfEveryDepthCoversZeroToOne) {
  for (const int depth : {1, 2, 4, 8, 16}) {
    const int values = std::min(1 << depth, 256);
    std::vector<std::uint8_t> packed;
    std::vector<std::uint16_t> words;
    for (int v = 0; v < values; ++v) {  // a row of every value
      if (depth < 8) {
        const int bit = v * depth;
        packed.resize(static_cast<std::size_t>(bit / 8 + 1));
        packed.back() = static_cast<std::uint8_t>(packed.back() | (v << (8 - depth - bit % 8)));
      } else {
        packed.push_back(static_cast<std::uint8_t>(v));
        words.push_back(static_cast<std::uint16_t>(v * 257));
      }
    }
    const spng_ihdr header{static_cast<std::uint32_t>(values), 1, static_cast<std::uint8_t>(depth), SPNG_COLOR_TYPE_GRAYSCALE, 0, 0, 0};
    const auto png = depth == 16 ? spng_file(header, words.data(), words.size() * 2) : spng_file(header, packed.data(), packed.size());
    const Image image = decoded(png);
    ASSERT_EQ(image.channels, 1);
    for (int v = 0; v < values; ++v) {
      EXPECT_FLOAT_EQ(image.at(v, 0)[0], static_cast<float>(v) / static_cast<float>(values - 1)) << depth << " bits";
    }
  }
}

TEST(PngReader, SixteenBitsAreReadInTheRightByteOrder) {
  const std::uint16_t words[3] = {0x0102, 0xFF00, 0x00FF};
  const Image image = decoded(spng_file({1, 1, 16, SPNG_COLOR_TYPE_TRUECOLOR, 0, 0, 0}, words, sizeof words));
  ASSERT_EQ(image.channels, 3);
  EXPECT_FLOAT_EQ(image.pixels[0], 258.0F / 65535);
  EXPECT_FLOAT_EQ(image.pixels[1], 65280.0F / 65535);
  EXPECT_FLOAT_EQ(image.pixels[2], 255.0F / 65535);
}

TEST(PngReader, PalettesBecomeColours) {
  spng_plte palette{};
  palette.n_entries = 3;
  palette.entries[0] = {255, 0, 0, 0};
  palette.entries[1] = {0, 51, 0, 0};
  palette.entries[2] = {0, 0, 102, 0};
  const std::uint8_t packed[1] = {0b01'10'00'00};  // entries 1, 2, 0
  const Image image = decoded(spng_file({3, 1, 2, SPNG_COLOR_TYPE_INDEXED, 0, 0, 0}, packed, 1, &palette));
  ASSERT_EQ(image.channels, 3);
  const std::vector<float> expected{0, 0.2F, 0, 0, 0, 0.4F, 1, 0, 0};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_FLOAT_EQ(image.pixels[i], expected[i]);
  }
  spng_trns trns{};
  trns.n_type3_entries = 2;
  trns.type3_alpha[0] = 0;
  trns.type3_alpha[1] = 51;
  const Image clear = decoded(spng_file({3, 1, 2, SPNG_COLOR_TYPE_INDEXED, 0, 0, 0}, packed, 1, &palette, &trns));
  ASSERT_EQ(clear.channels, 4);
  const std::vector<float> premultiplied{0, 0.2F * 0.2F, 0, 0.2F, 0, 0, 0.4F, 1, 0, 0, 0, 0};
  for (std::size_t i = 0; i < premultiplied.size(); ++i) {
    EXPECT_FLOAT_EQ(clear.pixels[i], premultiplied[i]) << i;
  }
}

TEST(PngReader, OneColourMayBeTransparent) {
  const std::uint8_t rgb[6] = {10, 20, 30, 10, 20, 31};
  spng_trns trns{};
  trns.red = 10;
  trns.green = 20;
  trns.blue = 30;
  const Image image = decoded(spng_file({2, 1, 8, SPNG_COLOR_TYPE_TRUECOLOR, 0, 0, 0}, rgb, 6, nullptr, &trns));
  ASSERT_EQ(image.channels, 4);
  EXPECT_EQ(image.at(0, 0)[3], 0.0F);
  EXPECT_EQ(image.at(0, 0)[2], 0.0F);
  EXPECT_EQ(image.at(1, 0)[3], 1.0F);
  EXPECT_FLOAT_EQ(image.at(1, 0)[2], 31.0F / 255);

  const std::uint8_t gray[2] = {7, 8};
  trns.gray = 8;
  const Image shades = decoded(spng_file({2, 1, 8, SPNG_COLOR_TYPE_GRAYSCALE, 0, 0, 0}, gray, 2, nullptr, &trns));
  ASSERT_EQ(shades.channels, 4);
  EXPECT_EQ(shades.at(0, 0)[3], 1.0F);
  EXPECT_FLOAT_EQ(shades.at(0, 0)[2], 7.0F / 255);
  EXPECT_EQ(shades.at(1, 0)[3], 0.0F);
}

TEST(PngReader, GrayWithAlphaBecomesColourWithAlpha) {
  const std::uint8_t data[2] = {255, 51};
  const Image image = decoded(spng_file({1, 1, 8, SPNG_COLOR_TYPE_GRAYSCALE_ALPHA, 0, 0, 0}, data, 2));
  ASSERT_EQ(image.channels, 4);
  for (const float v : image.pixels) {
    EXPECT_FLOAT_EQ(v, 0.2F);
  }
}

TEST(PngReader, InterlacedFilesGiveTheSamePicture) {
  // libspng writes no interlaced files, so this one is built by hand: Adam7 of a 3 x 3 picture, filter 0 in every row
  const auto value = [](int x, int y) { return static_cast<std::uint8_t>(30 * y + 10 * x); };
  std::vector<std::uint8_t> rows;
  constexpr int kX0[] = {0, 4, 0, 2, 0, 1, 0}, kY0[] = {0, 0, 4, 0, 2, 0, 1}, kDx[] = {8, 8, 4, 4, 2, 2, 1}, kDy[] = {8, 8, 8, 4, 4, 2, 2};
  for (int pass = 0; pass < 7; ++pass) {
    for (int y = kY0[pass]; y < 3 && kX0[pass] < 3; y += kDy[pass]) {
      rows.push_back(0);
      for (int x = kX0[pass]; x < 3; x += kDx[pass]) {
        rows.push_back(value(x, y));
      }
    }
  }
  std::vector<std::byte> png = *encode_png(Image(3, 3, 1), {.transfer = Transfer::none});
  std::vector<std::byte> packed(1000);
  libdeflate_compressor* compressor = libdeflate_alloc_compressor(6);
  packed.resize(libdeflate_zlib_compress(compressor, rows.data(), rows.size(), packed.data(), packed.size()));
  libdeflate_free_compressor(compressor);
  png.resize(33);  // the signature and IHDR
  png[28] = std::byte{1};
  const auto put_u32 = [&](std::size_t v) {
    for (int shift = 24; shift >= 0; shift -= 8) {
      png.push_back(static_cast<std::byte>((v >> shift) & 0xFF));
    }
  };
  const std::uint32_t header_crc = libdeflate_crc32(0, png.data() + 12, 17);
  png.resize(29);
  put_u32(header_crc);
  for (const auto& [type, data] : {std::pair{std::string("IDAT"), packed}, std::pair{std::string("IEND"), std::vector<std::byte>()}}) {
    put_u32(data.size());
    const std::size_t begin = png.size();
    const auto name = bytes_of_text(type);
    png.insert(png.end(), name.begin(), name.end());
    png.insert(png.end(), data.begin(), data.end());
    put_u32(libdeflate_crc32(0, png.data() + begin, png.size() - begin));
  }
  const Image image = decoded(png);
  ASSERT_EQ(image.width, 3);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) {
      EXPECT_FLOAT_EQ(image.at(x, y)[0], static_cast<float>(value(x, y)) / 255) << x << " " << y;
    }
  }
}

TEST(PngReader, TheTransferDecidesWhatTheNumbersMean) {
  const std::uint8_t gray[1] = {128};
  const auto png = spng_file({1, 1, 8, SPNG_COLOR_TYPE_GRAYSCALE, 0, 0, 0}, gray, 1);
  EXPECT_FLOAT_EQ(decoded(png, Transfer::none).pixels[0], 128.0F / 255);
  EXPECT_FLOAT_EQ(decoded(png, Transfer::srgb).pixels[0], srgb_decode(128.0F / 255));
}

TEST(PngReader, EveryPrefixFailsCleanly) {
  for (const int bits : {8, 16}) {
    const std::vector<std::byte> whole = *encode_png(random_image(5, 4, 4, 11), {.bits = bits});
    for (std::size_t length = 0; length < whole.size(); ++length) {
      const std::vector<std::byte> prefix(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
      const auto result = decode_png(prefix, "a.png", Transfer::srgb);
      ASSERT_FALSE(result) << length << " of " << whole.size();
      ASSERT_EQ(result.error().kind, ErrorKind::malformed);
      ASSERT_EQ(result.error().where.substr(0, 5), "a.png");
    }
  }
}

TEST(PngReader, EveryBrokenByteIsNoticedOrHarmless) {
  const std::vector<std::byte> whole = *encode_png(random_image(5, 4, 3, 13), {});
  int refused = 0;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::vector<std::byte> broken = whole;
    broken[at] ^= std::byte{0x10};
    refused += decode_png(broken, "a.png", Transfer::srgb).has_value() ? 0 : 1;
  }
  EXPECT_GT(refused, static_cast<int>(whole.size()) - 45);  // only the sRGB and tEXt chunks may be broken without harm
}

std::vector<std::byte> with_size(std::uint32_t width, std::uint32_t height) {
  std::vector<std::byte> png = *encode_png(Image(1, 1, 1), {});
  for (std::size_t i = 0; i < 4; ++i) {
    png[16 + i] = static_cast<std::byte>(width >> (24 - 8 * i));
    png[20 + i] = static_cast<std::byte>(height >> (24 - 8 * i));
  }
  const std::uint32_t crc = libdeflate_crc32(0, png.data() + 12, 17);
  for (std::size_t i = 0; i < 4; ++i) {
    png[29 + i] = static_cast<std::byte>(crc >> (24 - 8 * i));
  }
  return png;
}

TEST(PngReader, SizesAreCheckedBeforeMemoryIsTaken) {
  const auto large = decode_png(with_size(16385, 2), "a.png", Transfer::srgb);
  ASSERT_FALSE(large);
  EXPECT_EQ(large.error().kind, ErrorKind::limit);
  EXPECT_EQ(large.error().text(), "a.png: states a size of 16385 x 2 pixels; at most 16384 x 16384 are read");
  const auto bomb = decode_png(with_size(16384, 16384), "a.png", Transfer::srgb);
  ASSERT_FALSE(bomb);
  EXPECT_EQ(bomb.error().kind, ErrorKind::malformed);
  EXPECT_THAT(bomb.error().text(), testing::HasSubstr("states a size of 16384 x 16384 pixels, which a file of"));
}

TEST(PngReader, ALargeEvenPictureIsNotTakenForABomb) {
  const Image image(2048, 2048, 1);
  EXPECT_EQ(decoded(*encode_png(image, {})).width, 2048);
  EXPECT_EQ(decoded(*encode_png(image, {.png_level = 6})).width, 2048);
}

}  // namespace
}  // namespace lustro
