// Animated WebP by libwebp's own animation encoder, which stores what changes from frame to frame.
#include "image/animation.hpp"

#ifdef LUSTRO_HAS_WEBP

#include <fmt/format.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <cmath>
#include <memory>

namespace lustro {
namespace {

constexpr int kLossless = 100;

struct FreeEncoder {
  void operator()(WebPAnimEncoder* encoder) const { WebPAnimEncoderDelete(encoder); }
};

/// A WebPPicture that frees itself.
class Picture {
 public:
  Picture() { is_valid_ = WebPPictureInit(&picture_) != 0; }
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;
  ~Picture() { WebPPictureFree(&picture_); }

  [[nodiscard]] bool import(const ByteImage& frame, bool has_alpha) {
    picture_.use_argb = 1;
    picture_.width = frame.width;
    picture_.height = frame.height;
    const auto read = has_alpha ? WebPPictureImportRGBA : WebPPictureImportRGBX;
    return is_valid_ && read(&picture_, frame.pixels.data(), 4 * frame.width) != 0;
  }
  [[nodiscard]] WebPPicture* get() { return &picture_; }

 private:
  WebPPicture picture_{};
  bool is_valid_ = false;
};

class Webp {
 public:
  explicit Webp(const AnimationOptions& options) : options_(options) {}

  Result<void> begin() {
    WebPAnimEncoderOptions encoder_options;
    if (WebPAnimEncoderOptionsInit(&encoder_options) == 0 || WebPConfigInit(&config_) == 0) {
      return fail(ErrorKind::unsupported, "", "the WebP library at hand is of another version than the one built with");
    }
    config_.lossless = options_.quality >= kLossless ? 1 : 0;
    config_.quality = config_.lossless != 0 ? 50.0F : static_cast<float>(options_.quality);  // without loss it is the effort
    encoder_.reset(WebPAnimEncoderNew(options_.width, options_.height, &encoder_options));
    return encoder_ ? Result<void>() : fail(ErrorKind::limit, "", "not enough memory for the animation");
  }

  Result<void> add(const ByteImage& frame) {
    if (auto checked = check_frame(options_, frame, count_); !checked) {
      return checked;
    }
    Picture picture;
    if (!picture.import(frame, options_.has_alpha)) {
      return fail(ErrorKind::limit, "", "not enough memory for a frame");
    }
    if (WebPAnimEncoderAdd(encoder_.get(), picture.get(), time_of(count_), &config_) == 0) {
      return failed();
    }
    ++count_;
    return {};
  }

  Result<std::vector<std::byte>> finish() {
    if (count_ != options_.frames) {
      return fail(ErrorKind::usage, "", "the animation lacks frames");
    }
    WebPData data;
    WebPDataInit(&data);
    if (WebPAnimEncoderAdd(encoder_.get(), nullptr, time_of(count_), nullptr) == 0 || WebPAnimEncoderAssemble(encoder_.get(), &data) == 0) {
      WebPDataClear(&data);
      return tl::unexpected(failed().error());
    }
    const auto* const bytes = reinterpret_cast<const std::byte*>(data.bytes);
    std::vector<std::byte> out(bytes, bytes + data.size);
    WebPDataClear(&data);
    return out;
  }

 private:
  /// Milliseconds at which a frame begins.
  [[nodiscard]] int time_of(int frame) const { return static_cast<int>(std::lround(1000.0 * frame / options_.frames_per_second)); }
  [[nodiscard]] Result<void> failed() const {
    return fail(ErrorKind::limit, "", fmt::format("the WebP encoder failed: {}", WebPAnimEncoderGetError(encoder_.get())));
  }

  AnimationOptions options_;
  WebPConfig config_{};
  std::unique_ptr<WebPAnimEncoder, FreeEncoder> encoder_;
  int count_ = 0;
};

}  // namespace

Result<AnimationEncoder> make_webp_encoder(const AnimationOptions& options) {
  if (options.width > WEBP_MAX_DIMENSION || options.height > WEBP_MAX_DIMENSION) {
    return fail(ErrorKind::limit, "",
                fmt::format("a WebP has at most {0} x {0} pixels, not {1} x {2}", WEBP_MAX_DIMENSION, options.width, options.height));
  }
  const auto webp = std::make_shared<Webp>(options);
  return webp->begin().map([&] {
    return AnimationEncoder{[webp](const ByteImage& frame) { return webp->add(frame); }, [webp] { return webp->finish(); }};
  });
}

}  // namespace lustro

#else

namespace lustro {

Result<AnimationEncoder> make_webp_encoder(const AnimationOptions& options) {
  static_cast<void>(options);
  return fail(ErrorKind::unsupported, "", "this build of Lustro makes no WebP: libwebp was not there");
}

}  // namespace lustro

#endif
