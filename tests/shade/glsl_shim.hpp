// As much of GLSL ES 3.00 in C++ as the shaders need. Included inside a struct between glsl_begin.hpp and glsl_end.hpp, a .glsl file becomes a
// program object: uniforms, ins and outs are its members, main() its function. Every operation is one IEEE float operation, in the order that
// lustro/vec.hpp has, so that only pow() and exp2() may differ from the C++.
#pragma once

#include <cmath>
#include <limits>

namespace glsl {

/// GLSL's float: literals such as 0.5 are floats, and no operation is ever done in double.
struct Float {
  float v = 0;
  constexpr Float() = default;
  constexpr Float(double a) : v(static_cast<float>(a)) {}
  constexpr Float(float a) : v(a) {}
  friend constexpr bool operator<(Float a, Float b) { return a.v < b.v; }
  friend constexpr bool operator<=(Float a, Float b) { return a.v <= b.v; }
  friend constexpr bool operator>(Float a, Float b) { return a.v > b.v; }
  friend constexpr bool operator==(Float a, Float b) { return a.v == b.v; }
  friend constexpr bool operator!=(Float a, Float b) { return a.v != b.v; }
  friend constexpr Float operator+(Float a, Float b) { return a.v + b.v; }
  friend constexpr Float operator-(Float a, Float b) { return a.v - b.v; }
  friend constexpr Float operator*(Float a, Float b) { return a.v * b.v; }
  friend constexpr Float operator/(Float a, Float b) { return a.v / b.v; }
  friend constexpr Float operator-(Float a) { return -a.v; }
};

struct vec4;

struct vec3 {
  Float x, y, z;
  vec3() = default;
  explicit vec3(Float a) : x(a), y(a), z(a) {}
  vec3(Float a, Float b, Float c) : x(a), y(b), z(c) {}
  explicit vec3(const vec4& a);
  friend vec3 operator+(const vec3& a, const vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend vec3 operator-(const vec3& a, const vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend vec3 operator*(const vec3& a, const vec3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend vec3 operator*(const vec3& a, Float s) { return {a.x * s, a.y * s, a.z * s}; }
  friend bool operator==(const vec3& a, const vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
  friend vec3 operator-(const vec3& a) { return {-a.x, -a.y, -a.z}; }
  vec3& operator+=(const vec3& a) { return *this = *this + a; }
};

struct vec4 {
  Float x, y, z, w;
  vec4() = default;
  vec4(const vec3& a, Float b) : x(a.x), y(a.y), z(a.z), w(b) {}
};

inline vec3::vec3(const vec4& a) : x(a.x), y(a.y), z(a.z) {}

/// Matrices as rows; only products with a column vector are needed.
struct mat3 {
  vec3 rows[3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
};
struct mat4 {
  Float m[4][4] = {{1.0, 0.0, 0.0, 0.0}, {0.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, 0.0, 1.0}};
};

inline Float dot(const vec3& a, const vec3& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
inline vec3 cross(const vec3& a, const vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Float abs(Float a) {
  return std::abs(a.v);
}
inline Float sqrt(Float a) {
  return std::sqrt(a.v);
}
inline Float pow(Float a, Float b) {
  const bool is_defined = a.v > 0 || (a.v == 0 && b.v > 0);  // GLSL ES 3.00, 8.2
  return is_defined ? std::pow(a.v, b.v) : std::numeric_limits<float>::quiet_NaN();
}
inline vec3 pow(const vec3& a, const vec3& b) {
  return {pow(a.x, b.x), pow(a.y, b.y), pow(a.z, b.z)};
}
inline Float mix(Float a, Float b, Float t) {
  return a * (Float(1.0F) - t) + b * t;
}
inline vec3 mix(const vec3& a, const vec3& b, const vec3& t) {
  return {mix(a.x, b.x, t.x), mix(a.y, b.y, t.y), mix(a.z, b.z, t.z)};
}
inline Float step(Float edge, Float a) {
  return a < edge ? 0.0F : 1.0F;
}
inline vec3 step(const vec3& edge, const vec3& a) {
  return {step(edge.x, a.x), step(edge.y, a.y), step(edge.z, a.z)};
}
inline Float exp2(Float a) {
  return std::exp2(a.v);
}
inline Float min(Float a, Float b) {
  return b < a ? b : a;
}
inline vec3 min(const vec3& a, const vec3& b) {
  return {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)};
}
inline Float max(Float a, Float b) {
  return a < b ? b : a;
}
inline Float clamp(Float a, Float low, Float high) {
  return min(max(a, low), high);
}
inline vec3 clamp(const vec3& a, Float low, Float high) {
  return {clamp(a.x, low, high), clamp(a.y, low, high), clamp(a.z, low, high)};
}
inline Float length(const vec3& a) {
  return sqrt(dot(a, a));
}
inline vec3 normalize(const vec3& a) {
  return a * (Float(1.0F) / length(a));
}
inline vec3 operator*(const mat3& m, const vec3& a) {
  return {dot(m.rows[0], a), dot(m.rows[1], a), dot(m.rows[2], a)};
}
inline vec4 operator*(const mat4& m, const vec4& a) {
  const auto row = [&](int i) { return ((m.m[i][0] * a.x + m.m[i][1] * a.y) + m.m[i][2] * a.z) + m.m[i][3] * a.w; };
  vec4 result;
  result.x = row(0);
  result.y = row(1);
  result.z = row(2);
  result.w = row(3);
  return result;
}

/// What every shader finds around itself.
struct BuiltIns {
  vec4 gl_Position;
  bool gl_FrontFacing = true;
};

}  // namespace glsl
