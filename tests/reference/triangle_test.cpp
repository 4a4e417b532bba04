// Projection, clipping, the fill rule, interpolation.
#include "reference/triangle.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "reference/scenes.hpp"
#include "scene/samples.hpp"

namespace lustro {
namespace {

ScreenTriangle screen_triangle(std::array<std::int32_t, 3> x, std::array<std::int32_t, 3> y) {
  ScreenTriangle t;
  t.x = x;
  t.y = y;
  t.area2 = edge_function(x[0], y[0], x[1], y[1], x[2], y[2]);
  if (t.area2 < 0) {
    std::swap(t.x[1], t.x[2]);
    std::swap(t.y[1], t.y[2]);
    t.area2 = -t.area2;
  }
  t.depth_key = {1, 1, 1};
  t.corner_weights = {Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}};
  return t;
}

// Whether a corner is none of the mesh triangle's vertices.
bool is_clipped(const ScreenTriangle& t) {
  return std::any_of(t.corner_weights.begin(), t.corner_weights.end(), [](const Vec3f& w) { return std::max({w.x, w.y, w.z}) < 1; });
}

PreparedScene prepared(const Scene& scene) {
  auto result = prepare(scene);
  EXPECT_TRUE(result) << (result ? "" : result.error().text());
  return *std::move(result);
}

TEST(Triangle, APointOnATopOrLeftEdgeIsInsideOnARightOrBottomEdgeIsNot) {
  const ScreenTriangle lower_left = screen_triangle({0, 0, 256}, {0, 256, 256});   // left and bottom edges, diagonal on its right
  const ScreenTriangle upper_right = screen_triangle({0, 256, 256}, {0, 256, 0});  // top and right edges, the diagonal on its left
  EXPECT_TRUE(covers(lower_left, 0, 128));
  EXPECT_FALSE(covers(lower_left, 128, 256));
  EXPECT_TRUE(covers(upper_right, 128, 0));
  EXPECT_FALSE(covers(upper_right, 256, 128));
  EXPECT_NE(covers(lower_left, 128, 128), covers(upper_right, 128, 128)) << "a point on the shared diagonal belongs to exactly one";
}

TEST(Triangle, AFanAroundAVertexCoversEverySampleExactlyOnce) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    // A closed fan of triangles around a centre that lies on a sample as often as not.
    const std::int32_t cx = 2048 + static_cast<std::int32_t>(random() % 3) * 128;
    const std::int32_t cy = 2048 + static_cast<std::int32_t>(random() % 3) * 128;
    const std::size_t spokes = 4 + random() % 8;  // no gap of half a turn
    std::vector<std::array<std::int32_t, 2>> rim;
    for (std::size_t i = 0; i < spokes; ++i) {
      const double angle = (static_cast<double>(i) + 0.1 * static_cast<double>(random() % 8)) * 6.283185307 / static_cast<double>(spokes);
      rim.push_back({cx + static_cast<std::int32_t>(std::lround(1500 * std::cos(angle)) / 64 * 64),
                     cy + static_cast<std::int32_t>(std::lround(1500 * std::sin(angle)) / 64 * 64)});
    }
    std::vector<ScreenTriangle> fan;
    for (std::size_t i = 0; i < spokes; ++i) {
      const auto& a = rim[i];
      const auto& b = rim[(i + 1) % spokes];
      fan.push_back(screen_triangle({cx, a[0], b[0]}, {cy, a[1], b[1]}));
    }
    for (std::int32_t y = cy - 256; y <= cy + 256; y += 16) {
      for (std::int32_t x = cx - 256; x <= cx + 256; x += 16) {
        int hits = 0;
        for (const ScreenTriangle& t : fan) {
          hits += t.area2 > 0 && covers(t, x, y) ? 1 : 0;
        }
        ASSERT_EQ(hits, 1) << "at " << x << ", " << y << " in round " << round;
      }
    }
  }
}

TEST(Triangle, AMeshCutByNearPlaneAndGuardBandHasNoHolesAndNoDoubleHits) {
  // A wavy floor from behind the eye to far away, so near that it leaves the guard band sideways.
  auto mesh = std::make_shared<Mesh>();
  constexpr std::uint32_t kSide = 12;
  std::mt19937 random(3);
  for (std::uint32_t i = 0; i <= kSide; ++i) {
    for (std::uint32_t j = 0; j <= kSide; ++j) {
      const auto jitter = [&random] { return (static_cast<float>(random() >> 8) * 0x1p-24F - 0.5F) * 0.3F; };
      mesh->positions.push_back(
          {(static_cast<float>(i) - 6) * 400.0F + jitter(), -0.35F + 0.1F * jitter(), (static_cast<float>(j) - 2) * -2.0F + 4.5F + jitter()});
    }
  }
  for (std::uint32_t i = 0; i < kSide; ++i) {
    for (std::uint32_t j = 0; j < kSide; ++j) {
      const std::uint32_t a = i * (kSide + 1) + j;
      mesh->triangles.push_back({a, a + kSide + 1, a + 1});
      mesh->triangles.push_back({a + 1, a + kSide + 1, a + kSide + 2});
    }
  }
  Scene scene = plain_scene(mesh);
  scene.shading.interpolation = Interpolation::flat;
  scene.camera.near = 0.2;
  const PreparedScene p = prepared(scene);
  const auto triangles = setup_triangles(p, 1);
  std::size_t clipped = 0;
  for (const ScreenTriangle& t : triangles) {
    clipped += is_clipped(t) ? 1U : 0U;
    for (std::size_t i = 0; i < 3; ++i) {
      ASSERT_LE(std::abs(t.x[i]), 1 << 23);
      ASSERT_LE(std::abs(t.y[i]), 1 << 23);
    }
  }
  EXPECT_GT(clipped, 3U) << "the test must clip to mean anything";
  const auto hits_at = [&](std::int32_t x, std::int32_t y) {
    int hits = 0;
    for (const ScreenTriangle& t : triangles) {
      hits += covers(t, x, y) ? 1 : 0;
    }
    return hits;
  };
  // The floor is one sheet below the eye: below the horizon (y = 24 pixels) every point is covered once.
  for (std::int32_t y = 30 * 256; y < 48 * 256; y += 32) {
    for (std::int32_t x = 0; x < 64 * 256; x += 32) {
      ASSERT_EQ(hits_at(x, y), 1) << x / 256.0 << ", " << y / 256.0;
    }
  }
}

TEST(Triangle, InterpolationIsPerspectiveCorrectAlsoAfterClipping) {
  // A long triangle that passes behind the eye; its weights at a pixel follow from intersecting the pixel's ray with its plane, in double.
  const std::array<Vec3d, 3> v{Vec3d{-1, -1, 6}, Vec3d{2, -1, 6}, Vec3d{0.3, 0.4, -30}};
  const Scene scene = plain_scene(triangle_mesh(vec_cast<float>(v[0]), vec_cast<float>(v[1]), vec_cast<float>(v[2])));
  const PreparedScene p = prepared(scene);
  const auto triangles = setup_triangles(p, 1);
  ASSERT_TRUE(std::any_of(triangles.begin(), triangles.end(), is_clipped));
  int tested = 0;
  for (const ScreenTriangle& t : triangles) {
    for (std::int32_t y = 0; y < 48; ++y) {
      for (std::int32_t x = 0; x < 64; ++x) {
        if (!covers(t, x * 256 + 128, y * 256 + 128)) {
          continue;
        }
        const Interpolants at = interpolants_at(p.view, t, x * 256 + 128, y * 256 + 128);
        const double f = p.view.pixels_per_unit;
        const Vec3d ray{(x + 0.5 - 32) / f, -(y + 0.5 - 24) / f, -1};
        const Vec3d normal = cross(v[1] - v[0], v[2] - v[0]);
        const double depth = dot(v[0] - Vec3d{0, 0, 4}, normal) / dot(ray, normal);
        const Vec3d hit = Vec3d{0, 0, 4} + ray * depth;
        const double w1 = dot(cross(v[2] - hit, v[0] - hit), normal) / dot(normal, normal);
        const double w2 = dot(cross(v[0] - hit, v[1] - hit), normal) / dot(normal, normal);
        // Corners are snapped to 1/256 pixel: near the horizon that moves the hit; stay where the depth is moderate.
        if (depth < 12) {
          EXPECT_NEAR(static_cast<double>(depth_of(p.view, at.depth_key)), depth, 2e-2 * depth);
          EXPECT_NEAR(static_cast<double>(at.weights.y), w1, 2e-2);
          EXPECT_NEAR(static_cast<double>(at.weights.z), w2, 2e-2);
          ++tested;
        }
        EXPECT_NEAR(static_cast<double>(at.weights.x + at.weights.y + at.weights.z), 1, 1e-5);
      }
    }
  }
  EXPECT_GT(tested, 100);
}

TEST(Triangle, WeightsInsideSliversStayInsideTheTriangle) {
  std::mt19937 random(5);
  Scene scene = plain_scene(triangle_mesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  const PreparedScene p = prepared(scene);
  for (int i = 0; i < 20000; ++i) {
    // Thin triangles, up to 60 pixels long and a few 1/256 pixel wide.
    const auto coordinate = [&random] { return static_cast<std::int32_t>(random() % 16384); };
    const std::int32_t x = coordinate();
    const std::int32_t y = coordinate();
    const std::int32_t x1 = coordinate();
    const std::int32_t y1 = coordinate();
    ScreenTriangle t =
        screen_triangle({x, x1, x1 + static_cast<std::int32_t>(random() % 5) - 2}, {y, y1, y1 + static_cast<std::int32_t>(random() % 5) - 2});
    if (t.area2 == 0) {
      continue;
    }
    t.depth_key = {0.2F, 0.5F, 1.0F};
    const std::int32_t px = (t.x[0] + t.x[1] + t.x[2]) / 3;
    const std::int32_t py = (t.y[0] + t.y[1] + t.y[2]) / 3;
    if (!covers(t, px, py)) {
      continue;
    }
    const Interpolants at = interpolants_at(p.view, t, px, py);
    for (const float w : {at.weights.x, at.weights.y, at.weights.z}) {
      ASSERT_GE(w, -1e-5F);
      ASSERT_LE(w, 1 + 1e-5F);
    }
    ASSERT_GE(at.depth_key, 0.2F * (1 - 1e-6F));
    ASSERT_LE(at.depth_key, 1 + 1e-6F);
  }
}

TEST(Triangle, WindingOnTheImageTellsFrontFromBackAndAMirrorDoesNotChangeIt) {
  Scene scene = plain_scene(triangle_mesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  EXPECT_TRUE(setup_triangles(prepared(scene), 1).at(0).is_front);
  scene.camera.eye = Vec3d{0, 0, -4};
  EXPECT_FALSE(setup_triangles(prepared(scene), 1).at(0).is_front);
  scene.camera.eye = Vec3d{0, 0, 4};
  scene.objects[0].matrix(0, 0) = -1;
  EXPECT_TRUE(setup_triangles(prepared(scene), 1).at(0).is_front) << "a mirrored object keeps its outside";
}

TEST(Triangle, TrianglesOutsideTheImageOrWithoutAreaAreNotDrawn) {
  EXPECT_TRUE(setup_triangles(prepared(plain_scene(triangle_mesh({50, 0, 0}, {51, 0, 0}, {50, 1, 0}))), 1).empty());
  EXPECT_TRUE(setup_triangles(prepared(plain_scene(triangle_mesh({0, 0, 9}, {1, 0, 9}, {0, 1, 9}))), 1).empty()) << "behind the eye";
  EXPECT_TRUE(setup_triangles(prepared(plain_scene(triangle_mesh({0, 0, 0}, {1, 1, 0}, {2, 2, 0}))), 1).empty());
}

TEST(Triangle, SetupKeepsTheOrderOfTrianglesForEveryNumberOfThreads) {
  const PreparedScene p = prepared(rich_scene());
  const auto one = setup_triangles(p, 1);
  const auto many = setup_triangles(p, 3);
  ASSERT_EQ(one.size(), many.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].id, many[i].id);
    EXPECT_EQ(one[i].x, many[i].x);
  }
}

}  // namespace
}  // namespace lustro
