// Animations read back frame by frame: what loses nothing gives the very bytes back, what loses something stays close.
#include "image/animation.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <string>

#include "image/color_table.hpp"
#include "image/png.hpp"

#ifdef LUSTRO_HAS_GIF
#include <gif_lib.h>
#endif
#ifdef LUSTRO_HAS_WEBPDEMUX
#include <webp/demux.h>
#endif

namespace lustro {
namespace {

using Frames = std::vector<ByteImage>;

/// A disc with a gradient that wanders over a plain ground; the third frame is the second one again.
Frames wandering_disc(int width, int height, int count, bool transparent) {
  Frames frames;
  for (int i = 0; i < count; ++i) {
    ByteImage frame{width, height, 4, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * width * height))};
    const int shown = i == 2 ? 1 : i;
    const double cx = 8 + 5.0 * shown, cy = height / 2.0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        std::uint8_t* const p = &frame.pixels[static_cast<std::size_t>(4 * (y * width + x))];
        const double r = std::hypot(x - cx, y - cy);
        const bool is_in = r < 7;
        p[0] = is_in ? static_cast<std::uint8_t>(250 - 20 * r) : 40;
        p[1] = is_in ? static_cast<std::uint8_t>(90 + 4 * x % 100) : 60;
        p[2] = is_in ? static_cast<std::uint8_t>(10 + 3 * y) : 200;
        p[3] = is_in || !transparent ? 255 : 0;
        if (transparent && !is_in) {
          p[0] = p[1] = p[2] = 0;
        }
      }
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

std::vector<std::byte> encoded(const Result<AnimationEncoder>& encoder, const Frames& frames) {
  EXPECT_TRUE(encoder) << (encoder ? "" : encoder.error().text());
  for (const ByteImage& frame : frames) {
    const auto added = encoder->add(frame);
    EXPECT_TRUE(added) << (added ? "" : added.error().text());
  }
  const auto file = encoder->finish();
  EXPECT_TRUE(file) << (file ? "" : file.error().text());
  return file.value_or(std::vector<std::byte>());
}

AnimationOptions options_of(const Frames& frames, bool has_alpha) {
  AnimationOptions options;
  options.width = frames.front().width;
  options.height = frames.front().height;
  options.frames = static_cast<int>(frames.size());
  options.frames_per_second = 25;
  options.has_alpha = has_alpha;
  return options;
}

// --- APNG --------------------------------------------------------------------------------------------------------------------------

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number = number << 8U | static_cast<unsigned char>(bytes.at(at + i));
  }
  return number;
}

std::string number_text(std::uint32_t number) {
  std::string text;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) {
    text += static_cast<char>(number >> shift & 0xFFU);
  }
  return text;
}

struct Apng {
  Frames frames;                       ///< as they are shown
  std::vector<std::uint32_t> numbers;  ///< sequence numbers, in order
  std::vector<std::size_t> areas;      ///< pixels stored for each frame
  std::uint32_t stated_frames = 99, plays = 99, delay = 0;
};

/// A reader of APNG, from its specification: each part is decoded as a PNG of its own and laid over what is shown.
Apng read_apng(const std::vector<std::byte>& file) {
  const std::string bytes(reinterpret_cast<const char*>(file.data()), file.size());
  Apng apng;
  std::string header, control, data;
  ByteImage shown;
  const auto end_frame = [&] {
    if (data.empty()) {
      return;
    }
    const std::uint32_t width = number_at(control, 4), height = number_at(control, 8), left = number_at(control, 12),
                        top = number_at(control, 16);
    std::string png = bytes.substr(0, 8);
    const auto chunk = [&](const std::string& type, const std::string& content) {
      png += number_text(static_cast<std::uint32_t>(content.size())) + type + content;
      png += number_text(0);
    };
    chunk("IHDR", number_text(width) + number_text(height) + header.substr(8));
    chunk("IDAT", data);
    chunk("IEND", "");
    // Checksums made right by the slow way of the specification, since the decoder insists on them.
    for (std::size_t at = 8; at < png.size();) {
      const std::size_t size = number_at(png, at);
      std::uint32_t crc = 0xFFFFFFFFU;
      for (std::size_t i = at + 4; i < at + 8 + size; ++i) {
        crc ^= static_cast<unsigned char>(png[i]);
        for (int k = 0; k < 8; ++k) {
          crc = (crc & 1U) != 0 ? 0xEDB88320U ^ crc >> 1U : crc >> 1U;
        }
      }
      png.replace(at + 8 + size, 4, number_text(~crc));
      at += 12 + size;
    }
    const auto part = decode_png(std::as_bytes(std::span(png)), "part", Transfer::none);
    ASSERT_TRUE(part) << (part ? "" : part.error().text());
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        const auto p = part->at(static_cast<int>(x), static_cast<int>(y));
        std::uint8_t* const to = &shown.pixels[((top + y) * static_cast<std::size_t>(shown.width) + left + x) * 4];
        for (std::size_t c = 0; c < 4; ++c) {
          to[c] = c < p.size() ? static_cast<std::uint8_t>(std::lround(p[c] * 255)) : std::uint8_t{255};
        }
      }
    }
    apng.frames.push_back(shown);
    apng.areas.push_back(static_cast<std::size_t>(width) * height);
    data.clear();
  };
  for (std::size_t at = 8; at < bytes.size();) {
    const std::size_t size = number_at(bytes, at);
    const std::string type = bytes.substr(at + 4, 4), content = bytes.substr(at + 8, size);
    if (type == "IHDR") {
      header = content;
      shown = {static_cast<int>(number_at(content, 0)), static_cast<int>(number_at(content, 4)), 4, {}};
      shown.pixels.resize(static_cast<std::size_t>(4 * shown.width * shown.height));
    } else if (type == "acTL") {
      apng.stated_frames = number_at(content, 0);
      apng.plays = number_at(content, 4);
    } else if (type == "fcTL") {
      end_frame();
      apng.numbers.push_back(number_at(content, 0));
      control = content;
      apng.delay = number_at(content, 20);  // both halves: numerator and denominator
    } else if (type == "IDAT") {
      data += content;
    } else if (type == "fdAT") {
      apng.numbers.push_back(number_at(content, 0));
      data += content.substr(4);
    } else if (type == "IEND") {
      end_frame();
    }
    at += 12 + size;
  }
  return apng;
}

TEST(Apng, ShowsTheVeryFrames) {
  for (const bool transparent : {false, true}) {
    const Frames frames = wandering_disc(60, 30, 7, transparent);
    const auto file = encoded(make_apng_encoder(options_of(frames, transparent)), frames);
    const Apng apng = read_apng(file);
    ASSERT_EQ(apng.frames.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
      EXPECT_EQ(apng.frames[i].pixels, frames[i].pixels) << "frame " << i;
    }
    EXPECT_EQ(apng.stated_frames, 7U);
    EXPECT_EQ(apng.plays, 0U);
    EXPECT_EQ(apng.delay, 1U << 16U | 25U);
    for (std::size_t i = 0; i < apng.numbers.size(); ++i) {
      EXPECT_EQ(apng.numbers[i], i);
    }
    // Only what changes is stored: a strip around two discs, and one pixel for a frame that is the same.
    EXPECT_EQ(apng.areas[0], 60U * 30);
    EXPECT_LT(apng.areas[1], 20U * 15);
    EXPECT_EQ(apng.areas[2], 1U);
  }
}

TEST(Apng, IsAPngOfItsFirstFrameForOthers) {
  const Frames frames = wandering_disc(40, 30, 3, false);
  const auto file = encoded(make_apng_encoder(options_of(frames, false)), frames);
  const auto still = decode_png(file, "still.png", Transfer::none);  // checks the checksum of every chunk
  ASSERT_TRUE(still) << still.error().text();
  EXPECT_EQ(still->width, 40);
  EXPECT_EQ(still->channels, 3);
}

TEST(Animation, FramesOfAnotherSizeAndTooManyOrTooFewAreRefused) {
  const Frames frames = wandering_disc(20, 20, 2, false);
  const auto encoder = make_apng_encoder(options_of(frames, false));
  ASSERT_TRUE(encoder->add(frames[0]));
  EXPECT_EQ(encoder->finish().error().kind, ErrorKind::usage);
  EXPECT_EQ(encoder->add(wandering_disc(21, 20, 1, false)[0]).error().kind, ErrorKind::usage);
  ASSERT_TRUE(encoder->add(frames[1]));
  EXPECT_EQ(encoder->add(frames[1]).error().kind, ErrorKind::usage);
}

// --- WebP --------------------------------------------------------------------------------------------------------------------------

#ifdef LUSTRO_HAS_WEBPDEMUX

struct Webp {
  Frames frames;
  std::vector<int> ends;  ///< milliseconds
  int loops = 99;
};

Webp read_webp(const std::vector<std::byte>& file) {
  const WebPData data{reinterpret_cast<const std::uint8_t*>(file.data()), file.size()};
  const std::unique_ptr<WebPAnimDecoder, void (*)(WebPAnimDecoder*)> decoder(WebPAnimDecoderNew(&data, nullptr), WebPAnimDecoderDelete);
  WebPAnimInfo info{};
  Webp webp;
  if (!decoder || WebPAnimDecoderGetInfo(decoder.get(), &info) == 0) {
    return webp;
  }
  webp.loops = static_cast<int>(info.loop_count);
  while (WebPAnimDecoderHasMoreFrames(decoder.get()) != 0) {
    std::uint8_t* pixels = nullptr;
    int end = 0;
    if (WebPAnimDecoderGetNext(decoder.get(), &pixels, &end) == 0) {
      break;
    }
    const std::size_t bytes = std::size_t{4} * info.canvas_width * info.canvas_height;
    webp.frames.push_back({static_cast<int>(info.canvas_width), static_cast<int>(info.canvas_height), 4, {pixels, pixels + bytes}});
    webp.ends.push_back(end);
  }
  return webp;
}

TEST(AnimatedWebp, WithoutLossShowsTheVeryFrames) {
  for (const bool transparent : {false, true}) {
    Frames frames = wandering_disc(60, 30, 5, transparent);
    AnimationOptions options = options_of(frames, transparent);
    options.quality = 100;
    const Webp webp = read_webp(encoded(make_webp_encoder(options), frames));
    EXPECT_EQ(webp.loops, 0);
    // The encoder joins a frame that is the same to the one before.
    EXPECT_THAT(webp.ends, ::testing::ElementsAre(40, 120, 160, 200));
    frames.erase(frames.begin() + 2);
    ASSERT_EQ(webp.frames.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
      for (std::size_t k = 0; k < frames[i].pixels.size(); k += 4) {
        const std::uint8_t *const a = &webp.frames[i].pixels[k], *const b = &frames[i].pixels[k];
        ASSERT_TRUE(a[3] == b[3] && (b[3] == 0 || std::memcmp(a, b, 3) == 0)) << "frame " << i << ", pixel " << k / 4;  // the unseen is free
      }
    }
  }
}

TEST(AnimatedWebp, LossStaysSmallAndSavesBytes) {
  const Frames frames = wandering_disc(64, 48, 2, false);
  AnimationOptions options = options_of(frames, false);
  options.quality = 90;
  const auto fine = encoded(make_webp_encoder(options), frames);
  options.quality = 20;
  const auto coarse = encoded(make_webp_encoder(options), frames);
  EXPECT_LT(coarse.size(), fine.size());
  const Webp webp = read_webp(fine);
  ASSERT_EQ(webp.frames.size(), 2U);
  double squares = 0;
  for (std::size_t i = 0; i < frames[1].pixels.size(); ++i) {
    const double d = double{1} * webp.frames[1].pixels[i] - frames[1].pixels[i];
    squares += d * d;
  }
  EXPECT_GT(10 * std::log10(255.0 * 255 * static_cast<double>(frames[1].pixels.size()) / squares), 25);
}

TEST(AnimatedWebp, IsTheSameEveryTime) {
  const Frames frames = wandering_disc(64, 48, 3, false);
  EXPECT_EQ(encoded(make_webp_encoder(options_of(frames, false)), frames), encoded(make_webp_encoder(options_of(frames, false)), frames));
}

TEST(AnimatedWebp, HasALargestSize) {
  AnimationOptions options;
  options.width = 16384;
  options.height = 2;
  EXPECT_EQ(make_webp_encoder(options).error().kind, ErrorKind::limit);
}

#endif

// --- GIF ---------------------------------------------------------------------------------------------------------------------------

#ifdef LUSTRO_HAS_GIF

struct Gif {
  Frames frames;
  std::vector<int> delays;  ///< hundredths of a second
  bool loops = false;
};

Gif read_gif(const std::vector<std::byte>& file) {
  struct Source {
    const std::vector<std::byte>* bytes;
    std::size_t at;
  } source{&file, 0};
  const auto read = [](GifFileType* gif, GifByteType* to, int size) {
    auto* const from = static_cast<Source*>(gif->UserData);
    const std::size_t count = std::min(static_cast<std::size_t>(size), from->bytes->size() - from->at);
    std::memcpy(to, from->bytes->data() + from->at, count);
    from->at += count;
    return static_cast<int>(count);
  };
  int error = 0;
  GifFileType* const decoder = DGifOpen(&source, read, &error);
  Gif gif;
  if (decoder == nullptr || DGifSlurp(decoder) == GIF_ERROR) {
    return gif;
  }
  for (int i = 0; i < decoder->ImageCount; ++i) {
    const SavedImage& image = decoder->SavedImages[i];
    for (int k = 0; k < image.ExtensionBlockCount; ++k) {
      const ExtensionBlock& block = image.ExtensionBlocks[k];
      gif.loops = gif.loops || (block.ByteCount == 11 && std::memcmp(block.Bytes, "NETSCAPE2.0", 11) == 0);
    }
    GraphicsControlBlock control{};
    DGifSavedExtensionToGCB(decoder, i, &control);
    gif.delays.push_back(control.DelayTime);
    ByteImage frame{decoder->SWidth, decoder->SHeight, 4, {}};
    for (int p = 0; p < decoder->SWidth * decoder->SHeight; ++p) {
      const int entry = image.RasterBits[p];
      const GifColorType& color = decoder->SColorMap->Colors[entry];
      const bool is_clear = entry == control.TransparentColor;
      frame.pixels.insert(frame.pixels.end(), {color.Red, color.Green, color.Blue, static_cast<std::uint8_t>(is_clear ? 0 : 255)});
    }
    gif.frames.push_back(std::move(frame));
  }
  DGifCloseFile(decoder, &error);
  return gif;
}

TEST(Gif, ShowsTheFramesInFewColours) {
  const Frames frames = wandering_disc(60, 30, 4, false);
  const Gif gif = read_gif(encoded(make_gif_encoder(options_of(frames, false)), frames));
  ASSERT_EQ(gif.frames.size(), 4U);
  EXPECT_TRUE(gif.loops);
  EXPECT_THAT(gif.delays, ::testing::Each(4));
  for (std::size_t i = 0; i < frames.size(); ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < frames[i].pixels.size(); k += 4) {
      const bool is_ground = frames[i].pixels[k + 2] == 200;
      for (std::size_t c = 0; c < 3; ++c) {
        const int difference = std::abs(gif.frames[i].pixels[k + c] - frames[i].pixels[k + c]);
        EXPECT_LE(difference, is_ground ? 0 : 24) << "frame " << i << ", pixel " << k / 4;  // plain ground stays plain
        sum += difference;
      }
    }
    EXPECT_LT(sum / static_cast<double>(frames[i].pixels.size()), 2) << "frame " << i;
  }
}

TEST(Gif, AlphaIsAllOrNothing) {
  const Frames frames = wandering_disc(60, 30, 3, true);
  const Gif gif = read_gif(encoded(make_gif_encoder(options_of(frames, true)), frames));
  ASSERT_EQ(gif.frames.size(), 3U);
  for (std::size_t k = 3; k < frames[1].pixels.size(); k += 4) {
    EXPECT_EQ(gif.frames[1].pixels[k], frames[1].pixels[k]);
  }
}

TEST(Gif, DelaysKeepTheWholeTime) {
  const Frames frames = wandering_disc(20, 20, 30, false);
  AnimationOptions options = options_of(frames, false);
  options.frames_per_second = 30;  // 3.33 hundredths a frame
  const Gif gif = read_gif(encoded(make_gif_encoder(options), frames));
  int time = 0;
  for (const int delay : gif.delays) {
    EXPECT_TRUE(delay == 3 || delay == 4);
    time += delay;
  }
  EXPECT_EQ(time, 100);
  options.frames_per_second = 60;
  EXPECT_EQ(make_gif_encoder(options).error().kind, ErrorKind::usage);
}

#endif

// --- the table of colours ------------------------------------------------------------------------------------------------------------

TEST(ColorTable, HoldsTheColoursThemselvesWhereTheyAreFew) {
  ByteImage picture{3, 1, 4, {255, 0, 0, 255, 0, 128, 7, 255, 9, 9, 9, 0}};  // the last one cannot be seen
  ColorCounts counts;
  counts.add(picture);
  EXPECT_THAT(counts.table(256), ::testing::UnorderedElementsAre(Rgb8{255, 0, 0}, Rgb8{0, 128, 7}));
  EXPECT_THAT(counts.table(1), ::testing::ElementsAre(Rgb8{128, 64, 4}));
  EXPECT_TRUE(ColorCounts().table(256).empty());
}

TEST(ColorTable, IsFullAndNearWhereColoursAreMany) {
  std::mt19937 random(3);
  ByteImage picture{128, 128, 4, {}};
  for (int i = 0; i < 128 * 128; ++i) {
    for (int c = 0; c < 3; ++c) {
      picture.pixels.push_back(static_cast<std::uint8_t>(random() >> 24U));
    }
    picture.pixels.push_back(255);
  }
  ColorCounts counts;
  counts.add(picture);
  const std::vector<Rgb8> table = counts.table(256);
  EXPECT_EQ(table.size(), 256U);
  const std::vector<std::uint8_t> nearest = nearest_entries(table);
  double squares = 0;
  for (std::size_t k = 0; k < picture.pixels.size(); k += 4) {
    const Rgb8& entry = table[nearest[cell_of(picture.pixels[k], picture.pixels[k + 1], picture.pixels[k + 2])]];
    for (std::size_t c = 0; c < 3; ++c) {
      const double d = double{1} * entry[c] - picture.pixels[k + c];
      squares += d * d;
    }
  }
  // 256 equal cubes of side 40 would leave an error of 40 / sqrt(12) = 11.6 a channel; within a sixth of it is near.
  EXPECT_LT(std::sqrt(squares / (3.0 * 128 * 128)), 13.5);
}

}  // namespace
}  // namespace lustro
