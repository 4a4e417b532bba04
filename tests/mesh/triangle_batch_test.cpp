// A batch measures as the functions for one triangle do, bit by bit.
#include "mesh/triangle_batch.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "math/trig.hpp"
#include "mesh/polygon.hpp"

namespace lustro {
namespace {

std::uint64_t bits(double x) {
  return std::bit_cast<std::uint64_t>(x);
}

TEST(TriangleBatch, MeasuresAsOneTriangleIsMeasured) {
  std::mt19937 engine(11);
  for (int round = 0; round < 2000; ++round) {
    TriangleBatch batch{};
    std::array<std::array<Vec3f, 3>, TriangleBatch::kSize> triangles;
    for (std::size_t i = 0; i < TriangleBatch::kSize; ++i) {
      const int spread = static_cast<int>(engine() % 40) - 20;
      const auto coordinate = [&] {
        const auto kind = engine() % 16;
        return kind == 0   ? 0.0F
               : kind == 1 ? -0.0F
                           : std::ldexp(static_cast<float>(static_cast<std::int32_t>(engine()) >> (engine() % 28)), spread - 31);
      };
      for (std::size_t k = 0; k < 3; ++k) {
        triangles[i][k] = engine() % 8 == 0 && k > 0 ? triangles[i][k - 1] : Vec3f{coordinate(), coordinate(), coordinate()};
        if (engine() % 16 == 0 && k == 2) {
          triangles[i][k] = (triangles[i][0] + triangles[i][1]) * 0.5F;
        }
        batch.x[k][i] = static_cast<double>(triangles[i][k].x);
        batch.y[k][i] = static_cast<double>(triangles[i][k].y);
        batch.z[k][i] = static_cast<double>(triangles[i][k].z);
      }
    }
    measure(batch, true);
    for (std::size_t i = 0; i < TriangleBatch::kSize; ++i) {
      const PolygonPlane plane = plane_of(3, [&](std::size_t k) { return triangles[i][k]; });
      ASSERT_EQ(bits(batch.normal_x[i]), bits(plane.normal.x));
      ASSERT_EQ(bits(batch.normal_y[i]), bits(plane.normal.y));
      ASSERT_EQ(bits(batch.normal_z[i]), bits(plane.normal.z));
      ASSERT_EQ(bits(batch.area[i]), bits(plane.area));
      ASSERT_EQ(batch.is_sliver[i] != 0, plane.is_sliver);
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d here = vec_cast<double>(triangles[i][k]);
        const Vec3d ahead = vec_cast<double>(triangles[i][(k + 1) % 3]) - here;
        const Vec3d back = vec_cast<double>(triangles[i][(k + 2) % 3]) - here;
        ASSERT_EQ(bits(batch.angle[k][i]), bits(arctangent2(length(cross(ahead, back)), dot(ahead, back))));
      }
    }
  }
}

}  // namespace
}  // namespace lustro
