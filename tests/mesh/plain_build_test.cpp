// The plain way makes of every mesh what the general way makes of it, bit by bit, with any number of threads.
#include <cmath>
#include <limits>
#include <random>

#include "mesh/build.hpp"
#include "mesh/plain_mesh.hpp"
#include "same_bits.hpp"

namespace lustro {
namespace {

/// Triangles over a bumpy sheet of n x n places, with what real files have wrong with them at a rate of `flaws` in a thousand.
PlainMesh random_mesh(std::mt19937& engine, std::uint32_t n, unsigned flaws) {
  const auto random = [&](std::uint32_t below) { return static_cast<std::uint32_t>(engine()) % below; };
  const auto is_flawed = [&] { return random(1000) < flaws; };
  const auto real = [&] { return static_cast<float>(random(20001)) / 10000.0F - 1.0F; };
  const auto nan = std::numeric_limits<float>::quiet_NaN();
  PlainMesh mesh;
  for (std::uint32_t i = 0; i < n * n; ++i) {
    Vec3f p{static_cast<float>(i % n), static_cast<float>(i / n), real()};
    if (is_flawed()) {
      p = random(2) == 0 ? Vec3f{p.x, nan, p.z} : Vec3f{p.x, p.y, std::numeric_limits<float>::infinity()};
    }
    if (is_flawed() && i > 0) {
      p = mesh.positions[random(i)];  // two vertices at one place
    }
    mesh.positions.push_back(p);
  }
  const auto fill = [&](auto& list, const auto& make) {
    if (random(2) == 0) {
      for (std::uint32_t i = 0; i < n * n; ++i) {
        list.push_back(make());
      }
    }
  };
  fill(mesh.normals, [&] { return is_flawed() ? (random(2) == 0 ? Vec3f{} : Vec3f{0, nan, 1}) : Vec3f{real(), real(), 3}; });
  fill(mesh.uvs, [&] { return is_flawed() ? Vec2f{nan, 0} : Vec2f{real(), real()}; });
  fill(mesh.colors, [&] { return is_flawed() ? Vec3f{0, 0, nan} : Vec3f{real(), real(), real()}; });
  for (std::uint32_t y = 0; y + 1 < n; ++y) {
    for (std::uint32_t x = 0; x + 1 < n; ++x) {
      const std::uint32_t a = y * n + x;
      for (std::array<std::uint32_t, 3> t : {std::array{a, a + 1, a + n}, std::array{a + 1, a + n + 1, a + n}}) {
        if (is_flawed()) {
          t = {random(n * n), random(n * n), random(n * n)};
        }
        if (is_flawed()) {
          std::swap(t[0], t[1]);
        }
        mesh.triangles.push_back(t);
        if (is_flawed()) {
          mesh.triangles.push_back({t[0], t[2], t[1]});  // the same again from behind: normals cancel
        }
        if (is_flawed()) {
          mesh.triangles.push_back({a, a, t[2]});
        }
      }
    }
  }
  for (std::size_t i = 0; flaws != 0 && i < mesh.positions.size() / 50; ++i) {  // collinear: slivers and triangles without area
    const std::uint32_t a = random(n * n);
    const std::uint32_t b = random(n * n);
    const std::uint32_t c = random(n * n);
    mesh.positions[c] = (mesh.positions[a] + mesh.positions[b]) * 0.5F;
    mesh.triangles.push_back({a, b, c});
  }
  if (random(2) == 0) {
    mesh.materials.resize(3);
    mesh.materials[1].name = "second";
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const std::uint32_t material = random(4);
      mesh.materials_of.push_back(material == 3 ? SourceMesh::kNone : material);
    }
  }
  if (random(2) == 0) {  // no locality at all
    std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), engine);
  }
  return mesh;
}

void expect_both_ways_agree(const PlainMesh& mesh, const NormalOptions& options) {
  const auto general = build_general(to_source(mesh), options, 1);
  ASSERT_TRUE(general.has_value());
  for (const int threads : {1, 2, 3, 7}) {
    SCOPED_TRACE(threads);
    expect_same(build_plain(mesh, options, threads), *general);
  }
}

TEST(PlainBuild, EqualsTheGeneralWayOnSmallMeshes) {
  std::mt19937 engine(5);
  for (std::uint32_t round = 0; round < 300 && !testing::Test::HasFailure(); ++round) {
    SCOPED_TRACE(round);
    const PlainMesh mesh = random_mesh(engine, 2 + round % 9, round % 3 == 0 ? 0 : round % 3 == 1 ? 30 : 300);
    expect_both_ways_agree(mesh, {.weights = static_cast<VertexNormals>(round % 3), .crease_deg = 180, .recompute = round % 5 == 0});
  }
}

TEST(PlainBuild, EqualsTheGeneralWayWhereThreadsShareTheWork) {
  std::mt19937 engine(6);
  for (std::uint32_t round = 0; round < 12 && !testing::Test::HasFailure(); ++round) {
    SCOPED_TRACE(round);
    const PlainMesh mesh = random_mesh(engine, 260, round % 3 == 0 ? 0 : 2);
    ASSERT_GT(mesh.triangles.size(), 4 * 16384U);
    expect_both_ways_agree(mesh, {.weights = static_cast<VertexNormals>(round % 3), .crease_deg = 180, .recompute = round % 4 == 0});
  }
}

TEST(PlainBuild, AMeshGoesThroughTheGeneralFormAndBack) {
  std::mt19937 engine(7);
  for (int round = 0; round < 20; ++round) {
    const PlainMesh mesh = random_mesh(engine, 8, 20);
    SourceMesh source = to_source(mesh);
    const auto back = to_plain(source, {}, 1);
    ASSERT_TRUE(back.has_value());
    expect_same(to_source(*back), to_source(mesh));
  }
}

TEST(PlainBuild, WhatIsNotPlainIsLeftToTheGeneralWay) {
  const auto is_plain = [](const auto& change, const NormalOptions& options = {}) {
    SourceMesh source;
    source.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    source.corner_position = {0, 1, 2, 0, 2, 3};
    source.face_begin = {0, 3, 6};
    change(source);
    return to_plain(source, options, 1).has_value();
  };
  EXPECT_TRUE(is_plain([](SourceMesh&) {}));
  EXPECT_TRUE(is_plain([](SourceMesh& s) { s.face_smoothing = {7, 7}; }));
  EXPECT_FALSE(is_plain([](SourceMesh& s) { s.face_smoothing = {7, 8}; }));
  EXPECT_FALSE(is_plain([](SourceMesh& s) { s.face_smoothing = {0, 0}; }));
  EXPECT_FALSE(is_plain([](SourceMesh&) {}, {.crease_deg = 90}));
  EXPECT_FALSE(is_plain([](SourceMesh& s) { s.face_begin = {0, 2, 6}; }));
  EXPECT_FALSE(is_plain([](SourceMesh& s) { s.face_begin = {0, 6}; }));
  EXPECT_FALSE(is_plain([](SourceMesh& s) { s.weld_first = true; }));
  EXPECT_FALSE(is_plain([](SourceMesh& s) { s.face_colors = {{1, 1, 1}, {0, 0, 0}}; }));
  const auto with_normals = [](std::vector<std::uint32_t> corners, std::size_t count) {
    return [corners = std::move(corners), count](SourceMesh& s) {
      s.normals.resize(count, {0, 0, 1});
      s.corner_normal = corners;
    };
  };
  EXPECT_TRUE(is_plain(with_normals({0, 1, 2, 0, 2, 3}, 4)));
  EXPECT_FALSE(is_plain(with_normals({0, 1, 2, 0, 2, 3}, 5)));
  EXPECT_FALSE(is_plain(with_normals({0, 1, 2, 0, 2, 2}, 4)));
  EXPECT_FALSE(is_plain(with_normals({0, 1, 2, 0, 2, SourceMesh::kNone}, 4)));
}

}  // namespace
}  // namespace lustro
