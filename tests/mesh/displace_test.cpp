// Displacement: a plane against the formula, what must stay closed, and limits.
#include "mesh/displace.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include "mesh/normals.hpp"

namespace lustro {
namespace {

// A map of size x size texels, one in (u, v) = 0..1.
DisplacementMap map_of(float size, std::function<float(const Vec2f&)> height) {
  return {.texels_from_uv = {size, 0, 0, size}, .height = [height = std::move(height)](const Vec2f& uv, float) { return height(uv); }};
}

Mesh primitive(std::string_view name) {
  return build_mesh(*make_primitive(name))->mesh;
}

// Two triangles over 0..1 in x and z, facing +y, with u = x and v = z.
Mesh quad() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}};
  mesh.normals.assign(4, {0, 1, 0});
  mesh.uvs = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

// Edges, between positions, that do not belong to exactly one triangle in each direction.
std::size_t open_edges(const Mesh& mesh) {
  using Point = std::tuple<float, float, float>;
  std::map<std::pair<Point, Point>, int> count;
  const auto point = [&](std::uint32_t v) {
    const Vec3f& p = mesh.positions[v];
    return Point{p.x + 0.0F, p.y + 0.0F, p.z + 0.0F};
  };
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point a = point(t[i]), b = point(t[(i + 1) % 3]);
      if (a != b) {
        count[{a, b}] += 1;
        count[{b, a}] -= 1;
      }
    }
  }
  return static_cast<std::size_t>(std::count_if(count.begin(), count.end(), [](const auto& edge) { return edge.second != 0; }));
}

// Those that do not lie on the rim of the quad.
std::size_t open_edges_inside(const Mesh& mesh) {
  Mesh inner = mesh;
  for (Vec3f& p : inner.positions) {
    const bool is_rim = p.x == 0 || p.x == 1 || p.z == 0 || p.z == 1;
    p = is_rim ? Vec3f{-1, -1, -1} : p;  // the rim becomes one point, which closes the surface
  }
  return open_edges(inner);
}

float longest_edge(const Mesh& mesh, float size) {
  float longest = 0;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2f a = mesh.uvs[t[i]], b = mesh.uvs[t[(i + 1) % 3]];
      longest = std::max(longest, std::hypot(a.x - b.x, a.y - b.y) * size);
    }
  }
  return longest;
}

TEST(Displace, APlaneBecomesTheGraphOfTheHeights) {
  const auto height = [](const Vec2f& p) { return 0.1F * std::sin(6 * p.x) * std::cos(4 * p.y); };
  const std::array maps{map_of(128, height)};
  const DisplacedMesh result = displaced(quad(), maps);
  EXPECT_EQ(result.note, "");
  EXPECT_LE(longest_edge(result.mesh, 128), 2.0F);
  EXPECT_GE(result.mesh.triangles.size(), 2U * 64 * 64);
  EXPECT_LE(result.mesh.triangles.size(), 2U * 128 * 128);
  for (std::size_t v = 0; v < result.mesh.positions.size(); ++v) {
    const Vec3f& p = result.mesh.positions[v];
    const Vec2f& uv = result.mesh.uvs[v];
    ASSERT_EQ(uv, (Vec2f{p.x, p.z}));
    ASSERT_EQ(p.y, height(uv));
    if (p.x > 0.02F && p.x < 0.98F && p.z > 0.02F && p.z < 0.98F) {  // the rim has triangles on one side only
      const Vec3d truth = normalize(Vec3d{-0.6 * std::cos(6.0 * static_cast<double>(p.x)) * std::cos(4.0 * static_cast<double>(p.z)), 1,
                                          0.4 * std::sin(6.0 * static_cast<double>(p.x)) * std::sin(4.0 * static_cast<double>(p.z))});
      ASSERT_LT(length(vec_cast<double>(result.mesh.normals[v]) - truth), 2e-3);
    }
  }
  double area = 0;  // of the shadow: nothing is covered twice, nothing is left out
  for (const auto& t : result.mesh.triangles) {
    const Vec3f a = result.mesh.positions[t[0]], b = result.mesh.positions[t[1]], c = result.mesh.positions[t[2]];
    const float part = (b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z);
    ASSERT_GT(part, 0);
    area += static_cast<double>(part) / 2;
  }
  EXPECT_NEAR(area, 1, 1e-6);
}

TEST(Displace, WhatVerticesHoldIsCarriedAlong) {
  Mesh mesh = quad();
  mesh.uvs1 = {{0, 0}, {2, 0}, {2, 4}, {0, 4}};
  mesh.tangents.assign(4, {1, 0, 0, -1});
  mesh.colors = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.alphas = {0, 0.5F, 1, 0.5F};
  mesh.triangle_material = {1, 0};
  mesh.materials.resize(2);
  const std::array maps{map_of(16, [](const Vec2f&) { return 1.0F; }), map_of(16, [](const Vec2f&) { return 1.0F; })};
  const Mesh result = displaced(mesh, maps, {.encoded_colors = false}).mesh;
  ASSERT_EQ(result.triangle_material.size(), result.triangles.size());
  ASSERT_EQ(result.materials.size(), 2U);
  for (std::size_t v = 0; v < result.positions.size(); ++v) {
    const Vec3f& p = result.positions[v];
    EXPECT_EQ(p.y, 1.0F);
    EXPECT_EQ(result.normals[v], (Vec3f{0, 1, 0}));
    EXPECT_EQ(result.uvs1[v], (Vec2f{2 * p.z, 4 * p.x}));
    EXPECT_EQ(result.tangents[v], (std::array<float, 4>{1, 0, 0, -1}));
    EXPECT_EQ(result.colors[v], (Vec3f{p.z, p.x, 0}));
    EXPECT_EQ(result.alphas[v], (p.x + p.z) / 2);
  }
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {  // the first triangle has z > x
    const auto& c = result.triangles[t];
    float across = 0;
    for (const std::uint32_t v : c) {
      across += result.positions[v].z - result.positions[v].x;
    }
    EXPECT_EQ(result.triangle_material[t], across > 0 ? 1U : 0U);
  }
  const Mesh encoded = displaced(mesh, maps).mesh;  // the middle of black and white light is 188 of 255
  EXPECT_TRUE(std::any_of(encoded.colors.begin(), encoded.colors.end(), [](const Vec3f& c) { return std::abs(c.x - 0.7354F) < 1e-3F; }));
}

TEST(Displace, AClosedSurfaceStaysClosed) {
  std::mt19937 random(5);
  for (const char* name : {"sphere:9", "cube", "torus:7"}) {  // seams, poles and creases
    Mesh mesh = primitive(name);
    if (mesh.uvs.empty()) {
      for (const Vec3f& p : mesh.positions) {
        mesh.uvs.push_back({p.x + p.z, p.y});
      }
    }
    ASSERT_EQ(open_edges(mesh), 0U) << name;
    for (Vec2f& uv : mesh.uvs) {
      uv = {uv.x * (1 + static_cast<float>(random() % 100) * 0.01F), uv.y};  // both sides of an edge want it differently
    }
    const std::array maps{map_of(40, [](const Vec2f& p) { return 0.2F * std::sin(9 * p.x) + 0.1F * std::cos(17 * p.y); })};
    const Mesh result = displaced(mesh, maps).mesh;
    EXPECT_GT(result.triangles.size(), 4 * mesh.triangles.size()) << name;
    EXPECT_EQ(open_edges(result), 0U) << name;
  }
}

TEST(Displace, EqualHeightsGrowASphereAndKeepItsNormals) {
  const Mesh mesh = primitive("sphere:24");
  ASSERT_FALSE(mesh.uvs.empty());
  const std::array maps{map_of(64, [](const Vec2f&) { return 0.25F; })};
  const Mesh result = displaced(mesh, maps).mesh;
  const std::array flat{map_of(64, [](const Vec2f&) { return 0.0F; })};
  const Mesh still = displaced(mesh, flat).mesh;
  ASSERT_EQ(result.positions.size(), still.positions.size());
  for (std::size_t v = 0; v < result.positions.size(); ++v) {
    EXPECT_LT(length(result.positions[v] - still.positions[v] - still.normals[v] * 0.25F), 2e-6F);
    EXPECT_LT(length(result.normals[v] - still.normals[v]), 0.02F);
    EXPECT_LT(length(still.normals[v] - normalize(still.positions[v])), 0.03F);  // smooth: not those of the facets
  }
}

TEST(Displace, ABorderGoesWithTheMaterialThatHasAMap) {
  Mesh mesh = quad();  // x < z: material 0, with a map; the rest without
  mesh.triangle_material = {0, 1};
  mesh.materials.resize(2);
  const std::array maps{map_of(8, [](const Vec2f&) { return 0.5F; }), DisplacementMap{}};
  const Mesh result = displaced(mesh, maps).mesh;
  EXPECT_GT(result.triangles.size(), 20U);
  bool saw_still = false;
  for (const Vec3f& p : result.positions) {
    EXPECT_EQ(p.y, p.x <= p.z ? 0.5F : 0.0F);
    saw_still = saw_still || p.y == 0;
  }
  EXPECT_TRUE(saw_still);                    // the far corner of the other triangle
  EXPECT_EQ(open_edges_inside(result), 0U);  // no crack along the diagonal
}

TEST(Displace, ASeamMovesByTheMeanOfItsSides) {
  Mesh mesh = quad();  // two triangles that share no vertex along the diagonal, with coordinates of their own
  mesh.positions.insert(mesh.positions.end(), {mesh.positions[0], mesh.positions[2]});
  mesh.normals.resize(6, {0, 1, 0});
  mesh.uvs.insert(mesh.uvs.end(), {{5, 5}, {6, 6}});
  mesh.uvs[3] = {6, 5};
  mesh.triangles = {{0, 1, 2}, {4, 5, 3}};
  const std::array maps{map_of(4, [](const Vec2f& p) { return p.x < 3 ? 1.0F : 2.0F; })};
  const Mesh result = displaced(mesh, maps).mesh;
  for (const Vec3f& p : result.positions) {
    EXPECT_EQ(p.y, p.x == p.z ? 1.5F : (p.x < p.z ? 1.0F : 2.0F));
  }
}

TEST(Displace, ALimitIsKeptAndNoted) {
  float seen = 0;
  const std::array maps{DisplacementMap{.texels_from_uv = {1024, 0, 0, 1024}, .height = [&](const Vec2f&, float spacing) {
                                          seen = spacing;
                                          return 0.0F;
                                        }}};
  const DisplacedMesh result = displaced(quad(), maps, {.most_triangles = 1000, .threads = 1});
  EXPECT_LE(result.mesh.triangles.size(), 1000U);
  EXPECT_GE(result.mesh.triangles.size(), 250U);
  EXPECT_NE(result.note.find("finer ones would take more than 1000 triangles"), std::string::npos) << result.note;
  EXPECT_FLOAT_EQ(seen, longest_edge(result.mesh, 1024) / 2);
  const DisplacedMesh none = displaced(quad(), maps, {.most_triangles = 1, .threads = 1});
  EXPECT_EQ(none.mesh.triangles, quad().triangles);
}

TEST(Displace, NumbersThatAreNoneAreSurvived) {
  Mesh mesh = quad();
  mesh.uvs = {{NAN, 0}, {0, INFINITY}, {3e38F, 1}, {-3e38F, 0}};
  const std::array maps{map_of(64, [](const Vec2f& p) { return p.x; })};
  const Mesh result = displaced(mesh, maps, {.most_triangles = 5000}).mesh;
  for (const Vec3f& p : result.positions) {
    EXPECT_TRUE(is_finite(p));
  }
  Mesh bare;
  bare.triangles = {};
  EXPECT_TRUE(displaced(bare, maps).mesh.triangles.empty());
}

TEST(Displace, ThreadsDoNotMatter) {
  const Mesh mesh = primitive("torus:12");
  Mesh mapped = mesh;
  if (mapped.uvs.empty()) {
    for (const Vec3f& p : mesh.positions) {
      mapped.uvs.push_back({p.x, p.z});
    }
  }
  const std::array maps{map_of(200, [](const Vec2f& p) { return 0.05F * std::sin(20 * p.x + 30 * p.y); })};
  const Mesh one = displaced(mapped, maps, {.threads = 1}).mesh;
  for (const int threads : {2, 3, 7}) {
    const Mesh many = displaced(mapped, maps, {.threads = threads}).mesh;
    EXPECT_EQ(many.positions, one.positions);
    EXPECT_EQ(many.normals, one.normals);
    EXPECT_EQ(many.triangles, one.triangles);
  }
}

}  // namespace
}  // namespace lustro
