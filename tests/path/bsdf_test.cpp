// The lobes as samplers: chi-square against their densities, and the weights against what they stand for.
#include "path/bsdf.hpp"

#include "chi_square.hpp"
#include "path/fresnel.hpp"

namespace lustro {
namespace {

struct Subject {
  SurfacePoint point;
  ShadingMaterial material;
  Shading shading;
};

Subject subject(Lighting lighting, float n, float k_d, float k_s, double angle_deg, bool normalized) {
  Subject s;
  const double angle = radians(angle_deg);
  const Vec3f eye{static_cast<float>(std::sin(angle) * 0.8), static_cast<float>(std::sin(angle) * 0.6), static_cast<float>(std::cos(angle))};
  s.point.surface = {{}, {0, 0, 1}, eye};
  s.point.geometric_normal = {0, 0, 1};
  s.point.k = {{}, {k_d, k_d, k_d}, {k_s, k_s, k_s}, {}, {n}};
  s.material.lighting = lighting;
  s.shading.normalized = normalized;
  return s;
}

std::string name_of(Lighting lighting, float n, double angle) {
  return "model " + std::to_string(static_cast<int>(lighting)) + ", n " + std::to_string(n) + ", " + std::to_string(angle) + " degrees";
}

TEST(Bsdf, DirectionsFallAsTheirDensitySays) {
  for (const Lighting lighting : {Lighting::lambert, Lighting::phong, Lighting::blinn_phong, Lighting::ggx}) {
    for (const float n : {0.0F, 5.0F, 60.0F}) {
      for (const double angle : {0.0, 40.0, 80.0, 100.0}) {
        const Subject s = subject(lighting, n, 0.3F, 0.5F, angle, true);
        const Bsdf bsdf(s.point, s.material, s.shading, true);
        Uniform choice(7);
        // Opposite to the eye the density of lobes about H has no bound, and no sum over cells finds its integral.
        const auto is_tested = [&](const Vec3f& d) { return dot(d, s.point.surface.to_eye) > -0.8F; };
        expect_distribution(
            [&](const Vec2f& u) {
              const ScatterSample sample = bsdf.sample(choice.one(), u);
              return sample.density > 0 && is_tested(sample.direction) ? sample.direction : Vec3f{};
            },
            [&](const Vec3f& d) { return is_tested(d) ? static_cast<double>(bsdf.density(d)) : 0.0; }, name_of(lighting, n, angle));
      }
    }
  }
}

TEST(Bsdf, WeightsAreLightOverDensity) {
  Uniform uniform;
  for (const Lighting lighting : {Lighting::lambert, Lighting::phong, Lighting::blinn_phong, Lighting::ggx}) {
    const Subject s = subject(lighting, 12, 0.3F, 0.5F, 35, false);
    const Bsdf bsdf(s.point, s.material, s.shading, true);
    for (int i = 0; i < 500; ++i) {
      const ScatterSample sample = bsdf.sample(uniform.one(), uniform.two());
      if (!(sample.density > 0)) {
        continue;
      }
      EXPECT_NEAR(length(sample.direction), 1, 1e-5F);
      const Vec3f expected = bsdf.reflected(sample.direction).sum() * (kInversePiF / bsdf.density(sample.direction));
      EXPECT_NEAR(sample.weight.sum().x, expected.x, 1e-5F + 1e-4F * expected.x);
    }
  }
}

TEST(Bsdf, EveryDirectionThatReflectsCanBeChosen) {
  Uniform uniform;
  for (const Lighting lighting : {Lighting::lambert, Lighting::phong, Lighting::blinn_phong, Lighting::ggx}) {
    for (const float n : {0.0F, 1.0F, 30.0F}) {
      for (const double angle : {0.0, 70.0, 95.0}) {
        const Subject s = subject(lighting, n, 0, 0.5F, angle, false);
        const Bsdf bsdf(s.point, s.material, s.shading, true);
        for (int i = 0; i < 500; ++i) {
          const Vec3f d = sample_sphere(uniform.two());
          if (bsdf.reflected(d).sum().x > 1e-4F) {
            EXPECT_GT(bsdf.density(d), 0) << name_of(lighting, n, angle);
          }
        }
      }
    }
  }
}

TEST(Bsdf, NothingIsReflectedThroughTheSurface) {
  const Subject s = subject(Lighting::phong, 3, 0.5F, 0.5F, 60, true);
  const Bsdf bsdf(s.point, s.material, s.shading, true);
  EXPECT_EQ(bsdf.reflected(normalize(Vec3f{0.5F, 0, -0.1F})).sum(), Vec3f{});
  Subject tilted = s;  // the interpolated normal sees the light, the triangle does not
  tilted.point.surface.normal = normalize(Vec3f{0.5F, 0, 1});
  EXPECT_EQ(Bsdf(tilted.point, tilted.material, tilted.shading, true).reflected(normalize(Vec3f{1, 0, -0.1F})).sum(), Vec3f{});
}

TEST(Bsdf, MirrorsAndGlassSplitAsTheirIlluminationSays) {
  const auto split = [](int illumination, float k_s, float index, const Vec3f& transmission, bool is_front) {
    Subject s = subject(Lighting::phong, 30, 0, k_s, 40, true);
    s.material.stated.illumination = illumination;
    s.material.stated.refraction = index;
    s.material.stated.transmission.rgb = transmission;
    const Bsdf bsdf(s.point, s.material, s.shading, is_front);
    std::pair<double, double> shares{0, 0};  // mirrored and refracted, by the mean over choices
    constexpr int kChoices = 20000;
    for (int i = 0; i < kChoices; ++i) {
      const ScatterSample sample = bsdf.sample((static_cast<float>(i) + 0.5F) / kChoices, {0.5F, 0.5F});
      EXPECT_TRUE(sample.is_delta);
      (sample.passes ? shares.second : shares.first) += static_cast<double>(sample.weight.sum().x) / kChoices;
    }
    return shares;
  };
  const double cosine = std::cos(radians(40));
  const auto f = static_cast<double>(fresnel_dielectric(static_cast<float>(cosine), 1.5F).reflected);
  const Vec3f half{0.5F, 0.5F, 0.5F};
  EXPECT_NEAR(split(3, 0.7F, 1.5F, half, true).first, 0.7, 1e-3);
  EXPECT_EQ(split(3, 0.7F, 1.5F, half, true).second, 0);
  EXPECT_NEAR(split(5, 0.7F, 1.5F, half, true).first, 0.7 * f, 1e-3);
  EXPECT_NEAR(split(6, 0.7F, 1.5F, half, true).first, 0.7, 1e-3);
  EXPECT_NEAR(split(6, 0.7F, 1.5F, half, true).second, 0.3 * 0.5 / 2.25, 1e-3) << "and L / n^2 stays";
  EXPECT_NEAR(split(7, 1, 1.5F, half, true).first, f, 1e-3);
  EXPECT_NEAR(split(7, 1, 1.5F, half, true).second, (1 - f) * 0.5 / 2.25, 1e-3);
  const auto inner = static_cast<double>(fresnel_dielectric(static_cast<float>(cosine), 1 / 1.5F).reflected);
  EXPECT_NEAR(split(7, 1, 1.5F, half, false).second, (1 - inner) * 0.5 * 2.25, 1e-3) << "out of the glass";
}

}  // namespace
}  // namespace lustro
