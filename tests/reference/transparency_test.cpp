// What can be seen through: opacity, halos, masks and layers against their formulas in double precision.
#include <algorithm>
#include <cmath>

#include "reference/scenes.hpp"

namespace lustro {
namespace {

// A square of the plane z, -1..1, whose u and v run from 0 to 1, top left first.
std::shared_ptr<Mesh> square(float z, float size = 1) {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {{-size, -size, z}, {size, -size, z}, {size, size, z}, {-size, size, z}};
  mesh->normals.assign(4, {0, 0, 1});
  mesh->uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

// Unlit: the colour itself.
Material sheet(const Vec3f& color, float opacity, AlphaMode mode = AlphaMode::blend) {
  Material material;
  material.diffuse = {color};
  material.opacity = opacity;
  material.alpha_mode = mode;
  material.lighting = Lighting::constant;
  return material;
}

// A scene without an object, over nothing.
Scene bare_scene(int samples = 1) {
  Scene scene = plain_scene(square(0));
  scene.objects.clear();
  scene.image.background_alpha = 0;
  scene.image.samples = samples;
  return scene;
}

void add(Scene& scene, std::shared_ptr<const Mesh> mesh, const Material& material) {
  scene.objects.push_back({.source = "sheet", .mesh = std::move(mesh), .material = material});
}

TextureUse map_of(const Image& image) {
  TextureUse use;
  use.texture = *make_texture(image);
  use.sampler = {.wrap_u = Wrap::clamp_to_edge, .wrap_v = Wrap::clamp_to_edge, .mip = MipFilter::none};
  return use;
}

std::array<float, 4> center(const Rendering& r) {
  const auto pixel = r.color.at(30, 24);
  return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

TEST(Transparency, ASheetLetsThroughWhatItDoesNotHide) {
  Scene scene = bare_scene();
  add(scene, square(0), sheet({0.2F, 0.4F, 1}, 0.25F));
  add(scene, square(-1), sheet({1, 0.8F, 0}, 1));
  const auto color = center(drawn(scene));
  EXPECT_FLOAT_EQ(color[0], 0.25F * 0.2F + 0.75F * 1.0F);
  EXPECT_FLOAT_EQ(color[1], 0.25F * 0.4F + 0.75F * 0.8F);
  EXPECT_FLOAT_EQ(color[2], 0.25F * 1.0F);
  EXPECT_EQ(color[3], 1);
}

TEST(Transparency, EverySpecularAndEmittedTermIsPartOfTheLayer) {
  Scene scene = bare_scene();
  scene.ambient = {{1, 1, 1}};
  Material glass;
  glass.ambient = {{0.5F, 0, 0}};
  glass.emission = {{0, 0.5F, 0}};
  glass.opacity = 0.5F;
  add(scene, square(0), glass);
  const Rendering r = drawn(scene, {.aovs = {{AovKind::ambient}, {AovKind::emission}, {AovKind::mask}, {AovKind::albedo}}});
  EXPECT_FLOAT_EQ(r.layers[0].image.at(30, 24)[0], 0.25F);
  EXPECT_FLOAT_EQ(r.layers[1].image.at(30, 24)[1], 0.25F);
  EXPECT_FLOAT_EQ(r.layers[2].image.at(30, 24)[0], 0.5F);
  EXPECT_FLOAT_EQ(r.layers[3].image.at(30, 24)[0], 0.4F);
}

TEST(Transparency, TheBackgroundShowsThroughAndKeepsItsAlpha) {
  Scene scene = bare_scene();
  scene.image.background = {{0, 1, 0}};
  scene.image.background_alpha = 0.5F;
  add(scene, square(0), sheet({1, 0, 0}, 0.25F));
  const auto color = center(drawn(scene));  // premultiplied
  EXPECT_FLOAT_EQ(color[0], 0.25F);
  EXPECT_FLOAT_EQ(color[1], 0.75F * 0.5F);
  EXPECT_FLOAT_EQ(color[3], 0.25F + 0.75F * 0.5F);
  scene.image.transparent = true;
  EXPECT_FLOAT_EQ(center(drawn(scene))[1], 0);
  EXPECT_FLOAT_EQ(center(drawn(scene))[3], 0.25F);
}

TEST(Transparency, NeitherTheOrderOfObjectsNorOfTrianglesMatters) {
  constexpr std::array kOpacity{0.3F, 0.6F, 0.2F, 0.5F};
  const std::array colors{Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}, Vec3f{1, 1, 1}};
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  std::vector<float> first;
  do {
    Scene scene = bare_scene(4);
    for (const std::size_t i : order) {
      auto mesh = square(-0.3F * static_cast<float>(i), 1 + 0.1F * static_cast<float>(i));
      std::reverse(mesh->triangles.begin(), mesh->triangles.begin() + (order[0] % 2 == 0 ? 2 : 0));
      add(scene, mesh, sheet(colors[i], kOpacity[i]));
    }
    const Rendering r = drawn(scene);
    if (first.empty()) {
      first = r.color.pixels;
      double through = 1;
      std::array<double, 3> expected{};
      for (std::size_t i = 0; i < 4; ++i) {
        const double share = through * static_cast<double>(kOpacity[i]);
        expected[0] += share * static_cast<double>(colors[i].x);
        expected[1] += share * static_cast<double>(colors[i].y);
        expected[2] += share * static_cast<double>(colors[i].z);
        through -= share;
      }
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(center(r)[c], expected[c], 1e-6);
      }
      EXPECT_NEAR(center(r)[3], 1 - through, 1e-6);
    }
    EXPECT_EQ(r.color.pixels, first);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Transparency, SheetsThatCrossAreSortedInEverySample) {
  Scene scene = bare_scene(16);
  auto left = std::make_shared<Mesh>(*square(0));  // two planes that cross at x = 0
  auto right = std::make_shared<Mesh>(*square(0));
  for (std::size_t i = 0; i < 4; ++i) {
    left->positions[i].z = left->positions[i].x;
    right->positions[i].z = -right->positions[i].x;
  }
  add(scene, left, sheet({1, 0, 0}, 0.5F));
  add(scene, right, sheet({0, 1, 0}, 0.5F));
  const Rendering r = drawn(scene);
  EXPECT_FLOAT_EQ(r.color.at(26, 24)[0], 0.25F);  // green stands before red
  EXPECT_FLOAT_EQ(r.color.at(26, 24)[1], 0.5F);
  EXPECT_FLOAT_EQ(r.color.at(37, 24)[0], 0.5F);
  EXPECT_FLOAT_EQ(r.color.at(37, 24)[1], 0.25F);
}

TEST(Transparency, WhatLiesBehindAnOpaqueSurfaceIsNotSeen) {
  Scene scene = bare_scene();
  add(scene, square(-0.5F), sheet({0, 1, 0}, 0.5F));
  add(scene, square(0), sheet({1, 0, 0}, 1));
  EXPECT_EQ(center(drawn(scene)), (std::array<float, 4>{1, 0, 0, 1}));
}

TEST(Transparency, OpacityOfAMapOfVerticesAndOfTheMaterialMultiply) {
  Scene scene = bare_scene();
  Image image(1, 1, 4);
  image.pixels = {0.2F, 0.9F, 0.1F, 0.5F};
  auto mesh = square(0);
  mesh->alphas = {0.25F, 0.75F, 0.75F, 0.25F};  // from left to right
  Material material = sheet({1, 1, 1}, 0.8F);
  material.textures.opacity = map_of(image);
  for (const auto& [channel, value] : {std::pair{std::uint8_t{0}, 0.2}, {std::uint8_t{1}, 0.9}, {std::uint8_t{3}, 0.5}}) {
    material.textures.opacity->channel = channel;
    scene.objects.clear();
    add(scene, mesh, material);
    const auto e = explain(scene, 30, 24);
    ASSERT_TRUE(e);
    ASSERT_EQ(e->fragments.size(), 1U);
    const double x = static_cast<double>(e->fragments[0].position.x);
    const double expected = 0.8 * value * (0.5 + 0.25 * x);
    EXPECT_NEAR(e->fragments[0].opacity, expected, 2e-5);
    EXPECT_EQ(e->fragments[0].weight, e->fragments[0].opacity);
    EXPECT_NEAR(e->color[3], expected, 2e-5);
  }
}

TEST(Transparency, AHaloIsDenserWhereTheSurfaceIsSeenFromTheSide) {
  Scene scene = plain_scene(primitive("sphere:64"));
  scene.objects[0].material = sheet({1, 1, 1}, 0.25F);
  scene.objects[0].material->halo = true;
  scene.shading.cull = Culling::back;
  int looked_at = 0;
  for (int x = 8; x < 56; ++x) {
    const auto e = explain(scene, x, 24);
    ASSERT_TRUE(e);
    for (const FragmentExplanation& f : e->fragments) {
      ASSERT_EQ(f.shadings.size(), 1U);
      const double n_dot_v = static_cast<double>(dot(f.shadings[0].normal, f.shadings[0].to_eye));
      EXPECT_NEAR(f.opacity, 1 - std::abs(n_dot_v) * 0.75, 1e-6);
      ++looked_at;
    }
  }
  EXPECT_GT(looked_at, 20);
}

TEST(Transparency, AMaskCoversTheSamplesWhereItIsDenseEnough) {
  Image image(2, 1, 1);
  image.pixels = {0, 1};  // linear from u = 1/4 to 3/4
  for (const int samples : {1, 16}) {
    for (const float cutoff : {0.3F, 0.5F, 0.8F}) {
      Scene scene = bare_scene(samples);
      Material material = sheet({1, 1, 1}, 1, AlphaMode::mask);
      material.alpha_cutoff = cutoff;
      material.textures.opacity = map_of(image);
      add(scene, square(0), material);
      add(scene, square(-0.01F, 4), sheet({0, 1, 0}, 1));
      const Rendering r = drawn(scene);
      // The row's white share is the width of what lies right of the edge; the square is seen 2 / (2 * 4 tan 21 deg) * 48 pixels wide.
      const double pixels_per_unit = 24 / (4 * std::tan(21 * 3.14159265358979 / 180));
      const double edge = -1 + 2 * (0.25 + 0.5 * static_cast<double>(cutoff));
      double white = 0;
      for (int x = 0; x < 64; ++x) {
        const auto pixel = r.color.at(x, 24);
        EXPECT_FLOAT_EQ(pixel[1], 1);  // never a hole: what is not covered shows what lies behind
        white += static_cast<double>(pixel[0]);
      }
      EXPECT_NEAR(white, (1 - edge) * pixels_per_unit, samples == 1 ? 1 : 0.13) << cutoff;
    }
  }
}

TEST(Transparency, AMaskedSurfaceHidesWhatAlphaModeOpaqueHides) {
  Scene scene = bare_scene();
  add(scene, square(0), sheet({1, 0, 0}, 0.2F, AlphaMode::opaque));
  EXPECT_EQ(center(drawn(scene)), (std::array<float, 4>{1, 0, 0, 1}));
  scene.objects[0].material = sheet({1, 0, 0}, 0.6F, AlphaMode::mask);
  EXPECT_EQ(center(drawn(scene)), (std::array<float, 4>{1, 0, 0, 1}));
  scene.objects[0].material = sheet({1, 0, 0}, 0.4F, AlphaMode::mask);
  const Rendering r = drawn(scene);
  EXPECT_EQ(center(r), (std::array<float, 4>{0, 0, 0, 0}));
  EXPECT_EQ(r.stats.pixels_covered, 0U);
  ASSERT_EQ(r.notes.size(), 1U);
  EXPECT_EQ(r.notes[0].message, "the material has the opacity 0.4: it is not seen");
}

TEST(Transparency, LayersOfGeometryShowWhatBringsTheMost) {
  Scene scene = bare_scene();
  add(scene, square(0), sheet({1, 0, 0}, 0.4F));
  add(scene, square(-1), sheet({0, 1, 0}, 1));
  const std::vector<Aov> aovs{{AovKind::object}, {AovKind::depth}};
  EXPECT_EQ(drawn(scene, {.aovs = aovs}).layers[0].image.at(30, 24)[0], 1);
  EXPECT_FLOAT_EQ(drawn(scene, {.aovs = aovs}).layers[1].image.at(30, 24)[0], 5);
  scene.objects[0].material->opacity = 0.6F;
  EXPECT_EQ(drawn(scene, {.aovs = aovs}).layers[0].image.at(30, 24)[0], 0);
  EXPECT_FLOAT_EQ(drawn(scene, {.aovs = aovs}).layers[1].image.at(30, 24)[0], 4);
}

TEST(Transparency, AnExplanationListsLayersFromTheNearestOn) {
  Scene scene = rich_scene();
  scene.objects[0].material->opacity = 0.3F;
  const Rendering picture = drawn(scene);
  int layered = 0;
  for (int y = 5; y < 61; y += 7) {
    for (int x = 3; x < 97; x += 7) {
      const auto e = explain(scene, x, y);
      ASSERT_TRUE(e);
      const auto pixel = picture.color.at(x, y);
      EXPECT_EQ(e->color, (std::array<float, 4>{pixel[0], pixel[1], pixel[2], pixel[3]}));
      float weights = 0;
      for (const FragmentExplanation& f : e->fragments) {
        weights += f.weight;
        EXPECT_EQ(f.opacity, f.object == 0 ? 0.3F : 1.0F);
      }
      EXPECT_LE(weights, 1.000001F);
      if (e->fragments.size() == 3 && e->fragments[2].object == 1 && e->fragments[2].samples == 4) {
        EXPECT_LT(e->fragments[0].depth, e->fragments[1].depth);
        EXPECT_LT(e->fragments[1].depth, e->fragments[2].depth);
        EXPECT_FLOAT_EQ(e->fragments[2].weight, 0.7F * 0.7F);
        ++layered;
      }
    }
  }
  EXPECT_GT(layered, 2);
}

TEST(Transparency, FogDimsEveryLayerByItsOwnDistance) {
  Scene scene = bare_scene();
  scene.fog = Fog{.mode = FogMode::linear, .start = 0, .end = 10, .color = {{0, 0, 1}}};
  add(scene, square(0), sheet({1, 0, 0}, 0.5F));
  add(scene, square(-1), sheet({0, 1, 0}, 1));
  const auto e = explain(scene, 30, 24);
  ASSERT_TRUE(e);
  ASSERT_EQ(e->fragments.size(), 2U);
  const auto clear = [&](std::size_t i) { return 1 - static_cast<double>(length(e->fragments[i].position - Vec3f{0, 0, 4})) / 10; };
  EXPECT_NEAR(e->color[0], 0.5 * clear(0), 1e-6);
  EXPECT_NEAR(e->color[1], 0.5 * clear(1), 1e-6);
  EXPECT_NEAR(e->color[2], 0.5 * (1 - clear(0)) + 0.5 * (1 - clear(1)), 1e-6);
}

}  // namespace
}  // namespace lustro
