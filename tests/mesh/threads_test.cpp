// The general way to a mesh gives the same bits with any number of threads: polygons, creases, smoothing groups, welding, own indices.
#include <array>
#include <limits>
#include <map>
#include <random>

#include "mesh/build.hpp"
#include "mesh/weld.hpp"
#include "same_bits.hpp"

namespace lustro {
namespace {

/// A bumpy sheet of polygons with three to six corners, large enough for threads to share it.
SourceMesh random_sheet(std::mt19937& engine, bool as_facets, bool only_triangles, unsigned flaws) {
  constexpr std::uint32_t kSide = 180;
  const auto random = [&](std::uint32_t below) { return static_cast<std::uint32_t>(engine()) % below; };
  SourceMesh mesh;
  std::vector<Vec3f> places;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    places.push_back({static_cast<float>(i % kSide), static_cast<float>(i / kSide), static_cast<float>(random(100)) / 40});
    if (random(1000) < flaws) {
      places.back().z = std::numeric_limits<float>::infinity();
    }
  }
  mesh.normals = {{0, 0, 1}, {0, 1, 2}, {3, 0, 0}, {0, 0, 0}};
  const bool has_normals = random(3) == 0;
  const bool has_smoothing = random(2) == 0;
  for (std::uint32_t y = 0; y + 1 < kSide; ++y) {
    for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
      const std::uint32_t a = y * kSide + x;
      std::vector<std::uint32_t> face{a, a + 1, a + kSide + 1, a + kSide};
      if (only_triangles || random(3) == 0) {
        face.pop_back();
      } else if (random(5) == 0) {
        face.insert(face.begin() + 1, a + random(2));
      }
      if (random(1000) < flaws) {
        face[random(3)] = random(kSide * kSide);
      }
      for (const std::uint32_t p : face) {
        mesh.corner_position.push_back(as_facets ? static_cast<std::uint32_t>(mesh.positions.size()) : p);
        if (as_facets) {
          mesh.positions.push_back(places[p]);
        }
        if (has_normals) {
          mesh.corner_normal.push_back(random(4) == 0 ? SourceMesh::kNone : random(4));
        }
      }
      mesh.face_begin.push_back(static_cast<std::uint32_t>(mesh.corner_position.size()));
      if (has_smoothing) {
        mesh.face_smoothing.push_back(random(50) == 0 ? random(3) : 1);
      }
    }
  }
  if (!as_facets) {
    mesh.positions = places;
  }
  mesh.weld_first = as_facets;
  return mesh;
}

TEST(Threads, AnyNumberOfThemBuildsTheSameMesh) {
  std::mt19937 engine(51);
  for (std::uint32_t round = 0; round < 16 && !testing::Test::HasFailure(); ++round) {
    SCOPED_TRACE(round);
    const SourceMesh source = random_sheet(engine, round % 2 == 0, round % 4 >= 2, round % 3 == 0 ? 0 : 5);
    ASSERT_GT(source.face_count(), 31000U);
    const NormalOptions options{.weights = static_cast<VertexNormals>(round % 3), .crease_deg = round % 5 == 0 ? 180.0 : 50.0};
    const auto one = build_general(SourceMesh(source), options, 1);
    ASSERT_TRUE(one.has_value());
    for (const int threads : {2, 3, 7}) {
      const auto many = build_general(SourceMesh(source), options, threads);
      ASSERT_TRUE(many.has_value());
      expect_same(*many, *one);
    }
    expect_same(*build_mesh(source, options), *one);
  }
}

TEST(Threads, WeldingFindsTheFirstOfEqualPositions) {
  std::mt19937 engine(52);
  for (const std::size_t count : {std::size_t{10}, std::size_t{20'000}, std::size_t{300'000}}) {
    std::vector<Vec3f> positions(count);
    for (Vec3f& p : positions) {
      const auto coordinate = [&] { return static_cast<float>(static_cast<int>(engine() % 41) - 20) * (engine() % 2 == 0 ? 0.5F : -0.5F); };
      p = {coordinate(), coordinate(), engine() % 1000 == 0 ? std::numeric_limits<float>::quiet_NaN() : coordinate()};
    }
    std::map<std::array<float, 3>, std::uint32_t> known;
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < count; ++i) {
      const Vec3f& p = positions[i];
      expected.push_back(is_finite(p) ? known.emplace(std::array{p.x + 0.0F, p.y + 0.0F, p.z + 0.0F}, i).first->second : i);
    }
    for (const int threads : {1, 2, 3, 7}) {
      EXPECT_EQ(weld_positions(positions, 0, threads), expected);
    }
  }
}

}  // namespace
}  // namespace lustro
