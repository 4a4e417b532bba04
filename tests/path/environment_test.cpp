// The sky as a sampler.
#include "path/environment.hpp"

#include "chi_square.hpp"

namespace lustro {
namespace {

PreparedEnvironment sky_of(int width, int height, bool with_sun) {
  Image picture(width, height, 3);
  std::mt19937 random(11);
  for (float& value : picture.pixels) {
    value = 0.2F + static_cast<float>(random() >> 8U) * 0x1p-24F;
  }
  if (with_sun) {
    picture.at(width / 3, height / 4)[1] = 500;
  }
  PreparedEnvironment environment;
  environment.color = {1, 1, 1};
  environment.picture = std::make_shared<const Image>(std::move(picture));
  const double turn = radians(33);
  environment.cosine = static_cast<float>(std::cos(turn));
  environment.sine = static_cast<float>(std::sin(turn));
  return environment;
}

TEST(Sky, DirectionsFallAsTheirDensitySays) {
  for (const bool with_sun : {false, true}) {
    const PreparedEnvironment environment = sky_of(16, 8, with_sun);
    const Sky sky(environment);
    expect_distribution(
        [&](const Vec2f& u) {
          const SkySample sample = sky.sample(u);
          EXPECT_NEAR(length(sample.direction), 1, 1e-5F);
          return sample.direction;
        },
        [&](const Vec3f& d) { return static_cast<double>(sky.density(d)); }, with_sun ? "with a sun" : "clouds");
  }
}

TEST(Sky, TheMeanOfRadianceOverDensityIsItsIntegral) {
  const PreparedEnvironment environment = sky_of(32, 16, true);
  const Sky sky(environment);
  Uniform uniform;
  double by_density = 0;
  double spread = 0;
  constexpr int kSamples = 100000;
  for (int i = 0; i < kSamples; ++i) {
    const SkySample sample = sky.sample(uniform.two());
    if (!(sample.density > 0)) {
      continue;  // at a pole, to the last bit
    }
    const Vec3f radiance = sky.radiance(sample.direction);
    const double value =
        (0.2126 * static_cast<double>(radiance.x) + 0.7152 * static_cast<double>(radiance.y) + 0.0722 * static_cast<double>(radiance.z)) /
        static_cast<double>(sample.density);
    by_density += value / kSamples;
    spread += value * value / kSamples;
  }
  const double deviation = std::sqrt(spread - by_density * by_density);
  EXPECT_NEAR(by_density, static_cast<double>(sky.power()), 0.01 * by_density) << "rows are not wholly even in their solid angle";
  EXPECT_LT(deviation, by_density) << "the sun is hardly found; evenly it would be seven times the mean";
}

TEST(Sky, IsSeenWhereReflectionMapsAreLaidOut) {
  Image picture(4, 2, 3);
  for (int x = 0; x < 4; ++x) {
    picture.at(x, 0)[0] = picture.at(x, 1)[0] = static_cast<float>(x);
    picture.at(x, 0)[1] = 1;
  }
  PreparedEnvironment environment;
  environment.color = {2, 2, 2};
  environment.picture = std::make_shared<const Image>(picture);
  const Sky sky(environment);
  // u = 1/2 + atan2(x, -z) / 2 pi: -z lies between the pixels 1 and 2, +x between 2 and 3, +z between 3 and 0.
  EXPECT_NEAR(sky.radiance({0, 0, -1}).x, 2 * 1.5F, 1e-4F);
  EXPECT_NEAR(sky.radiance({1, 0, 0}).x, 2 * 2.5F, 1e-4F);
  EXPECT_NEAR(sky.radiance({-1, 0, 0}).x, 2 * 0.5F, 1e-4F);
  EXPECT_NEAR(sky.radiance({0, 0, 1}).x, 2 * 1.5F, 1e-3F);
  EXPECT_NEAR(sky.radiance({0, 1, 0}).y, 2, 1e-4F);
  EXPECT_NEAR(sky.radiance({0, -1, 0}).y, 0, 1e-4F);
}

TEST(Sky, ABlackOneHasNoPowerAndIsNeverChosen) {
  PreparedEnvironment environment;
  environment.color = {1, 1, 1};
  environment.picture = std::make_shared<const Image>(4, 2, 3);
  const Sky sky(environment);
  EXPECT_EQ(sky.power(), 0);
  EXPECT_EQ(sky.sample({0.5F, 0.5F}).density, 0);
}

}  // namespace
}  // namespace lustro
