// Whether two scenes are the same, member by member and bit by bit.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <string>

#include "scene/fields.hpp"

namespace lustro {

template <class T>
std::string difference(const T& a, const T& b, const std::string& path);

struct SameValue {
  static bool bits(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }
  static bool bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }
  static bool bits(const Vec3f& a, const Vec3f& b) { return bits(a.x, b.x) && bits(a.y, b.y) && bits(a.z, b.z); }
  static bool bits(const Vec3d& a, const Vec3d& b) { return bits(a.x, b.x) && bits(a.y, b.y) && bits(a.z, b.z); }
  static bool bits(const Vec2f& a, const Vec2f& b) { return bits(a.x, b.x) && bits(a.y, b.y); }
  static bool bits(const std::array<float, 6>& a, const std::array<float, 6>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), [](float x, float y) { return bits(x, y); });
  }
  static bool bits(const WrapPair& a, const WrapPair& b) { return a == b; }
  static bool bits(const Color& a, const Color& b) { return bits(a.rgb, b.rgb) && a.space == b.space; }
  static bool bits(const Mat4& a, const Mat4& b) {
    for (std::size_t i = 0; i < 16; ++i) {
      if (!bits(a.m[i], b.m[i])) {
        return false;
      }
    }
    return true;
  }
  static bool bits(const ColorAlphaRef& a, const ColorAlphaRef& b) { return bits(a.color, b.color) && bits(a.alpha, b.alpha); }
  static bool bits(const std::string& a, const std::string& b) { return a == b; }
  static bool bits(const TermSet& a, const TermSet& b) { return a == b; }
  static bool bits(bool a, bool b) { return a == b; }
  static bool bits(int a, int b) { return a == b; }
  static bool bits(std::monostate, std::monostate) { return true; }
  template <class E>
  requires std::is_enum_v<E>
  static bool bits(const E& a, const E& b) { return a == b; }
  template <class V>
  static bool bits(const std::optional<V>& a, const std::optional<V>& b) {
    return a.has_value() == b.has_value() && (!a || bits(*a, *b));
  }
  template <class V>
  static bool bits(const std::vector<V>& a, const std::vector<V>& b) {
    if (a.size() != b.size()) {
      return false;
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (!bits(a[i], b[i])) {
        return false;
      }
    }
    return true;
  }
  template <class T>
  requires std::is_class_v<T>
  static bool bits(const T& a, const T& b) { return difference(a, b, "").empty(); }
};

inline bool same_value(const ValueRef& a, const ValueRef& b) {
  return std::visit(
      [&]<class R>(const R& x) {
        const R* y = std::get_if<R>(&b);
        if constexpr (std::is_pointer_v<R>) {
          return y != nullptr && SameValue::bits(*x, **y);
        } else {
          return y != nullptr && SameValue::bits(x, *y);
        }
      },
      a);
}

/// The path of the first member that differs; empty where all are the same.
template <class T>
std::string difference(const T& a, const T& b, const std::string& path) {
  T left = a;
  T right = b;
  for (const Field<T>& field : fields<T>()) {
    if (!same_value(field.value(left), field.value(right))) {
      return path + "." + std::string(field.key);
    }
  }
  return {};
}

}  // namespace lustro
