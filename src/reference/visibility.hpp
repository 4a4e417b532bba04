// Which triangle each sample of a part of the image shows: a visibility buffer (Burns and Hunt 2013), filled one sample at a time.
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
/// the scene wins.
class Visibility {
 public:
  static constexpr std::uint32_t kNothing = 0xFFFFFFFFU;

  Visibility(const Rectangle& area, int samples);

  /// Fills one triangle; `index` is what winner() returns.
  void draw(const View& view, const ScreenTriangle& triangle, std::uint32_t index);

  /// The index of the triangle that sample `sample` of pixel (x, y) shows, or kNothing.
  [[nodiscard]] std::uint32_t winner(int x, int y, int sample) const { return winners_[at(x, y) + static_cast<std::size_t>(sample)]; }

 private:
  [[nodiscard]] std::size_t at(int x, int y) const {
    const auto row = static_cast<std::size_t>(y - area_.top);
    const auto column = static_cast<std::size_t>(x - area_.left);
    return (row * static_cast<std::size_t>(area_.right - area_.left) + column) * static_cast<std::size_t>(samples_);
  }

  Rectangle area_;
  int samples_;
  std::vector<std::uint64_t> keys_;
  std::vector<std::uint32_t> winners_;
};

}  // namespace lustro
