// One loop, compiled for several widths of vectors: IEEE + - * / and square roots, in one order and never fused, give the same bits in each.
#include "mesh/triangle_batch.hpp"

#include <cmath>

#include "math/trig.hpp"

#if defined(__x86_64__) && defined(__GNUC__)
#define LUSTRO_HAS_ROWS
#endif

namespace lustro {
namespace {

[[gnu::always_inline]] inline double larger(double a, double b) {
  return a < b ? b : a;
}

/// arctangent_kernel() of math/trig.cpp.
[[gnu::always_inline]] inline double arctangent_kernel(double t) {
  t = t / (1 + std::sqrt(1 + t * t));
  t = t / (1 + std::sqrt(1 + t * t));
  const double z = t * t;
  double sum = 0;
#pragma GCC unroll 12
  for (int k = 23; k >= 1; k -= 2) {
    sum = 1.0 / k - z * sum;
  }
  return 4 * t * sum;
}

/// arctangent2(y, x) for y >= 0, without branches.
[[gnu::always_inline]] inline double angle_of_vector(double y, double x) {
  const double ax = std::abs(x);
  const bool is_flat = y <= ax;
  const double large = is_flat ? ax : y;
  const double small = is_flat ? y : ax;
  double angle = arctangent_kernel(small / (large == 0 ? 1.0 : large));
  angle = is_flat ? angle : kPi / 2 - angle;
  return x < 0 ? kPi - angle : angle;
}

struct Point {
  double x, y, z;
};

[[gnu::always_inline]] inline Point minus(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[gnu::always_inline]] inline Point cross_of(const Point& a, const Point& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[gnu::always_inline]] inline double dot_of(const Point& a, const Point& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
[[gnu::always_inline]] inline Point corner_of(const TriangleBatch& b, std::size_t corner, std::size_t i) {
  return {b.x[corner][i], b.y[corner][i], b.z[corner][i]};
}
[[gnu::always_inline]] inline double largest_of(const Point& p) {
  return larger(larger(std::abs(p.x), std::abs(p.y)), std::abs(p.z));
}

[[gnu::always_inline]] inline void measure_planes(TriangleBatch& batch) {
  for (std::size_t i = 0; i < TriangleBatch::kSize; ++i) {
    const Point p0 = corner_of(batch, 0, i);
    const Point p1 = corner_of(batch, 1, i);
    const Point p2 = corner_of(batch, 2, i);
    const Point a = minus(p1, p0);
    const Point b = minus(p2, p0);
    const Point c = minus(b, a);
    Point sum = cross_of(a, b);
    sum = {sum.x + 0.0, sum.y + 0.0, sum.z + 0.0};  // the sums of plane_of() begin with 0, which makes 0 of -0
    const double largest = larger(larger(largest_of(p0), largest_of(p1)), largest_of(p2));
    const double longest_squared = larger(larger(dot_of(a, a), dot_of(c, c)), dot_of(b, b));
    const double doubled = std::sqrt(dot_of(sum, sum));
    const double divisor = doubled == 0 ? 1.0 : doubled;
    batch.normal_x[i] = sum.x / divisor;
    batch.normal_y[i] = sum.y / divisor;
    batch.normal_z[i] = sum.z / divisor;
    batch.area[i] = doubled / 2;
    batch.is_sliver[i] = doubled <= largest * 0x1p-23 * std::sqrt(longest_squared) ? 1U : 0U;
  }
}

[[gnu::always_inline]] inline void measure_angles(TriangleBatch& batch, std::size_t corner) {
  const std::size_t next = (corner + 1) % 3;
  const std::size_t before = (corner + 2) % 3;
  for (std::size_t i = 0; i < TriangleBatch::kSize; ++i) {
    const Point here = corner_of(batch, corner, i);
    const Point ahead = minus(corner_of(batch, next, i), here);
    const Point back = minus(corner_of(batch, before, i), here);
    const Point turn = cross_of(ahead, back);
    batch.angle[corner][i] = angle_of_vector(std::sqrt(dot_of(turn, turn)), dot_of(ahead, back));
  }
}

[[gnu::always_inline]] inline void measure_all(TriangleBatch& batch, bool with_angles) {
  measure_planes(batch);
  if (with_angles) {
    measure_angles(batch, 0);
    measure_angles(batch, 1);
    measure_angles(batch, 2);
  }
}

#ifdef LUSTRO_HAS_ROWS
[[gnu::target("avx512f,avx512dq,avx512vl")]] void measure_avx512(TriangleBatch& batch, bool with_angles) {
  measure_all(batch, with_angles);
}
[[gnu::target("avx2")]] void measure_avx2(TriangleBatch& batch, bool with_angles) {
  measure_all(batch, with_angles);
}
#endif

}  // namespace

void measure(TriangleBatch& batch, bool with_angles) {
#ifdef LUSTRO_HAS_ROWS
  if (__builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0) {
    measure_avx512(batch, with_angles);
    return;
  }
  if (__builtin_cpu_supports("avx2") != 0) {
    measure_avx2(batch, with_angles);
    return;
  }
#endif
  measure_all(batch, with_angles);
}

}  // namespace lustro
