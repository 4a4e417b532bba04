// MikkTSpace: known simple cases, and the properties that its description promises.
#include "mesh/tangents.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

namespace lustro {
namespace {

using Tangent = std::array<float, 4>;

/// A square of -1..1 in x and y facing +z, u to the right; v goes down, as in glTF.
Mesh square() {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// A bumpy sheet of n x n squares with coordinates that are not parallel to its edges.
Mesh sheet(std::uint32_t n, unsigned seed) {
  std::mt19937 random(seed);
  const auto noise = [&] { return static_cast<float>(random() >> 8) * 0x1p-24F - 0.5F; };
  Mesh mesh;
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x) {
      mesh.positions.push_back({static_cast<float>(x) + 0.3F * noise(), static_cast<float>(y) + 0.3F * noise(), noise()});
      mesh.normals.push_back(normalize(Vec3f{noise(), noise(), 2}));
      mesh.uvs.push_back({static_cast<float>(x) + 0.5F * static_cast<float>(y) + 0.2F * noise(), static_cast<float>(y) + 0.2F * noise()});
    }
  }
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t v = y * (n + 1) + x;
      mesh.triangles.push_back({v, v + 1, v + n + 2});
      mesh.triangles.push_back({v, v + n + 2, v + n + 1});
    }
  }
  return mesh;
}

Tangent at(const Mesh& mesh, std::size_t triangle, std::size_t corner) {
  return mesh.tangents[mesh.triangles[triangle][corner]];
}

void expect_near(const Tangent& a, const Tangent& b, float tolerance = 1e-6F) {
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(a[i], b[i], tolerance) << i;
  }
}

TEST(Tangents, OfASquarePointAlongUAndTheBitangentUpThePicture) {
  const Mesh mesh = with_tangents(square());
  EXPECT_EQ(mesh.positions.size(), 4U);
  EXPECT_EQ(mesh.triangles, square().triangles);
  for (const Tangent& t : mesh.tangents) {
    EXPECT_EQ(t, (Tangent{1, 0, 0, 1}));  // cross((0, 0, 1), (1, 0, 0)) = (0, 1, 0), the picture's top
  }
}

TEST(Tangents, AMirroredPictureHasTheOtherHandedness) {
  Mesh mesh = square();
  for (Vec2f& uv : mesh.uvs) {
    uv.x = 1 - uv.x;
  }
  for (const Tangent& t : with_tangents(mesh).tangents) {
    EXPECT_EQ(t, (Tangent{-1, 0, 0, -1}));  // -cross((0, 0, 1), (-1, 0, 0)) = (0, 1, 0)
  }
}

TEST(Tangents, FollowTheMatrixThatLaysThePictureOnTheMesh) {
  Mesh up = square();
  for (Vec2f& uv : up.uvs) {
    uv.y = 1 - uv.y;  // OBJ: v goes up, and the map's matrix turns it round
  }
  for (const Tangent& t : with_tangents(up, {.uv_matrix = {1, 0, 0, -1}}).tangents) {
    EXPECT_EQ(t, (Tangent{1, 0, 0, 1}));
  }
  for (const Tangent& t : with_tangents(square(), {.uv_matrix = {0, 1, -1, 0}}).tangents) {
    EXPECT_EQ(t, (Tangent{0, -1, 0, 1}));  // u' = v grows downwards, v' = -u: up the picture is to the right
  }
  Mesh second = square();
  second.uvs1 = second.uvs;
  for (Vec2f& uv : second.uvs1) {
    uv.x = -uv.x;
  }
  EXPECT_EQ(with_tangents(second, {.uv_set = 1}).tangents[0], (Tangent{-1, 0, 0, -1}));
}

TEST(Tangents, AreThoseOfTheMathematicsOnASphere) {
  // u is the longitude: the tangent points east. Away from the poles and the seam.
  Mesh mesh;
  constexpr std::uint32_t kColumns = 64, kRows = 32;
  for (std::uint32_t r = 0; r <= kRows; ++r) {
    for (std::uint32_t c = 0; c <= kColumns; ++c) {
      const float u = static_cast<float>(c) / kColumns, v = static_cast<float>(r) / kRows;
      const float a = u * 6.2831853F, b = v * 3.1415927F;
      mesh.positions.push_back({std::sin(b) * std::cos(a), std::cos(b), -std::sin(b) * std::sin(a)});
      mesh.normals.push_back(normalize(mesh.positions.back()));
      mesh.uvs.push_back({u, v});
    }
  }
  for (std::uint32_t r = 0; r < kRows; ++r) {
    for (std::uint32_t c = 0; c < kColumns; ++c) {
      const std::uint32_t v = r * (kColumns + 1) + c;
      mesh.triangles.push_back({v, v + kColumns + 1, v + kColumns + 2});
      mesh.triangles.push_back({v, v + kColumns + 2, v + 1});
    }
  }
  const Mesh result = with_tangents(mesh);
  EXPECT_EQ(result.positions.size(), mesh.positions.size());
  for (std::uint32_t r = 4; r < kRows - 3; ++r) {
    for (std::uint32_t c = 1; c < kColumns; ++c) {
      const std::size_t v = r * (kColumns + 1) + c;
      const float a = static_cast<float>(c) / kColumns * 6.2831853F;
      expect_near(result.tangents[v], {-std::sin(a), 0, -std::cos(a), 1}, 0.02F);
    }
  }
}

TEST(Tangents, AreUnitAndAtRightAnglesToTheirNormals) {
  const Mesh mesh = with_tangents(sheet(12, 1));
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3f t{mesh.tangents[v][0], mesh.tangents[v][1], mesh.tangents[v][2]};
    EXPECT_NEAR(length(t), 1, 1e-6F);
    EXPECT_NEAR(dot(t, mesh.normals[v]), 0, 1e-6F);
    EXPECT_EQ(std::abs(mesh.tangents[v][3]), 1);
  }
}

TEST(Tangents, AVertexAveragesItsTrianglesByTheirAngles) {
  // Around the origin: one triangle with an angle of 90 degrees whose u runs along x, one of 45 degrees whose u runs along (1, 1).
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 1, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.uvs = {{0, 0}, {1, 0}, {0, -1}, {-1, -2}};
  const Mesh result = with_tangents(mesh);
  // Second triangle, t up: (s, t) = (0, 0), (0, 1), (-1, 2); d1 = (0, 1), d2 = (-1, 1): along u = (d1 2 - d2 1) = (1, 1) / sqrt(2).
  const double first = 3.14159265358979 / 2, second = 3.14159265358979 / 4;
  const Vec3d sum = normalize(Vec3d{first + second * std::sqrt(0.5), second * std::sqrt(0.5), 0});
  expect_near(at(result, 0, 0), {static_cast<float>(sum.x), static_cast<float>(sum.y), 0, 1});
  expect_near(at(result, 0, 1), {1, 0, 0, 1});
}

TEST(Tangents, DoNotDependOnTheOrderOfTriangles) {
  const Mesh mesh = sheet(9, 2);
  const Mesh straight = with_tangents(mesh);
  std::mt19937 random(3);
  for (int round = 0; round < 5; ++round) {
    std::vector<std::size_t> order(mesh.triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = order.size(); i > 1; --i) {
      std::swap(order[i - 1], order[random() % i]);
    }
    Mesh shuffled = mesh;
    for (std::size_t t = 0; t < order.size(); ++t) {
      shuffled.triangles[t] = mesh.triangles[order[t]];
    }
    const Mesh result = with_tangents(shuffled);
    for (std::size_t t = 0; t < order.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_EQ(at(result, t, i), at(straight, order[t], i));
      }
    }
  }
}

TEST(Tangents, DoNotDependOnHowVerticesAreShared) {
  const Mesh mesh = sheet(5, 4);
  Mesh loose;  // every corner its own vertex
  for (const auto& triangle : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(loose.positions.size());
    for (const std::uint32_t v : triangle) {
      loose.positions.push_back(mesh.positions[v]);
      loose.normals.push_back(mesh.normals[v]);
      loose.uvs.push_back(mesh.uvs[v]);
    }
    loose.triangles.push_back({first, first + 1, first + 2});
  }
  const Mesh shared = with_tangents(mesh), alone = with_tangents(loose);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      ASSERT_EQ(at(shared, t, i), at(alone, t, i));
    }
  }
}

TEST(Tangents, AtASeamOfMirroredCoordinatesAVertexIsThereTwice) {
  // Two squares side by side, u mirrored at x = 1: |1 - x|.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  mesh.normals.assign(6, {0, 0, 1});
  mesh.uvs = {{1, 1}, {0, 1}, {1, 1}, {1, 0}, {0, 0}, {1, 0}};
  mesh.colors.assign(6, {0.5F, 0.5F, 0.5F});
  mesh.uvs1.assign(6, {0.25F, 0.75F});
  mesh.alphas.assign(6, 0.5F);
  mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
  const Mesh result = with_tangents(mesh);
  EXPECT_EQ(result.positions.size(), 8U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(at(result, 0, i), (Tangent{-1, 0, 0, -1}));
    EXPECT_EQ(at(result, 1, i), (Tangent{-1, 0, 0, -1}));
    EXPECT_EQ(at(result, 2, i), (Tangent{1, 0, 0, 1}));
    EXPECT_EQ(at(result, 3, i), (Tangent{1, 0, 0, 1}));
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(result.positions[result.triangles[t][i]], mesh.positions[mesh.triangles[t][i]]);
      EXPECT_EQ(result.uvs[result.triangles[t][i]], mesh.uvs[mesh.triangles[t][i]]);
    }
  }
  EXPECT_EQ(result.colors.size(), 8U);
  EXPECT_EQ(result.uvs1.size(), 8U);
  EXPECT_EQ(result.alphas.size(), 8U);
  EXPECT_EQ(result.normals.size(), 8U);
}

TEST(Tangents, TrianglesThatTouchInAVertexAloneDoNotShareATangent) {
  Mesh mesh = square();  // and one more that shares vertex 2 only, turned a quarter in its coordinates
  mesh.positions.insert(mesh.positions.end(), {{2, 1, 0}, {2, 2, 0}});
  mesh.normals.resize(6, {0, 0, 1});
  mesh.uvs.insert(mesh.uvs.end(), {{1, -1}, {2, -1}});  // u along y
  mesh.triangles.push_back({2, 4, 5});
  const Mesh result = with_tangents(mesh);
  expect_near(at(result, 0, 2), {1, 0, 0, 1});
  EXPECT_NE(at(result, 2, 0), at(result, 0, 2));
}

TEST(Tangents, ATriangleWithoutAnAreaInThePictureTakesItsNeighboursTangents) {
  Mesh mesh = square();
  mesh.positions.push_back({2, 0, 0});
  mesh.normals.push_back({0, 0, 1});
  mesh.uvs.push_back({1, 0.5F});  // on the edge from vertex 1 to vertex 2
  mesh.triangles.push_back({1, 4, 2});
  for (const bool is_mirrored : {false, true}) {
    for (Vec2f& uv : mesh.uvs) {
      uv = is_mirrored ? Vec2f{-uv.x, uv.y} : Vec2f{uv.y, -uv.x};  // a quarter turn, and that mirrored
    }
    const Mesh result = with_tangents(mesh);
    const Tangent expected = is_mirrored ? Tangent{0, 1, 0, -1} : Tangent{0, -1, 0, 1};
    EXPECT_EQ(at(result, 0, 1), expected);
    EXPECT_EQ(at(result, 2, 0), expected);
    EXPECT_EQ(at(result, 2, 2), expected);
    EXPECT_EQ(at(result, 2, 1), (Tangent{1, 0, 0, 1}));  // of no group: the default
    EXPECT_EQ(result.positions.size(), 5U);
  }
}

TEST(Tangents, ATriangleWithTwoCornersAtOnePlaceTakesPartInNothing) {
  Mesh mesh = square();
  for (Vec2f& uv : mesh.uvs) {
    uv.x = -uv.x;
  }
  const Mesh before = with_tangents(mesh);
  mesh.triangles.push_back({0, 0, 2});
  mesh.triangles.insert(mesh.triangles.begin(), {3, 1, 1});
  const Mesh result = with_tangents(mesh);
  EXPECT_EQ(result.positions.size(), 4U);
  EXPECT_EQ(result.tangents, before.tangents);
}

TEST(Tangents, AMeshWithoutCoordinatesOrNormalsComesBackAsItIs) {
  Mesh mesh = square();
  mesh.uvs.clear();
  EXPECT_TRUE(with_tangents(mesh).tangents.empty());
  mesh = square();
  mesh.normals.clear();
  EXPECT_TRUE(with_tangents(mesh).tangents.empty());
  EXPECT_TRUE(with_tangents(square(), {.uv_set = 1}).tangents.empty());
}

TEST(Tangents, AnyNumbersGiveFiniteTangents) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const std::array<float, 9> wild{std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity, 3e38F, -3e38F, 1e-45F, 0, 1, -1};
  std::mt19937 random(5);
  for (int round = 0; round < 300; ++round) {
    Mesh mesh = sheet(3, static_cast<unsigned>(round));
    const auto pick = [&] { return wild[random() % wild.size()]; };
    for (Vec2f& uv : mesh.uvs) {
      uv = random() % 2 == 0 ? uv : Vec2f{pick(), pick()};
    }
    for (Vec3f& n : mesh.normals) {
      n = random() % 8 != 0 ? n : Vec3f{pick(), pick(), pick()};
    }
    for (Vec3f& p : mesh.positions) {
      p = random() % 8 != 0 ? p : Vec3f{3e38F, -3e38F, 1e-45F};
    }
    for (const Tangent& t : with_tangents(mesh).tangents) {
      ASSERT_NEAR(t[0] * t[0] + t[1] * t[1] + t[2] * t[2], 1, 1e-5F);
      ASSERT_EQ(std::abs(t[3]), 1);
    }
  }
}

}  // namespace
}  // namespace lustro
