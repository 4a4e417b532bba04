// Colours of an OFF file, written as whole numbers or with a point, gathered and brought into 0..1.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "io/note_book.hpp"
#include "lustro/vec.hpp"

namespace lustro {

/// The colours of one kind (vertices or faces).
class OffColors {
 public:
  /// components  3 or 4 in `channels`
  void add(const std::array<float, 4>& channels, std::size_t components, bool is_whole) {
    colors_.push_back({channels[0], channels[1], channels[2]});
    is_whole_.push_back(is_whole);
    has_any_ = true;
    for (std::size_t i = 0; is_whole && i < components; ++i) {
      counts_to_255_ |= channels[i] > 1;
    }
    see_through_ += components == 4 && channels[3] != 1 && channels[3] != 255 ? 1U : 0U;
  }
  void add_none() {
    colors_.push_back({1, 1, 1});
    is_whole_.push_back(false);
  }
  [[nodiscard]] bool has_any() const { return has_any_; }

  /// All of them, `encoded`; empty where there was none.
  [[nodiscard]] std::vector<Vec3f> settle(const char* what, NoteBook& notes);

 private:
  std::vector<Vec3f> colors_;
  std::vector<bool> is_whole_;
  std::size_t see_through_ = 0;  // with an opacity that is full in neither way of counting
  bool has_any_ = false;
  bool counts_to_255_ = false;
};

}  // namespace lustro
