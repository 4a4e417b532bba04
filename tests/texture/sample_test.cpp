// Every wrap mode and filter against a sampler in double precision, which shares nothing with the look-up but the texels.
#include "texture/sample.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "texture/random_texture.hpp"
#include "texture/sampler_oracle.hpp"

namespace lustro {
namespace {

constexpr std::array kWraps{Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge, Wrap::clamp_to_border};
constexpr std::array kFilters{TextureFilter::nearest, TextureFilter::linear};
constexpr std::array kMips{MipFilter::none, MipFilter::nearest, MipFilter::linear};

Texel<float> sampled(const Texture& texture, const Sampler& sampler, const Footprint<float>& at) {
  return sample(sampler, TexelReader(texture.layout()), static_cast<float>(texture.width()), static_cast<float>(texture.height()), at);
}

Footprint<float> random_footprint(std::mt19937& random, const Texture& texture) {
  const auto between = [&](float low, float high) { return low + (high - low) * unit_random(random); };
  const float size = std::exp2(between(-3, 6));  // texels
  const float w = static_cast<float>(texture.width());
  const float h = static_cast<float>(texture.height());
  Footprint<float> at{between(-3, 3), between(-3, 3), 0, 0, 0, 0};
  at.u_dx = between(-1, 1) * size / w;
  at.v_dx = between(-1, 1) * size / h;
  at.u_dy = between(-1, 1) * size / w;
  at.v_dy = between(-1, 1) * size / h;
  return at;
}

Footprint<double> widened(const Footprint<float>& at) {
  return {static_cast<double>(at.u),    static_cast<double>(at.v),    static_cast<double>(at.u_dx),
          static_cast<double>(at.v_dx), static_cast<double>(at.u_dy), static_cast<double>(at.v_dy)};
}

/// Calls check(sampler) for every combination.
void for_every_sampler(const std::function<void(const Sampler&)>& check) {
  for (const Wrap wrap_u : kWraps) {
    for (const Wrap wrap_v : kWraps) {
      for (const TextureFilter magnify : kFilters) {
        for (const TextureFilter minify : kFilters) {
          for (const MipFilter mip : kMips) {
            for (const int anisotropy : {1, 8}) {
              Sampler sampler{wrap_u, wrap_v, magnify, minify, mip, anisotropy, {0.3F, 0.7F, 0.1F, 0.9F}};
              check(sampler);
              sampler.lod_bias = anisotropy == 1 ? -1.25F : 0.75F;
              sampler.blend_u = mip == MipFilter::linear;
              sampler.blend_v = wrap_u != wrap_v;
              check(sampler);
            }
          }
        }
      }
    }
  }
}

TEST(Sample, EqualsTheSpecificationForEveryWrapAndFilter) {
  std::mt19937 random(1);
  int compared = 0, passed_over = 0;
  for (const std::array<int, 2>& size : std::vector<std::array<int, 2>>{{8, 8}, {5, 3}, {1, 7}, {1, 1}}) {
    for (const bool is_hdr : {false, true}) {
      const auto texture = made(noise(size[0], size[1], 4, static_cast<unsigned>(size[0]), is_hdr ? -2 : 0, is_hdr ? 2 : 1));
      for_every_sampler([&](const Sampler& sampler) {
        for (int i = 0; i < 25; ++i) {
          const Footprint<float> at = random_footprint(random, *texture);
          SamplerOracle oracle(*texture, sampler);
          const Rgba expected = oracle.sample(widened(at));
          if (oracle.margin < 2e-5) {  // of a choice that single precision may make the other way
            ++passed_over;
            continue;
          }
          ++compared;
          const Texel<float> value = sampled(*texture, sampler, at);
          for (std::size_t c = 0; c < 4; ++c) {
            ASSERT_NEAR(static_cast<double>(value[c]), expected[c], 5e-5)
                << size[0] << " x " << size[1] << ", wrap " << static_cast<int>(sampler.wrap_u) << " " << static_cast<int>(sampler.wrap_v)
                << ", magnify " << static_cast<int>(sampler.magnify) << ", minify " << static_cast<int>(sampler.minify) << ", mip "
                << static_cast<int>(sampler.mip) << ", anisotropy " << sampler.anisotropy << ", at " << at.u << " " << at.v << ", " << at.u_dx
                << " " << at.v_dx << " " << at.u_dy << " " << at.v_dy;
          }
        }
      });
    }
  }
  EXPECT_GT(compared, 20 * passed_over);
}

TEST(Sample, ATexelsCentreShowsTheTexelExactly) {
  const auto texture = made(noise(8, 4, 4, 3));
  for (const Wrap wrap : kWraps) {
    const Sampler sampler{.wrap_u = wrap, .wrap_v = wrap};
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 8; ++x) {
        EXPECT_EQ(sampled(*texture, sampler, {(static_cast<float>(x) + 0.5F) / 8, (static_cast<float>(y) + 0.5F) / 4, 1.0F / 8, 0, 0, 0}),
                  texture->texel(0, x, y));
      }
    }
  }
}

TEST(Sample, BytesAreLookedUpAsTheSameValuesInSixteenBits) {
  std::mt19937 random(8);
  for (const int channels : {2, 3, 4}) {
    Image image = noise(9, 12, channels, 5);
    for (float& value : image.pixels) {
      value = std::round(value * 255) / 255;
    }
    const auto bytes = made(image);
    ASSERT_EQ(bytes->format(), Texture::Format::unorm8);
    Image finer(10, 12, channels);  // one more column, of which a texel is no whole 255th: the others are compared
    for (int y = 0; y < 12; ++y) {
      for (int x = 0; x < 10; ++x) {
        std::copy_n(image.at(x % 9, y).begin(), channels, finer.at(x, y).begin());
      }
    }
    finer.pixels.back() = 0.1234567F;
    const auto unorms = made(finer);
    ASSERT_EQ(unorms->format(), Texture::Format::unorm16);
    const Sampler sampler{.wrap_u = Wrap::clamp_to_edge, .wrap_v = Wrap::clamp_to_edge, .mip = MipFilter::none};
    for (int i = 0; i < 200; ++i) {
      const float x = 0.5F + 8 * static_cast<float>(random() % 1000) / 1000;  // in texels, before the last column
      const float y = 0.5F + 10 * static_cast<float>(random() % 1000) / 1000;
      const Texel<float> a = sampled(*bytes, sampler, {x / 9, y / 12, 0.01F, 0, 0, 0.01F});
      const Texel<float> b = sampled(*unorms, sampler, {x / 10, y / 12, 0.01F, 0, 0, 0.01F});
      for (std::size_t c = 0; c < 4; ++c) {
        ASSERT_NEAR(a[c], b[c], 1e-5F);
      }
    }
  }
}

TEST(Sample, AConstantTextureGivesTheConstantExactly) {
  Image image(6, 5, 4);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = std::array{0.2F, 0.4F, 0.6F, 0.8F}[i % 4];
  }
  const auto texture = made(image);
  std::mt19937 random(2);
  for_every_sampler([&](Sampler sampler) {
    sampler.wrap_u = sampler.wrap_u == Wrap::clamp_to_border ? Wrap::repeat : sampler.wrap_u;
    sampler.wrap_v = sampler.wrap_v == Wrap::clamp_to_border ? Wrap::repeat : sampler.wrap_v;
    for (int i = 0; i < 10; ++i) {
      ASSERT_EQ(sampled(*texture, sampler, random_footprint(random, *texture)), texture->texel(0, 0, 0));
    }
  });
}

TEST(Sample, AWholeShiftUnderRepeatAndAnEvenOneUnderMirroringChangeNothing) {
  const auto texture = made(noise(7, 6, 4, 5));
  std::mt19937 random(3);
  for_every_sampler([&](Sampler sampler) {
    const auto even = [](Wrap wrap) { return wrap == Wrap::mirrored_repeat ? 2.0F : 1.0F; };
    if (sampler.wrap_u > Wrap::mirrored_repeat || sampler.wrap_v > Wrap::mirrored_repeat || sampler.anisotropy > 1) {
      return;
    }
    Footprint<float> at = random_footprint(random, *texture);
    at.u = std::floor(at.u * 1024) / 1024;  // so that the shift is exact
    at.v = std::floor(at.v * 1024) / 1024;
    const Texel<float> value = sampled(*texture, sampler, at);
    at.u += 3 * even(sampler.wrap_u);
    at.v -= 2 * even(sampler.wrap_v);
    ASSERT_EQ(sampled(*texture, sampler, at), value);
  });
}

TEST(Sample, MirroringIsSymmetricAboutEveryEdge) {
  const auto texture = made(noise(8, 8, 4, 6));
  const Sampler sampler{.wrap_u = Wrap::mirrored_repeat, .wrap_v = Wrap::mirrored_repeat};
  std::mt19937 random(4);
  for (int i = 0; i < 200; ++i) {
    const float d = std::floor(unit_random(random) * 512) / 512;
    const float v = unit_random(random);
    for (const float edge : {-1.0F, 0.0F, 1.0F, 2.0F}) {
      ASSERT_EQ(sampled(*texture, sampler, {edge + d, v, 0.1F, 0, 0, 0.2F}), sampled(*texture, sampler, {edge - d, v, 0.1F, 0, 0, 0.2F}));
    }
  }
}

TEST(Sample, TheBorderIsSeenOutsideAndHalfAtTheEdge) {
  Image white(4, 4, 1);
  std::fill(white.pixels.begin(), white.pixels.end(), 1.0F);
  const auto texture = made(white);
  const Sampler sampler{.wrap_u = Wrap::clamp_to_border, .wrap_v = Wrap::clamp_to_edge, .border = {0.25F, 0, 0, 0.5F}};
  EXPECT_EQ(sampled(*texture, sampler, {-0.5F, 0.5F, 0, 0, 0, 0}), (Texel<float>{0.25F, 0, 0, 0.5F}));
  EXPECT_EQ(sampled(*texture, sampler, {1.5F, 0.5F, 0, 0, 0, 0}), (Texel<float>{0.25F, 0, 0, 0.5F}));
  EXPECT_EQ(sampled(*texture, sampler, {0, 0.5F, 0, 0, 0, 0}), (Texel<float>{0.625F, 0.5F, 0.5F, 0.75F}));
  EXPECT_EQ(sampled(*texture, sampler, {1, 0.5F, 0, 0, 0, 0}), (Texel<float>{0.625F, 0.5F, 0.5F, 0.75F}));
  EXPECT_EQ(sampled(*texture, sampler, {0.5F, 7, 0, 0, 0, 0}), (Texel<float>{1, 1, 1, 1}));
}

TEST(Sample, TrilinearIsContinuousAcrossLevels) {
  const auto texture = made(noise(64, 64, 1, 7));
  const Sampler sampler;
  for (int level = 0; level < 6; ++level) {
    const float texels = std::exp2(static_cast<float>(level));
    const float below = sampled(*texture, sampler, {0.3F, 0.6F, texels * 0.99999F / 64, 0, 0, 0})[0];
    const float above = sampled(*texture, sampler, {0.3F, 0.6F, texels * 1.00001F / 64, 0, 0, 0})[0];
    EXPECT_NEAR(below, above, 5e-5F) << level;
  }
}

TEST(Sample, ALevelIsShownAsItIsWhereItsTexelsAreAPixel) {
  const auto texture = made(noise(16, 16, 4, 8));
  for (int level = 0; level < 5; ++level) {
    const float texels = std::exp2(static_cast<float>(level));
    const Texel<float> value = sampled(*texture, {}, {texels * 0.5F / 16, texels * 0.5F / 16, texels / 16, 0, 0, texels / 16});
    for (std::size_t c = 0; c < 4; ++c) {
      EXPECT_NEAR(value[c], texture->texel(static_cast<std::size_t>(level), 0, 0)[c], 1e-6F) << level;
    }
  }
}

TEST(Sample, AFootprintFourTimesAsLongAsWideTakesFourLooksAtTheWidthsLevel) {
  Footprint<float> at{0.5F, 0.5F, 8.0F / 64, 0, 0, 2.0F / 64};  // 8 by 2 texels
  const FootprintSize<float> four = size_of_footprint<float>({.anisotropy = 16}, 64, 64, at);
  EXPECT_EQ(four.looks, 4);
  EXPECT_NEAR(four.lod, 1, 1e-6F);
  EXPECT_EQ(four.u_long, 8.0F / 64);
  EXPECT_EQ(four.v_long, 0);
  const FootprintSize<float> two = size_of_footprint<float>({.anisotropy = 2}, 64, 64, at);
  EXPECT_EQ(two.looks, 2);
  EXPECT_NEAR(two.lod, 2, 1e-6F);
  EXPECT_NEAR(size_of_footprint<float>({}, 64, 64, at).lod, 3, 1e-6F);
  // Stripes across the long axis vanish, stripes along it stay: which no isotropic level can show.
  Image stripes(64, 64, 1);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      stripes.at(x, y)[0] = static_cast<float>(y / 4 % 2);
    }
  }
  const auto texture = made(stripes);
  at.v = 34.0F / 64;
  const float isotropic = sampled(*texture, {.anisotropy = 1}, at)[0];
  const float anisotropic = sampled(*texture, {.anisotropy = 16}, at)[0];
  EXPECT_NEAR(isotropic, 0.5F, 1e-4F);
  EXPECT_NEAR(anisotropic, 0, 1e-4F);
}

TEST(Sample, ACoordinateJustBelow0ShowsTheLastTexelOfARepeatedPicture) {  // c - floor(c) is 1 for it, in single precision
  const auto texture = made(noise(3, 5, 4, 10));
  const Sampler sampler{.magnify = TextureFilter::nearest, .minify = TextureFilter::nearest, .mip = MipFilter::none};
  for (const float tiny : {-1e-9F, -1e-40F}) {
    EXPECT_EQ(sampled(*texture, sampler, {tiny, tiny, 0, 0, 0, 0}), texture->texel(0, 2, 4));
    EXPECT_EQ(sampled(*texture, sampler, {0.5F, tiny, 0, 0, 0, 0}), texture->texel(0, 1, 4));
  }
  const Texel<float> linear = sampled(*texture, {}, {-1e-9F, 0.5F, 0, 0, 0, 0});  // half way between the last and the first
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_NEAR(linear[c], (texture->texel(0, 2, 2)[c] + texture->texel(0, 0, 2)[c]) / 2, 1e-6F);
  }
}

TEST(Sample, AnyNumbersAtAllReadNothingOutsideTheTexture) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const std::array<float, 18> wild{std::numeric_limits<float>::quiet_NaN(),
                                   kInfinity,
                                   -kInfinity,
                                   3.4e38F,
                                   -3.4e38F,
                                   1e30F,
                                   -1e9F,
                                   16777216.0F,
                                   -16777217.0F,
                                   1e-40F,
                                   -1e-40F,
                                   -1e-9F,
                                   0.99999994F,
                                   1.0F,
                                   -1.0F,
                                   0.0F,
                                   -0.0F,
                                   2.0F};
  std::mt19937 random(5);
  // The block ends with the last level: a sanitizer sees a read behind it, and every value must lie within what the texels and the border hold.
  for (const auto& [width, height] : std::vector<std::array<int, 2>>{{1, 1}, {3, 2}, {1000, 3}}) {
    const auto texture = made(noise(width, height, 4, 1));
    for_every_sampler([&](const Sampler& sampler) {
      for (int i = 0; i < 60; ++i) {
        const auto pick = [&] { return wild[random() % wild.size()]; };
        const Texel<float> value = sampled(*texture, sampler, {pick(), pick(), pick(), pick(), pick(), pick()});
        for (const float channel : value) {
          ASSERT_GE(channel, 0);
          ASSERT_LE(channel, 1);
        }
      }
    });
  }
}

}  // namespace
}  // namespace lustro
