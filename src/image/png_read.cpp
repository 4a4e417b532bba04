// The PNG reader: libspng does the decoding (no longjmp, limits on every size), this file turns what it gives into linear floats.
#include <fmt/format.h>
#include <spng.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>

#include "image/png.hpp"
#include "image/srgb.hpp"

namespace lustro {
namespace {

struct FreeContext {
  void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};

/// Deflate never packs more than 1032 bytes into one, so a short file cannot hold a large picture.
bool can_hold(std::size_t file_bytes, const spng_ihdr& header) {
  constexpr std::size_t kChannels[] = {1, 0, 3, 1, 2, 0, 4};
  const std::size_t row_bits = std::size_t{header.width} * header.bit_depth * kChannels[header.color_type];
  return row_bits / 8 * header.height / 1032 <= file_bytes;
}

/// Walks the chunks up to the end of IEND, which libspng itself does not ask for: a file that was cut anywhere is not whole.
Result<void> check_whole(std::span<const std::byte> bytes, const std::string& where) {
  constexpr std::size_t kAround = 12;  // length, type, CRC
  for (std::size_t at = 8; bytes.size() - at >= kAround;) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      length = (length << 8) | static_cast<std::size_t>(bytes[at + i]);
    }
    if (length > bytes.size() - at - kAround) {
      break;
    }
    if (std::memcmp(bytes.data() + at + 4, "IEND", 4) == 0) {
      return {};
    }
    at += kAround + length;
  }
  return fail(ErrorKind::malformed, fmt::format("{}: byte {}", where, bytes.size()), "the PNG file ends before its IEND chunk does");
}

/// RGBA integers of either width as floats: linear, only the channels that say something.
template <class Int>
Image to_floats(const std::vector<Int>& rgba, const spng_ihdr& header, int channels, Transfer transfer, AlphaForm alpha_form) {
  constexpr std::size_t kMax = static_cast<Int>(-1);
  std::vector<float> linear(kMax + 1);
  std::vector<float> plain(kMax + 1);
  for (std::size_t i = 0; i <= kMax; ++i) {
    plain[i] = static_cast<float>(i) / static_cast<float>(kMax);
    linear[i] = transfer == Transfer::srgb ? srgb_decode(plain[i]) : plain[i];
  }
  Image image(static_cast<int>(header.width), static_cast<int>(header.height), channels);
  const auto step = static_cast<std::size_t>(channels);
  for (std::size_t from = 0, to = 0; from < rgba.size(); from += 4, to += step) {
    const float alpha = plain[rgba[from + 3]];
    const float factor = alpha_form == AlphaForm::premultiplied && channels == 4 ? alpha : 1.0F;
    for (std::size_t c = 0; c < std::min<std::size_t>(step, 3); ++c) {
      image.pixels[to + c] = linear[rgba[from + c]] * factor;
    }
    if (channels == 4) {
      image.pixels[to + 3] = alpha;
    }
  }
  return image;
}

template <class Int>
Result<Image> decode_pixels(spng_ctx* context, const spng_ihdr& header, Transfer transfer, AlphaForm alpha, const std::string& where) {
  const auto check = [&](int status) -> Result<void> {
    if (status != 0 && status != SPNG_EOI) {
      return fail(ErrorKind::malformed, where, fmt::format("the PNG data is broken: {}", spng_strerror(status)));
    }
    return {};
  };
  std::vector<Int> rgba(std::size_t{header.width} * header.height * 4);
  const int format = sizeof(Int) == 2 ? SPNG_FMT_RGBA16 : SPNG_FMT_RGBA8;
  if (auto ok = check(spng_decode_image(context, rgba.data(), rgba.size() * sizeof(Int), format, SPNG_DECODE_TRNS)); !ok) {
    return tl::unexpected(std::move(ok).error());
  }
  if (auto ok = check(spng_decode_chunks(context)); !ok) {  // up to IEND: a file that was cut after its pixels is not whole
    return tl::unexpected(std::move(ok).error());
  }
  spng_trns transparency{};
  const bool has_alpha = (header.color_type & 4) != 0 || spng_get_trns(context, &transparency) == 0;
  const bool is_gray = header.color_type == SPNG_COLOR_TYPE_GRAYSCALE;
  return to_floats(rgba, header, has_alpha ? 4 : (is_gray ? 1 : 3), transfer, alpha);
}

}  // namespace

Result<Image> decode_png(std::span<const std::byte> bytes, const std::string& where, Transfer transfer, const ImageLimits& limits,
                         AlphaForm alpha) {
  const std::unique_ptr<spng_ctx, FreeContext> context(spng_ctx_new(0));
  if (!context) {
    return fail(ErrorKind::limit, where, "does not fit into memory");
  }
  spng_set_crc_action(context.get(), SPNG_CRC_ERROR, SPNG_CRC_DISCARD);
  constexpr std::size_t kChunkLimit = std::size_t{64} << 20;
  spng_set_chunk_limits(context.get(), kChunkLimit, kChunkLimit);
  spng_ihdr header{};
  int status = spng_set_png_buffer(context.get(), bytes.data(), bytes.size());
  if (status == 0) {
    status = spng_get_ihdr(context.get(), &header);
  }
  if (status != 0) {
    return fail(ErrorKind::malformed, where, fmt::format("the PNG header is broken: {}", spng_strerror(status)));
  }
  if (auto ok = check_image_size(header.width, header.height, where, limits); !ok) {
    return tl::unexpected(std::move(ok).error());
  }
  if (!can_hold(bytes.size(), header)) {
    return fail(ErrorKind::malformed, where,
                fmt::format("states a size of {} x {} pixels, which a file of {} bytes cannot hold", header.width, header.height, bytes.size()));
  }
  if (auto ok = check_whole(bytes, where); !ok) {
    return tl::unexpected(std::move(ok).error());
  }
  return within_memory(where, [&] {
    return header.bit_depth == 16 ? decode_pixels<std::uint16_t>(context.get(), header, transfer, alpha, where)
                                  : decode_pixels<std::uint8_t>(context.get(), header, transfer, alpha, where);
  });
}

}  // namespace lustro
