// Numbers as the bytes of mesh files, the least significant first.
#pragma once

#include <bit>
#include <cstdint>
#include <string>

#include "lustro/vec.hpp"

namespace lustro {

inline void append_u32(std::string& bytes, std::uint32_t x) {
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>((x >> shift) & 0xFFU);
  }
}
inline void append_f32(std::string& bytes, float x) {
  append_u32(bytes, std::bit_cast<std::uint32_t>(x));
}
inline void append_f32(std::string& bytes, const Vec3f& v) {
  append_f32(bytes, v.x);
  append_f32(bytes, v.y);
  append_f32(bytes, v.z);
}
inline void append_f32(std::string& bytes, const Vec2f& v) {
  append_f32(bytes, v.x);
  append_f32(bytes, v.y);
}

}  // namespace lustro
