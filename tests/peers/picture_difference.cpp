// A pixel is at an edge when in its 3 x 3 neighbourhood
//   the object changes, or, with `flat` interpolation, the triangle,
//   the depth changes by more than four pixels' width (a contour inside an object, or a surface seen at more than 76 degrees),
//   or the normal turns by more than 25 degrees from pixel to pixel (an edge of the object).
// There a surface that is moved by less than 1/256 pixel may show something else; everywhere else it may not.
#include "peers/picture_difference.hpp"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "lustro/lustro.hpp"

namespace lustro::peers {
namespace {

constexpr int kTolerance = 2;

class Edges {
 public:
  Edges(const Scene& scene, const Rendering& rendering) : scene_(scene), layers_(rendering.layers) {
    const Camera& camera = scene.camera;
    const bool is_perspective = camera.projection == Projection::perspective;
    pixel_width_ = (is_perspective ? 2 * std::tan(camera.fov * 3.14159265358979323846 / 360) : camera.height.value()) / scene.image.height;
  }

  [[nodiscard]] bool is_at_edge(int x, int y) const {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int nx = x + dx;
        const int ny = y + dy;
        if (nx >= 0 && ny >= 0 && nx < scene_.image.width && ny < scene_.image.height && differ(x, y, nx, ny)) {
          return true;
        }
      }
    }
    return false;
  }

 private:
  [[nodiscard]] float value(std::size_t layer, int x, int y, std::size_t channel = 0) const { return layers_[layer].image.at(x, y)[channel]; }

  [[nodiscard]] bool differ(int x, int y, int nx, int ny) const {
    if (value(0, x, y) != value(0, nx, ny)) {
      return true;
    }
    if (value(0, x, y) < 0) {
      return false;
    }
    if (scene_.shading.interpolation == Interpolation::flat && value(1, x, y) != value(1, nx, ny)) {
      return true;
    }
    const auto depth = static_cast<double>(value(2, x, y));
    const double width = pixel_width_ * (scene_.camera.projection == Projection::perspective ? depth : 1);
    float cosine = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      cosine += value(3, x, y, c) * value(3, nx, ny, c);
    }
    return std::abs(depth - static_cast<double>(value(2, nx, ny))) > 4 * width || cosine < 0.9063F;
  }

  const Scene& scene_;
  const std::vector<Layer>& layers_;
  double pixel_width_;
};

}  // namespace

PictureDifference compare_with_peer(const Scene& scene, const ByteImage& peer) {
  RenderOptions options;
  options.aovs = {{AovKind::object}, {AovKind::triangle}, {AovKind::depth}, {AovKind::normal}};
  const Result<Rendering> rendering = render(scene, options);
  if (!rendering) {
    throw std::runtime_error(rendering.error().text());
  }
  PictureDifference result;
  result.ours = to_bytes(rendering->color, scene.image.transfer);
  const Edges edges(scene, *rendering);
  for (int y = 0; y < peer.height; ++y) {
    for (int x = 0; x < peer.width; ++x) {
      ++result.pixels;
      int difference = 0;
      const std::size_t at = static_cast<std::size_t>(y * peer.width + x) * 4;
      for (std::size_t c = 0; c < 3; ++c) {
        difference = std::max(difference, std::abs(result.ours.pixels[at + c] - peer.pixels[at + c]));
      }
      result.over += difference > kTolerance ? 1 : 0;
      if (difference > result.worst && !edges.is_at_edge(x, y)) {
        result.worst = difference;
      }
      if (difference > kTolerance && !edges.is_at_edge(x, y) && ++result.strays == 1) {
        result.stray = "(" + std::to_string(x) + ", " + std::to_string(y) + "): ours";
        for (std::size_t c = 0; c < 3; ++c) {
          result.stray += " " + std::to_string(result.ours.pixels[at + c]);
        }
        result.stray += ", the peer's";
        for (std::size_t c = 0; c < 3; ++c) {
          result.stray += " " + std::to_string(peer.pixels[at + c]);
        }
      }
    }
  }
  return result;
}

void write_triple(const std::filesystem::path& file, const ByteImage& ours, const ByteImage& peer) {
  Image image(3 * ours.width, ours.height, 3);
  for (int y = 0; y < ours.height; ++y) {
    for (int x = 0; x < ours.width; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t at = static_cast<std::size_t>(y * ours.width + x) * 4 + c;
        const auto a = static_cast<float>(ours.pixels[at]) / 255;
        const auto b = static_cast<float>(peer.pixels[at]) / 255;
        image.at(x, y)[c] = a;
        image.at(ours.width + x, y)[c] = b;
        image.at(2 * ours.width + x, y)[c] = 8 * std::abs(a - b);
      }
    }
  }
  std::filesystem::create_directories(file.parent_path());
  WriteOptions options;
  options.transfer = Transfer::none;
  if (const auto written = write_image(file, image, options); !written) {
    throw std::runtime_error(written.error().text());
  }
}

}  // namespace lustro::peers
