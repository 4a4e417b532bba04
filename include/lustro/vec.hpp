// Small vectors and a 4x4 matrix. F is a lane type: float or double here, N floats in a kernel.
// The order of every sum is fixed, because floating-point addition is not associative and the bits are promised.
#pragma once

#include <array>
#include <cmath>

namespace lustro {

template <class F>
struct Vec2 {
  F x{}, y{};
  friend bool operator==(const Vec2&, const Vec2&) = default;
};

template <class F>
struct Vec3 {
  F x{}, y{}, z{};
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

using Vec2f = Vec2<float>;
using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;

// clang-format off
template <class F> constexpr Vec3<F> operator+(const Vec3<F>& a, const Vec3<F>& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
template <class F> constexpr Vec3<F> operator-(const Vec3<F>& a, const Vec3<F>& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
template <class F> constexpr Vec3<F> operator*(const Vec3<F>& a, const Vec3<F>& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
template <class F> constexpr Vec3<F> operator*(const Vec3<F>& a, const F& s) { return {a.x * s, a.y * s, a.z * s}; }
template <class F> constexpr Vec3<F> operator*(const F& s, const Vec3<F>& a) { return {a.x * s, a.y * s, a.z * s}; }
template <class F> constexpr Vec3<F> operator-(const Vec3<F>& a) { return {-a.x, -a.y, -a.z}; }
template <class F> constexpr Vec3<F>& operator+=(Vec3<F>& a, const Vec3<F>& b) { a = a + b; return a; }

/// (x x' + y y') + z z', in this order.
template <class F> constexpr F dot(const Vec3<F>& a, const Vec3<F>& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }

template <class F> constexpr Vec3<F> cross(const Vec3<F>& a, const Vec3<F>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
// clang-format on

template <class F>
F length(const Vec3<F>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// v / |v| by one IEEE division and one IEEE square root. Not for the zero vector.
template <class F>
Vec3<F> normalize(const Vec3<F>& a) {
  return a * (F(1) / length(a));
}

template <class To, class From>
constexpr Vec3<To> vec_cast(const Vec3<From>& a) {
  return {static_cast<To>(a.x), static_cast<To>(a.y), static_cast<To>(a.z)};
}

[[nodiscard]] inline bool is_finite(const Vec3f& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
[[nodiscard]] inline bool is_finite(const Vec3d& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// A 4x4 matrix, row-major, for column vectors: x' = M x. Named destination_from_source.
struct Mat4 {
  std::array<double, 16> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

  constexpr double operator()(int row, int column) const { return m[static_cast<std::size_t>(4 * row + column)]; }
  constexpr double& operator()(int row, int column) { return m[static_cast<std::size_t>(4 * row + column)]; }
  friend constexpr bool operator==(const Mat4&, const Mat4&) = default;
};

[[nodiscard]] constexpr Mat4 operator*(const Mat4& a, const Mat4& b) {
  Mat4 r;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      r(i, j) = ((a(i, 0) * b(0, j) + a(i, 1) * b(1, j)) + a(i, 2) * b(2, j)) + a(i, 3) * b(3, j);
    }
  }
  return r;
}

[[nodiscard]] constexpr Vec3d transform_point(const Mat4& m, const Vec3d& p) {
  return {((m(0, 0) * p.x + m(0, 1) * p.y) + m(0, 2) * p.z) + m(0, 3), ((m(1, 0) * p.x + m(1, 1) * p.y) + m(1, 2) * p.z) + m(1, 3),
          ((m(2, 0) * p.x + m(2, 1) * p.y) + m(2, 2) * p.z) + m(2, 3)};
}

}  // namespace lustro
