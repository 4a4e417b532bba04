// The EXR reader, on OpenEXR's input file over memory; its headers are checked by exr_header.cpp first.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>

#include "image/exr.hpp"

namespace lustro {
namespace {

class MemoryInput : public Imf::IStream {
 public:
  explicit MemoryInput(std::span<const std::byte> bytes) : Imf::IStream("memory"), bytes_(bytes) {}
  bool read(char c[], int n) override {
    const auto count = static_cast<std::size_t>(n);
    if (n < 0 || position_ > bytes_.size() || count > bytes_.size() - position_) {
      throw std::runtime_error("the file ends too early");
    }
    std::memcpy(c, bytes_.data() + position_, count);
    position_ += count;
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;
};

/// The file's channels that make the picture, in its order. Absent colours stay 0.
Result<std::vector<std::string>> picture_channels(const Imf::ChannelList& channels, const std::string& where) {
  const auto has = [&](const char* name) { return channels.findChannel(name) != nullptr; };
  std::vector<std::string> names;
  if (has("R") || has("G") || has("B")) {
    names = {"R", "G", "B"};
  } else if (has("Y") && has("A")) {
    names = {"Y", "Y", "Y"};
  } else if (has("Y")) {
    return std::vector<std::string>{"Y"};
  } else {
    std::string all;
    int count = 0;
    for (auto it = channels.begin(); it != channels.end(); ++it, ++count) {
      all += (all.empty() ? "" : ", ") + std::string(it.name());
    }
    if (count == 1) {
      return std::vector<std::string>{all};
    }
    return fail(ErrorKind::unsupported, where, fmt::format("has no picture: channels R, G, B or Y were expected, and found were: {}", all));
  }
  if (has("A")) {
    names.emplace_back("A");
  }
  return names;
}

Image crop(const Image& data, const Imath::Box2i& data_window, const Imath::Box2i& display_window) {
  Image out(display_window.max.x - display_window.min.x + 1, display_window.max.y - display_window.min.y + 1, data.channels);
  const int x0 = std::max(data_window.min.x, display_window.min.x);
  const int x1 = std::min(data_window.max.x, display_window.max.x);
  for (int y = std::max(data_window.min.y, display_window.min.y); y <= std::min(data_window.max.y, display_window.max.y); ++y) {
    for (int x = x0; x <= x1; ++x) {
      std::ranges::copy(data.at(x - data_window.min.x, y - data_window.min.y),
                        out.at(x - display_window.min.x, y - display_window.min.y).begin());
    }
  }
  return out;
}

Result<Image> read_picture(Imf::InputFile& file, const std::string& where) {
  const Imf::ChannelList& channels = file.header().channels();
  const auto names = picture_channels(channels, where);
  if (!names) {
    return tl::unexpected(names.error());
  }
  const Imath::Box2i window = file.header().dataWindow();
  Image image(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, static_cast<int>(names->size()));
  const std::size_t x_stride = sizeof(float) * names->size();
  const std::size_t y_stride = x_stride * static_cast<std::size_t>(image.width);
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < names->size(); ++c) {
    const Imf::Channel* channel = channels.findChannel((*names)[c]);
    if (channel != nullptr && (channel->xSampling != 1 || channel->ySampling != 1)) {
      return fail(ErrorKind::unsupported, where, fmt::format("channel `{}` is subsampled, which is not read", (*names)[c]));
    }
    if (channel != nullptr && (c == 0 || (*names)[c] != (*names)[c - 1])) {
      frame.insert((*names)[c], Imf::Slice::Make(Imf::FLOAT, image.pixels.data() + c, window, x_stride, y_stride));
    }
  }
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  if (names->size() == 4 && names->front() == "Y") {  // gray with alpha becomes colour with alpha
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
      image.pixels[i + 1] = image.pixels[i + 2] = image.pixels[i];
    }
  }
  const Imath::Box2i display = file.header().displayWindow();
  return display == window ? std::move(image) : crop(image, window, display);
}

}  // namespace

Result<Image> decode_exr(std::span<const std::byte> bytes, const std::string& where, const ImageLimits& limits) {
  if (auto ok = check_exr_headers(bytes, where, limits); !ok) {
    return tl::unexpected(std::move(ok).error());
  }
  try {
    MemoryInput stream(bytes);
    Imf::InputFile file(stream, 0);
    if (!file.isComplete()) {
      return fail(ErrorKind::malformed, where, "is not complete: scan lines or tiles are missing");
    }
    return read_picture(file, where);
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::limit, where, "does not fit into memory");
  } catch (const std::exception& e) {
    return fail(ErrorKind::malformed, where, fmt::format("the EXR data is broken: {}", e.what()));
  }
}

}  // namespace lustro
