// Fresnel and Snell, against their form with angles.
#include "path/fresnel.hpp"

#include <gtest/gtest.h>

namespace lustro {
namespace {

TEST(Fresnel, IsWhatTheTextbooksSay) {
  for (const double index : {1.33, 1.5, 2.4, 1 / 1.33, 1 / 1.5}) {
    EXPECT_NEAR(static_cast<double>(fresnel_dielectric(1, static_cast<float>(index)).reflected), std::pow((index - 1) / (index + 1), 2), 1e-6);
    for (double angle = 0.05; angle < 1.55; angle += 0.05) {
      const double sine = std::sin(angle) / index;
      const Fresnel f = fresnel_dielectric(static_cast<float>(std::cos(angle)), static_cast<float>(index));
      if (sine > 0.9999 && sine < 1.0001) {
        continue;
      }
      if (sine >= 1) {
        EXPECT_EQ(f.reflected, 1.0F) << "total reflection";
        EXPECT_EQ(f.cosine_behind, 0.0F);
        continue;
      }
      const double behind = std::asin(sine);
      const double across = std::sin(angle - behind) / std::sin(angle + behind);
      const double along = std::tan(angle - behind) / std::tan(angle + behind);
      EXPECT_NEAR(static_cast<double>(f.reflected), (across * across + along * along) / 2, 1e-5) << index << ' ' << angle;
      EXPECT_NEAR(static_cast<double>(f.cosine_behind), std::cos(behind), 1e-5);
    }
  }
}

TEST(Fresnel, NothingIsMirroredParallelAtBrewstersAngle) {
  const double brewster = std::atan(1.5);
  const double behind = std::asin(std::sin(brewster) / 1.5);
  const double across = std::pow(std::sin(brewster - behind) / std::sin(brewster + behind), 2);
  EXPECT_NEAR(static_cast<double>(fresnel_dielectric(static_cast<float>(std::cos(brewster)), 1.5F).reflected), across / 2, 1e-6);
}

TEST(Fresnel, ARefractedRayObeysSnellAndStaysInItsPlane) {
  const Vec3f normal{0, 0, 1};
  const Vec3f to_eye = normalize(Vec3f{0.6F, 0.3F, 0.7F});
  const Fresnel f = fresnel_dielectric(to_eye.z, 1.5F);
  const Vec3f t = refracted(to_eye, normal, to_eye.z, f.cosine_behind, 1.5F);
  EXPECT_NEAR(length(t), 1, 1e-6F);
  EXPECT_LT(t.z, 0);
  EXPECT_NEAR(length(cross(t, normal)) * 1.5F, length(cross(to_eye, normal)), 1e-6F) << "n sin";
  EXPECT_NEAR(dot(t, cross(to_eye, normal)), 0, 1e-6F);
  EXPECT_LT(t.x * to_eye.x + t.y * to_eye.y, 0) << "across the normal";
}

}  // namespace
}  // namespace lustro
