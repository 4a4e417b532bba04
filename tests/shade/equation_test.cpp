// The lighting equation as a whole: random surfaces under random lights against the textbook, the sum against its parts bit for bit, and the
// normalised lobes in a white furnace.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "shade/lighting.hpp"
#include "shade/random_surface.hpp"
#include "shade/textbook.hpp"

namespace lustro {
namespace {

constexpr auto kNobody = [](std::size_t, const Incident<float>&, const LightTerms<float>&) {};

std::vector<ShadingLight> ready(const std::vector<Light>& lights) {
  std::vector<ShadingLight> out;
  for (const Light& light : lights) {
    out.push_back(textbook::ready(light));
  }
  return out;
}

TEST(Equation, LightsAddUpInTheirOrderAndVisitSeesEveryPart) {
  RandomSurface random(7);
  for (int round = 0; round < 1000; ++round) {
    const Surface<float> s = random.surface();
    const Coefficients<float> k = random.coefficients();
    const std::vector<ShadingLight> lights = ready(random.lights(5));
    const Vec3f scene_ambient = random.color();
    Terms<float> expected{k.ambient * scene_ambient, {}, {}, k.emission};
    std::size_t next = 0;
    const Terms<float> terms = light_surface(
        Lighting::phong, s, k, scene_ambient, lights, false, [&](std::size_t i, const Incident<float>& in, const LightTerms<float>& part) {
          EXPECT_EQ(i, next++);
          EXPECT_EQ(in.attenuation, incident_light(lights[i], s.position).attenuation);
          const std::vector<ShadingLight> alone{lights[i]};
          const Terms<float> single = light_surface(Lighting::phong, s, k, Vec3f{0, 0, 0}, alone, false, kNobody);
          EXPECT_EQ(part.ambient, single.ambient);
          EXPECT_EQ(part.diffuse, single.diffuse);
          EXPECT_EQ(part.specular, single.specular);
          expected.ambient += part.ambient;
          expected.diffuse += part.diffuse;
          expected.specular += part.specular;
        });
    EXPECT_EQ(next, lights.size());
    EXPECT_EQ(terms.ambient, expected.ambient);  // bit for bit: the order of a sum is part of the result
    EXPECT_EQ(terms.diffuse, expected.diffuse);
    EXPECT_EQ(terms.specular, expected.specular);
    EXPECT_EQ(terms.emission, expected.emission);
  }
}

TEST(Equation, TheWholeEquationAgreesWithTheTextbook) {  // random surfaces under random lights, in double precision and from libm
  RandomSurface random(1975);
  int compared = 0;
  for (int round = 0; round < 200000; ++round) {
    const Surface<float> s = random.surface();
    const Coefficients<float> k = random.coefficients();
    const std::vector<Light> lights = random.lights(1);
    const Vec3f scene_ambient = random.color();
    const Lighting model = random.model();
    const bool normalized = random.chance(0.3F);
    const textbook::Point p{vec_cast<double>(s.position), vec_cast<double>(s.normal), vec_cast<double>(s.to_eye)};
    if (random.is_at_an_edge(p, lights[0])) {
      continue;  // at a step of the equation a rounding decides
    }
    ++compared;
    const Coefficients<double> kd{vec_cast<double>(k.ambient), vec_cast<double>(k.diffuse), vec_cast<double>(k.specular),
                                  vec_cast<double>(k.emission), k.shininess};
    const textbook::Result expected = textbook::light(model, p, kd, vec_cast<double>(scene_ambient), lights, normalized);
    const Terms<float> actual = light_surface(model, s, k, scene_ambient, ready(lights), normalized, kNobody);
    // A cosine is off by some 2e-7; the spot's power and the highlight's multiply that by their exponents, a fade by its steepness.
    const double fade = lights[0].beam ? 1 / (textbook::cosine_of(*lights[0].beam) - textbook::cosine_of(lights[0].cutoff)) : 0;
    const double relative = 3e-6 + 6e-7 * lights[0].exponent + 4e-7 * fade;
    const auto expect_near = [&](const Vec3f& a, const Vec3d& e, double error) {
      EXPECT_NEAR(a.x, e.x, error * (1 + e.x));
      EXPECT_NEAR(a.y, e.y, error * (1 + e.y));
      EXPECT_NEAR(a.z, e.z, error * (1 + e.z));
    };
    expect_near(actual.ambient, expected.ambient, relative);
    expect_near(actual.diffuse, expected.diffuse, relative);
    expect_near(actual.specular, expected.specular, relative + 6e-7 * static_cast<double>(k.shininess.n));
    expect_near(actual.emission, expected.emission, 0);
    ASSERT_FALSE(HasFailure()) << "round " << round;
  }
  EXPECT_GT(compared, 190000);
}

// --- normalised lobes: a white furnace
// -----------------------------------------------------------------------------------------------------------

/// The share of a uniform environment that the lobe alone reflects to an eye `degrees` off the normal: (1/pi) * the integral over the
/// hemisphere.
double albedo(Lighting model, double shininess, double eye_degrees, bool normalized) {
  const double lean = eye_degrees * textbook::kPi / 180;
  const Surface<float> s{.position = {}, .normal = {0, 0, 1}, .to_eye = vec_cast<float>(Vec3d{std::sin(lean), 0, std::cos(lean)})};
  const auto n = static_cast<float>(shininess);
  const int rings = eye_degrees == 0 ? 4000 : 600;
  const int spokes = eye_degrees == 0 ? 4 : 600;
  double sum = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const double theta = (ring + 0.5) / rings * (textbook::kPi / 2);
    for (int spoke = 0; spoke < spokes; ++spoke) {
      const double phi = (spoke + 0.5) / spokes * 2 * textbook::kPi;
      const Vec3d l{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
      const float n_dot_l = static_cast<float>(l.z);
      const float spec = model == Lighting::phong
                             ? specular_factor<Lighting::phong>(s, Exponent(n), vec_cast<float>(l), n_dot_l, normalized)
                             : specular_factor<Lighting::blinn_phong>(s, Exponent(n), vec_cast<float>(l), n_dot_l, normalized);
      sum += static_cast<double>(spec) * std::sin(theta);
    }
  }
  return sum * (textbook::kPi / 2 / rings) * (2 * textbook::kPi / spokes) / textbook::kPi;
}

TEST(Equation, ANormalizedLobeReflectsEverythingAtNormalIncidence) {
  for (Lighting model : {Lighting::phong, Lighting::blinn_phong}) {
    for (double n : {0.0, 1.0, 2.0, 10.0, 76.8, 1000.0}) {
      EXPECT_NEAR(albedo(model, n, 0, true), 1, 2e-4) << n;
    }
  }
}

TEST(Equation, ANormalizedPhongLobeNeverReflectsMore) {  // Lafortune and Willems: the albedo falls towards grazing angles
  for (double n : {1.0, 20.0}) {
    double above = 1.0005;
    for (double degrees : {0.0, 30.0, 60.0, 85.0}) {
      const double share = albedo(Lighting::phong, n, degrees, true);
      EXPECT_LT(share, above) << n << ' ' << degrees;
      above = share;
    }
  }
}

/// The share that GGX, diffuse and highlight together, reflects of a uniform environment to an eye `degrees` off the normal.
double ggx_albedo(float n, float k_d, float k_s, double eye_degrees) {
  const double lean = eye_degrees * textbook::kPi / 180;
  const Surface<float> s{.position = {}, .normal = {0, 0, 1}, .to_eye = vec_cast<float>(Vec3d{std::sin(lean), 0, std::cos(lean)})};
  const Coefficients<float> k{{}, {k_d, k_d, k_d}, {k_s, k_s, k_s}, {}, n};
  ShadingLight white;
  white.diffuse = white.specular = {1, 1, 1};
  constexpr int kRings = 500, kSpokes = 500;
  double sum = 0;
  for (int ring = 0; ring < kRings; ++ring) {
    const double theta = (ring + 0.5) / kRings * (textbook::kPi / 2);
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
      const double phi = (spoke + 0.5) / kSpokes * 2 * textbook::kPi;
      white.travel = vec_cast<float>(Vec3d{-std::sin(theta) * std::cos(phi), -std::sin(theta) * std::sin(phi), -std::cos(theta)});
      const std::vector<ShadingLight> lights{white};
      sum += static_cast<double>(light_surface(Lighting::ggx, s, k, Vec3f{}, lights, false, kNobody).sum().x) * std::sin(theta);
    }
  }
  return sum * (textbook::kPi / 2 / kRings) * (2 * textbook::kPi / kSpokes) / textbook::kPi;
}

TEST(Equation, GgxNeverReflectsMoreThanComes) {  // a white furnace; single scattering loses light where the surface is rough
  for (const double degrees : {0.0, 40.0, 75.0}) {
    for (const float n : {0.0F, 6.0F, 60.0F}) {
      const double mirror = ggx_albedo(n, 0, 1, degrees);
      EXPECT_LT(mirror, 1.003) << n << ' ' << degrees;
      EXPECT_GT(mirror, n == 0.0F ? 0.3 : 0.65) << n << ' ' << degrees;
      // With a diffuse part below the facets a tenth may come on top at grazing angles: glTF weighs it by F of V.H alone.
      EXPECT_LT(ggx_albedo(n, 1, 0.04F, degrees), degrees < 60 ? 1.003 : 1.1) << n << ' ' << degrees;
      EXPECT_GT(ggx_albedo(n, 1, 0.04F, degrees), 0.8) << n << ' ' << degrees;
    }
  }
  // The roughest mirror, a = 1, seen from above: pi D = 1 and Vis = 1 / (2 (1 + N.L)), so the share is the integral of c / (1 + c) over 0..1.
  EXPECT_NEAR(ggx_albedo(0, 0, 1, 0), 1 - std::log(2.0), 1e-5);
  EXPECT_NEAR(ggx_albedo(200, 0, 1, 0), 1, 0.015) << "what is smooth loses nothing";
}

TEST(Equation, TheClassicLobeGainsAtLowExponentsAndLosesAtHighOnes) {  // by design: (1/pi) * the integral of cos^n is 2 / (n + 1)
  for (double n : {0.0, 1.0, 10.0, 100.0}) {
    const double exact = 2 / (n + 1);

    EXPECT_NEAR(albedo(Lighting::phong, n, 0, false), exact, 1e-3 * exact) << n;
  }
}

}  // namespace
}  // namespace lustro
