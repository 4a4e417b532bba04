// APNG: frames are whole PNG files of our writer, taken apart into chunks and put together again.
// source  W3C, Portable Network Graphics, 3rd edition, 11.3.4 (acTL, fcTL, fdAT)
#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <string_view>

#include "image/animation.hpp"
#include "image/png.hpp"

namespace lustro {
namespace {

constexpr std::size_t kSignatureBytes = 8;

void append_u16(std::vector<std::byte>& out, std::uint32_t value) {
  for (const unsigned shift : {8U, 0U}) {
    out.push_back(static_cast<std::byte>(value >> shift & 0xFFU));
  }
}
void append_u32(std::vector<std::byte>& out, std::uint32_t value) {
  append_u16(out, value >> 16U);
  append_u16(out, value & 0xFFFFU);
}

struct Chunk {
  std::string_view type;
  std::span<const std::byte> data;
};

/// The chunks of a file that we have written.
std::vector<Chunk> chunks_of(std::span<const std::byte> file) {
  std::vector<Chunk> chunks;
  for (std::size_t at = kSignatureBytes; at + 12 <= file.size();) {
    std::uint32_t size = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      size = size << 8U | std::to_integer<std::uint32_t>(file[at + i]);
    }
    chunks.push_back({{reinterpret_cast<const char*>(file.data()) + at + 4, 4}, file.subspan(at + 8, size)});
    at += 12 + std::size_t{size};
  }
  return chunks;
}

void append_chunk(std::vector<std::byte>& out, std::string_view type, std::span<const std::byte> data) {
  append_u32(out, static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = out.size();
  for (const char c : type) {
    out.push_back(static_cast<std::byte>(c));
  }
  out.insert(out.end(), data.begin(), data.end());
  append_u32(out, libdeflate_crc32(0, out.data() + begin, out.size() - begin));
}

struct Rectangle {
  int x = 0, y = 0, width = 1, height = 1;
};

/// The smallest part that holds every pixel in which the frames differ; one pixel where none does.
Rectangle changed_part(const ByteImage& before, const ByteImage& after) {
  int left = after.width, right = -1, top = after.height, bottom = -1;
  const std::size_t row_bytes = static_cast<std::size_t>(after.width) * 4;
  for (int y = 0; y < after.height; ++y) {
    const std::uint8_t* const a = &before.pixels[static_cast<std::size_t>(y) * row_bytes];
    const std::uint8_t* const b = &after.pixels[static_cast<std::size_t>(y) * row_bytes];
    if (std::memcmp(a, b, row_bytes) == 0) {
      continue;
    }
    const auto first = static_cast<std::size_t>(std::mismatch(a, a + row_bytes, b).first - a);
    std::size_t end = row_bytes;
    while (a[end - 1] == b[end - 1]) {
      --end;
    }
    left = std::min(left, static_cast<int>(first / 4));
    right = std::max(right, static_cast<int>((end - 1) / 4));
    top = std::min(top, y);
    bottom = y;
  }
  return right < 0 ? Rectangle{} : Rectangle{left, top, right - left + 1, bottom - top + 1};
}

ByteImage cut(const ByteImage& frame, const Rectangle& part, bool with_alpha) {
  ByteImage out{part.width, part.height, with_alpha ? 4 : 3, {}};
  const auto channels = static_cast<std::size_t>(out.channels);
  out.pixels.resize(static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height) * channels);
  std::uint8_t* to = out.pixels.data();
  for (int y = part.y; y < part.y + part.height; ++y) {
    const std::uint8_t* from =
        &frame.pixels[(static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(part.x)) * 4];
    for (int x = 0; x < part.width; ++x, from += 4, to += channels) {
      std::memcpy(to, from, channels);
    }
  }
  return out;
}

/// Seconds as a fraction of 16-bit numbers: 1/30 for 30 frames a second, else thousandths.
std::array<std::uint32_t, 2> delay_of(double frames_per_second) {
  const double whole = std::round(frames_per_second);
  if (std::abs(frames_per_second - whole) < 1e-9 && whole >= 1 && whole <= 65535) {
    return {1, static_cast<std::uint32_t>(whole)};
  }
  return {static_cast<std::uint32_t>(std::clamp(std::round(1000 / frames_per_second), 1.0, 65535.0)), 1000};
}

class Apng {
 public:
  explicit Apng(const AnimationOptions& options) : options_(options) {}

  Result<void> add(const ByteImage& frame) {
    if (auto checked = check_frame(options_, frame, count_); !checked) {
      return checked;
    }
    const Rectangle part = count_ == 0 ? Rectangle{0, 0, frame.width, frame.height} : changed_part(before_, frame);
    const WriteOptions write{.transfer = options_.transfer, .png_level = {}, .threads = options_.threads};
    const auto file = encode_png(cut(frame, part, options_.has_alpha), write, options_.has_alpha);
    if (!file) {
      return tl::unexpected(file.error());
    }
    const std::vector<Chunk> chunks = chunks_of(*file);
    if (count_ == 0) {
      begin(*file, chunks);
    }
    append_control(part);
    for (const Chunk& chunk : chunks) {
      if (chunk.type == "IDAT" && count_ == 0) {
        append_chunk(out_, "IDAT", chunk.data);
      } else if (chunk.type == "IDAT") {
        std::vector<std::byte> data;
        append_u32(data, sequence_++);
        data.insert(data.end(), chunk.data.begin(), chunk.data.end());
        append_chunk(out_, "fdAT", data);
      }
    }
    before_ = frame;
    ++count_;
    return {};
  }

  Result<std::vector<std::byte>> finish() {
    if (count_ != options_.frames) {
      return fail(ErrorKind::usage, "", "the animation lacks frames");
    }
    append_chunk(out_, "IEND", {});
    return std::move(out_);
  }

 private:
  /// What stands before the first frame, with the number of frames.
  void begin(std::span<const std::byte> file, const std::vector<Chunk>& chunks) {
    out_.assign(file.begin(), file.begin() + kSignatureBytes);
    for (const Chunk& chunk : chunks) {
      if (chunk.type == "IDAT") {
        break;
      }
      append_chunk(out_, chunk.type, chunk.data);
    }
    std::vector<std::byte> control;
    append_u32(control, static_cast<std::uint32_t>(options_.frames));
    append_u32(control, 0);  // plays without end
    append_chunk(out_, "acTL", control);
  }

  void append_control(const Rectangle& part) {
    std::vector<std::byte> control;
    append_u32(control, sequence_++);
    for (const int number : {part.width, part.height, part.x, part.y}) {
      append_u32(control, static_cast<std::uint32_t>(number));
    }
    for (const std::uint32_t number : delay_of(options_.frames_per_second)) {
      append_u16(control, number);
    }
    append_u16(control, 0);  // the frame stays for the next one, and takes the place of what was there
    append_chunk(out_, "fcTL", control);
  }

  AnimationOptions options_;
  std::vector<std::byte> out_;
  ByteImage before_;
  int count_ = 0;
  std::uint32_t sequence_ = 0;
};

}  // namespace

Result<AnimationEncoder> make_apng_encoder(const AnimationOptions& options) {
  const auto apng = std::make_shared<Apng>(options);
  return AnimationEncoder{[apng](const ByteImage& frame) { return apng->add(frame); }, [apng] { return apng->finish(); }};
}

}  // namespace lustro
