// Interpolated normals: the weighted sum, and the spherical average against the sin formula on edges and against a brute-force minimisation
// inside.
#include "shade/interpolation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace lustro {
namespace {

using Corners = std::array<Vec3f, 3>;
constexpr Vec3f kFallback{0, 0, 1};

class RandomNormals {
 public:
  explicit RandomNormals(std::uint32_t seed) : bits_(seed) {}

  double unit() { return static_cast<double>(bits_()) * 0x1p-32; }

  Vec3d direction() {
    for (;;) {
      const Vec3d v{2 * unit() - 1, 2 * unit() - 1, 2 * unit() - 1};
      if (const double l = dot(v, v); l < 1 && l > 1e-3) {
        return normalize(v);
      }
    }
  }

  /// Three unit normals; no two are more than `spread` degrees apart.
  Corners corners(double spread) {
    const double cosine = std::cos(spread * kPi / 180);
    for (;;) {
      const std::array<Vec3d, 3> n{direction(), direction(), direction()};
      if (std::min({dot(n[0], n[1]), dot(n[1], n[2]), dot(n[2], n[0])}) > cosine) {
        return {vec_cast<float>(n[0]), vec_cast<float>(n[1]), vec_cast<float>(n[2])};
      }
    }
  }

  Weights<float> weights() {
    double a = unit();
    double b = unit();
    if (a + b > 1) {
      a = 1 - a;
      b = 1 - b;
    }
    return {static_cast<float>(1 - a - b), static_cast<float>(a), static_cast<float>(b)};
  }

 private:
  std::mt19937 bits_;
};

double distance_between(const Vec3f& a, const Vec3d& b) {
  return length(vec_cast<double>(a) - b);
}

double angle(const Vec3d& a, const Vec3d& b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

/// The classic formula on an arc.
Vec3d sin_formula(const Vec3f& from, const Vec3f& to, double t) {
  const Vec3d n0 = normalize(vec_cast<double>(from));
  const Vec3d n1 = normalize(vec_cast<double>(to));
  const double a = angle(n0, n1);
  return (std::sin((1 - t) * a) * n0 + std::sin(t * a) * n1) * (1 / std::sin(a));
}

/// The minimum of sum w_i angle^2 by walking downhill with ever smaller steps: no derivative, no cleverness, nothing shared with the code.
Vec3d least_squared_angles(const Corners& corners, const Weights<float>& w) {
  std::array<Vec3d, 3> n;
  Vec3d q;
  for (std::size_t i = 0; i < 3; ++i) {
    n[i] = normalize(vec_cast<double>(corners[i]));
    q += n[i] * static_cast<double>(w[i]);
  }
  q = normalize(q);
  const auto cost = [&](const Vec3d& at) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += static_cast<double>(w[i]) * angle(at, n[i]) * angle(at, n[i]);
    }
    return sum;
  };
  const Vec3d u = normalize(cross(q, std::abs(q.x) < 0.7 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
  const Vec3d v = cross(q, u);
  double best = cost(q);
  for (double step = 0.25; step > 1e-9;) {
    const Vec3d before = q;
    for (const Vec3d& way : {u, v, -u, -v, u + v, u - v, v - u, -u - v}) {
      const Vec3d tried = normalize(q + way * step);
      if (const double c = cost(tried); c < best) {
        best = c;
        q = tried;
      }
    }
    step = q == before ? step / 2 : step;
  }
  return q;
}

// --- lerp -------------------------------------------------------------------------------------------------------------------------

TEST(LerpNormal, IsTheNormalizedWeightedSum) {
  RandomNormals random(1);
  for (int i = 0; i < 10000; ++i) {
    const Corners n = random.corners(100);
    const Weights<float> w = random.weights();
    Vec3d sum;
    for (std::size_t c = 0; c < 3; ++c) {
      sum += vec_cast<double>(n[c]) * static_cast<double>(w[c]);
    }
    EXPECT_LT(distance_between(lerp_normal(n, w, kFallback), normalize(sum)), 4e-7);
  }
}

TEST(LerpNormal, HalvesARightAngle) {
  const Vec3f middle = lerp_normal(Corners{Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}}, {0.5F, 0.5F, 0}, kFallback);
  EXPECT_LT(distance_between(middle, {std::sqrt(0.5), std::sqrt(0.5), 0}), 1e-7);
}

TEST(LerpNormal, LagsBehindTheArc) {  // a quarter of the chord of a right angle is atan(1/3) = 18.43 degrees, not 22.5
  const Vec3f quarter = lerp_normal(Corners{Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}}, {0.75F, 0.25F, 0}, kFallback);
  EXPECT_NEAR(quarter.y / quarter.x, 1.0 / 3, 1e-6);
}

TEST(InterpolatedNormal, FallsBackWhereTheNormalsCancel) {
  const Corners opposite{Vec3f{1, 0, 0}, Vec3f{-1, 0, 0}, Vec3f{0, 1, 0}};
  const Corners around{Vec3f{1, 0, 0}, Vec3f{-0.5F, 0.8660254F, 0}, Vec3f{-0.5F, -0.8660254F, 0}};
  const Weights<float> thirds{1.0F / 3, 1.0F / 3, 1.0F / 3};
  for (NormalInterpolation mode : {NormalInterpolation::lerp, NormalInterpolation::slerp}) {
    EXPECT_EQ(interpolate_normal(mode, opposite, {0.5F, 0.5F, 0}, kFallback), kFallback);
    EXPECT_LT(distance_between(interpolate_normal(mode, around, thirds, kFallback), vec_cast<double>(kFallback)), 1e-6);
    EXPECT_NE(interpolate_normal(mode, opposite, {0.6F, 0.4F, 0}, kFallback), kFallback);
  }
}

TEST(InterpolatedNormal, ObeysTheMode) {
  const Corners n{Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}};
  const Weights<float> w{0.75F, 0.25F, 0};
  EXPECT_EQ(interpolate_normal(NormalInterpolation::lerp, n, w, kFallback), lerp_normal(n, w, kFallback));
  EXPECT_EQ(interpolate_normal(NormalInterpolation::slerp, n, w, kFallback), slerp_normal(n, w, kFallback));
  EXPECT_NE(lerp_normal(n, w, kFallback), slerp_normal(n, w, kFallback));
}

// --- slerp ------------------------------------------------------------------------------------------------------------------------------

TEST(SlerpNormal, MovesEvenlyAlongTheArc) {  // a quarter of a right angle is 22.5 degrees
  const Vec3f quarter = slerp_normal(Corners{Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}}, {0.75F, 0.25F, 0}, kFallback);
  EXPECT_LT(distance_between(quarter, {std::cos(kPi / 8), std::sin(kPi / 8), 0}), 5e-7);
}

TEST(SlerpNormal, IsTheSinFormulaOnEveryEdge) {
  RandomNormals random(2);
  for (int i = 0; i < 20000; ++i) {
    const Corners n = random.corners(i % 2 == 0 ? 60 : 165);
    const auto t = static_cast<float>(random.unit());
    for (std::size_t edge = 0; edge < 3; ++edge) {
      Weights<float> w{0, 0, 0};
      const std::size_t next = (edge + 1) % 3;
      w[edge] = 1 - t;
      w[next] = t;
      const double arc = angle(vec_cast<double>(n[edge]), vec_cast<double>(n[next]));
      const double conditioning = 1 / std::cos(arc / 2);  // the closer to opposite, the less the plane of the arc is known
      EXPECT_LT(distance_between(slerp_normal(n, w, kFallback), sin_formula(n[edge], n[next], static_cast<double>(t))), 1e-6 * conditioning);
    }
  }
}

TEST(SlerpNormal, OnAnEdgeTheThirdCornerDoesNotMatter) {  // no seam: neighbours that share an edge agree on it, bit for bit
  RandomNormals random(3);
  for (int i = 0; i < 20000; ++i) {
    const Corners n = random.corners(100);
    const Vec3f other = vec_cast<float>(random.direction());
    const auto t = static_cast<float>(random.unit());
    const Vec3f here = slerp_normal(n, {1 - t, t, 0}, kFallback);
    EXPECT_EQ(here, slerp_normal(Corners{n[0], n[1], other}, {1 - t, t, 0}, kFallback));
    EXPECT_EQ(here, slerp_normal(Corners{n[1], n[0], other}, {t, 1 - t, 0}, kFallback));  // the neighbour runs along the edge the other way
    EXPECT_EQ(here, slerp_normal(Corners{other, n[1], n[0]}, {0, t, 1 - t}, kFallback));
    EXPECT_EQ(here, slerp_normal(Corners{n[1], other, n[0]}, {t, 0, 1 - t}, kFallback));
    const Vec3f straight = lerp_normal(n, {1 - t, t, 0}, kFallback);
    EXPECT_EQ(straight, lerp_normal(Corners{n[1], other, n[0]}, {t, 0, 1 - t}, kFallback));
  }
}

TEST(SlerpNormal, IsTheCornersNormalAtTheCorner) {
  RandomNormals random(4);
  for (int i = 0; i < 5000; ++i) {
    const Corners n = random.corners(150);
    for (std::size_t c = 0; c < 3; ++c) {
      Weights<float> w{0, 0, 0};
      w[c] = 1;
      EXPECT_LT(distance_between(slerp_normal(n, w, kFallback), vec_cast<double>(n[c])), 2e-7);
      EXPECT_LT(distance_between(lerp_normal(n, w, kFallback), vec_cast<double>(n[c])), 2e-7);
    }
  }
}

TEST(SlerpNormal, OfASymmetricTriangleIsItsAxis) {
  for (double tilt : {0.01, 10.0, 45.0, 65.0}) {
    Corners n;
    for (std::size_t c = 0; c < 3; ++c) {
      const double turn = 2 * kPi / 3 * static_cast<double>(c);
      const double a = tilt * kPi / 180;
      n[c] = vec_cast<float>(Vec3d{std::sin(a) * std::cos(turn), std::sin(a) * std::sin(turn), std::cos(a)});
    }
    EXPECT_LT(distance_between(slerp_normal(n, {1.0F / 3, 1.0F / 3, 1.0F / 3}, {1, 0, 0}), {0, 0, 1}), 5e-7) << tilt;
  }
}

TEST(SlerpNormal, MinimizesTheWeightedSquaresOfTheAngles) {
  RandomNormals random(5);
  for (int i = 0; i < 1000; ++i) {
    const double spread = i % 4 == 0 ? 120 : i % 4 == 1 ? 90 : i % 4 == 2 ? 45 : 10;
    const Corners n = random.corners(spread);
    const Weights<float> w = random.weights();
    const Vec3d q = least_squared_angles(n, w);
    // The walk itself finds the minimum to a few 1e-8; a flat minimum (normals nearly around a great circle) is known less well.
    EXPECT_LT(distance_between(slerp_normal(n, w, kFallback), q), spread < 120 ? 8e-7 : 2e-6) << spread << ' ' << i;
  }
}

TEST(SlerpNormal, TurnsWithItsNormals) {
  RandomNormals random(6);
  for (int i = 0; i < 5000; ++i) {
    const Corners n = random.corners(100);
    const Weights<float> w = random.weights();
    const Vec3d x = random.direction();  // a rotation by its three axes
    const Vec3d y = normalize(cross(x, random.direction()));
    const Vec3d z = cross(x, y);
    const auto turn = [&](const Vec3f& a) {
      const Vec3d d = vec_cast<double>(a);
      return x * d.x + y * d.y + z * d.z;
    };
    const Corners turned{vec_cast<float>(turn(n[0])), vec_cast<float>(turn(n[1])), vec_cast<float>(turn(n[2]))};
    EXPECT_LT(distance_between(slerp_normal(turned, w, kFallback), turn(slerp_normal(n, w, kFallback))), 1.5e-6);
  }
}

TEST(SlerpNormal, DoesNotCareWhichCornerComesFirst) {
  RandomNormals random(7);
  for (int i = 0; i < 5000; ++i) {
    const Corners n = random.corners(100);
    const Weights<float> w = random.weights();
    const Vec3d first = vec_cast<double>(slerp_normal(n, w, kFallback));
    for (const std::array<std::size_t, 3>& p : {std::array<std::size_t, 3>{1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {2, 1, 0}, {0, 2, 1}}) {
      EXPECT_LT(distance_between(slerp_normal(Corners{n[p[0]], n[p[1]], n[p[2]]}, {w[p[0]], w[p[1]], w[p[2]]}, kFallback), first), 1e-6);
    }
  }
}

TEST(InterpolatedNormal, IsAUnitVectorWhateverTheCorners) {  // up to opposite, equal, and anything between
  RandomNormals random(8);
  for (int i = 0; i < 20000; ++i) {
    Corners n = random.corners(180);
    if (i % 3 == 0) {
      n[1] = n[0];
    } else if (i % 3 == 1) {
      n[1] = -n[0];
    }
    for (NormalInterpolation mode : {NormalInterpolation::lerp, NormalInterpolation::slerp}) {
      EXPECT_NEAR(length(interpolate_normal(mode, n, random.weights(), kFallback)), 1.0F, 4e-7F);
    }
  }
}

}  // namespace
}  // namespace lustro
