// Triangulation: known cuts, then properties on random outlines in random planes.
#include "mesh/triangulate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/shapes.hpp"

namespace lustro {
namespace {

using testing::ElementsAre;
using testing::SizeIs;
using Triangle = std::array<std::uint32_t, 3>;

struct Point {
  double x, y;
};
using Outline = std::vector<Point>;

double doubled_area(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double area(const Outline& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& a = outline[i];
    const Point& b = outline[(i + 1) % outline.size()];
    sum += (a.x * b.y - a.y * b.x) / 2;
  }
  return sum;
}

/// How often the outline runs round a point that lies on no edge.
int winding(const Outline& outline, const Point& p) {
  int count = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& a = outline[i];
    const Point& b = outline[(i + 1) % outline.size()];
    if ((a.y <= p.y) != (b.y <= p.y)) {
      const bool left = doubled_area(a, b, p) > 0;
      count += b.y > a.y ? (left ? 1 : 0) : (left ? 0 : -1);
    }
  }
  return count;
}

struct Cut {
  std::vector<Triangle> triangles;
  bool clean = false;
};

Cut cut_flat(const Outline& outline) {
  std::vector<Vec3f> polygon;
  for (const Point& p : outline) {
    polygon.push_back({static_cast<float>(p.x), static_cast<float>(p.y), 0});
  }
  Cut cut;
  cut.clean = Triangulator().cut(polygon, cut.triangles);
  return cut;
}

/// Rounded to floats, so that the test's arithmetic is about the same points as the triangulator's.
Outline to_float(Outline outline) {
  for (Point& p : outline) {
    p = {static_cast<double>(static_cast<float>(p.x)), static_cast<double>(static_cast<float>(p.y))};
  }
  return outline;
}

/// A simple outline must be cut into n - 2 triangles that turn its way, preserve its area and cover every point of it once.
void expect_partition(const Outline& outline, const Cut& cut, std::mt19937& random) {
  ASSERT_THAT(cut.triangles, SizeIs(outline.size() - 2));
  EXPECT_TRUE(cut.clean);
  const double sign = area(outline) < 0 ? -1 : 1;
  double extent = 0;
  for (const Point& p : outline) {
    extent = std::max({extent, std::abs(p.x), std::abs(p.y)});
  }
  double sum = 0;
  for (const Triangle& t : cut.triangles) {
    const double doubled = doubled_area(outline[t[0]], outline[t[1]], outline[t[2]]) * sign;
    EXPECT_GE(doubled, -1e-6 * extent * extent) << t[0] << ' ' << t[1] << ' ' << t[2];
    sum += std::abs(doubled) / 2;
  }
  EXPECT_NEAR(sum, std::abs(area(outline)), 1e-5 * extent * extent);
  int hits = 0;
  for (int k = 0; k < 50; ++k) {
    const Point p{(2 * uniform01(random) - 1) * extent, (2 * uniform01(random) - 1) * extent};
    const auto is_near_an_edge = [&](const Point& a, const Point& b) {
      return std::abs(doubled_area(a, b, p)) < 1e-5 * extent * std::hypot(b.x - a.x, b.y - a.y);
    };
    int covered = 0;
    bool unclear = false;
    for (const Triangle& t : cut.triangles) {
      const Point a = outline[t[0]], b = outline[t[1]], c = outline[t[2]];
      unclear = unclear || is_near_an_edge(a, b) || is_near_an_edge(b, c) || is_near_an_edge(c, a);
      covered += doubled_area(a, b, p) * sign > 0 && doubled_area(b, c, p) * sign > 0 && doubled_area(c, a, p) * sign > 0 ? 1 : 0;
    }
    if (!unclear) {
      ASSERT_EQ(covered, std::abs(winding(outline, p)));
      hits += covered;
    }
  }
  (void)hits;
}

Outline star_shaped(std::size_t n, std::mt19937& random) {
  Outline outline;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * (static_cast<double>(i) + 0.8 * uniform01(random)) / static_cast<double>(n);
    const double radius = 0.1 + 0.9 * uniform01(random);
    outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return outline;
}

/// A band that winds inwards `turns` times.
Outline spiral(std::size_t steps, double turns) {
  Outline outline;
  const auto at = [&](std::size_t i, double shift) {
    const double t = static_cast<double>(i) / static_cast<double>(steps);
    const double radius = 1 - 0.8 * t - shift * 0.15 / turns;
    outline.push_back({radius * std::cos(2 * M_PI * turns * t), radius * std::sin(2 * M_PI * turns * t)});
  };
  for (std::size_t i = 0; i <= steps; ++i) {
    at(i, 0);
  }
  for (std::size_t i = steps + 1; i-- > 0;) {
    at(i, 1);
  }
  return outline;
}

Outline comb(std::size_t teeth) {
  Outline outline{{0, 0}, {static_cast<double>(teeth), 0}};
  for (std::size_t i = teeth; i-- > 0;) {
    outline.push_back({static_cast<double>(i) + 0.9, 5});
    outline.push_back({static_cast<double>(i) + 0.1, 1});
  }
  return outline;
}

TEST(Triangulate, AConvexPolygonBecomesAFanFromItsFirstCorner) {
  EXPECT_THAT(cut_flat({{0, 0}, {1, 0}, {1, 1}, {0, 1}}).triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  EXPECT_THAT(cut_flat({{1, 1}, {0, 1}, {0, 0}, {1, 0}}).triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  EXPECT_THAT(cut_flat({{0, 0}, {0, 1}, {1, 1}, {1, 0}}).triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));  // clockwise
  Outline circle;
  for (int i = 0; i < 300; ++i) {
    circle.push_back({std::cos(i * M_PI / 150), std::sin(i * M_PI / 150)});
  }
  const Cut cut = cut_flat(circle);
  ASSERT_THAT(cut.triangles, SizeIs(298));
  for (std::uint32_t i = 0; i < 298; ++i) {
    EXPECT_EQ(cut.triangles[i], (Triangle{0, i + 1, i + 2}));
  }
}

TEST(Triangulate, AWarpedQuadIsAFanToo) {
  std::vector<Triangle> triangles;
  EXPECT_TRUE(Triangulator().cut(std::vector<Vec3f>{{0, 0, 0.4F}, {1, 0, -0.4F}, {1, 1, 0.4F}, {0, 1, -0.4F}}, triangles));
  EXPECT_THAT(triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
}

TEST(Triangulate, AnArrowheadIsCutAtItsDentWhereverItBegins) {
  const Outline arrow{{0, 0}, {2, -1}, {0, 2}, {-2, -1}};  // corner 0 is the dent
  for (std::size_t shift = 0; shift < 4; ++shift) {
    Outline outline = arrow;
    std::rotate(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(shift), outline.end());
    const auto dent = static_cast<std::uint32_t>((4 - shift) % 4);
    for (const Triangle& t : cut_flat(outline).triangles) {
      EXPECT_THAT(t, testing::Contains(dent)) << shift;  // the diagonal from the dent to the tip, not the one that leaves the polygon
    }
  }
}

TEST(Triangulate, APentagramOrADoubleRoundIsNotTakenForConvex) {
  Outline pentagram;
  Outline twice;  // a limacon with its inner loop: every corner turns left, and yet the edges cross
  for (int i = 0; i < 5; ++i) {
    pentagram.push_back({std::cos(i * 4 * M_PI / 5), std::sin(i * 4 * M_PI / 5)});
  }
  for (int i = 0; i < 24; ++i) {
    const double a = 2 * M_PI * (i + 12.5) / 24;
    twice.push_back({(0.5 + std::cos(a)) * std::cos(a), (0.5 + std::cos(a)) * std::sin(a)});
  }
  EXPECT_FALSE(cut_flat(pentagram).clean);
  EXPECT_THAT(cut_flat(pentagram).triangles, SizeIs(3));
  EXPECT_FALSE(cut_flat(twice).clean);
  EXPECT_THAT(cut_flat(twice).triangles, SizeIs(22));
}

TEST(Triangulate, RandomStarShapedOutlinesArePartitioned) {
  std::mt19937 random(2);
  for (int round = 0; round < 600; ++round) {
    Outline outline = to_float(star_shaped(4 + random() % 60, random));
    if (round % 2 == 1) {
      std::reverse(outline.begin(), outline.end());
    }
    expect_partition(outline, cut_flat(outline), random);
    ASSERT_FALSE(testing::Test::HasFailure()) << "round " << round;
  }
}

TEST(Triangulate, SpiralsAndCombsArePartitioned) {
  std::mt19937 random(3);
  for (const double turns : {1.0, 2.0, 3.5, 5.0, 9.0}) {
    for (const bool reverse : {false, true}) {
      Outline outline = to_float(spiral(static_cast<std::size_t>(24 * turns), turns));
      Outline teeth = to_float(comb(static_cast<std::size_t>(4 * turns)));
      if (reverse) {
        std::reverse(outline.begin(), outline.end());
        std::reverse(teeth.begin(), teeth.end());
      }
      expect_partition(outline, cut_flat(outline), random);
      expect_partition(teeth, cut_flat(teeth), random);
    }
  }
}

TEST(Triangulate, CornersOnStraightEdgesArePartOfTrianglesWithArea) {
  const Outline square{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  for (std::size_t shift = 0; shift < square.size(); ++shift) {
    Outline outline = square;
    std::rotate(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(shift), outline.end());
    const Cut cut = cut_flat(outline);
    EXPECT_TRUE(cut.clean);
    ASSERT_THAT(cut.triangles, SizeIs(6));
    for (const Triangle& t : cut.triangles) {
      EXPECT_GT(doubled_area(outline[t[0]], outline[t[1]], outline[t[2]]), 0.1) << shift;
    }
  }
}

TEST(Triangulate, CornersOnStraightEdgesUpToRoundingAreThatToo) {
  for (int turn = 0; turn < 50; ++turn) {
    const double c = std::cos(turn), s = std::sin(turn);
    Outline outline;
    for (const Point& p : Outline{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}) {
      outline.push_back({10 + c * p.x - s * p.y, s * p.x + c * p.y});
    }
    outline = to_float(outline);
    for (const Triangle& t : cut_flat(outline).triangles) {
      EXPECT_GT(doubled_area(outline[t[0]], outline[t[1]], outline[t[2]]), 0.1) << turn;
    }
  }
}

TEST(Triangulate, AHoleJoinedByABridgeStaysOpen) {
  // The outline, a bridge to the hole, the hole the other way round, and back over the same bridge.
  const Outline keyhole{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};
  std::mt19937 random(4);
  for (std::size_t shift = 0; shift < keyhole.size(); ++shift) {
    for (const bool reverse : {false, true}) {
      Outline outline = keyhole;
      std::rotate(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(shift), outline.end());
      if (reverse) {
        std::reverse(outline.begin(), outline.end());
      }
      expect_partition(outline, cut_flat(outline), random);
    }
  }
}

TEST(Triangulate, ManyRandomHolesOnBridgesStayOpen) {
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round) {
    const std::size_t holes = 1 + random() % 5;
    Outline outline{{0, 0}};
    // Holes side by side; each hangs on the bottom edge by a vertical bridge.
    for (std::size_t h = 0; h < holes; ++h) {
      const double x = 2 * static_cast<double>(h) + 1;
      Outline hole = star_shaped(3 + random() % 9, random);
      const auto lowest = std::min_element(hole.begin(), hole.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
      std::rotate(hole.begin(), lowest, hole.end());
      std::reverse(hole.begin() + 1, hole.end());
      const Point foot{x + hole[0].x, 0};
      outline.push_back(foot);
      for (std::size_t i = 0; i <= hole.size(); ++i) {
        outline.push_back({x + hole[i % hole.size()].x, 2 + hole[i % hole.size()].y});
      }
      outline.push_back(foot);
    }
    outline.push_back({2 * static_cast<double>(holes), 0});
    outline.push_back({2 * static_cast<double>(holes), 4});
    outline.push_back({0, 4});
    outline = to_float(outline);
    expect_partition(outline, cut_flat(outline), random);
    ASSERT_FALSE(testing::Test::HasFailure()) << "round " << round;
  }
}

TEST(Triangulate, TheCutDoesNotDependOnThePlane) {
  std::mt19937 random(6);
  for (int round = 0; round < 200; ++round) {
    const Outline outline = to_float(star_shaped(4 + random() % 30, random));
    Vec3d u{2 * uniform01(random) - 1, 2 * uniform01(random) - 1, 2 * uniform01(random) - 1};
    Vec3d v{2 * uniform01(random) - 1, 2 * uniform01(random) - 1, 2 * uniform01(random) - 1};
    u = normalize(u);
    v = normalize(cross(cross(u, v), u));
    std::vector<Vec3f> polygon;
    for (const Point& p : outline) {
      polygon.push_back(vec_cast<float>(u * p.x + v * p.y + Vec3d{3, -2, 1}));
    }
    Cut cut;
    cut.clean = Triangulator().cut(polygon, cut.triangles);
    expect_partition(outline, cut, random);
  }
}

TEST(Triangulate, AnythingAtAllEndsWithNMinus2TrianglesThatSumToTheSignedArea) {
  std::mt19937 random(7);
  for (int round = 0; round < 400; ++round) {
    const std::size_t n = 4 + random() % 40;
    const bool on_a_grid = round % 2 == 0;  // many coincident and collinear corners
    Outline outline;
    for (std::size_t i = 0; i < n; ++i) {
      outline.push_back(on_a_grid ? Point{static_cast<double>(random() % 4), static_cast<double>(random() % 4)}
                                  : Point{uniform01(random), uniform01(random)});
    }
    outline = to_float(outline);
    const Cut cut = cut_flat(outline);
    ASSERT_THAT(cut.triangles, SizeIs(n - 2));
    double sum = 0;
    for (const Triangle& t : cut.triangles) {
      EXPECT_LT(std::max({t[0], t[1], t[2]}), n);
      sum += doubled_area(outline[t[0]], outline[t[1]], outline[t[2]]) / 2;
    }
    EXPECT_NEAR(sum, area(outline), 1e-5) << round;
  }
}

TEST(Triangulate, ABowtieAndALineEndAndTheBowtieIsNamed) {
  EXPECT_FALSE(cut_flat({{0, 0}, {2, 2}, {2, 0}, {0, 2}}).clean);
  EXPECT_THAT(cut_flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}}).triangles, SizeIs(3));
  EXPECT_THAT(cut_flat({{0, 0}, {0, 0}, {0, 0}, {0, 0}}).triangles, SizeIs(2));
}

TEST(Triangulate, ADentThatPiercesTheOtherSideIsNamedThoughTheOutlineTurnsOnce) {
  for (std::size_t shift = 0; shift < 6; ++shift) {
    Outline outline{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {2.5, -2}, {0, 4}};
    std::rotate(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(shift), outline.end());
    EXPECT_FALSE(cut_flat(outline).clean) << shift;
  }
}

TEST(Triangulate, ARingThatRunsOverItsOwnBeginningIsNamed) {
  Outline ring;
  for (int i = 0; i <= 40; ++i) {
    ring.push_back({std::cos(i * M_PI / 18.3), std::sin(i * M_PI / 18.3)});
  }
  for (int i = 40; i >= 0; --i) {
    ring.push_back({0.8 * std::cos(i * M_PI / 18.3), 0.8 * std::sin(i * M_PI / 18.3)});
  }
  EXPECT_FALSE(cut_flat(ring).clean);
  ring = Outline(ring.begin() + 6, ring.end() - 6);  // the same ring short of a full round
  EXPECT_TRUE(cut_flat(ring).clean);
}

TEST(Triangulate, AKnotOfManyCornersEndsInTime) {  // without a limit of work this takes cubic time
  std::mt19937 random(8);
  Outline knot;
  for (int i = 0; i < 5000; ++i) {
    knot.push_back({uniform01(random), uniform01(random)});
  }
  const Cut cut = cut_flat(knot);
  EXPECT_THAT(cut.triangles, SizeIs(4998));
  EXPECT_FALSE(cut.clean);
}

TEST(Triangulate, ALongCoastlineIsCutWithoutGivingUp) {
  std::mt19937 random(9);
  const Outline coast = to_float(star_shaped(20000, random));
  EXPECT_TRUE(cut_flat(coast).clean);
  EXPECT_TRUE(cut_flat(to_float(spiral(4000, 10))).clean);
}

TEST(Triangulate, FacesOfAMeshKeepTheirOrderAndNameTheirFace) {
  const SourceMesh source = polygons({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 2, 3}, {0, 2, 3}});
  const Triangles triangles = triangulate(source);
  EXPECT_THAT(triangles.corners, ElementsAre(Triangle{0, 1, 2}, Triangle{3, 4, 5}, Triangle{3, 5, 6}, Triangle{7, 8, 9}));
  EXPECT_THAT(triangles.face, ElementsAre(0, 1, 1, 2));
  EXPECT_EQ(triangles.crossing_polygons, 0U);
}

}  // namespace
}  // namespace lustro
