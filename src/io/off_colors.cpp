// Whole numbers are divided here, the rest is settle_colors().
#include "io/off_colors.hpp"

#include <fmt/format.h>

#include <utility>

#include "io/colors.hpp"

namespace lustro {

std::vector<Vec3f> OffColors::settle(const char* what, NoteBook& notes) {
  if (!has_any_) {
    return {};
  }
  for (std::size_t i = 0; counts_to_255_ && i < colors_.size(); ++i) {
    if (is_whole_[i]) {
      colors_[i] = {colors_[i].x / 255.0F, colors_[i].y / 255.0F, colors_[i].z / 255.0F};
    }
  }
  if (see_through_ != 0) {
    notes.add(0, fmt::format("opacities of {} colours are ignored", what), see_through_);
  }
  settle_colors(colors_, what, notes);
  return std::move(colors_);
}

}  // namespace lustro
