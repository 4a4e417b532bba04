// The JPEG reader. libjpeg ends what it cannot go on with by a call that must not return: ours jumps back (setjmp), so between the jump's two
// ends stand only C calls and plain data, and everything with a destructor lives outside. Integer transforms alone: the same bytes everywhere.
#include "image/jpeg.hpp"

#ifdef LUSTRO_HAS_JPEG
#include <fmt/format.h>
#include <jerror.h>
#include <jpeglib.h>

#include <array>
#include <csetjmp>
#include <cstdint>
#include <cstdio>

#include "image/decode_bytes.hpp"
#endif

namespace lustro {

#ifdef LUSTRO_HAS_JPEG

namespace {

constexpr int kMostScans = 128;  // of a progressive file; each goes over the whole picture, and encoders make about ten

/// One decompressor and how it ended.
struct Decoder {
  jpeg_decompress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf back{};
  std::array<char, JMSG_LENGTH_MAX> message{};
  int code = 0;
  bool has_too_many_scans = false;
};

Decoder& decoder_of(j_common_ptr jpeg) {
  return *static_cast<Decoder*>(jpeg->client_data);
}

[[noreturn]] void give_up(j_common_ptr jpeg) {
  Decoder& decoder = decoder_of(jpeg);
  decoder.code = jpeg->err->msg_code;
  jpeg->err->format_message(jpeg, decoder.message.data());
  std::longjmp(decoder.back, 1);
}

/// Warnings are what libjpeg can go on after. Where data is missing the rest of the picture would be gray, so those end it.
void weigh_warning(j_common_ptr jpeg, int level) {
  const int code = jpeg->err->msg_code;
  if (level < 0 && (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER || code == JWRN_HUFF_BAD_CODE)) {
    give_up(jpeg);
  }
}

void count_scans(j_common_ptr jpeg) {
  Decoder& decoder = decoder_of(jpeg);
  if (decoder.jpeg.input_scan_number > kMostScans) {
    decoder.has_too_many_scans = true;
    std::longjmp(decoder.back, 1);
  }
}

/// The three steps below are called one after the other, each with a jump of its own. They are not to be inlined into what has destructors.
[[gnu::noinline]] bool read_jpeg_header(Decoder& decoder, const unsigned char* data, std::size_t size) {
  decoder.jpeg.err = jpeg_std_error(&decoder.errors);
  decoder.errors.error_exit = give_up;
  decoder.errors.emit_message = weigh_warning;
  decoder.errors.output_message = [](j_common_ptr) {};
  decoder.progress.progress_monitor = count_scans;
  decoder.jpeg.client_data = &decoder;
  if (setjmp(decoder.back) != 0) {
    return false;
  }
  jpeg_create_decompress(&decoder.jpeg);
  decoder.jpeg.progress = &decoder.progress;
  jpeg_mem_src(&decoder.jpeg, data, size);
  jpeg_read_header(&decoder.jpeg, TRUE);
  return true;
}

[[gnu::noinline]] bool read_jpeg_pixels(Decoder& decoder, unsigned char* pixels, std::size_t row_bytes) {
  if (setjmp(decoder.back) != 0) {
    return false;
  }
  jpeg_start_decompress(&decoder.jpeg);
  while (decoder.jpeg.output_scanline < decoder.jpeg.output_height) {
    JSAMPROW row = pixels + decoder.jpeg.output_scanline * row_bytes;
    jpeg_read_scanlines(&decoder.jpeg, &row, 1);
  }
  jpeg_finish_decompress(&decoder.jpeg);  // reads on to the end mark
  return true;
}

/// Frees what libjpeg holds, however decoding ended.
class DecoderGuard {
 public:
  explicit DecoderGuard(Decoder& decoder) : decoder_(decoder) {}
  DecoderGuard(const DecoderGuard&) = delete;
  DecoderGuard& operator=(const DecoderGuard&) = delete;
  ~DecoderGuard() { jpeg_destroy_decompress(&decoder_.jpeg); }

 private:
  Decoder& decoder_;
};

Error error_of(const Decoder& decoder, const std::string& where) {
  if (decoder.has_too_many_scans) {
    return {ErrorKind::limit, where, fmt::format("the JPEG file has more than {} scans, the most that are read", kMostScans)};
  }
  const bool is_unsupported = decoder.code == JERR_BAD_PRECISION || decoder.code == JERR_SOF_UNSUPPORTED ||
                              decoder.code == JERR_CONVERSION_NOTIMPL || decoder.code == JERR_ARITH_NOTIMPL ||
                              decoder.code == JERR_CCIR601_NOTIMPL || decoder.code == JERR_FRACT_SAMPLE_NOTIMPL;
  const ErrorKind kind = is_unsupported                                                             ? ErrorKind::unsupported
                         : decoder.code == JERR_OUT_OF_MEMORY || decoder.code == JERR_IMAGE_TOO_BIG ? ErrorKind::limit
                                                                                                    : ErrorKind::malformed;
  return {kind, where, fmt::format("the JPEG data {}: {}", is_unsupported ? "is not read" : "is broken", decoder.message.data())};
}

/// Adobe's programs store the light that each ink lets through, as the marker of theirs tells; others store the ink.
void inks_to_rgb(ByteImage& image, bool is_inverted) {
  std::size_t to = 0;
  for (std::size_t from = 0; from < image.pixels.size(); from += 4) {
    const auto light = [&](std::size_t c) {
      const std::uint32_t value = image.pixels[from + c];
      return is_inverted ? value : 255 - value;
    };
    const std::array<std::uint32_t, 4> through{light(0), light(1), light(2), light(3)};
    for (std::size_t c = 0; c < 3; ++c) {
      image.pixels[to++] = static_cast<std::uint8_t>((through[c] * through[3] + 127) / 255);
    }
  }
  image.pixels.resize(to);
  image.channels = 3;
}

}  // namespace

Result<ByteImage> decode_jpeg(std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits) {
  Decoder decoder;
  const DecoderGuard guard(decoder);
  if (!read_jpeg_header(decoder, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size())) {
    return tl::unexpected(error_of(decoder, where));
  }
  jpeg_decompress_struct& jpeg = decoder.jpeg;
  if (auto ok = check_image_size(jpeg.image_width, jpeg.image_height, where, limits); !ok) {
    return tl::unexpected(std::move(ok).error());
  }
  // A block of 64 samples takes a bit at least, and no component has fewer samples than one for 16 pixels.
  if (std::size_t{jpeg.image_width} * jpeg.image_height / 8192 > bytes.size()) {
    return fail(
        ErrorKind::malformed, where,
        fmt::format("states a size of {} x {} pixels, which a file of {} bytes cannot hold", jpeg.image_width, jpeg.image_height, bytes.size()));
  }
  const bool is_inks = jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK;
  jpeg.out_color_space = is_inks ? JCS_CMYK : (jpeg.num_components == 1 ? JCS_GRAYSCALE : JCS_RGB);
  jpeg.dct_method = JDCT_ISLOW;
  jpeg.do_block_smoothing = FALSE;
  return within_memory(where, [&]() -> Result<ByteImage> {
    ByteImage image{
        static_cast<int>(jpeg.image_width), static_cast<int>(jpeg.image_height), is_inks ? 4 : (jpeg.num_components == 1 ? 1 : 3), {}};
    const std::size_t row = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
    image.pixels.resize(row * static_cast<std::size_t>(image.height));
    if (!read_jpeg_pixels(decoder, image.pixels.data(), row)) {
      return tl::unexpected(error_of(decoder, where));
    }
    if (is_inks) {
      inks_to_rgb(image, jpeg.saw_Adobe_marker != FALSE);
    }
    return image;
  });
}

#else

Result<ByteImage> decode_jpeg(std::span<const std::byte>, const std::string& where, const ImageLimits&) {
  return fail(ErrorKind::unsupported, where,
              "is a JPEG file, and this build reads none: it was made without libjpeg-turbo (Debian: libjpeg62-turbo-dev)");
}

#endif

}  // namespace lustro
