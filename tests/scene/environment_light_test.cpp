// The light of an environment against integrals from paper and against sums that are made another way.
#include "scene/environment_light.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <random>

#include "math/trig.hpp"

namespace lustro {
namespace {

/// A picture of all directions.
Image sky(int width, const std::function<Vec3d(const Vec3d&)>& radiance) {
  Image picture(width, width / 2, 3);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double longitude = 2 * kPi * ((x + 0.5) / width - 0.5), colatitude = kPi * (y + 0.5) / picture.height;
      const Vec3d light =
          radiance({std::sin(longitude) * std::sin(colatitude), std::cos(colatitude), -std::cos(longitude) * std::sin(colatitude)});
      const auto to = picture.at(x, y);
      to[0] = static_cast<float>(light.x);
      to[1] = static_cast<float>(light.y);
      to[2] = static_cast<float>(light.z);
    }
  }
  return picture;
}

std::vector<Vec3d> directions() {
  std::mt19937 random(7);
  std::vector<Vec3d> list{{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}};
  const auto part = [&] { return static_cast<double>(random() % 2001) / 1000 - 1; };
  for (int i = 0; i < 20; ++i) {
    list.push_back(normalize(Vec3d{part(), part(), part() + 1e-3}));
  }
  return list;
}

Vec3f shown(const ShadingEnvironment& light, const Vec3d& normal) {
  return light_around(light, vec_cast<float>(normal));
}

TEST(EnvironmentLight, AWhiteSkyLightsAWhiteSurfaceToOne) {
  const ShadingEnvironment light = diffuse_light(sky(256, [](const Vec3d&) { return Vec3d{1, 2, 0.5}; }), 1);
  for (const Vec3d& n : directions()) {
    const Vec3f value = shown(light, n);
    EXPECT_NEAR(value.x, 1, 1e-4);
    EXPECT_NEAR(value.y, 2, 2e-4);
    EXPECT_NEAR(value.z, 0.5, 1e-4);
    EXPECT_EQ(shown(diffuse_light(Vec3f{1, 2, 0.5F}), n).y, 2.0F);
  }
}

// Of radiance 1 + d.y: 1/pi times the integral of (1 + w.y) max(n.w, 0) is 1 + 2/3 n.y.
TEST(EnvironmentLight, ASkyBrighterAboveGivesTwoThirdsOfItsSlope) {
  const ShadingEnvironment light = diffuse_light(sky(256, [](const Vec3d& d) { return Vec3d{1 + d.x, 1 + d.y, 1 + d.z}; }), 1);
  for (const Vec3d& n : directions()) {
    const Vec3f value = shown(light, n);
    EXPECT_NEAR(value.x, 1 + 2.0 / 3 * n.x, 2e-3);
    EXPECT_NEAR(value.y, 1 + 2.0 / 3 * n.y, 2e-3);
    EXPECT_NEAR(value.z, 1 + 2.0 / 3 * n.z, 2e-3);
  }
}

// A quadratic radiance is of order 0 and 2, whose cosine integrals are A_0 = pi and A_2 = pi / 4: x^2 is 1/3 + (x^2 - 1/3).
TEST(EnvironmentLight, QuadraticSkiesComeThroughByAQuarter) {
  const ShadingEnvironment light = diffuse_light(sky(256, [](const Vec3d& d) { return Vec3d{d.x * d.x, d.z * d.z, 1 + d.x * d.z}; }), 1);
  for (const Vec3d& n : directions()) {
    const Vec3f value = shown(light, n);
    EXPECT_NEAR(value.x, 1.0 / 3 + (n.x * n.x - 1.0 / 3) / 4, 2e-3);
    EXPECT_NEAR(value.y, 1.0 / 3 + (n.z * n.z - 1.0 / 3) / 4, 2e-3);
    EXPECT_NEAR(value.z, 1 + n.x * n.z / 4, 2e-3);
  }
}

TEST(EnvironmentLight, TurningTheLightIsTurningThePicture) {
  const auto radiance = [](const Vec3d& d) { return Vec3d{1 + d.x + d.z * d.x, 1 + d.y * d.z, 2 + d.x * d.y - d.z * d.z}; };
  for (const double degrees : {0.0, 30.0, 90.0, 200.0}) {
    const double s = std::sin(radians(degrees)), c = std::cos(radians(degrees));
    const ShadingEnvironment turned_light = turned(diffuse_light(sky(256, radiance), 1), degrees);
    const ShadingEnvironment of_turned =  // counter-clockwise seen from above: what was at +z comes to +x at 90 degrees
        diffuse_light(sky(256,
                          [&](const Vec3d& d) {
                            return radiance({c * d.x - s * d.z, d.y, s * d.x + c * d.z});
                          }),
                      1);
    for (const Vec3d& n : directions()) {
      EXPECT_NEAR(shown(turned_light, n).x, shown(of_turned, n).x, 2e-3) << degrees;
      EXPECT_NEAR(shown(turned_light, n).y, shown(of_turned, n).y, 2e-3) << degrees;
      EXPECT_NEAR(shown(turned_light, n).z, shown(of_turned, n).z, 2e-3) << degrees;
    }
  }
}

// The mean of w.y over the lobe cos^n about R is R.y (n + 1) / (n + 2).
TEST(EnvironmentLight, ALobeBlursByItsExponent) {
  const Image picture = sky(512, [](const Vec3d& d) { return Vec3d{2 + d.y, 2 + d.x, 1}; });
  for (const float n : {1.0F, 8.0F, 50.0F, 400.0F}) {
    const Image blurred = blurred_by_lobe(picture, n, 1);
    const double kept = (static_cast<double>(n) + 1) / (static_cast<double>(n) + 2);
    const Image expected = sky(blurred.width, [&](const Vec3d& d) { return Vec3d{2 + d.y * kept, 2 + d.x * kept, 1}; });
    ASSERT_EQ(blurred.pixels.size(), expected.pixels.size());
    for (std::size_t i = 0; i < blurred.pixels.size(); ++i) {
      ASSERT_NEAR(blurred.pixels[i], expected.pixels[i], 0.01) << "n = " << n;
    }
  }
}

// Beside a sum over all pixels, without the shortcuts.
TEST(EnvironmentLight, ALobeSeesTheLampThatItPointsAt) {
  const Image picture = sky(128, [](const Vec3d& d) { return d.x > 0.9 ? Vec3d{10, 5, 1} : Vec3d{0.1, 0.1, 0.1}; });
  const float n = 30;
  const Image blurred = blurred_by_lobe(picture, n, 2);
  for (int y = 0; y < blurred.height; y += 7) {
    for (int x = 0; x < blurred.width; x += 5) {
      const auto direction = [](int i, int j, int width) {
        const double longitude = 2 * kPi * ((i + 0.5) / width - 0.5), colatitude = kPi * (j + 0.5) / (width / 2.0);
        return Vec3d{std::sin(longitude) * std::sin(colatitude), std::cos(colatitude), -std::cos(longitude) * std::sin(colatitude)};
      };
      const Vec3d mirrored = direction(x, y, blurred.width);
      double sum = 0, weight = 0;
      for (int j = 0; j < picture.height; ++j) {
        for (int i = 0; i < picture.width; ++i) {
          const double share = std::pow(std::max(0.0, dot(mirrored, direction(i, j, picture.width))), static_cast<double>(n)) *
                               std::sin(kPi * (j + 0.5) / picture.height);
          sum += share * static_cast<double>(picture.at(i, j)[0]);
          weight += share;
        }
      }
      EXPECT_NEAR(blurred.at(x, y)[0], sum / weight, 0.02 * (1 + sum / weight)) << x << ' ' << y;
    }
  }
}

TEST(EnvironmentLight, TheBitsAreTheSameForAnyNumberOfThreads) {
  const Image picture = sky(96, [](const Vec3d& d) { return Vec3d{1 + d.x * d.y, std::abs(d.z), 2 - d.y}; });
  const ShadingEnvironment one = diffuse_light(picture, 1), three = diffuse_light(picture, 3);
  EXPECT_EQ(std::memcmp(one.of.data(), three.of.data(), sizeof one.of), 0);
  EXPECT_EQ(blurred_by_lobe(picture, 20, 1).pixels, blurred_by_lobe(picture, 20, 3).pixels);
}

}  // namespace
}  // namespace lustro
