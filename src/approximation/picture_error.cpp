// The figures by which two pictures of the same scene are compared. Sums run pixel by pixel, in order.
#include <cmath>
#include <cstddef>

#include "lustro/approximation.hpp"

namespace lustro {
namespace {

double luminance_at(const Image& image, std::size_t pixel) {
  const float* p = image.pixels.data() + pixel * static_cast<std::size_t>(image.channels);
  return 0.2126 * static_cast<double>(p[0]) + 0.7152 * static_cast<double>(p[1]) + 0.0722 * static_cast<double>(p[2]);
}

std::size_t pixel_count(const Image& image) {
  return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

/// What is stored of a picture, 0..1.
Image stored(const Image& image, Transfer transfer, const Tone& tone) {
  const ByteImage bytes = to_bytes(image, transfer, tone);
  Image result(bytes.width, bytes.height, 3);
  const auto step = static_cast<std::size_t>(bytes.channels);
  for (std::size_t i = 0; i < pixel_count(result); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      result.pixels[3 * i + c] = static_cast<float>(bytes.pixels[step * i + c]) / 255.0F;
    }
  }
  return result;
}

}  // namespace

double mean_luminance(const Image& image) {
  double sum = 0;
  for (std::size_t i = 0; i < pixel_count(image); ++i) {
    sum += luminance_at(image, i);
  }
  return pixel_count(image) > 0 ? sum / static_cast<double>(pixel_count(image)) : 0;
}

Result<PictureError> picture_error(const Image& a, const Image& b, double truth_luminance, Transfer transfer, const Tone& tone) {
  if (a.channels < 3 || b.channels < 3) {
    return fail(ErrorKind::usage, "", "pictures without colours cannot be compared");
  }
  const Result<Comparison> comparison = compare_images(stored(a, transfer, tone), stored(b, transfer, tone), 0, Transfer::none);
  if (!comparison) {
    return tl::unexpected(comparison.error());
  }
  PictureError error;
  error.flip = comparison->flip;
  double squares = 0, absolute = 0, total = 0;
  const std::size_t count = pixel_count(a);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double difference = static_cast<double>(b.pixels[i * static_cast<std::size_t>(b.channels) + c]) -
                                static_cast<double>(a.pixels[i * static_cast<std::size_t>(a.channels) + c]);
      squares += difference * difference;
    }
    const double difference = luminance_at(b, i) - luminance_at(a, i);
    absolute += std::abs(difference);
    total += difference;
  }
  const double scale = truth_luminance > 0 ? truth_luminance : 1;
  error.rmse = std::sqrt(squares / (3 * static_cast<double>(count)));
  error.luminance = absolute / static_cast<double>(count) / scale;
  error.bias = total / static_cast<double>(count) / scale;
  return error;
}

}  // namespace lustro
