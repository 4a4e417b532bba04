// The lighting equation, clause by clause. Expected values come from paper or from libm in double precision (textbook.hpp), never from the code
// under test. The whole equation on random surfaces stands in equation_test.cpp. Most tests happen in one plane, where every direction is an
// angle away from straight up:
//
//                N  H
//          L     |  /       V        N  normal            R  L mirrored about N
//            \   | /     .           L  to the light      H  halfway between L and V
//              \ |/  .               V  to the eye
//     ___________*___________
#include "shade/lighting.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "shade/textbook.hpp"

namespace lustro {
namespace {

constexpr float kRounding = 4e-7F;  // a few operations on floats near 1
constexpr Lighting kWithHighlight[] = {Lighting::phong, Lighting::blinn_phong};

// --- a small vocabulary ---------------------------------------------------------------------------------------------------------

double cosine_of(double degrees) {
  return textbook::cosine_of(degrees);
}

/// The unit vector `degrees` to the right of straight up.
Vec3f leaning(double degrees) {
  return vec_cast<float>(Vec3d{std::sin(degrees * textbook::kPi / 180), 0, std::cos(degrees * textbook::kPi / 180)});
}

/// A surface in the origin: N, V.
Surface<float> surface(const Vec3f& normal, const Vec3f& to_eye) {
  return {.position = {0, 0, 0}, .normal = normal, .to_eye = to_eye};
}
const Surface<float> kFlatOnTheTable = surface({0, 0, 1}, {0, 0, 1});

/// A material that keeps all light, so that a term is the geometry alone.
Coefficients<float> white(float shininess = 0) {
  return {.ambient = {1, 1, 1}, .diffuse = {1, 1, 1}, .specular = {1, 1, 1}, .emission = {0, 0, 0}, .shininess = shininess};
}

/// A directional light of colour 1 that stands in direction `to_light`.
Light sun(const Vec3f& to_light) {
  return {.type = LightType::directional, .direction = vec_cast<double>(-to_light)};
}

/// A point light of colour 1, straight above at a distance.
Light bulb(double distance, const Attenuation& attenuation = {}) {
  return {.type = LightType::point, .position = {0, 0, distance}, .attenuation = attenuation};
}

std::vector<ShadingLight> ready(const std::vector<Light>& lights) {
  std::vector<ShadingLight> out;
  for (const Light& light : lights) {
    out.push_back(textbook::ready(light));
  }
  return out;
}

Terms<float> shine(Lighting model, const Surface<float>& s, const Coefficients<float>& k, const std::vector<Light>& lights,
                   const Vec3f& scene_ambient = {0, 0, 0}) {
  return light_surface(model, s, k, scene_ambient, ready(lights), false, [](std::size_t, const Incident<float>&, const LightTerms<float>&) {});
}

float diffuse_of(const Surface<float>& s, const Light& light) {
  return shine(Lighting::lambert, s, white(), {light}).diffuse.x;
}
float highlight_of(Lighting model, const Surface<float>& s, double shininess, const Light& light) {
  return shine(model, s, white(static_cast<float>(shininess)), {light}).specular.x;
}

// --- diffuse: Lambert 1760 ----------------------------------------------------------------------------------------------------------

TEST(Lighting, WhiteFacingAWhiteLightIsOne) {  // classic units: no 1/pi
  EXPECT_EQ(diffuse_of(kFlatOnTheTable, sun({0, 0, 1})), 1.0F);
}

TEST(Lighting, DiffuseIsTheCosineOfTheAngleToTheLight) {
  for (int degrees = 0; degrees < 90; degrees += 5) {
    EXPECT_NEAR(diffuse_of(kFlatOnTheTable, sun(leaning(degrees))), cosine_of(degrees), kRounding) << degrees;
  }
  EXPECT_NEAR(diffuse_of(kFlatOnTheTable, sun(leaning(60))), 0.5F, kRounding);
}

TEST(Lighting, DiffuseDoesNotDependOnTheEye) {
  for (int degrees = -90; degrees <= 90; degrees += 30) {
    EXPECT_EQ(diffuse_of(surface({0, 0, 1}, leaning(degrees)), sun(leaning(40))), diffuse_of(kFlatOnTheTable, sun(leaning(40)))) << degrees;
  }
}

TEST(Lighting, LightFromBehindGivesNoDiffuse) {
  EXPECT_EQ(diffuse_of(kFlatOnTheTable, sun({1, 0, 0})), 0.0F);  // N.L = 0
  for (int degrees = 91; degrees <= 180; degrees += 5) {
    EXPECT_EQ(diffuse_of(kFlatOnTheTable, sun(leaning(degrees))), 0.0F) << degrees;
  }
}

// --- specular: Phong 1975, Blinn 1977 -----------------------------------------------------------------------------------------------------

TEST(Lighting, PhongSeesTwiceTheTilt) {  // eye and light straight above: tilt the surface by 10 degrees, and R turns by 20
  for (double n : {1.0, 20.0, 76.8, 1000.0}) {
    EXPECT_NEAR(highlight_of(Lighting::phong, surface(leaning(10), {0, 0, 1}), n, sun({0, 0, 1})), std::pow(cosine_of(20), n), 2e-6) << n;
  }
}

TEST(Lighting, BlinnPhongSeesTheTiltOnce) {  // H stays straight above
  for (double n : {1.0, 20.0, 76.8, 1000.0}) {
    EXPECT_NEAR(highlight_of(Lighting::blinn_phong, surface(leaning(10), {0, 0, 1}), n, sun({0, 0, 1})), std::pow(cosine_of(10), n), 4e-6) << n;
  }
}

TEST(Lighting, TheMirrorDirectionShinesFully) {  // L 35 degrees to the left, V 35 degrees to the right, N straight up
  for (Lighting model : kWithHighlight) {
    EXPECT_NEAR(highlight_of(model, surface({0, 0, 1}, leaning(35)), 50, sun(leaning(-35))), 1.0F, 5e-6);
  }
}

TEST(Lighting, TheMirrorDirectionLiesInThePlaneOfLightAndNormal) {  // R, component by component, out of the drawing's plane
  const Vec3d n = normalize(Vec3d{1, 2, 2});
  const Vec3d l = normalize(Vec3d{2, -1, 4});
  const Vec3d r = 2 * dot(n, l) * n - l;
  const Vec3f actual = reflect_about(vec_cast<float>(n), vec_cast<float>(l));
  EXPECT_NEAR(actual.x, r.x, kRounding);
  EXPECT_NEAR(actual.y, r.y, kRounding);
  EXPECT_NEAR(actual.z, r.z, kRounding);
}

TEST(Lighting, TheExponentShapesTheHighlight) {  // 12 degrees off the mirror direction
  const Surface<float> s = surface({0, 0, 1}, leaning(42));
  const Light light = sun(leaning(-30));
  for (double n : {0.5, 1.0, 2.0, 5.0, 76.8, 128.0, 1000.0}) {
    const double conditioning = 4e-7 * (1 + n);  // relative: a cosine's last digit, n times
    const double phong = std::pow(cosine_of(12), n);
    const double blinn = std::pow(cosine_of(6), n);
    EXPECT_NEAR(highlight_of(Lighting::phong, s, n, light), phong, conditioning * phong) << n;
    EXPECT_NEAR(highlight_of(Lighting::blinn_phong, s, n, light), blinn, conditioning * blinn) << n;
  }
}

TEST(Lighting, ExponentZeroIsOneWhereverTheLightReaches) {  // x^0 = 1, also for x = 0 and below
  for (Lighting model : kWithHighlight) {
    for (int eye = -90; eye <= 180; eye += 45) {
      EXPECT_EQ(highlight_of(model, surface({0, 0, 1}, leaning(eye)), 0, sun(leaning(-30))), 1.0F) << eye;
    }
    EXPECT_EQ(highlight_of(model, kFlatOnTheTable, 0, sun(leaning(100))), 0.0F) << "but not behind the surface";
  }
}

TEST(Lighting, BesideTheLobeThereIsNoHighlight) {  // a negative cosine counts as 0, also under an even exponent
  for (double n : {1.0, 2.0}) {
    EXPECT_EQ(highlight_of(Lighting::phong, surface({0, 0, 1}, leaning(-80)), n, sun(leaning(-60))), 0.0F) << n;         // R.V = cos 140
    EXPECT_EQ(highlight_of(Lighting::blinn_phong, surface({0, 0, 1}, leaning(-170)), n, sun(leaning(-60))), 0.0F) << n;  // N.H = cos 115
  }
}

TEST(Lighting, NoHighlightWhereTheLightIsBehind) {  // the eye looks straight into the mirror direction, yet N.L <= 0 closes the gate
  for (Lighting model : kWithHighlight) {
    for (double n : {0.0, 1.0, 20.0}) {
      for (int degrees : {91, 120, 170, 180}) {
        const Vec3f mirrored = leaning(-degrees);
        EXPECT_EQ(highlight_of(model, surface({0, 0, 1}, mirrored), n, sun(leaning(degrees))), 0.0F) << degrees;
        EXPECT_EQ(highlight_of(model, surface({0, 0, 1}, {0, 0, 1}), n, sun(leaning(degrees))), 0.0F) << degrees;
      }
      EXPECT_EQ(highlight_of(model, surface({0, 0, 1}, {-1, 0, 0}), n, sun({1, 0, 0})), 0.0F) << "at N.L = 0 exactly";
    }
  }
}

TEST(Lighting, TheGateIsAStepNotAFade) {  // a hair in front of the surface the highlight is whole
  for (Lighting model : kWithHighlight) {
    EXPECT_NEAR(highlight_of(model, surface({0, 0, 1}, leaning(-89.9)), 20, sun(leaning(89.9))), 1.0F, 1e-5);
  }
}

TEST(Lighting, LightAndEyeOppositeHaveNoHalfway) {  // H does not exist: no highlight, and no NaN
  const Surface<float> s = surface({0, 0, 1}, -leaning(30));
  EXPECT_EQ(n_dot_h(s, leaning(30)), 0.0F);
  EXPECT_EQ(highlight_of(Lighting::blinn_phong, s, 5, sun(leaning(30))), 0.0F);
}

TEST(Lighting, LambertHasNoHighlightAndIsOtherwiseTheSame) {
  const Surface<float> s = surface({0, 0, 1}, leaning(30));
  const Terms<float> lambert = shine(Lighting::lambert, s, white(10), {sun(leaning(-30))}, {0.2F, 0.2F, 0.2F});
  const Terms<float> phong = shine(Lighting::phong, s, white(10), {sun(leaning(-30))}, {0.2F, 0.2F, 0.2F});
  EXPECT_EQ(lambert.specular, (Vec3f{0, 0, 0}));
  EXPECT_GT(phong.specular.x, 0.9F);
  EXPECT_EQ(lambert.diffuse, phong.diffuse);
  EXPECT_EQ(lambert.ambient, phong.ambient);
}

TEST(Lighting, ConstantIsTheDiffuseColourAlone) {
  Coefficients<float> k = white(10);
  k.diffuse = {0.1F, 0.5F, 0.9F};
  k.emission = {1, 1, 1};
  const Terms<float> terms = shine(Lighting::constant, kFlatOnTheTable, k, {sun({0, 0, 1})}, {0.2F, 0.2F, 0.2F});
  EXPECT_EQ(terms.sum(), (Vec3f{0.1F, 0.5F, 0.9F}));
  EXPECT_EQ(terms.diffuse, terms.sum());
}

// --- ambient, emission, colours -------------------------------------------------------------------------------------------------------------

TEST(Lighting, WithoutLightsRemainAmbientAndEmission) {
  Coefficients<float> k = white();
  k.ambient = {0.5F, 0.25F, 1};
  k.emission = {0.125F, 0, 2};
  for (Lighting model : {Lighting::lambert, Lighting::phong, Lighting::blinn_phong}) {
    const Terms<float> terms = shine(model, kFlatOnTheTable, k, {}, {0.5F, 1, 0.25F});
    EXPECT_EQ(terms.ambient, (Vec3f{0.25F, 0.25F, 0.25F}));
    EXPECT_EQ(terms.emission, k.emission);
    EXPECT_EQ(terms.sum(), (Vec3f{0.375F, 0.25F, 2.25F}));
  }
}

TEST(Lighting, SceneAmbientAndEmissionAreNotAttenuated) {
  Coefficients<float> k = white();
  k.emission = {0.5F, 0.5F, 0.5F};
  const Terms<float> terms = shine(Lighting::phong, kFlatOnTheTable, k, {bulb(10, {.quadratic = 1})}, {0.25F, 0.25F, 0.25F});
  EXPECT_EQ(terms.ambient.x, 0.25F);
  EXPECT_EQ(terms.emission.x, 0.5F);
}

TEST(Lighting, TheAmbientOfALightIsAttenuatedButReachesTheBack) {
  Light above = bulb(2, {.constant = 0, .quadratic = 1});  // f = 1/4
  above.ambient.rgb = {1, 1, 1};
  EXPECT_EQ(shine(Lighting::phong, kFlatOnTheTable, white(), {above}).ambient.x, 0.25F);
  EXPECT_EQ(shine(Lighting::phong, surface({0, 0, -1}, {0, 0, -1}), white(), {above}).ambient.x, 0.25F);
  EXPECT_EQ(shine(Lighting::phong, kFlatOnTheTable, white(), {bulb(2)}).ambient.x, 0.0F) << "black unless stated";
}

TEST(Lighting, AttenuationAndSpotScaleEveryTermOfTheLight) {
  Light spot = bulb(2, {.constant = 0, .quadratic = 1});  // f = 1/4
  spot.type = LightType::spot;
  spot.direction = vec_cast<double>(-leaning(60));  // the point is 60 degrees off the axis: s = cos 60 = 1/2
  spot.cutoff = 80;
  spot.exponent = 1;
  spot.ambient.rgb = {1, 1, 1};
  const Terms<float> terms = shine(Lighting::phong, kFlatOnTheTable, white(7), {spot});
  EXPECT_NEAR(terms.ambient.x, 0.125F, kRounding);
  EXPECT_NEAR(terms.diffuse.x, 0.125F, kRounding);
  EXPECT_NEAR(terms.specular.x, 0.125F, kRounding);
}

TEST(Lighting, EachChannelMeetsItsOwn) {  // powers of two: every product is exact
  Coefficients<float> k = white();
  k.ambient = {1, 2, 4};
  k.diffuse = {8, 16, 32};
  k.specular = {64, 128, 256};
  Light light = sun({0, 0, 1});
  light.ambient.rgb = {0.5F, 0.25F, 2};
  light.diffuse.rgb = {0.25F, 2, 0.5F};
  light.specular.rgb = {2, 0.5F, 0.25F};
  const Terms<float> terms = shine(Lighting::phong, kFlatOnTheTable, k, {light}, {1, 4, 16});
  EXPECT_EQ(terms.ambient, (Vec3f{1 + 0.5F, 8 + 0.5F, 64 + 8}));
  EXPECT_EQ(terms.diffuse, (Vec3f{2, 32, 16}));
  EXPECT_EQ(terms.specular, (Vec3f{128, 64, 64}));
}

// --- attenuation ------------------------------------------------------------------------------------------------------------------------------

float attenuation_of(double distance, const Attenuation& attenuation) {
  return incident_light(textbook::ready(bulb(distance, attenuation)), Vec3f{0, 0, 0}).attenuation;
}

TEST(Lighting, ADirectionalLightIsTheSameEverywhere) {
  Light light = sun(leaning(30));
  light.attenuation = {.constant = 3, .linear = 2, .quadratic = 1};  // has no meaning for it
  for (const Vec3f& place : {Vec3f{0, 0, 0}, Vec3f{100, -50, 3}}) {
    const Incident<float> in = incident_light(textbook::ready(light), place);
    EXPECT_EQ(in.attenuation, 1.0F);
    EXPECT_EQ(in.spot, 1.0F);
    EXPECT_EQ(in.distance, 0.0F);
    EXPECT_EQ(in.to_light, leaning(30));
  }
}

TEST(Lighting, APointLightShinesFromItsPlace) {
  const Light light{.type = LightType::point, .position = {1, 2, 3}};
  const Incident<float> in = incident_light(textbook::ready(light), Vec3f{1, -1, 7});  // offset (0, 3, -4)
  EXPECT_EQ(in.distance, 5.0F);
  EXPECT_NEAR(in.to_light.y, 0.6F, kRounding);
  EXPECT_NEAR(in.to_light.z, -0.8F, kRounding);
  EXPECT_EQ(in.attenuation, 1.0F);
  EXPECT_EQ(in.spot, 1.0F);
}

TEST(Lighting, AttenuationIsOneOverThePolynomial) {
  EXPECT_EQ(attenuation_of(2, {.constant = 2, .linear = 1, .quadratic = 1}), 0.125F);  // 1 / (2 + 2 + 4)
  for (double d : {0.25, 1.0, 3.0, 1000.0}) {
    EXPECT_NEAR(attenuation_of(d, {.constant = 1, .linear = 0.05, .quadratic = 0.03}), 1 / (1 + 0.05 * d + 0.03 * d * d), kRounding) << d;
    EXPECT_EQ(attenuation_of(d, {}), 1.0F) << "the default does not attenuate";
  }
}

TEST(Lighting, FalloffIsOneOverAPowerOfTheDistance) {
  for (double p : {0.0, 0.5, 1.0, 2.0, 3.0}) {
    for (double d : {1.0, 1.5, 4.0, 50.0}) {
      const double f = 1 / std::pow(d, p);
      EXPECT_NEAR(attenuation_of(d, {.falloff = p}), f, 5e-6 * f) << p << ' ' << d;
    }
  }
  EXPECT_EQ(attenuation_of(4, {.falloff = 2}), 0.0625F);
}

TEST(Lighting, AttenuationIsLimitedToOneUnlessUnclamped) {
  EXPECT_EQ(attenuation_of(1, {.constant = 0.5}), 1.0F);
  EXPECT_EQ(attenuation_of(1, {.constant = 0.5, .unclamped = true}), 2.0F);
  for (double p : {0.5, 1.0, 2.0, 3.0}) {
    EXPECT_EQ(attenuation_of(0.25, {.falloff = p}), 1.0F) << p;
    EXPECT_NEAR(attenuation_of(0.25, {.falloff = p, .unclamped = true}), std::pow(4, p), 5e-6 * std::pow(4, p)) << p;
  }
}

TEST(Lighting, InTheLightItselfNothingBreaks) {  // d = 0: L does not exist, so neither diffuse nor highlight; the light's ambient remains
  for (const Attenuation& a : {Attenuation{}, Attenuation{.constant = 0, .linear = 1}, Attenuation{.constant = 0, .quadratic = 1},
                               Attenuation{.falloff = 0.5}, Attenuation{.falloff = 2}, Attenuation{.falloff = 3}}) {
    Light light = bulb(0, a);
    light.ambient.rgb = {1, 1, 1};
    for (LightType type : {LightType::point, LightType::spot}) {
      light.type = type;
      const Terms<float> terms = shine(Lighting::phong, kFlatOnTheTable, white(5), {light});
      EXPECT_EQ(terms.diffuse.x, 0.0F);
      EXPECT_EQ(terms.specular.x, 0.0F);
      EXPECT_EQ(terms.ambient.x, type == LightType::point ? 1.0F : 0.0F);
    }
    light.type = LightType::point;
    light.attenuation.unclamped = true;
    EXPECT_TRUE(std::isfinite(shine(Lighting::phong, kFlatOnTheTable, white(5), {light}).diffuse.x));
  }
}

// --- spots ------------------------------------------------------------------------------------------------------------------------------------

/// s of a spot above that aims straight down, at a point `degrees` off its axis.
float spot_at(double degrees, const Light& like) {
  Light light = like;
  light.type = LightType::spot;
  light.position = vec_cast<double>(leaning(degrees)) * 3.0;
  light.direction = {0, 0, -2};  // of any length
  return incident_light(textbook::ready(light), Vec3f{0, 0, 0}).spot;
}

TEST(Lighting, ASpotIsDarkOutsideItsCutoff) {
  for (double cutoff : {5.0, 28.0, 45.0, 89.0, 90.0}) {
    EXPECT_EQ(spot_at(cutoff - 0.1, {.cutoff = cutoff}), 1.0F) << cutoff;
    EXPECT_EQ(spot_at(cutoff + 0.1, {.cutoff = cutoff}), 0.0F) << cutoff;
  }
  EXPECT_EQ(spot_at(44.9, {}), 1.0F) << "45 unless stated";
  EXPECT_EQ(spot_at(45.1, {}), 0.0F);
}

TEST(Lighting, TheEdgeOfTheConeIsInside) {  // OpenGL 2.1: lit where the cosine is >= cos(cutoff)
  const ShadingLight light = textbook::ready({.type = LightType::spot, .cutoff = 30});
  EXPECT_EQ(spot_factor(light, light.cos_cutoff), 1.0F);
  EXPECT_EQ(spot_factor(light, std::nextafter(light.cos_cutoff, 0.0F)), 0.0F);
}

TEST(Lighting, TheSpotExponentDimsTowardsTheEdge) {
  for (double e : {1.0, 12.0, 128.0}) {
    for (double degrees : {0.0, 10.0, 40.0}) {
      const double s = std::pow(cosine_of(degrees), e);
      EXPECT_NEAR(spot_at(degrees, {.exponent = e}), s, 4e-7 * (1 + e) * s) << e << ' ' << degrees;
    }
  }
  EXPECT_EQ(spot_at(46, {.exponent = 1}), 0.0F) << "the cutoff still cuts";
}

TEST(Lighting, TheBeamFadesBySmoothstepBetweenTheCosines) {
  const ShadingLight light = textbook::ready({.type = LightType::spot, .cutoff = 60, .beam = 0});  // cosines 1/2 and 1
  EXPECT_NEAR(spot_factor(light, 0.5F), 0, 1e-6F);
  EXPECT_NEAR(spot_factor(light, 0.625F), 0.15625F, 1e-6F);  // t = 1/4: t^2 (3 - 2 t) = 5/32
  EXPECT_NEAR(spot_factor(light, 0.75F), 0.5F, 1e-6F);       // the midpoint
  EXPECT_NEAR(spot_factor(light, 0.875F), 0.84375F, 1e-6F);  // 27/32
  EXPECT_NEAR(spot_factor(light, 1.0F), 1.0F, 1e-6F);
}

TEST(Lighting, InsideTheBeamTheSpotIsWhole) {
  EXPECT_EQ(spot_at(19.9, {.cutoff = 28, .beam = 20}), 1.0F);
  EXPECT_LT(spot_at(22, {.cutoff = 28, .beam = 20}), 0.95F);
  EXPECT_GT(spot_at(27, {.cutoff = 28, .beam = 20}), 0.01F);
  EXPECT_EQ(spot_at(28.1, {.cutoff = 28, .beam = 20}), 0.0F);
}

TEST(Lighting, BeamAndExponentMultiply) {
  const float faded = spot_at(25, {.cutoff = 40, .beam = 10});
  EXPECT_NEAR(spot_at(25, {.cutoff = 40, .beam = 10, .exponent = 3}) / faded, std::pow(cosine_of(25), 3), 3e-6);
}

TEST(Lighting, TheQuadraticFadeIsTheSquareBetweenTheCosines) {  // KHR_lights_punctual: saturate((cd - cos outer) / (cos inner - cos outer))^2
  const ShadingLight light = textbook::ready({.type = LightType::spot, .cutoff = 60, .beam = 0, .fade = SpotFade::quadratic});
  EXPECT_NEAR(spot_factor(light, 0.5F), 0, 1e-6F);
  EXPECT_NEAR(spot_factor(light, 0.625F), 0.0625F, 1e-6F);
  EXPECT_NEAR(spot_factor(light, 0.75F), 0.25F, 1e-6F);
  EXPECT_NEAR(spot_factor(light, 1.0F), 1.0F, 1e-6F);
}

TEST(Lighting, TheRangeEndsALight) {  // 1/d^2 clamp(1 - (d/range)^4, 0, 1): at half the range 15/16 of it
  const Attenuation khr{.falloff = 2, .unclamped = true, .range = 4};
  EXPECT_NEAR(attenuation_of(2, khr), 0.25 * 15 / 16, 1e-7);
  EXPECT_NEAR(attenuation_of(0.5, khr), 4 * (1 - 1.0 / 4096), 1e-6);
  EXPECT_NEAR(attenuation_of(3.5, khr), (1 - std::pow(3.5 / 4, 4)) / (3.5 * 3.5), 1e-8);
  EXPECT_EQ(attenuation_of(4, khr), 0.0F);
  EXPECT_EQ(attenuation_of(5, khr), 0.0F);
  EXPECT_EQ(attenuation_of(1e6, khr), 0.0F);
  EXPECT_NEAR(attenuation_of(1, {.range = 2}), 15.0 / 16, 1e-7) << "of a light that does not attenuate otherwise, too";
}

// --- GGX: glTF 2.0, appendix B
// ------------------------------------------------------------------------------------------------------------------

TEST(Lighting, GgxFacingEverythingIsOneOverFourAlphaSquared) {  // N = L = V = H: pi D = 1/a, Vis = 1/4, F = k_s
  Coefficients<float> k = white();
  k.specular = {0.04F, 0.5F, 1};
  for (const float n : {0.0F, 6.0F, 198.0F, 9998.0F}) {  // a = 1, 1/4, 1/100, 1/5000
    k.shininess = n;
    const Terms<float> terms = shine(Lighting::ggx, kFlatOnTheTable, k, {sun({0, 0, 1})});
    const float lobe = (n + 2) / 8;
    EXPECT_NEAR(terms.specular.x, 0.04F * lobe, 1e-5F * lobe) << n;
    EXPECT_NEAR(terms.specular.y, 0.5F * lobe, 1e-5F * lobe) << n;
    EXPECT_NEAR(terms.specular.z, lobe, 1e-5F * lobe) << n;
    EXPECT_NEAR(terms.diffuse.x, 0.96F, 1e-6F) << n;  // (1 - F) k_d
    EXPECT_NEAR(terms.diffuse.y, 0.5F, 1e-6F) << n;
    EXPECT_EQ(terms.diffuse.z, 0.0F) << "a mirror has no diffuse light";
  }
}

TEST(Lighting, GgxAtSixtyDegreesByHand) {
  // L and V 60 degrees off N on either side: N.L = N.V = V.H = 1/2, N.H = 1; a = 1/4 (n = 6), k_s = 0.04.
  // (1 - V.H)^5 = 1/32, F = 0.04 + 0.96/32 = 0.07; pi D = 4; sqrt(1/4 + 3/4 * 1/4) = sqrt(7)/4 = 0.6614378,
  // Vis = 1 / (0.5 + 0.6614378)^2 = 0.7413198; F pi D Vis N.L = 0.07 * 4 * 0.7413198 / 2 = 0.1037848; (1 - F) N.L = 0.465
  Coefficients<float> k = white(6);
  k.specular = {0.04F, 0.04F, 0.04F};
  const Terms<float> terms = shine(Lighting::ggx, surface({0, 0, 1}, leaning(60)), k, {sun(leaning(-60))});
  EXPECT_NEAR(terms.specular.x, 0.1037848F, 1e-6F);
  EXPECT_NEAR(terms.diffuse.x, 0.465F, 1e-6F);
}

TEST(Lighting, GgxTiltedByHand) {
  // N = V = up, L 60 degrees off: H leans 30, N.H = V.H = sqrt(3)/2, N.L = 1/2; a = 1/4.
  // pi D = (1/4) / (3/4 * (-3/4) + 1)^2 = 0.25 / 0.4375^2 = 1.3061224; (1 - 0.8660254)^5 = 4.3163e-5, F = 0.0400414
  // Vis = 1 / ((0.5 + 0.6614378) (1 + 1)) = 0.4305008; F pi D Vis N.L = 0.0400414 * 1.3061224 * 0.4305008 / 2 = 0.0112574
  Coefficients<float> k = white(6);
  k.specular = {0.04F, 0.04F, 0.04F};
  const Terms<float> terms = shine(Lighting::ggx, kFlatOnTheTable, k, {sun(leaning(60))});
  EXPECT_NEAR(terms.specular.x, 0.0112574F, 3e-7F);
  EXPECT_NEAR(terms.diffuse.x, (1 - 0.0400414F) / 2, 1e-6F);
}

TEST(Lighting, GgxGrazesWhite) {  // Schlick: at V.H = 0 everything reflects, whatever its colour
  Coefficients<float> k = white(6);
  k.specular = {0.04F, 0.5F, 0};
  const Terms<float> terms = shine(Lighting::ggx, surface({0, 0, 1}, leaning(89.99)), k, {sun(leaning(-89.99))});
  EXPECT_NEAR(terms.specular.x / terms.specular.y, 1, 2e-3);
  EXPECT_NEAR(terms.specular.z / terms.specular.y, 1, 3e-3);
  EXPECT_LT(terms.diffuse.x, 1e-6F);
}

TEST(Lighting, GgxIsDarkBehindAndFiniteEverywhere) {
  for (const float n : {0.0F, 50.0F, 10000.0F}) {
    for (int degrees : {90, 91, 120, 180}) {
      const Terms<float> terms = shine(Lighting::ggx, kFlatOnTheTable, white(n), {sun(leaning(degrees + 0.001))});
      EXPECT_EQ(terms.specular.x, 0.0F) << degrees;
      EXPECT_EQ(terms.diffuse.x, 0.0F) << degrees;
    }
    for (int eye = 0; eye < 360; eye += 5) {  // also where the eye looks at the back, and where L and V are opposite
      const Terms<float> terms =
          shine(Lighting::ggx, surface({0, 0, 1}, leaning(eye)), white(n), {sun(leaning(30)), bulb(0), sun(-leaning(eye))});
      EXPECT_TRUE(std::isfinite(terms.sum().x)) << eye;
      EXPECT_GE(terms.specular.x, 0.0F) << eye;
    }
  }
}

TEST(Lighting, GgxCountsSpecularAboveOneAsOne) {
  Coefficients<float> k = white(20);
  const auto with = [&](float specular) {
    k.specular = {specular, specular, specular};
    return shine(Lighting::ggx, surface(leaning(5), leaning(40)), k, {sun(leaning(-30))}).sum();
  };
  EXPECT_EQ(with(1), with(7));
}

// --- many lights ------------------------------------------------------------------------------------------------------------------------------

TEST(Lighting, LightsAddUp) {
  Light dim = sun({0, 0, 1});
  dim.diffuse.rgb = {0.25F, 0.25F, 0.25F};
  EXPECT_EQ(shine(Lighting::lambert, kFlatOnTheTable, white(), {sun({0, 0, 1}), dim, bulb(2, {.constant = 2})}).diffuse.x, 1.75F);
}

TEST(Lighting, VisitSeesEachLightsPartInOrder) {
  Light dim = bulb(2, {.constant = 4});
  dim.ambient.rgb = {0.5F, 0.5F, 0.5F};
  std::vector<float> attenuation, ambient, diffuse, specular;
  light_surface(Lighting::phong, kFlatOnTheTable, white(1), Vec3f{1, 1, 1}, ready({sun({0, 0, 1}), dim}), false,
                [&](std::size_t i, const Incident<float>& in, const LightTerms<float>& part) {
                  EXPECT_EQ(i, attenuation.size());
                  attenuation.push_back(in.attenuation);
                  ambient.push_back(part.ambient.x);
                  diffuse.push_back(part.diffuse.x);
                  specular.push_back(part.specular.x);
                });
  EXPECT_EQ(attenuation, (std::vector{1.0F, 0.25F}));
  EXPECT_EQ(ambient, (std::vector{0.0F, 0.125F}));
  EXPECT_EQ(diffuse, (std::vector{1.0F, 0.25F}));
  EXPECT_EQ(specular, (std::vector{1.0F, 0.25F}));
}

TEST(Lighting, TheColourIsTheSumOfTheTermsInTheStatedOrder) {  // beyond 2^25 a float steps by 4: any other order rounds to another number
  const Terms<float> terms{{1, 1, 1}, {1, 1, 1}, {33554436, 33554436, 33554436}, {3, 3, 3}};
  EXPECT_EQ(terms.sum(), (Vec3f{33554444, 33554444, 33554444}));
}

}  // namespace
}  // namespace lustro
