// See frames.hpp.
#include "common/frames.hpp"

#include <cstdlib>
#include <stdexcept>

namespace lustro::bench {

OurFrames::OurFrames(const Subject& subject, Scene scene, int threads) : subject_(subject), scene_(std::move(scene)) {
  options_.threads = threads;
  options_.store_color = false;
  options_.store_bytes = true;
}

void OurFrames::cull(bool culls) {
  scene_.shading.cull = culls ? Culling::back : Culling::none;
  scene_.shading.two_sided = !culls;
}

const Rendering& OurFrames::draw(int i) {
  scene_.objects.front().matrix = turned(subject_, i);
  if (const Result<void> drawn = renderer_.render(scene_, options_, picture_); !drawn) {
    throw std::runtime_error(drawn.error().text());
  }
  return picture_;
}

double share_that_differs(const ByteImage& a, const ByteImage& b) {
  constexpr int kTolerance = 2;
  if (a.width != b.width || a.height != b.height || a.pixels.size() != b.pixels.size()) {
    return 1;
  }
  std::size_t differ = 0;
  const std::size_t pixels = a.pixels.size() / 4;
  for (std::size_t i = 0; i < pixels; ++i) {
    bool over = false;
    for (std::size_t c = 0; c < 3; ++c) {
      over = over || std::abs(a.pixels[4 * i + c] - b.pixels[4 * i + c]) > kTolerance;
    }
    differ += over ? 1 : 0;
  }
  return static_cast<double>(differ) / static_cast<double>(pixels);
}

}  // namespace lustro::bench
