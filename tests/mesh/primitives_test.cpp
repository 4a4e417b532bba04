// Primitives: their sizes, that they are closed and wound outwards, that they keep what the header says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "lustro/mesh.hpp"
#include "mesh/shapes.hpp"
#include "mesh/validate.hpp"

namespace lustro {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

SourceMesh primitive(std::string_view name) {
  auto source = make_primitive(name);
  EXPECT_TRUE(source.has_value()) << source.error().text();
  return source ? *source : SourceMesh{};
}

Mesh mesh_of(std::string_view name, const NormalOptions& options = {}) {
  auto built = build_mesh(primitive(name), options);
  EXPECT_TRUE(built.has_value());
  EXPECT_THAT(built->notes, IsEmpty()) << name << ": " << built->notes.front().text();
  return built->mesh;
}

using Bits = std::tuple<float, float, float>;
Bits bits(const Vec3f& p) {
  return {p.x, p.y, p.z};
}

/// How many edges have no partner that runs the other way between the very same positions.
std::size_t open_edges(const Mesh& mesh) {
  std::map<std::pair<Bits, Bits>, int> balance;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Bits a = bits(mesh.positions[t[k]]);
      const Bits b = bits(mesh.positions[t[(k + 1) % 3]]);
      balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  return static_cast<std::size_t>(std::count_if(balance.begin(), balance.end(), [](const auto& edge) { return edge.second != 0; }));
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const auto p = [&](std::size_t k) { return vec_cast<double>(mesh.positions[t[k]]); };
    sum += dot(p(0), cross(p(1), p(2))) / 6;
  }
  return sum;
}

std::size_t distinct_positions(const SourceMesh& source) {
  std::set<Bits> positions;
  for (const Vec3f& p : source.positions) {
    positions.insert(bits(p));
  }
  return positions.size();
}

TEST(Primitives, EveryNameIsMadeAndIsAValidSource) {
  EXPECT_THAT(primitive_names(), SizeIs(5));
  for (const std::string_view name : primitive_names()) {
    const SourceMesh source = primitive(name);
    EXPECT_GT(source.face_count(), 0U) << name;
    const auto valid = validate(source);
    ASSERT_TRUE(valid.has_value()) << name << ": " << valid.error().text();
    EXPECT_THAT(valid->notes, IsEmpty()) << name;
    EXPECT_EQ(valid->source.face_count(), source.face_count());
    EXPECT_EQ(distinct_positions(source), source.positions.size()) << name;
  }
}

TEST(Primitives, ClosedOnesHaveNoOpenEdgeAndPositiveVolume) {
  for (const char* name :
       {"cube", "cube:3", "cube:10", "sphere", "sphere:3", "sphere:4", "sphere:5", "sphere:97", "torus", "torus:3", "torus:4", "torus:33"}) {
    const Mesh mesh = mesh_of(name);
    EXPECT_EQ(open_edges(mesh), 0U) << name;
    EXPECT_GT(volume(mesh), 0) << name;
  }
}

TEST(Primitives, VolumesApproachTheSolids) {
  EXPECT_EQ(volume(mesh_of("cube")), 8);
  EXPECT_NEAR(volume(mesh_of("sphere:512")), 4.0 / 3 * M_PI, 1e-3);
  EXPECT_NEAR(volume(mesh_of("torus:512")), 2 * M_PI * M_PI * 0.7 * 0.3 * 0.3, 1e-3);
}

TEST(Primitives, SegmentsAreCountedAsTheHeaderSays) {
  EXPECT_THAT(mesh_of("plane").triangles, SizeIs(2));
  EXPECT_THAT(mesh_of("plane:10").triangles, SizeIs(200));
  EXPECT_THAT(primitive("plane:10").positions, SizeIs(121));
  EXPECT_THAT(mesh_of("cube").triangles, SizeIs(12));
  EXPECT_THAT(primitive("cube").positions, SizeIs(8));
  EXPECT_THAT(mesh_of("cube:3").triangles, SizeIs(108));
  EXPECT_THAT(mesh_of("sphere:12").triangles, SizeIs(12 * (2 * 6 - 2)));
  EXPECT_THAT(primitive("sphere:12").positions, SizeIs(12 * 5 + 2));
  EXPECT_THAT(mesh_of("torus:48").triangles, SizeIs(48 * 24 * 2));
  EXPECT_THAT(mesh_of("sphere:1024").triangles, SizeIs(1024 * (2 * 512 - 2)));
}

TEST(Primitives, SizesAreAsTheHeaderSays) {
  const Bounds plane = mesh_of("plane:3").bounds();
  EXPECT_EQ(plane.lower, (Vec3d{-1, 0, -1}));
  EXPECT_EQ(plane.upper, (Vec3d{1, 0, 1}));
  const Bounds cube = mesh_of("cube").bounds();
  EXPECT_EQ(cube.lower, (Vec3d{-1, -1, -1}));
  EXPECT_EQ(cube.upper, (Vec3d{1, 1, 1}));
  const Bounds sphere = mesh_of("sphere:8").bounds();
  EXPECT_EQ(sphere.lower, (Vec3d{-1, -1, -1}));
  EXPECT_EQ(sphere.upper, (Vec3d{1, 1, 1}));
  const Bounds torus = mesh_of("torus:8").bounds();
  EXPECT_NEAR(torus.upper.x, 1, 1e-7);
  EXPECT_NEAR(torus.upper.y, 0.3, 1e-7);
  EXPECT_NEAR(torus.lower.z, -1, 1e-7);
}

TEST(Primitives, ThePlaneFacesUpAndItsTextureStandsUprightFromTheFront) {
  const Mesh mesh = mesh_of("plane");
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_EQ(mesh.normals[v], (Vec3f{0, 1, 0}));
    EXPECT_EQ(mesh.uvs[v], (Vec2f{(mesh.positions[v].x + 1) / 2, (1 - mesh.positions[v].z) / 2}));
  }
  for (const auto& t : mesh.triangles) {
    EXPECT_GT(cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]).y, 0);
  }
}

TEST(Primitives, TheCubeHasHardEdges) {
  const Mesh mesh = mesh_of("cube");
  ASSERT_THAT(mesh.positions, SizeIs(24));
  for (std::size_t v = 0; v < 24; ++v) {
    EXPECT_EQ(std::abs(mesh.normals[v].x) + std::abs(mesh.normals[v].y) + std::abs(mesh.normals[v].z), 1);
    EXPECT_EQ(dot(mesh.normals[v], mesh.positions[v]), 1);
  }
  const Mesh smooth = mesh_of("cube", {.recompute = true});
  for (std::size_t v = 0; v < smooth.positions.size(); ++v) {
    EXPECT_NEAR(dot(smooth.normals[v], smooth.positions[v]), std::sqrt(3.0), 1e-6);
  }
}

TEST(Primitives, SphereAndTorusHaveTheNormalsOfTheirSurfaces) {
  const Mesh sphere = mesh_of("sphere:24");
  for (std::size_t v = 0; v < sphere.positions.size(); ++v) {
    EXPECT_NEAR(length(sphere.normals[v] - sphere.positions[v]), 0, 1e-7);
    EXPECT_NEAR(length(sphere.positions[v]), 1, 1e-7);
  }
  const Mesh torus = mesh_of("torus:24");
  for (std::size_t v = 0; v < torus.positions.size(); ++v) {
    const Vec3d p = vec_cast<double>(torus.positions[v]);
    const double ring = std::sqrt(p.x * p.x + p.z * p.z);
    const Vec3d center{0.7 * p.x / ring, 0, 0.7 * p.z / ring};
    EXPECT_NEAR(length(vec_cast<double>(torus.normals[v]) - (p - center) * (1 / 0.3)), 0, 1e-6);
  }
}

TEST(Primitives, RecomputedNormalsComeFromTheFacesAndObeyTheCrease) {
  const Mesh smooth = mesh_of("sphere:48", {.recompute = true});
  for (std::size_t v = 0; v < smooth.positions.size(); ++v) {
    EXPECT_NEAR(length(smooth.normals[v] - smooth.positions[v]), 0, 5e-3);
  }
  const Mesh faceted = mesh_of("sphere:8", {.crease_deg = 10, .recompute = true});
  EXPECT_THAT(faceted.positions, SizeIs(8 * 2 * 4 + 8 * 2 * 3));  // every corner of every quad and triangle on its own
}

TEST(Primitives, TexturesOfTheSphereMeetAtTheSeamAndRunEastwards) {
  const Mesh mesh = mesh_of("sphere:16");
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2f& a = mesh.uvs[t[k]];
      const Vec2f& b = mesh.uvs[t[(k + 1) % 3]];
      EXPECT_LE(std::abs(a.x - b.x), 1.0F / 16 + 1e-6F);  // no triangle runs backwards through the whole texture
    }
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_NEAR(mesh.uvs[v].y, 1 - std::acos(static_cast<double>(mesh.positions[v].y)) / M_PI, 1e-6);
    if (std::abs(mesh.positions[v].y) < 0.99F && mesh.uvs[v].x > 0 && mesh.uvs[v].x < 1) {
      EXPECT_NEAR(mesh.uvs[v].x, 0.5 + static_cast<double>(std::atan2(mesh.positions[v].x, mesh.positions[v].z)) / (2 * M_PI), 1e-6);
    }
  }
}

TEST(Primitives, TheTeapotStandsUprightAndIsWoundOutwards) {
  const SourceMesh source = primitive("teapot");
  EXPECT_EQ(source.stated_triangle_count(), 992U);
  EXPECT_THAT(source.positions, SizeIs(529));
  const Mesh mesh = mesh_of("teapot");
  EXPECT_THAT(mesh.triangles, SizeIs(992));
  const Bounds box = mesh.bounds();
  EXPECT_EQ(box.lower.y, 0);
  EXPECT_NEAR(box.upper.y, 3.15, 1e-6);  // Newell's own numbers: 3.15 high, body of radius 2 about the axis, handle to -3
  EXPECT_NEAR(box.lower.x, -3, 1e-6);
  EXPECT_NEAR(box.upper.z, 2, 1e-6);
  EXPECT_NEAR(box.lower.z, -2, 1e-6);
  EXPECT_GT(volume(mesh), 20);
  std::size_t outward = 0;  // of the body, seen from a point within
  std::size_t body = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3f center = (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) * (1.0F / 3);
    const float radius = std::sqrt(center.x * center.x + center.z * center.z);
    if (center.y > 0.2F && center.y < 2.2F && radius > 1.45F && radius < 2.01F && std::abs(center.z) > 0.6F) {
      const Vec3f normal = cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
      ++body;
      outward += dot(normal, center - Vec3f{0, center.y, 0}) > 0 ? 1U : 0U;
    }
  }
  EXPECT_GT(body, 80U);
  EXPECT_EQ(outward, body);
}

TEST(Primitives, WhatIsNotThereIsRefusedWithTheNamesThatAre) {
  const auto unknown = make_primitive("spher");
  ASSERT_FALSE(unknown.has_value());
  EXPECT_EQ(unknown.error().kind, ErrorKind::usage);
  EXPECT_THAT(unknown.error().text(), HasSubstr("`spher`"));
  EXPECT_THAT(unknown.error().text(), HasSubstr("plane, cube, sphere, torus, teapot"));
  for (const char* name : {"sphere:2", "sphere:1025", "sphere:", "sphere:abc", "sphere:12x", "sphere:-4", "sphere: 12", "sphere:99999999999999",
                           "", ":", "teapot:5", "Sphere", "sphere:12:13"}) {
    const auto refused = make_primitive(name);
    ASSERT_FALSE(refused.has_value()) << name;
    EXPECT_EQ(refused.error().kind, ErrorKind::usage) << name;
  }
  EXPECT_THAT(make_primitive("torus:2").error().text(), HasSubstr("3..1024"));
}

}  // namespace
}  // namespace lustro
