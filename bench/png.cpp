// bench_png [SECONDS]: the 1080p picture of the common scene, sRGB, as a PNG in memory: ours beside libpng and libspng at level 1. All pack the
// same RGB bytes with the filters that they choose themselves; each file is read back first and must hold the picture.
#include "image/png.hpp"

#include <fmt/format.h>
#include <png.h>
#include <spng.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "common/frames.hpp"
#include "common/measure.hpp"

namespace lustro::bench {
namespace {

using Bytes = std::vector<std::byte>;

ByteImage common_picture() {
  const Subject& subject = *find_subject("70k");
  Scene scene = common_scene(subject, 4);
  scene.image.transfer = Transfer::srgb;
  OurFrames frames(subject, scene);
  const ByteImage& four = frames.draw(0).bytes;
  ByteImage three{four.width, four.height, 3, {}};
  for (std::size_t i = 0; i < four.pixels.size(); i += 4) {
    three.pixels.insert(three.pixels.end(), {four.pixels[i], four.pixels[i + 1], four.pixels[i + 2]});
  }
  return three;
}

Bytes by_ours(const ByteImage& image, int threads) {
  Result<Bytes> file = encode_png(image, {.threads = threads});
  if (!file) {
    throw std::runtime_error(file.error().text());
  }
  return std::move(*file);
}

Bytes by_libpng(const ByteImage& image) {
  Bytes file;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &file,
      [](png_structp p, png_bytep data, std::size_t size) {  // NOLINT(readability-non-const-parameter): libpng's type
        auto* out = static_cast<Bytes*>(png_get_io_ptr(p));
        const auto* bytes = reinterpret_cast<const std::byte*>(data);
        out->insert(out->end(), bytes, bytes + size);
      },
      nullptr);
  png_set_compression_level(png, 1);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  for (int y = 0; y < image.height; ++y) {
    png_write_row(png, image.pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) * 3);
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return file;
}

Bytes by_libspng(const ByteImage& image) {
  spng_ctx* png = spng_ctx_new(SPNG_CTX_ENCODER);
  spng_set_option(png, SPNG_ENCODE_TO_BUFFER, 1);
  spng_set_option(png, SPNG_IMG_COMPRESSION_LEVEL, 1);
  spng_ihdr header{};
  header.width = static_cast<std::uint32_t>(image.width);
  header.height = static_cast<std::uint32_t>(image.height);
  header.bit_depth = 8;
  header.color_type = SPNG_COLOR_TYPE_TRUECOLOR;
  spng_set_ihdr(png, &header);
  int error = spng_encode_image(png, image.pixels.data(), image.pixels.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
  std::size_t size = 0;
  void* made = error == 0 ? spng_get_png_buffer(png, &size, &error) : nullptr;
  Bytes file(size);
  if (made != nullptr) {
    std::memcpy(file.data(), made, size);
  }
  std::free(made);  // NOLINT(cppcoreguidelines-no-malloc): libspng's buffer is the caller's to free
  spng_ctx_free(png);
  if (error != 0) {
    throw std::runtime_error(spng_strerror(error));
  }
  return file;
}

/// Whether a file holds the picture: by a reader that shares nothing with the writers under test but the format.
bool holds(const Bytes& file, const ByteImage& image) {
  png_image reader{};
  reader.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&reader, file.data(), file.size()) == 0) {
    return false;
  }
  reader.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(reader));
  return png_image_finish_read(&reader, nullptr, pixels.data(), 0, nullptr) != 0 && pixels == image.pixels;
}

int compare(double seconds) {
  const ByteImage image = common_picture();
  const Bytes ours = by_ours(image, 0);
  const Bytes libpng = by_libpng(image);
  const Bytes libspng = by_libspng(image);
  if (!holds(ours, image) || !holds(libpng, image) || !holds(libspng, image)) {
    report_failure("png", "a file does not hold the picture");
    return 1;
  }
  const std::vector<Side> sides{{"ours", [&](int) { (void)by_ours(image, 0); }},
                                {"ours, one thread", [&](int) { (void)by_ours(image, 1); }},
                                {"libpng", [&](int) { (void)by_libpng(image); }},
                                {"libspng", [&](int) { (void)by_libspng(image); }}};
  report("png", fmt::format("all files hold the picture; bytes: ours {}, libpng {}, libspng {}", ours.size(), libpng.size(), libspng.size()),
         sides, in_turns(sides, {.most_seconds = seconds}));
  return 0;
}

}  // namespace
}  // namespace lustro::bench

int main(int argc, char** argv) {
  try {
    return lustro::bench::compare(argc > 1 ? std::atof(argv[1]) : 10);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "bench_png: %s\n", e.what());
    return 1;
  }
}
