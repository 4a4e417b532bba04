// What a rendering says of itself, over the tree of scenes: its terms sum to the picture bit for bit, its lights do up to rounding, and
// explain() takes apart the very pixel that render() made.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include "lustro/lustro.hpp"
#include "truth/scene_tree.hpp"

namespace lustro::truth {
namespace {

bool same_bits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

/// -0 and 0 are the same sum: a term that is switched off may carry either.
bool same_sum(float a, float b) {
  return same_bits(a, b) || (a == 0 && b == 0);
}

TEST(Tree, TermsSumToThePictureExactlyAndLightsUpToRounding) {
  const std::array kTerms{AovKind::ambient, AovKind::diffuse, AovKind::specular, AovKind::emission, AovKind::fog, AovKind::background};
  RenderOptions options;
  options.engine = Engine::reference;
  for (const AovKind kind : kTerms) {
    options.aovs.push_back({kind});
  }
  options.aovs.push_back({AovKind::scene});
  options.aovs.push_back({AovKind::light, -1});  // unfolds to one layer a light
  std::size_t lit = 0;
  for (const TreeScene* entry : chosen_scenes()) {
    const Result<Rendering> rendering = render(entry->scene, options);
    ASSERT_TRUE(rendering) << entry->name << ": " << rendering.error().text();
    ASSERT_EQ(rendering->layers.size(), kTerms.size() + 1 + entry->scene.lights->size()) << entry->name;
    for (int y = 0; y < entry->scene.image.height; ++y) {
      for (int x = 0; x < entry->scene.image.width; ++x) {
        for (std::size_t c = 0; c < 3; ++c) {
          const auto layer = [&](std::size_t i) { return rendering->layers[i].image.at(x, y)[c]; };
          const float color = rendering->color.at(x, y)[c];
          const float lighting = ((layer(0) + layer(1)) + layer(2)) + layer(3);
          ASSERT_TRUE(same_sum((lighting + layer(4)) + layer(5), color)) << entry->name << " (" << x << ", " << y << ") channel " << c;
          float lights = layer(kTerms.size());
          for (std::size_t i = kTerms.size() + 1; i < rendering->layers.size(); ++i) {
            lights += layer(i);
            lit += layer(i) > 0 ? 1U : 0U;
          }
          ASSERT_NEAR(lights, lighting, 4e-6F * std::max(1.0F, lighting)) << entry->name << " (" << x << ", " << y << ") channel " << c;
        }
      }
    }
  }
  EXPECT_GT(lit, 100000U);
}

TEST(Tree, ExplainTakesApartTheVeryPixelThatRenderMade) {
  std::mt19937 bits(20);
  const std::vector<const TreeScene*> scenes = chosen_scenes();
  std::size_t fragments = 0;
  for (std::size_t i = 0; i < scenes.size(); i += 4) {
    const Scene& scene = scenes[i]->scene;
    const Result<Rendering> rendering = render(scene, {.engine = Engine::reference});
    ASSERT_TRUE(rendering) << scenes[i]->name;
    const ByteImage bytes = to_bytes(rendering->color, scene.image.transfer);
    for (int pixel = 0; pixel < 20; ++pixel) {
      const int x = static_cast<int>(bits() % static_cast<unsigned>(scene.image.width));
      const int y = static_cast<int>(bits() % static_cast<unsigned>(scene.image.height));
      const Result<Explanation> told = explain(scene, x, y);
      ASSERT_TRUE(told) << scenes[i]->name;
      const std::array<Vec3f, 6> terms{told->ambient, told->diffuse, told->specular, told->emission, told->fog, told->background};
      Vec3f sum = terms[0];
      for (std::size_t t = 1; t < terms.size(); ++t) {
        sum = sum + terms[t];
      }
      const std::array<float, 3> sums{sum.x, sum.y, sum.z};
      for (std::size_t c = 0; c < 4; ++c) {
        const float color = rendering->color.at(x, y)[c];
        ASSERT_TRUE(same_bits(told->color[c], color))
            << scenes[i]->name << " (" << x << ", " << y << "): " << told->color[c] << ", rendered " << color;
        ASSERT_TRUE(c == 3 || same_sum(sums[c], color)) << scenes[i]->name << " (" << x << ", " << y << "): the terms sum to " << sums[c];
        const std::size_t byte = static_cast<std::size_t>(y * scene.image.width + x) * 4 + c;
        ASSERT_EQ(told->bytes[c], bytes.pixels[byte]) << scenes[i]->name << " (" << x << ", " << y << ")";
      }
      // Every fragment is the sum of its shadings, dimmed by the fog; every shading the sum of its lights unless a vertex was clamped.
      float weight = 0;
      for (const FragmentExplanation& fragment : told->fragments) {
        weight += fragment.weight;
        ++fragments;
        Vec3f diffuse;
        Vec3f specular;
        for (const ShadingExplanation& shading : fragment.shadings) {
          diffuse += shading.diffuse * (shading.weight * fragment.fog_factor);
          specular += shading.specular * (shading.weight * fragment.fog_factor);
          Vec3f of_lights = shading.scene_ambient;
          for (const LightExplanation& light : shading.lights) {
            of_lights += light.ambient + light.diffuse + light.specular;
          }
          const Vec3f whole = (shading.ambient + shading.diffuse) + shading.specular;
          if (fragment.lighting != Lighting::constant && scene.shading.interpolation != Interpolation::gouraud) {
            ASSERT_LE(length(of_lights - whole), 4e-6F * std::max(1.0F, length(whole))) << scenes[i]->name << " (" << x << ", " << y << ")";
          }
        }
        if (!fragment.maps.empty() && scene.shading.interpolation != Interpolation::phong) {
          continue;  // the maps come after the shading
        }
        ASSERT_LE(length(diffuse - fragment.diffuse), 4e-6F * std::max(1.0F, length(diffuse)))
            << scenes[i]->name << " (" << x << ", " << y << ")";
        ASSERT_LE(length(specular - fragment.specular), 4e-6F * std::max(1.0F, length(specular)))
            << scenes[i]->name << " (" << x << ", " << y << ")";
      }
      ASSERT_LE(weight, 1.00001F) << scenes[i]->name;
    }
  }
  EXPECT_GT(fragments, scenes.size());
}

/// The tree as scene files: written, read back, their meshes loaded, and drawn to the same bits.
TEST(Tree, SurvivesTheSceneFile) {
  const std::vector<const TreeScene*> scenes = chosen_scenes();
  int drawn = 0;
  for (std::size_t i = 0; i < scenes.size(); i += 4) {
    const Scene& scene = scenes[i]->scene;
    if (std::any_of(scene.objects.begin(), scene.objects.end(), [](const Object& object) { return object.source.empty(); })) {
      continue;  // a mesh made by hand has no name
    }
    const std::string text = scene_json(scene);
    Result<Scene> read = parse_scene(text, scenes[i]->name);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(scene_json(*read), text);
    const Result<Notes> loaded = load_meshes(*read, ".");
    ASSERT_TRUE(loaded) << loaded.error().text();
    const Result<Rendering> before = render(scene, {.engine = Engine::reference});
    const Result<Rendering> after = render(*read, {.engine = Engine::reference});
    ASSERT_TRUE(before && after) << scenes[i]->name;
    ASSERT_EQ(before->color.pixels, after->color.pixels) << scenes[i]->name << "\n" << text;
    ++drawn;
  }
  EXPECT_GT(drawn, 10);
}

}  // namespace
}  // namespace lustro::truth
