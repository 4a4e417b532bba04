// Reflection maps in the reference renderer: a surrounding whose colour is its direction shows every pixel's mirrored view.
#include <algorithm>
#include <cmath>

#include "math/trig.hpp"
#include "reference/scenes.hpp"
#include "shade/direction_picture.hpp"

namespace lustro {
namespace {

// Colours are (d + 1) / 2. Looked up without mip levels, which average over a pixel's footprint.
ReflectionMap directions(ReflectionShape shape) {
  ReflectionMap map{.shape = shape};
  if (shape == ReflectionShape::sphere) {
    map.faces[0] = TextureUse{
        .texture = picture(
            512, 256,
            [](double u, double v) {
              const double longitude = (u - 0.5) * 2 * kPi, colatitude = v * kPi;
              return Vec3d{std::sin(colatitude) * std::sin(longitude), std::cos(colatitude), -std::sin(colatitude) * std::cos(longitude)};
            }),
        .name = "around.png"};
    map.faces[0]->sampler.mip = MipFilter::none;
    return map;
  }
  for (std::size_t face = 0; face < 6; ++face) {
    map.faces[face] = TextureUse{
        .texture = picture(128, 128,
                           [face](double u, double v) {
                             const double s = 2 * u - 1, t = 2 * v - 1;
                             const std::array<Vec3d, 6> seen{{{1, -t, -s}, {-1, -t, s}, {s, 1, t}, {s, -1, -t}, {s, -t, 1}, {-s, -t, -1}}};
                             return seen[face];
                           }),
        .name = "face " + std::to_string(face)};
    map.faces[face]->sampler.mip = MipFilter::none;
  }
  return map;
}

TextureUse plain(const Vec3f& rgb) {
  Image image(1, 1, 3);
  image.pixels = {rgb.x, rgb.y, rgb.z};
  return {.texture = *make_texture(image, 1)};
}

Scene mirror_ball(ReflectionShape shape) {
  Scene scene = plain_scene(primitive("sphere:24"));
  scene.image.width = scene.image.height = 64;
  scene.camera.eye = Vec3d{1.2, 0.9, 2.4};
  scene.objects[0].material = Material{.specular = {{0.5F, 0.75F, 1}}};
  scene.objects[0].material->textures.reflection = directions(shape);
  return scene;
}

RenderOptions with_layers(std::string_view names) {
  RenderOptions options;
  options.aovs = *parse_aovs(names);
  return options;
}

const Image& layer(const Rendering& rendering, std::string_view name) {
  return std::find_if(rendering.layers.begin(), rendering.layers.end(), [name](const Layer& l) { return l.name == name; })->image;
}

Vec3d vector(const Image& image, int x, int y) {
  const auto p = image.at(x, y);
  return vec_cast<double>(Vec3f{p[0], p[1], p[2]});
}

// The largest difference between the specular term and k_s (R + 1) / 2.
double largest_error(const Scene& scene, const Vec3d& k_s) {
  const Rendering r = drawn(scene, with_layers("specular,scene,normal,position,mask"));
  double largest = 0;
  int covered = 0;
  for (int y = 0; y < scene.image.height; ++y) {
    for (int x = 0; x < scene.image.width; ++x) {
      if (layer(r, "mask").at(x, y)[0] == 0) {
        continue;
      }
      ++covered;
      const Vec3d n = vector(layer(r, "normal"), x, y);
      Vec3d v = normalize(*scene.camera.eye - vector(layer(r, "position"), x, y));
      if (scene.camera.projection == Projection::orthographic) {
        v = normalize(*scene.camera.eye - *scene.camera.target);
      }
      const Vec3d mirrored = n * (2 * dot(n, v)) - v;
      const Vec3d error = vector(layer(r, "specular"), x, y) - k_s * ((mirrored + Vec3d{1, 1, 1}) * 0.5);
      largest = std::max(largest, length(error));
      EXPECT_EQ(vector(layer(r, "specular"), x, y), vector(layer(r, "scene"), x, y));  // no light brings it
    }
  }
  EXPECT_GT(covered, 300);
  return largest;
}

TEST(ReflectionMaps, EveryPixelShowsItsMirroredViewWhateverTheInterpolation) {
  for (const ReflectionShape shape : {ReflectionShape::sphere, ReflectionShape::cube}) {
    for (const Interpolation interpolation : {Interpolation::flat, Interpolation::gouraud, Interpolation::phong}) {
      for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        Scene scene = mirror_ball(shape);
        scene.shading.interpolation = interpolation;
        scene.camera.projection = projection;
        EXPECT_LT(largest_error(scene, {0.5, 0.75, 1}), 0.03);
      }
    }
  }
}

TEST(ReflectionMaps, BumpsAndNormalMapsTiltTheMirror) {
  Scene scene = mirror_ball(ReflectionShape::sphere);
  auto mesh = std::make_shared<Mesh>(*scene.objects[0].mesh);
  mesh->tangents.assign(mesh->positions.size(), {1, 0, 0, 1});
  scene.objects[0].mesh = mesh;
  scene.objects[0].material->textures.normal = plain({0.5F, 0.75F, 0.9F});
  scene.objects[0].material->textures.normal_is_object_space = true;
  EXPECT_LT(largest_error(scene, {0.5, 0.75, 1}), 0.03);
}

TEST(ReflectionMaps, TheSpecularMapCoversTheMirror) {
  Scene scene = mirror_ball(ReflectionShape::cube);
  scene.objects[0].material->textures.specular = plain({0.5F, 1, 0.25F});
  scene.shading.interpolation = Interpolation::gouraud;
  EXPECT_LT(largest_error(scene, {0.25, 0.75, 0.25}), 0.03);
  scene.objects[0].material->textures.reflection->faces[4]->gain = {0, 0, 0};  // black towards +z alone
  const Rendering r = drawn(scene, with_layers("specular"));
  EXPECT_GT(vector(layer(r, "specular"), 32, 20).y, 0.1);
}

TEST(ReflectionMaps, WithoutHighlightsThereIsNoMirror) {
  const Scene scene = mirror_ball(ReflectionShape::sphere);
  Scene black = scene;
  black.objects[0].material->textures.reflection.reset();
  Scene off = scene;
  off.shading.terms.specular = false;
  EXPECT_EQ(drawn(off).color.pixels, drawn(black).color.pixels);
  off.shading.terms.specular = true;
  off.objects[0].material->lighting = Lighting::lambert;
  EXPECT_EQ(drawn(off).color.pixels, drawn(black).color.pixels);
  EXPECT_NE(drawn(scene).color.pixels, drawn(black).color.pixels);
  EXPECT_TRUE(drawn(off).notes.empty());
}

TEST(ReflectionMaps, AMirrorThatIsSeenSmallShowsTheMean) {
  Scene scene = mirror_ball(ReflectionShape::sphere);
  Image stripes(1024, 512, 3);
  for (int y = 0; y < stripes.height; ++y) {
    for (int x = 0; x < stripes.width; ++x) {
      const auto pixel = stripes.at(x, y);
      std::fill(pixel.begin(), pixel.end(), ((x ^ y) & 1) != 0 ? 1.0F : 0.0F);
    }
  }
  scene.objects[0].material->textures.reflection->faces[0] = TextureUse{.texture = *make_texture(stripes, 1)};
  scene.objects[0].material->specular.rgb = {1, 1, 1};
  for (const Interpolation interpolation : {Interpolation::gouraud, Interpolation::phong}) {
    scene.shading.interpolation = interpolation;
    const Rendering r = drawn(scene, with_layers("specular,mask"));
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        if (layer(r, "mask").at(x, y)[0] != 0) {
          EXPECT_NEAR(layer(r, "specular").at(x, y)[0], 0.5F, 0.02F) << x << " " << y;  // a checkerboard's mean, at all its levels but the first
        }
      }
    }
  }
}

TEST(ReflectionMaps, WhatIsMissingIsBlackWithANote) {
  Scene scene = mirror_ball(ReflectionShape::cube);
  scene.objects[0].material->textures.reflection->faces[2].reset();
  EXPECT_EQ(drawn(scene).notes, (Notes{{"objects[0]", "its reflection map is black where it has no texture: top"}}));
  scene.objects[0].material->textures.reflection = ReflectionMap{};
  EXPECT_EQ(drawn(scene).notes, (Notes{{"objects[0]", "its reflection map is left out: it has no texture"}}));
}

TEST(ReflectionMaps, AnExplanationSaysWhatIsMirrored) {
  for (const ReflectionShape shape : {ReflectionShape::sphere, ReflectionShape::cube}) {
    Scene scene = mirror_ball(shape);
    scene.lights = std::vector<Light>{{.type = LightType::directional, .direction = {-1, -1, -1}}};
    const Rendering r = drawn(scene);
    const auto e = explain(scene, 30, 25);
    ASSERT_TRUE(e);
    const auto pixel = r.color.at(30, 25);
    EXPECT_EQ(e->color, (std::array<float, 4>{pixel[0], pixel[1], pixel[2], pixel[3]}));
    const FragmentExplanation& f = e->fragments.at(0);
    ASSERT_EQ(f.maps.size(), 1U);
    EXPECT_TRUE(f.maps[0].map.starts_with(shape == ReflectionShape::sphere ? "reflection" : "reflection.")) << f.maps[0].map;
    EXPECT_EQ(f.maps[0].name.substr(0, 4), shape == ReflectionShape::sphere ? "arou" : "face");
    EXPECT_EQ(f.reflection, (Vec3f{0.5F * f.maps[0].value[0], 0.75F * f.maps[0].value[1], f.maps[0].value[2]}));
    EXPECT_EQ(f.specular, f.shadings[0].specular + f.reflection);
  }
}

}  // namespace
}  // namespace lustro
