// Which triangle each sample of a part of the image shows: a visibility buffer (Burns and Hunt 2013), filled one sample at a time. Triangles
// that are blended are listed by pixel.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "reference/triangle.hpp"

namespace lustro {

/// A part of the image, pixels, the upper bounds excluded.
struct Rectangle {
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// Per sample the winner: max((depth key's bits << 32) | ~id), so that the order of triangles is of no matter. Of equally near ones the first in
/// the scene wins. Where a triangle's material is a mask, only samples that it covers count.
class Visibility {
 public:
  static constexpr std::uint32_t kNothing = 0xFFFFFFFFU;

  Visibility(const PreparedScene& scene, const Rectangle& area);

  /// Fills one triangle; `index` is what winner() returns and layers() lists.
  void draw(const ScreenTriangle& triangle, std::uint32_t index);

  /// The index of the triangle that sample `sample` of pixel (x, y) shows, or kNothing.
  [[nodiscard]] std::uint32_t winner(int x, int y, int sample) const { return winners_[at(x, y, sample)]; }
  /// Its key; 0 where there is none.
  [[nodiscard]] std::uint64_t key(int x, int y, int sample) const { return keys_[at(x, y, sample)]; }
  /// The blended triangles that cover samples of a pixel, in the order of drawing.
  [[nodiscard]] std::span<const std::uint32_t> layers(int x, int y) const { return layers_[pixel(x, y)]; }

 private:
  [[nodiscard]] std::size_t pixel(int x, int y) const {
    return static_cast<std::size_t>(y - area_.top) * static_cast<std::size_t>(area_.right - area_.left) +
           static_cast<std::size_t>(x - area_.left);
  }
  [[nodiscard]] std::size_t at(int x, int y, int sample) const {
    return pixel(x, y) * static_cast<std::size_t>(scene_.view.samples) + static_cast<std::size_t>(sample);
  }

  const PreparedScene& scene_;
  Rectangle area_;
  std::vector<std::uint64_t> keys_;
  std::vector<std::uint32_t> winners_;
  std::vector<std::vector<std::uint32_t>> layers_;
};

/// A triangle's key at a sample of a pixel, by which samples choose the nearest; 0 where it does not cover it or lies behind the far plane.
[[nodiscard]] std::uint64_t key_at(const View& view, const ScreenTriangle& t, std::int32_t px, std::int32_t py);

}  // namespace lustro
