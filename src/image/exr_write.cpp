// The EXR writer, on OpenEXR's scan-line output into memory.
#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringVectorAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <set>

#include "image/exr.hpp"

namespace lustro {
namespace {

/// An output stream that OpenEXR can seek in: it comes back to fill in the table of line offsets.
class MemoryOutput : public Imf::OStream {
 public:
  MemoryOutput() : Imf::OStream("memory") {}
  void write(const char c[], int n) override {
    const auto count = static_cast<std::size_t>(n);
    bytes_.resize(std::max(bytes_.size(), position_ + count));
    std::memcpy(bytes_.data() + position_, c, count);
    position_ += count;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
  std::size_t position_ = 0;
};

/// A file's channel and where its floats lie.
struct Plane {
  std::string name;
  const Image* image = nullptr;
  std::size_t channel = 0;
};

std::vector<std::string> color_names(int channels) {
  switch (channels) {
    case 1:
      return {"Y"};
    case 2:
      return {"Y", "A"};
    case 3:
      return {"R", "G", "B"};
    default:
      return {"R", "G", "B", "A"};
  }
}

Result<std::vector<Plane>> planes_of(const Image& color, std::span<const Layer> layers) {
  std::vector<Plane> planes;
  for (const std::string& name : color_names(color.channels)) {
    planes.push_back({name, &color, planes.size()});
  }
  for (const Layer& layer : layers) {
    const Image& image = layer.image;
    if (image.width != color.width || image.height != color.height ||
        image.pixels.size() != static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * layer.channels.size() ||
        image.channels != static_cast<int>(layer.channels.size())) {
      return fail(ErrorKind::usage, "",
                  fmt::format("layer `{}` is {} x {} pixels of {} channels with {} names; the picture is {} x {}", layer.name, image.width,
                              image.height, image.channels, layer.channels.size(), color.width, color.height));
    }
    for (std::size_t c = 0; c < layer.channels.size(); ++c) {
      planes.push_back({layer.name + "." + layer.channels[c], &image, c});
    }
  }
  std::set<std::string> seen;
  for (const Plane& plane : planes) {
    if (plane.name.size() > 255 || plane.name.front() == '.' || plane.name.back() == '.' || plane.name.find('\0') != std::string::npos) {
      return fail(ErrorKind::usage, "", fmt::format("`{}` cannot be the name of an EXR channel", plane.name));
    }
    if (!seen.insert(plane.name).second) {
      return fail(ErrorKind::usage, "", fmt::format("the EXR channel `{}` would be there twice", plane.name));
    }
  }
  return planes;
}

}  // namespace

Result<std::vector<std::byte>> encode_exr(const Image& color, std::span<const Layer> layers) {
  const auto planes = planes_of(color, layers);
  if (!planes) {
    return tl::unexpected(planes.error());
  }
  try {
    Imf::Header header(color.width, color.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = 4;
    Imf::addChromaticities(header, Imf::Chromaticities());  // the defaults are those of Rec. 709 and sRGB
    for (const Layer& layer : layers) {
      if (!layer.labels.empty()) {
        header.insert(layer.name + ".labels", Imf::StringVectorAttribute(layer.labels));
      }
    }
    Imf::FrameBuffer frame;
    for (const Plane& plane : *planes) {
      header.channels().insert(plane.name, Imf::Channel(Imf::FLOAT));
      const std::size_t x_stride = sizeof(float) * static_cast<std::size_t>(plane.image->channels);
      // OpenEXR's slices are not const, also where it only reads
      auto* base = reinterpret_cast<char*>(const_cast<float*>(plane.image->pixels.data() + plane.channel));
      frame.insert(plane.name, Imf::Slice(Imf::FLOAT, base, x_stride, x_stride * static_cast<std::size_t>(color.width)));
    }
    MemoryOutput out;
    {
      Imf::OutputFile file(out, header, 0);  // no threads; it is complete when it is destroyed
      file.setFrameBuffer(frame);
      file.writePixels(color.height);
    }
    return out.take();
  } catch (const std::exception& e) {
    return fail(ErrorKind::io, "", fmt::format("OpenEXR cannot write the picture: {}", e.what()));
  }
}

}  // namespace lustro
