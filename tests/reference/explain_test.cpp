// An explanation is the rendering of one pixel: equal to the last bit.
#include <array>

#include "reference/explained_products.hpp"
#include "reference/scenes.hpp"

namespace lustro {
namespace {

TEST(Explain, EqualsTheRenderedPixelExactly) {
  std::mt19937 random(2);
  for (const Interpolation interpolation : {Interpolation::flat, Interpolation::gouraud, Interpolation::phong}) {
    for (const Lighting lighting : {Lighting::constant, Lighting::lambert, Lighting::phong, Lighting::blinn_phong}) {
      for (const int samples : {1, 8}) {
        Scene scene = rich_scene();
        scene.shading.interpolation = interpolation;
        scene.shading.lighting = lighting;
        scene.shading.two_sided = samples == 8;
        scene.image.samples = samples;
        const Rendering picture = drawn(scene);
        const ByteImage bytes = to_bytes(picture.color, scene.image.transfer);
        for (int i = 0; i < 25; ++i) {
          const int x = static_cast<int>(random() % 97);
          const int y = static_cast<int>(random() % 61);
          const auto e = explain(scene, x, y);
          ASSERT_TRUE(e) << e.error().text();
          const auto pixel = picture.color.at(x, y);
          const std::array<float, 4> rendered{pixel[0], pixel[1], pixel[2], pixel[3]};
          ASSERT_EQ(e->color, rendered) << x << ", " << y;
          const Vec3f sum = ((((e->ambient + e->diffuse) + e->specular) + e->emission) + e->fog) + e->background;
          ASSERT_EQ(sum, (Vec3f{rendered[0], rendered[1], rendered[2]}));
          const std::size_t at = (static_cast<std::size_t>(y) * 97 + static_cast<std::size_t>(x)) * 4;
          for (std::size_t c = 0; c < 4; ++c) {
            ASSERT_EQ(e->bytes[c], bytes.pixels[at + c]);
          }
        }
      }
    }
  }
}

TEST(Explain, ALightsNumbersFollowFromItsVectors) {
  Scene scene = rich_scene();
  scene.image.samples = 1;
  const auto e = explain(scene, 48, 30);
  ASSERT_TRUE(e);
  ASSERT_EQ(e->fragments.size(), 1U);
  const FragmentExplanation& f = e->fragments[0];
  ASSERT_EQ(f.shadings.size(), 1U);
  const ShadingExplanation& s = f.shadings[0];
  ASSERT_EQ(s.lights.size(), 3U);
  Vec3f diffuse{};
  for (const LightExplanation& l : s.lights) {
    EXPECT_NEAR(length(l.to_light), 1, 1e-6F);
    EXPECT_NEAR(l.n_dot_l, dot(s.normal, l.to_light), 1e-6F);
    EXPECT_NEAR(l.r_dot_v, dot(l.reflected, s.to_eye), 1e-5F);
    EXPECT_NEAR(l.n_dot_h, dot(l.half, s.normal), 1e-5F);
    diffuse += l.diffuse;
  }
  EXPECT_EQ(diffuse, s.diffuse);
  EXPECT_NEAR(s.diffuse.x * f.fog_factor, e->diffuse.x, 1e-6F);
  EXPECT_NEAR(f.barycentrics.x + f.barycentrics.y + f.barycentrics.z, 1, 1e-6F);
  EXPECT_EQ(s.lights[0].distance, 0.0F);
  EXPECT_LT(s.lights[1].attenuation, 1.0F);
}

TEST(Explain, FactorsMultiplyToTermsAlsoUnderVertexColoursAndTheClamp) {
  std::mt19937 random(4);
  for (const Interpolation interpolation : {Interpolation::flat, Interpolation::gouraud, Interpolation::phong}) {
    for (const Lighting lighting : {Lighting::lambert, Lighting::phong, Lighting::blinn_phong}) {
      Scene scene = rich_scene();
      scene.shading.interpolation = interpolation;
      scene.shading.lighting = lighting;
      scene.shading.terms.emission = lighting == Lighting::phong;
      scene.lights->front().diffuse = {{3, 2.5F, 0.5F}};
      auto mesh = std::make_shared<Mesh>(*scene.objects[0].mesh);
      for (const Vec3f& p : mesh->positions) {
        mesh->colors.push_back({p.x * 0.5F + 0.5F, p.y * 0.5F + 0.5F, 0.7F});
      }
      scene.objects[0].mesh = mesh;
      bool is_clamped = false;
      for (int i = 0; i < 40; ++i) {
        const auto e = explain(scene, static_cast<int>(random() % 97), static_cast<int>(random() % 61));
        ASSERT_TRUE(e);
        expect_products(*e);
        for (const FragmentExplanation& f : e->fragments) {
          for (const ShadingExplanation& s : f.shadings) {
            is_clamped = is_clamped || s.clamp != Vec3f{1, 1, 1};
          }
        }
      }
      EXPECT_EQ(is_clamped, interpolation == Interpolation::gouraud);
    }
  }
}

TEST(Explain, GouraudShowsThreeVerticesAndFlatOneFace) {
  Scene scene = rich_scene();
  scene.image.samples = 1;
  scene.shading.interpolation = Interpolation::gouraud;
  const auto gouraud = explain(scene, 48, 30);
  ASSERT_TRUE(gouraud);
  ASSERT_EQ(gouraud->fragments.at(0).shadings.size(), 3U);
  float weights = 0;
  for (const ShadingExplanation& s : gouraud->fragments[0].shadings) {
    weights += s.weight;
  }
  EXPECT_NEAR(weights, 1, 1e-6F);
  scene.shading.interpolation = Interpolation::flat;
  EXPECT_EQ(explain(scene, 48, 30)->fragments.at(0).shadings.size(), 1U);
}

TEST(Explain, ABackgroundPixelHasNoFragments) {
  const auto e = explain(rich_scene(), 0, 0);
  ASSERT_TRUE(e);
  EXPECT_TRUE(e->fragments.empty());
  EXPECT_EQ(e->background, (Vec3f{e->color[0], e->color[1], e->color[2]}));
}

TEST(Explain, APixelOutsideIsAnError) {
  const auto e = explain(rich_scene(), 97, 0);
  ASSERT_FALSE(e);
  EXPECT_EQ(e.error().text(), "pixel 97, 0 is outside the picture of 97 x 61 pixels, counted from 0");
}

}  // namespace
}  // namespace lustro
