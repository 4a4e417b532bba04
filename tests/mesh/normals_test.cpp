// Vertex normals: values from paper, properties, creases and smoothing groups, messy input.
#include "mesh/normals.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "mesh/shapes.hpp"

namespace lustro {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

constexpr auto kWeights = {VertexNormals::uniform, VertexNormals::area, VertexNormals::angle};

CornerNormals normals_of(const SourceMesh& s, const NormalOptions& options = {}) {
  return make_normals({s.positions, s.face_begin, s.corner_position, s.face_smoothing}, options);
}

/// The normal of face f's corner at a position.
Vec3f normal_at(const SourceMesh& s, const CornerNormals& normals, std::uint32_t face, std::uint32_t position) {
  for (std::uint32_t c = s.face_begin[face]; c < s.face_begin[face + 1]; ++c) {
    if (s.corner_position[c] == position) {
      return normals.normals[normals.corner_normal[c]];
    }
  }
  ADD_FAILURE() << "face " << face << " has no corner at position " << position;
  return {};
}

void expect_near(const Vec3f& found, const Vec3d& expected, double tolerance = 1e-6) {
  EXPECT_NEAR(length(vec_cast<double>(found) - expected), 0, tolerance)
      << found.x << ' ' << found.y << ' ' << found.z << " instead of " << expected.x << ' ' << expected.y << ' ' << expected.z;
}

/// An icosahedron whose triangles are cut in four `levels` times, on the unit sphere.
SourceMesh icosphere(int levels) {
  const float g = (1 + std::sqrt(5.0F)) / 2;
  SourceMesh s =
      polygons({{-1, g, 0},
                {1, g, 0},
                {-1, -g, 0},
                {1, -g, 0},
                {0, -1, g},
                {0, 1, g},
                {0, -1, -g},
                {0, 1, -g},
                {g, 0, -1},
                {g, 0, 1},
                {-g, 0, -1},
                {-g, 0, 1}},
               {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                {3, 9, 4},  {3, 4, 2}, {3, 2, 6}, {3, 6, 8},  {3, 8, 9},   {4, 9, 5}, {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}});
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
    const auto between = [&](std::uint32_t a, std::uint32_t b) {
      const auto [place, is_new] = middle.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(s.positions.size()));
      if (is_new) {
        s.positions.push_back((s.positions[a] + s.positions[b]) * 0.5F);
      }
      return place->second;
    };
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::size_t f = 0; f < s.face_count(); ++f) {
      const std::uint32_t a = s.corner_position[3 * f], b = s.corner_position[3 * f + 1], c = s.corner_position[3 * f + 2];
      const std::uint32_t ab = between(a, b), bc = between(b, c), ca = between(c, a);
      faces.insert(faces.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    s = polygons(s.positions, faces);
  }
  for (Vec3f& p : s.positions) {
    p = normalize(p);
  }
  return s;
}

/// A random rotation: three axes.
std::array<Vec3d, 3> rotation(std::mt19937& random) {
  const auto axis = [&] { return Vec3d{2 * uniform01(random) - 1, 2 * uniform01(random) - 1, 2 * uniform01(random) - 1}; };
  const Vec3d x = normalize(axis());
  const Vec3d z = normalize(cross(x, axis()));
  return {x, cross(z, x), z};
}
Vec3d rotate(const std::array<Vec3d, 3>& axes, const Vec3d& v) {
  return axes[0] * v.x + axes[1] * v.y + axes[2] * v.z;
}

/// A bumpy sphere of quads and triangles; nothing symmetric about it.
SourceMesh bumpy(std::mt19937& random) {
  SourceMesh s = icosphere(2);
  for (Vec3f& p : s.positions) {
    p = p * static_cast<float>(0.7 + 0.6 * uniform01(random));
  }
  return s;
}

TEST(Normals, OfATetrahedronPointAwayFromTheCenterWhateverTheWeights) {
  const SourceMesh s = polygons({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
  for (const auto weights : kWeights) {
    const CornerNormals normals = normals_of(s, {.weights = weights});
    for (std::uint32_t c = 0; c < 12; ++c) {
      expect_near(normals.normals[normals.corner_normal[c]], normalize(vec_cast<double>(s.positions[s.corner_position[c]])));
    }
  }
}

// Two faces meet at position 0: a right triangle with legs 1 in the xy plane (normal z), and one with an angle of 45 degrees at position 0
// in the xz plane (normal -y, area 2 x its height).
TEST(Normals, EachWeightIsTheOneItIsNamedAfter) {
  const SourceMesh s = polygons({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {4, 0, 4}}, {{0, 1, 2}, {0, 1, 3}});  // the second turns to -y, area 2
  expect_near(normal_at(s, normals_of(s, {.weights = VertexNormals::uniform}), 0, 0), normalize(Vec3d{0, -1, 1}));
  expect_near(normal_at(s, normals_of(s, {.weights = VertexNormals::area}), 0, 0), normalize(Vec3d{0, -2, 0.5}));
  expect_near(normal_at(s, normals_of(s, {.weights = VertexNormals::angle}), 0, 0), normalize(Vec3d{0, -45, 90}));
  expect_near(normal_at(s, normals_of(s, {.weights = VertexNormals::angle}), 0, 2), {0, 0, 1});
}

TEST(Normals, APolygonIsOneFaceWhateverItsTriangles) {
  // A square of side 1 and, standing on its edge, a square of height 2: areas 1 and 2, one face each, right angles.
  const SourceMesh s = polygons({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 2}, {1, 0, 2}}, {{0, 1, 2, 3}, {1, 0, 4, 5}});
  expect_near(normal_at(s, normals_of(s, {.weights = VertexNormals::uniform}), 0, 0), normalize(Vec3d{0, 1, 1}));
  expect_near(normal_at(s, normals_of(s, {.weights = VertexNormals::area}), 0, 0), normalize(Vec3d{0, 2, 1}));
  expect_near(normal_at(s, normals_of(s, {.weights = VertexNormals::angle}), 0, 0), normalize(Vec3d{0, 1, 1}));
}

TEST(Normals, ADentInAPolygonCountsItsReflexAngle) {
  // An L with its dent at position 3 (270 degrees inside) and a wall on one of the dent's edges (90 degrees).
  const SourceMesh s =
      polygons({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {1, 1, 1}, {2, 1, 1}}, {{0, 1, 2, 3, 4, 5}, {3, 2, 7, 6}});
  expect_near(normal_at(s, normals_of(s), 0, 3), normalize(Vec3d{0, -90, 270}));
}

TEST(Normals, OfAnIcosphereAreNearlyRadial) {
  for (const auto weights : kWeights) {
    const SourceMesh s = icosphere(3);
    const CornerNormals normals = normals_of(s, {.weights = weights});
    for (std::size_t c = 0; c < s.corner_position.size(); ++c) {
      expect_near(normals.normals[normals.corner_normal[c]], vec_cast<double>(s.positions[s.corner_position[c]]), 0.02);
    }
  }
}

TEST(Normals, TurnWithTheMesh) {
  std::mt19937 random(11);
  for (const auto weights : kWeights) {
    for (const double crease : {180.0, 30.0}) {
      const SourceMesh s = bumpy(random);
      SourceMesh turned = s;
      const auto axes = rotation(random);
      for (Vec3f& p : turned.positions) {
        p = vec_cast<float>(rotate(axes, vec_cast<double>(p)));
      }
      const CornerNormals a = normals_of(s, {.weights = weights, .crease_deg = crease});
      const CornerNormals b = normals_of(turned, {.weights = weights, .crease_deg = crease});
      ASSERT_EQ(a.corner_normal, b.corner_normal);  // the same sharing
      for (std::size_t i = 0; i < a.normals.size(); ++i) {
        expect_near(b.normals[i], rotate(axes, vec_cast<double>(a.normals[i])), 1e-5);
      }
    }
  }
}

TEST(Normals, DoNotDependOnTheOrderOfTheFacesNorOnTheFirstCorner) {
  std::mt19937 random(12);
  for (const auto weights : kWeights) {
    for (const double crease : {180.0, 35.0}) {
      const SourceMesh s = bumpy(random);
      std::vector<std::uint32_t> order(s.face_count());
      std::iota(order.begin(), order.end(), 0U);
      std::shuffle(order.begin(), order.end(), random);
      std::vector<std::vector<std::uint32_t>> faces;
      for (const std::uint32_t f : order) {
        const std::uint32_t* c = s.corner_position.data() + 3 * f;
        faces.push_back({c[f % 3], c[(f + 1) % 3], c[(f + 2) % 3]});
      }
      const SourceMesh shuffled = polygons(s.positions, faces);
      const CornerNormals a = normals_of(s, {.weights = weights, .crease_deg = crease});
      const CornerNormals b = normals_of(shuffled, {.weights = weights, .crease_deg = crease});
      for (std::uint32_t f = 0; f < order.size(); ++f) {
        for (const std::uint32_t position : faces[f]) {
          expect_near(normal_at(shuffled, b, f, position), vec_cast<double>(normal_at(s, a, order[f], position)), 2e-7);
        }
      }
    }
  }
}

TEST(Normals, AreUnitVectors) {
  std::mt19937 random(13);
  SourceMesh s = bumpy(random);
  for (Vec3f& p : s.positions) {
    p = p * 1e-15F + Vec3f{0, 0, 0};
  }
  for (const Vec3f& n : normals_of(s, {.crease_deg = 20}).normals) {
    EXPECT_NEAR(length(n), 1, 2e-7);
  }
}

TEST(Crease, SharingPassesOnFromNeighbourToNeighbour) {
  // Eight sides of a drum, 45 degrees from each to the next, around a vertical edge row; and its lid.
  SourceMesh s;
  std::vector<std::vector<std::uint32_t>> faces;
  std::vector<std::uint32_t> lid;
  for (std::uint32_t i = 0; i < 8; ++i) {
    const double a = 2 * M_PI * i / 8;
    s.positions.push_back({static_cast<float>(std::cos(a)), 0, static_cast<float>(-std::sin(a))});
    s.positions.push_back({static_cast<float>(std::cos(a)), 1, static_cast<float>(-std::sin(a))});
    faces.push_back({2 * i, (2 * i + 2) % 16, (2 * i + 3) % 16, 2 * i + 1});
    lid.push_back(2 * i + 1);
  }
  faces.push_back(lid);
  s = polygons(s.positions, faces);
  const CornerNormals at_45 = normals_of(s, {.crease_deg = 45});  // exactly the angle between two sides: they share
  const CornerNormals at_44 = normals_of(s, {.crease_deg = 44.9});
  const CornerNormals at_90 = normals_of(s, {.crease_deg = 90});
  expect_near(normal_at(s, at_45, 0, 3), {std::sqrt(0.5), 0, -std::sqrt(0.5)});
  expect_near(normal_at(s, at_45, 8, 3), {0, 1, 0});
  expect_near(normal_at(s, at_44, 0, 3), {std::cos(M_PI / 8), 0, -std::sin(M_PI / 8)});
  EXPECT_GT(normal_at(s, at_90, 0, 3).y, 0.1F);
  EXPECT_EQ(normal_at(s, at_90, 0, 3), normal_at(s, at_90, 8, 3));
}

TEST(Crease, RoundingDoesNotPartFacesAtExactlyTheCreaseAngle) {
  for (const std::uint32_t sides : {9U, 12U, 36U, 45U}) {
    SourceMesh s;
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double a = 2 * M_PI * i / sides;
      s.positions.push_back({static_cast<float>(0.7 * std::cos(a)), 0, static_cast<float>(-0.7 * std::sin(a))});
      s.positions.push_back({static_cast<float>(0.7 * std::cos(a)), 1, static_cast<float>(-0.7 * std::sin(a))});
      faces.push_back({2 * i, (2 * i + 2) % (2 * sides), (2 * i + 3) % (2 * sides), 2 * i + 1});
    }
    s = polygons(s.positions, faces);
    EXPECT_THAT(normals_of(s, {.crease_deg = 360.0 / sides}).normals, SizeIs(2 * sides));
    EXPECT_THAT(normals_of(s, {.crease_deg = 360.0 / sides - 0.05}).normals, SizeIs(4 * sides));
  }
}

TEST(Crease, FacesThatOnlyTouchInAPointDoNotShare) {
  // Two triangles in one plane, point to point.
  const SourceMesh s = polygons({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1F}, {-1, 0, 0}, {-1, -1, 0.1F}}, {{0, 1, 2}, {0, 3, 4}});
  const CornerNormals creased = normals_of(s, {.crease_deg = 179});
  EXPECT_NE(normal_at(s, creased, 0, 0), normal_at(s, creased, 1, 0));
  const CornerNormals smooth = normals_of(s, {.crease_deg = 180});
  EXPECT_EQ(normal_at(s, smooth, 0, 0), normal_at(s, smooth, 1, 0));
}

TEST(Crease, AConeKeepsItsSideSmoothAndItsRimSharp) {
  SourceMesh s;
  s.positions = {{0, 0.5F, 0}};
  std::vector<std::vector<std::uint32_t>> faces;
  std::vector<std::uint32_t> base;
  constexpr std::uint32_t kSides = 32;
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const double a = 2 * M_PI * i / kSides;
    s.positions.push_back({static_cast<float>(std::cos(a)), 0, static_cast<float>(-std::sin(a))});
    faces.push_back({0, 1 + i, 1 + (i + 1) % kSides});
    base.push_back(kSides - i);
  }
  faces.push_back(base);
  s = polygons(s.positions, faces);
  const CornerNormals normals = normals_of(s, {.crease_deg = 60});
  EXPECT_EQ(normal_at(s, normals, kSides, 5), (Vec3f{0, -1, 0}));
  EXPECT_GT(normal_at(s, normals, 4, 5).y, 0.5F);
  expect_near(normal_at(s, normals, 4, 0), {0, 1, 0}, 1e-6);  // all sides share the tip
}

TEST(SmoothingGroups, FacesShareWithinTheirGroupOnly) {
  SourceMesh s = cube_of_quads();  // -x +x -y +y -z +z
  s.face_smoothing = {1, 1, 1, 2, 2, 0};
  const CornerNormals normals = normals_of(s, {.weights = VertexNormals::uniform});
  // Position 0 = (-1, -1, -1) touches -x, -y (group 1) and -z (group 2).
  expect_near(normal_at(s, normals, 0, 0), normalize(Vec3d{-1, -1, 0}));
  expect_near(normal_at(s, normals, 2, 0), normalize(Vec3d{-1, -1, 0}));
  expect_near(normal_at(s, normals, 4, 0), {0, 0, -1});
  // Position 2 = (-1, 1, -1): -x (1), +y and -z (2).
  expect_near(normal_at(s, normals, 3, 2), normalize(Vec3d{0, 1, -1}));
  expect_near(normal_at(s, normals, 0, 2), {-1, 0, 0});
  // Face +z is off.
  for (const std::uint32_t position : {4U, 5U, 6U, 7U}) {
    EXPECT_EQ(normal_at(s, normals, 5, position), (Vec3f{0, 0, 1}));
  }
}

TEST(SmoothingGroups, OffFacesKeepTheirOwnNormalsEvenBesideEachOther) {
  SourceMesh s = cube_of_quads();
  s.face_smoothing.assign(6, 0);
  const CornerNormals normals = normals_of(s);
  for (std::uint32_t f = 0; f < 6; ++f) {
    for (std::uint32_t c = 4 * f; c < 4 * f + 4; ++c) {
      const Vec3f n = normals.normals[normals.corner_normal[c]];
      EXPECT_EQ(std::abs(n.x) + std::abs(n.y) + std::abs(n.z), 1);
      EXPECT_EQ(dot(n, s.positions[s.corner_position[c]]), 1);
    }
  }
}

TEST(SmoothingGroups, TheCreasePartsFacesOfOneGroupToo) {
  SourceMesh s = cube_of_quads();
  s.face_smoothing.assign(6, 4);
  EXPECT_EQ(normal_at(s, normals_of(s, {.crease_deg = 80}), 0, 0), (Vec3f{-1, 0, 0}));
  expect_near(normal_at(s, normals_of(s, {.crease_deg = 100}), 0, 0), normalize(Vec3d{-1, -1, -1}));
  s.face_smoothing = {1, 2, 3, 4, 5, 6};
  EXPECT_EQ(normal_at(s, normals_of(s, {.crease_deg = 100}), 0, 0), (Vec3f{-1, 0, 0}));
}

TEST(Messy, FacesThatCancelKeepTheirOwnNormals) {
  const SourceMesh s = polygons({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});  // one triangle, drawn from both sides
  for (const auto weights : kWeights) {
    const CornerNormals normals = normals_of(s, {.weights = weights});
    for (const std::uint32_t p : {0U, 1U, 2U}) {
      EXPECT_EQ(normal_at(s, normals, 0, p), (Vec3f{0, 0, 1}));
      EXPECT_EQ(normal_at(s, normals, 1, p), (Vec3f{0, 0, -1}));
    }
  }
}

TEST(Messy, ACreasePartsNeighboursWoundAgainstEachOther) {
  const SourceMesh s = polygons({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 3, 2}});  // the second is turned over
  const CornerNormals normals = normals_of(s, {.crease_deg = 90});
  EXPECT_EQ(normal_at(s, normals, 0, 0), (Vec3f{0, 0, 1}));
  EXPECT_EQ(normal_at(s, normals, 1, 0), (Vec3f{0, 0, -1}));
}

TEST(Messy, ASliverDoesNotSpoilItsNeighbours) {
  // A slightly bent roof; position 4 lies on the ridge between 0 and 1 (a cap without area fills the gap), up to float rounding.
  for (const float lift : {0.0F, 3e-8F}) {
    const SourceMesh s =
        polygons({{0, 0, 0}, {1, 1, 1}, {1, 0, 0}, {0, 1, 0.2F}, {0.3F, 0.3F, 0.3F + lift}}, {{0, 1, 3}, {0, 4, 1}, {0, 2, 4}, {4, 2, 1}});
    for (const auto weights : kWeights) {
      const Vec3d sides[] = {normalize(cross(Vec3d{1, 1, 1}, Vec3d{0, 1, 0.2})), normalize(cross(Vec3d{1, 0, 0}, Vec3d{1, 1, 1}))};
      const CornerNormals smooth = normals_of(s, {.weights = weights});
      const Vec3f at_ridge = normal_at(s, smooth, 2, 0);
      EXPECT_GT(dot(vec_cast<double>(at_ridge), sides[0]), 0.5);
      EXPECT_GT(dot(vec_cast<double>(at_ridge), sides[1]), 0.5);
      expect_near(normal_at(s, smooth, 2, 4), sides[1], 1e-5);  // only the cap and the plane side touch position 4
      const CornerNormals sharp = normals_of(s, {.weights = weights, .crease_deg = 20});
      expect_near(normal_at(s, sharp, 0, 0), sides[0], 1e-5);  // the cap does not join what the crease parts
      expect_near(normal_at(s, sharp, 2, 0), sides[1], 1e-5);
      const CornerNormals joined = normals_of(s, {.weights = weights, .crease_deg = 100});
      expect_near(normal_at(s, joined, 2, 0), vec_cast<double>(at_ridge), 1e-5);  // and does not part what the crease joins
      expect_near(normal_at(s, joined, 1, 0), vec_cast<double>(at_ridge), 1e-5);
    }
  }
}

TEST(Messy, ManySliversAroundOnePositionDoNotJoinWhatTheCreaseParts) {
  // Twenty roofs that share their first corner alone, each with a cap on its ridge.
  std::vector<Vec3f> positions{{0, 0, 0}};
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t i = 0; i < 20; ++i) {
    const float x = static_cast<float>(std::cos(i)), y = static_cast<float>(std::sin(i));
    const std::uint32_t ridge = 1 + 4 * i, middle = ridge + 1, top = ridge + 2, side = ridge + 3;
    positions.insert(positions.end(), {{x, y, 0}, {x / 2, y / 2, 0}, {x, y, 1}, {x + y, y - x, 0}});
    faces.insert(faces.end(), {{0, ridge, top}, {0, middle, ridge}, {0, side, middle}, {middle, side, ridge}});
  }
  const SourceMesh s = polygons(positions, faces);
  const CornerNormals normals = normals_of(s, {.crease_deg = 40});
  for (std::uint32_t i = 0; i < 20; ++i) {
    EXPECT_NEAR(normal_at(s, normals, 4 * i, 0).z, 0, 1e-6) << i;
    EXPECT_NEAR(normal_at(s, normals, 4 * i + 2, 0).z, 1, 1e-6) << i;
  }
}

TEST(Messy, WhatIsLeftOfACancelledSumIsNotTakenForANormal) {
  // A tilted plane around position 0, once from its front in five triangles and once from its back in seven.
  std::vector<Vec3f> positions{{0.1F, 0.2F, 0.3F}};
  std::vector<std::vector<std::uint32_t>> faces;
  for (const std::uint32_t sides : {5U, 7U}) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double a = 2 * M_PI * i / sides;
      const Vec3d p = Vec3d{0.6, 0.8, 0} * std::cos(a) + Vec3d{-0.48, 0.36, 0.8} * std::sin(a);
      positions.push_back(positions[0] + vec_cast<float>(p));
      const std::uint32_t next = first + (i + 1) % sides;
      faces.push_back(sides == 5 ? std::vector<std::uint32_t>{0, first + i, next} : std::vector<std::uint32_t>{0, next, first + i});
    }
  }
  const SourceMesh s = polygons(positions, faces);
  const Vec3d front = cross(Vec3d{0.6, 0.8, 0}, Vec3d{-0.48, 0.36, 0.8});
  for (std::uint32_t f = 0; f < 12; ++f) {
    expect_near(normal_at(s, normals_of(s), f, 0), f < 5 ? front : -front, 1e-5);
  }
}

TEST(Messy, APolygonWhoseHalvesCancelHasTheNormalOfItsFirstHalf) {
  const SourceMesh s = polygons({{0, 0, 0}, {2, 0, 2}, {2, 0, 0}, {0, 0, 2}}, {{0, 1, 2, 3}});
  for (const Vec3f& n : {normal_at(s, normals_of(s), 0, 0), normal_at(s, normals_of(s), 0, 3)}) {
    EXPECT_EQ(n, (Vec3f{0, 1, 0}));
  }
}

TEST(Messy, SliversAloneStillHaveUnitNormals) {
  const SourceMesh s = polygons({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1e-9F, 0}, {5, 5, 5}}, {{0, 1, 2}, {0, 2, 3}});
  const CornerNormals normals = normals_of(s);
  for (const std::uint32_t n : normals.corner_normal) {
    EXPECT_NEAR(length(normals.normals[n]), 1, 1e-6);
  }
  expect_near(normal_at(s, normals, 1, 3), {0, 0, 1});
}

TEST(Messy, ManyFacesOnOneEdgeOrOneCornerTakeLinearTime) {
  constexpr std::uint32_t kFaces = 200000;
  SourceMesh s;
  s.positions = {{0, 0, 0}, {0, 0, 1}};
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t i = 0; i < kFaces; ++i) {
    s.positions.push_back({static_cast<float>(std::cos(i)), static_cast<float>(std::sin(i)), 0});
    faces.push_back({0, 1, i + 2});
  }
  s = polygons(s.positions, faces);
  s.face_smoothing.assign(kFaces, 3);
  const CornerNormals normals = normals_of(s, {.crease_deg = 1});  // quadratic work would take minutes
  EXPECT_THAT(normals.corner_normal, SizeIs(3 * kFaces));
}

TEST(WithVertexNormals, KeepsVerticesAndAppendsCopiesWhereFacesDoNotShare) {
  Mesh mesh;
  mesh.positions = cube_corners();
  mesh.positions.push_back({7, 7, 7});  // not used
  for (const Vec3f& p : mesh.positions) {
    mesh.uvs.push_back({p.x, p.y});
    mesh.colors.push_back(p);
  }
  const SourceMesh cube = cube_of_triangles();
  for (std::size_t f = 0; f < 12; ++f) {
    mesh.triangles.push_back({cube.corner_position[3 * f], cube.corner_position[3 * f + 1], cube.corner_position[3 * f + 2]});
  }
  const Mesh smooth = with_vertex_normals(mesh, {});
  EXPECT_EQ(smooth.positions, mesh.positions);
  EXPECT_EQ(smooth.triangles, mesh.triangles);
  for (std::size_t v = 0; v < 8; ++v) {
    expect_near(smooth.normals[v], normalize(vec_cast<double>(mesh.positions[v])));
  }
  EXPECT_EQ(smooth.normals[8], (Vec3f{0, 0, 1}));

  const Mesh sharp = with_vertex_normals(mesh, {.crease_deg = 30});
  ASSERT_THAT(sharp.positions, SizeIs(25));
  ASSERT_THAT(sharp.normals, SizeIs(25));
  ASSERT_THAT(sharp.uvs, SizeIs(25));
  ASSERT_THAT(sharp.colors, SizeIs(25));
  EXPECT_TRUE(std::equal(mesh.positions.begin(), mesh.positions.end(), sharp.positions.begin()));
  for (std::size_t t = 0; t < 12; ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = sharp.triangles[t][k];
      EXPECT_EQ(sharp.positions[v], mesh.positions[mesh.triangles[t][k]]);
      EXPECT_EQ(sharp.colors[v], sharp.positions[v]);
      EXPECT_EQ(sharp.uvs[v], (Vec2f{sharp.positions[v].x, sharp.positions[v].y}));
      EXPECT_EQ(dot(sharp.normals[v], sharp.positions[v]), 1);
    }
  }
}

TEST(WithVertexNormals, LeavesNormalsThatAreThereUnlessAskedForOthers) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals = {{1, 0, 0}, {0, 1, 0}, {1, 0, 0}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(with_vertex_normals(mesh, {}).normals, mesh.normals);
  EXPECT_THAT(with_vertex_normals(mesh, {.recompute = true}).normals, ElementsAre(Vec3f{0, 0, 1}, Vec3f{0, 0, 1}, Vec3f{0, 0, 1}));
}

}  // namespace
}  // namespace lustro
