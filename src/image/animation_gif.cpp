// GIF89a by giflib. The colours of all frames decide the table, so frames are kept until the end.
#include "image/animation.hpp"

#ifdef LUSTRO_HAS_GIF

#include <fmt/format.h>
#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>

#include "image/color_table.hpp"

namespace lustro {
namespace {

constexpr double kMostFramesPerSecond = 50;                // shorter delays are shown as long ones
constexpr std::size_t kMostBytes = std::size_t{2} << 30U;  // of kept frames
constexpr std::size_t kTransparent = 255;                  // its place in the table

/// Bayer 1973, 8 x 8: thresholds -0.5 .. 0.5 such that near ones differ as much as can be.
float threshold(int x, int y) {
  unsigned value = 0;
  for (unsigned bit = 0; bit < 3; ++bit) {
    const unsigned a = static_cast<unsigned>(x) >> bit & 1U, b = static_cast<unsigned>(y) >> bit & 1U;
    value |= ((a ^ b) << 1U | b) << (2U * (2U - bit));
  }
  return (static_cast<float>(value) + 0.5F) / 64.0F - 0.5F;
}

/// How far apart neighbouring colours of the table are: the mean distance of an entry to its nearest.
float spacing_of(const std::vector<Rgb8>& table) {
  double sum = 0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    double nearest = 1e9;
    for (std::size_t j = 0; j < table.size(); ++j) {
      double distance = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double d = double{1} * table[i][axis] - table[j][axis];
        distance += d * d;
      }
      nearest = i == j ? nearest : std::min(nearest, distance);
    }
    sum += std::sqrt(nearest);
  }
  return table.size() < 2 ? 0.0F : static_cast<float>(sum / static_cast<double>(table.size()));
}

struct FreeMap {
  void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};

int append_bytes(GifFileType* file, const GifByteType* bytes, int size) {
  auto* const out = static_cast<std::vector<std::byte>*>(file->UserData);
  const auto* const begin = reinterpret_cast<const std::byte*>(bytes);
  try {
    out->insert(out->end(), begin, begin + size);
  } catch (const std::exception&) {
    return 0;  // the library must not be thrown through
  }
  return size;
}

class Gif {
 public:
  explicit Gif(const AnimationOptions& options) : options_(options) {}

  Result<void> add(const ByteImage& frame) {
    if (auto checked = check_frame(options_, frame, static_cast<int>(frames_.size())); !checked) {
      return checked;
    }
    counts_.add(frame);
    frames_.push_back(frame);
    return {};
  }

  Result<std::vector<std::byte>> finish() {
    if (static_cast<int>(frames_.size()) != options_.frames) {
      return fail(ErrorKind::usage, "", "the animation lacks frames");
    }
    table_ = counts_.table(options_.has_alpha ? kTransparent : kTransparent + 1);
    nearest_ = nearest_entries(table_);
    spacing_ = spacing_of(table_);
    std::vector<std::byte> out;
    int error = 0;
    GifFileType* const file = EGifOpen(&out, append_bytes, &error);
    bool is_fine = file != nullptr && write(file);
    if (file != nullptr && EGifCloseFile(file, &error) == GIF_ERROR) {
      is_fine = false;
    }
    return is_fine ? Result<std::vector<std::byte>>(std::move(out))
                   : fail(ErrorKind::limit, "", fmt::format("the GIF encoder failed (giflib's error {})", error));
  }

 private:
  [[nodiscard]] bool write(GifFileType* file) {
    EGifSetGifVersion(file, true);
    std::array<GifColorType, 256> colors{};
    for (std::size_t i = 0; i < table_.size(); ++i) {
      colors[i] = {table_[i][0], table_[i][1], table_[i][2]};
    }
    const std::unique_ptr<ColorMapObject, FreeMap> map(GifMakeMapObject(256, colors.data()));
    if (!map || EGifPutScreenDesc(file, options_.width, options_.height, 8, 0, map.get()) == GIF_ERROR || !write_loop(file)) {
      return false;
    }
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      if (!write_frame(file, i)) {
        return false;
      }
    }
    return true;
  }

  /// The extension by which browsers repeat: an application's name, then 1 and a count of 16 bits; 0 is without end.
  static bool write_loop(GifFileType* file) {
    constexpr std::array<GifByteType, 3> kForEver{1, 0, 0};
    return EGifPutExtensionLeader(file, APPLICATION_EXT_FUNC_CODE) != GIF_ERROR && EGifPutExtensionBlock(file, 11, "NETSCAPE2.0") != GIF_ERROR &&
           EGifPutExtensionBlock(file, static_cast<int>(kForEver.size()), kForEver.data()) != GIF_ERROR &&
           EGifPutExtensionTrailer(file) != GIF_ERROR;
  }

  bool write_frame(GifFileType* file, std::size_t index) {
    // Hundredths of a second, as whole numbers that keep the whole time.
    const auto time = [&](std::size_t frame) {
      return static_cast<int>(std::lround(100.0 * static_cast<double>(frame) / options_.frames_per_second));
    };
    GraphicsControlBlock control{};
    control.DelayTime = std::max(time(index + 1) - time(index), 2);
    control.DisposalMode = options_.has_alpha ? DISPOSE_BACKGROUND : DISPOSE_DO_NOT;
    control.TransparentColor = options_.has_alpha ? static_cast<int>(kTransparent) : NO_TRANSPARENT_COLOR;
    std::array<GifByteType, 4> extension{};
    const std::size_t size = EGifGCBToExtension(&control, extension.data());
    if (EGifPutExtension(file, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(size), extension.data()) == GIF_ERROR ||
        EGifPutImageDesc(file, 0, 0, options_.width, options_.height, false, nullptr) == GIF_ERROR) {
      return false;
    }
    std::vector<GifPixelType> row(static_cast<std::size_t>(options_.width));
    for (int y = 0; y < options_.height; ++y) {
      for (int x = 0; x < options_.width; ++x) {
        row[static_cast<std::size_t>(x)] = entry_at(frames_[index], x, y);
      }
      if (EGifPutLine(file, row.data(), options_.width) == GIF_ERROR) {
        return false;
      }
    }
    return true;
  }

  /// The entry for a pixel: its own colour where the table has it, else one of those between which it lies, by its place in the pattern.
  [[nodiscard]] GifPixelType entry_at(const ByteImage& frame, int x, int y) const {
    const std::uint8_t* const p =
        &frame.pixels[(static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(x)) * 4];
    if (options_.has_alpha && p[3] < 128) {
      return static_cast<GifPixelType>(kTransparent);
    }
    const std::uint8_t own = nearest_[cell_of(p[0], p[1], p[2])];
    if (std::memcmp(table_[own].data(), p, 3) == 0) {
      return own;
    }
    const float shift = threshold(x, y) * spacing_;
    const auto moved = [&](int c) { return static_cast<int>(std::clamp(static_cast<float>(c) + shift, 0.0F, 255.0F)); };
    return nearest_[cell_of(moved(p[0]), moved(p[1]), moved(p[2]))];
  }

  AnimationOptions options_;
  std::vector<ByteImage> frames_;
  ColorCounts counts_;
  std::vector<Rgb8> table_;
  std::vector<std::uint8_t> nearest_;
  float spacing_ = 0;
};

}  // namespace

Result<AnimationEncoder> make_gif_encoder(const AnimationOptions& options) {
  if (options.frames_per_second > kMostFramesPerSecond) {
    return fail(ErrorKind::usage, "",
                fmt::format("a GIF shows at most {} frames a second, not {}", kMostFramesPerSecond, options.frames_per_second));
  }
  const auto bytes =
      static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height) * 4 * static_cast<std::size_t>(options.frames);
  if (bytes > kMostBytes) {
    return fail(ErrorKind::limit, "",
                fmt::format("the frames of a GIF are kept until its end, and these are {} MB; at most {} are", bytes / 1'000'000,
                            kMostBytes / 1'000'000));
  }
  const auto gif = std::make_shared<Gif>(options);
  return AnimationEncoder{[gif](const ByteImage& frame) { return gif->add(frame); }, [gif] { return gif->finish(); }};
}

}  // namespace lustro

#else

namespace lustro {

Result<AnimationEncoder> make_gif_encoder(const AnimationOptions& options) {
  static_cast<void>(options);
  return fail(ErrorKind::unsupported, "", "this build of Lustro makes no GIF: giflib was not there");
}

}  // namespace lustro

#endif
