// Numbers as the text of mesh files.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <string>

#include "lustro/vec.hpp"

namespace lustro {

/// ` x`, the shortest decimal number that is read back to the same bits.
inline void append_number(std::string& text, float x) {
  fmt::format_to(std::back_inserter(text), " {}", x);
}
inline void append_number(std::string& text, std::uint32_t x) {
  fmt::format_to(std::back_inserter(text), " {}", x);
}
inline void append_vector(std::string& text, const Vec3f& v) {
  append_number(text, v.x);
  append_number(text, v.y);
  append_number(text, v.z);
}
inline void append_vector(std::string& text, const Vec2f& v) {
  append_number(text, v.x);
  append_number(text, v.y);
}

}  // namespace lustro
