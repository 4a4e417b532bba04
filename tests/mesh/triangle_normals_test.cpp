// Sums over groups of corners, against the definition written down: one triangle after the other, slivers last.
#include "mesh/triangle_normals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "math/trig.hpp"
#include "mesh/polygon.hpp"

namespace lustro {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Two corners at one place.
bool is_thin(const TriangleCorners& corners, std::size_t t) {
  const auto position = [&](std::size_t k) { return corners.positions[corners.triangles[t][k]]; };
  return position(0) == position(1) || position(1) == position(2) || position(2) == position(0);
}

std::vector<Vec3f> by_definition(const TriangleCorners& corners, VertexNormals weights) {
  std::vector<Vec3d> sums(corners.group_count);
  std::vector<double> totals(corners.group_count, 0.0);
  for (const bool slivers : {false, true}) {
    for (std::size_t t = 0; t < corners.triangles.size(); ++t) {
      const auto position = [&](std::size_t k) { return corners.positions[corners.triangles[t][k]]; };
      if (is_thin(corners, t)) {
        continue;
      }
      const PolygonPlane plane = plane_of(3, position);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t group = corners.groups[t][k];
        if (plane.is_sliver != slivers || (slivers && totals[group] > 0)) {
          continue;
        }
        const Vec3d here = vec_cast<double>(position(k));
        const Vec3d ahead = vec_cast<double>(position((k + 1) % 3)) - here;
        const Vec3d back = vec_cast<double>(position((k + 2) % 3)) - here;
        const double weight = weights == VertexNormals::angle  ? arctangent2(length(cross(ahead, back)), dot(ahead, back))
                              : weights == VertexNormals::area ? plane.area
                                                               : 1;
        sums[group] += plane.normal * weight;
        totals[group] += slivers ? -weight : weight;
      }
    }
  }
  std::vector<Vec3f> normals(corners.group_count);
  for (std::size_t g = 0; g < normals.size(); ++g) {
    const double size = length(sums[g]);
    if (size > 1e-6 * std::abs(totals[g])) {
      normals[g] = vec_cast<float>(Vec3d{sums[g].x / size, sums[g].y / size, sums[g].z / size});
    }
  }
  return normals;
}

TEST(TriangleNormals, AreTheSumsByDefinitionForAnyNumberOfThreads) {
  std::mt19937 engine(41);
  for (const std::size_t count : {std::size_t{1}, std::size_t{63}, std::size_t{300}, std::size_t{40000}}) {
    for (int round = 0; round < 6; ++round) {
      const auto random = [&](std::size_t below) { return static_cast<std::uint32_t>(engine() % below); };
      std::vector<Vec3f> positions(count / 2 + 3);
      for (Vec3f& p : positions) {
        p = {static_cast<float>(random(2000)) / 7, static_cast<float>(random(2000)) / 7,
             round == 5 ? 0.0F : static_cast<float>(random(2000)) / 7};
      }
      std::vector<Triangle> triangles(count);
      std::vector<Triangle> groups(count);
      for (std::size_t t = 0; t < count; ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
          triangles[t][k] = (round % 2 == 0 ? random(positions.size()) : static_cast<std::uint32_t>(t / 2) + random(3)) %
                            static_cast<std::uint32_t>(positions.size());
          groups[t][k] = round < 2 ? triangles[t][k] : 2 * triangles[t][k] + random(2);
        }
        if (random(20) == 0) {
          positions[triangles[t][2]] = (positions[triangles[t][0]] + positions[triangles[t][1]]) * 0.5F;
        }
      }
      const TriangleCorners corners{positions, triangles, groups, 2 * positions.size()};
      const auto weights = static_cast<VertexNormals>(round % 3);
      const std::vector<Vec3f> expected = by_definition(corners, weights);
      bool has_thin = false;
      bool has_flat = false;
      for (std::size_t t = 0; t < count; ++t) {
        const auto position = [&](std::size_t k) { return positions[triangles[t][k]]; };
        has_thin = has_thin || is_thin(corners, t);
        has_flat = has_flat || (!is_thin(corners, t) && plane_of(3, position).area == 0);
      }
      for (const int threads : {1, 2, 3, 7}) {
        const TriangleNormals made = make_triangle_normals(corners, weights, threads);
        ASSERT_EQ(made.normals.size(), expected.size());
        for (std::size_t g = 0; g < expected.size(); ++g) {
          ASSERT_EQ(std::memcmp(&made.normals[g], &expected[g], sizeof(Vec3f)), 0) << g;
        }
        EXPECT_EQ(made.has_thin, has_thin);
        EXPECT_EQ(made.has_flat, has_flat);
        EXPECT_EQ(made.has_zero, std::find(expected.begin(), expected.end(), Vec3f{}) != expected.end());
      }
    }
  }
}

}  // namespace
}  // namespace lustro
