// Shadows against the truth: for every pixel a ray from its surface to the light, asked against every triangle. What the maps say may differ
// from that within one and a half texels of a shadow's edge, and nowhere else: there is no acne, and no light leaks.
#include "reference/depth_maps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "rays.hpp"
#include "scenes.hpp"
#include "shade/depth_map.hpp"

namespace lustro {
namespace {

constexpr double kWrong = 1.5;  // texels from an edge, beyond which a pixel must be lit by more or by less than a half, as it is

struct Shadows {
  int lit = 0, dark = 0, near_edges = 0, wrong = 0;
  int patchy = 0;  // lit, though the face turns away from the light
  std::string first;
};

// The scene has one light. Every pixel shows one surface at its centre.
Shadows judge(Scene scene) {
  scene.image.samples = 1;
  scene.shading.interpolation = Interpolation::phong;
  scene.shading.two_sided = true;
  scene.ambient = {{0, 0, 0}};
  const Light& light = scene.lights->at(0);
  const RenderOptions options{.aovs = {{AovKind::position}, {AovKind::triangle}, {AovKind::object}, {AovKind::diffuse}, {AovKind::normal}}};
  const Rendering seen = drawn(scene, options);
  Scene without = scene;
  without.shadow.reset();
  const Rendering unshadowed = drawn(without, options);
  const auto prepared = prepare(scene);
  EXPECT_TRUE(prepared);
  const DepthMap& map = prepared->shadows.maps.at(0);

  const std::vector<Triangle> all = triangles_of(scene);
  std::vector<std::size_t> first_of;
  std::size_t count = 0;
  for (const Object& object : scene.objects) {
    first_of.push_back(count);
    count += object.mesh->triangles.size();
  }
  const bool is_parallel = light.type == LightType::directional;
  Shadows result;
  for (int y = 0; y < scene.image.height; ++y) {
    for (int x = 0; x < scene.image.width; ++x) {
      const float full = unshadowed.layers[3].image.at(x, y)[0];
      if (!(full > 0)) {
        continue;  // the light is behind the surface, or there is none
      }
      const float visible = seen.layers[3].image.at(x, y)[0] / full;
      const auto at = seen.layers[0].image.at(x, y);
      const Vec3d p{static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])};
      const std::size_t own =
          first_of[static_cast<std::size_t>(seen.layers[2].image.at(x, y)[0])] + static_cast<std::size_t>(seen.layers[1].image.at(x, y)[0]);
      const Vec3d n = normalize(cross(all[own].b - all[own].a, all[own].c - all[own].a));
      const Vec3d to_light = is_parallel ? -normalize(light.direction) : normalize(light.position - p);
      const auto lit_by = seen.layers[4].image.at(x, y);
      const Vec3d smooth{static_cast<double>(lit_by[0]), static_cast<double>(lit_by[1]), static_cast<double>(lit_by[2])};
      const double side = dot(n, smooth) < 0 ? -1 : 1;
      const double facing = std::clamp(4 * side * dot(n, to_light) / std::max(dot(smooth, to_light), 1e-6), 0.0, 1.0);
      double depth = 1;
      if (light.type == LightType::spot) {
        depth = dot(p - light.position, normalize(light.direction));
      } else if (light.type == LightType::point) {
        const Vec3d d = p - light.position;
        depth = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
      }
      // A look-up's texels lie about it on the map, whose texels are larger across a pyramid's edge than in its middle.
      const double aside = light.type == LightType::directional ? 1 : length(light.position - p) / depth;
      const double texel = depth * aside / static_cast<double>(map.texels);
      const auto is_lit = [&](const Vec3d& from) {
        const Vec3d way = is_parallel ? to_light : light.position - from;
        for (std::size_t t = 0; t < all.size(); ++t) {
          const double distance = t == own ? -1 : hit(all[t], from, way);
          if (distance > 1e-6 && (is_parallel || distance < 1)) {
            return false;
          }
        }
        return true;
      };
      const bool expected = is_lit(p);
      const Vec3d right = normalize(cross(to_light, std::abs(to_light.y) < 0.9 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0}));
      const Vec3d up = cross(right, to_light);
      const auto is_near_edge = [&](double texels) {
        constexpr int kAngles = 48;
        constexpr int kRings = 12;
        for (int i = 0; i < kAngles * kRings; ++i) {
          const double angle = i % kAngles * 2 * 3.14159265358979 / kAngles;
          const double radius = texels * texel * (i / kAngles + 1) / kRings;
          const Vec3d aside_by = right * (std::cos(angle) * radius) + up * (std::sin(angle) * radius);
          // Along the surface, and beside the light's way off the surface: where light grazes, an edge may lie just above.
          const bool is_off = dot(n, aside_by) * dot(n, to_light) > 0;
          if (is_lit(p + aside_by - to_light * (dot(n, aside_by) / dot(n, to_light))) != expected ||
              (is_off && is_lit(p + aside_by) != expected)) {
            return true;
          }
        }
        return false;
      };
      const float error = std::abs(visible - (expected ? static_cast<float>(facing) : 0.0F));
      result.patchy += facing <= 0 && visible != 0.0F ? 1 : 0;
      const bool is_wrong = error > 0.5F && !is_near_edge(kWrong);
      if (error > 2e-4F && !is_wrong) {
        ++result.near_edges;
      } else if (is_wrong) {
        result.first = result.wrong++ == 0 ? "pixel " + std::to_string(x) + ", " + std::to_string(y) + " is " +
                                                 (expected ? "lit" : "in shadow") + ", the map says " + std::to_string(visible)
                                           : result.first;
      } else {
        ++(expected ? result.lit : result.dark);
      }
    }
  }
  return result;
}

Scene stage(int size) {
  Scene scene = plain_scene(primitive("plane"));
  scene.image.width = 128;
  scene.image.height = 96;
  scene.objects[0].matrix = {{3, 0, 0, 0, 0, 1, 0, -0.5, 0, 0, 3, 0, 0, 0, 0, 1}};
  scene.camera.eye = Vec3d{2, 2.2, 3.4};
  scene.camera.target = Vec3d{0, 0, 0};
  scene.shadow = ShadowSettings{.size = size};
  return scene;
}

Object placed(const char* mesh, const Vec3d& size, const Vec3d& place) {
  Object object{.mesh = primitive(mesh)};
  object.matrix = {{size.x, 0, 0, place.x, 0, size.y, 0, place.y, 0, 0, size.z, place.z, 0, 0, 0, 1}};
  return object;
}

std::vector<Light> lights_from(const Vec3d& way) {
  Light spot{.type = LightType::spot, .position = -way * 3.0, .direction = way};
  spot.cutoff = 55;
  spot.attenuation.unclamped = true;
  Light wide = spot;
  wide.cutoff = 80;
  return {Light{.type = LightType::directional, .direction = way}, spot, wide, Light{.type = LightType::point, .position = -way * 3.0}};
}

// All the lights that shine along `way`, on several sizes of maps.
void expect_exact(const std::vector<Object>& objects, const Vec3d& way, int least_dark, int coarse = 256) {
  for (const int size : {coarse, 1024}) {
    for (const Light& light : lights_from(normalize(way))) {
      Scene scene = stage(size);
      scene.lights = {light};
      scene.objects.insert(scene.objects.end(), objects.begin(), objects.end());
      const Shadows shadows = judge(scene);
      const std::string name = "light type " + std::to_string(static_cast<int>(light.type)) + ", cutoff " + std::to_string(light.cutoff) +
                               ", size " + std::to_string(size) + ": ";
      EXPECT_EQ(shadows.wrong, 0) << name << shadows.first;
      EXPECT_GT(shadows.dark, least_dark) << name;
      EXPECT_GT(shadows.lit, 1000) << name;
      if (size == 1024) {
        EXPECT_LT(shadows.near_edges, (shadows.lit + shadows.dark) / 5) << name;
      }
    }
  }
}

// Smooth normals see the light where their faces do not.
TEST(Shadows, EndWhereFacesTurnAway) {
  for (const char* mesh : {"sphere:7", "teapot"}) {
    for (const Light& light : lights_from(normalize(Vec3d{-1, -0.7, -0.3}))) {
      Scene scene = stage(1024);
      scene.lights = {light};
      scene.objects = {placed(mesh, {0.4, 0.4, 0.4}, {0, -0.4, 0})};
      const Shadows shadows = judge(scene);
      EXPECT_EQ(shadows.patchy, 0) << mesh;
      EXPECT_EQ(shadows.wrong, 0) << mesh << ": " << shadows.first;
      EXPECT_GT(shadows.lit, 200) << mesh;
    }
  }
}

TEST(Shadows, FacesThatSeeAQuarterOfWhatTheirNormalsSeeAreWhole) {
  const Vec3f up{0, 0, 1};
  const auto share = [&](const Vec3f& face, const Vec3f& to_light) { return facing_share(face, up, to_light, dot(up, to_light)); };
  for (const float x : {0.0F, 0.3F, 0.9F, 0.99F, 0.9999F}) {
    EXPECT_EQ(share(up, {x, 0, std::sqrt(1 - x * x)}), 1.0F) << x;   // flat: exactly
    EXPECT_EQ(share(-up, {x, 0, std::sqrt(1 - x * x)}), 1.0F) << x;  // wound the other way
  }
  const Vec3f to_light = normalize(Vec3f{1, 0, 1});
  const auto tilted = [&](float f_dot_l) {  // a face whose normal is on N's side, with this F.L
    const float angle = std::acos(f_dot_l);
    const Vec3f across = normalize(Vec3f{-1, 0, 1});
    return to_light * std::cos(angle) + across * std::sin(angle);
  };
  const float n_dot_l = dot(up, to_light);
  EXPECT_EQ(share(tilted(n_dot_l * 0.3F), to_light), 1.0F);
  EXPECT_NEAR(share(tilted(n_dot_l / 8), to_light), 0.5F, 1e-5F);
  EXPECT_EQ(share(tilted(-0.01F), to_light), 0.0F);
}

TEST(Shadows, OfABallOnAPlane) {
  expect_exact({placed("sphere:24", {0.5, 0.5, 0.5}, {0, 0, 0})}, {-1, -1.2, -0.5}, 60);
}

TEST(Shadows, OfThinBoxes) {
  expect_exact({placed("cube", {0.02, 0.4, 0.4}, {-0.3, -0.1, 0.2}), placed("cube", {0.5, 0.02, 0.5}, {0.6, 0.1, -0.4})}, {-0.7, -1, -0.6}, 100);
}

TEST(Shadows, UnderGrazingLight) {
  expect_exact({placed("cube", {0.1, 0.1, 0.1}, {0, -0.4, 0}), placed("torus:24", {0.3, 0.3, 0.3}, {0.6, -0.3, 0.8})}, {-1, -0.06, -0.3}, 100,
               2048);
}

TEST(Shadows, InsideAHollow) {
  expect_exact({placed("torus:40", {1, 1, 1}, {0, -0.2, 0})}, {-0.6, -1, 0.2}, 100);
}

// A square of light and shade whose edges are known: a plate of half the size above a plane, lit from above.
TEST(Shadows, LieWhereThePlateIs) {
  Scene scene = plain_scene(primitive("plane"));
  scene.camera.projection = Projection::orthographic;
  scene.camera.eye = Vec3d{0, 4, 0};
  scene.camera.target = Vec3d{0, 0, 0};
  scene.camera.up = Vec3d{0, 0, -1};
  scene.camera.height = 2;
  scene.image.width = scene.image.height = 64;
  Object plate = placed("plane", {0.5, 1, 0.5}, {0, 1, 0});
  plate.material = Material{.opacity = 0.75F};  // casts a whole shadow, is not looked at
  scene.objects.push_back(plate);
  scene.objects[0].material = Material{.diffuse = {{1, 1, 1}}};
  scene.lights = {Light{.direction = {-0.25, -1, 0}}};
  scene.shadow.emplace();
  scene.camera.far = 4.5;
  scene.camera.near = 3.5;  // the plate is before the near plane
  const Rendering picture = drawn(scene);
  const float lit = static_cast<float>(1 / std::sqrt(1 + 0.0625));
  EXPECT_NEAR(picture.color.at(4, 32)[0], lit, 1e-5F);
  EXPECT_EQ(picture.color.at(10, 32)[0], 0);             // x = -0.67: the plate's edge at -0.5 is seen at -0.75
  EXPECT_EQ(picture.color.at(38, 32)[0], 0);             // x = 0.2
  EXPECT_NEAR(picture.color.at(42, 32)[0], lit, 1e-5F);  // x = 0.33, beyond the edge at 0.25
  EXPECT_NEAR(picture.color.at(20, 14)[0], lit, 1e-5F);  // z = -0.55
  EXPECT_EQ(picture.color.at(20, 17)[0], 0);
}

// What casts: opaque surfaces, masks where they are not cut out, and of blended ones those that hide at least a half.
TEST(Shadows, ByOpacity) {
  const auto lit_under = [](const Material& material) {
    Scene scene = plain_scene(primitive("plane"));
    scene.camera.eye = Vec3d{0, 0.2, 0.9};
    scene.objects[0].material = Material{.diffuse = {{1, 1, 1}}};
    Object plate = placed("plane", {1, 1, 1}, {0, 0.5, 0});
    plate.material = material;
    scene.objects.push_back(plate);
    scene.lights = {Light{.direction = {0, -1, 0}}};
    scene.shadow.emplace();
    return drawn(scene).color.at(32, 24)[0] > 0.5F;
  };
  EXPECT_FALSE(lit_under({}));
  EXPECT_FALSE(lit_under({.opacity = 0.5F}));
  EXPECT_TRUE(lit_under({.opacity = 0.49F}));
  EXPECT_TRUE(lit_under({.opacity = 0}));
  EXPECT_FALSE(lit_under({.opacity = 0, .alpha_mode = AlphaMode::opaque}));
  EXPECT_FALSE(lit_under({.opacity = 0.3F, .alpha_mode = AlphaMode::mask, .alpha_cutoff = 0.3F}));
  EXPECT_TRUE(lit_under({.opacity = 0.3F, .alpha_mode = AlphaMode::mask, .alpha_cutoff = 0.31F}));
  EXPECT_FALSE(lit_under({.cull = Culling::front}));  // both sides cast, whichever is drawn
  EXPECT_FALSE(lit_under({.cull = Culling::back}));
}

TEST(Shadows, TakeTheDirectLightAndLeaveTheAmbient) {
  Scene scene = stage(512);
  scene.objects.push_back(placed("cube", {5, 0.1, 5}, {0, 4, 0}));
  scene.lights = {Light{.direction = {0, -1, 0}, .ambient = {{0.25F, 0, 0}}}};
  scene.ambient = {{0, 0.5F, 0}};
  scene.objects[0].material = Material{.ambient = {{1, 1, 1}}, .diffuse = {{1, 1, 1}}, .specular = {{1, 1, 1}}};
  const RenderOptions options{.aovs = {{AovKind::ambient}, {AovKind::diffuse}, {AovKind::specular}, {AovKind::light, 0}, {AovKind::scene}}};
  for (const Interpolation interpolation : {Interpolation::flat, Interpolation::gouraud, Interpolation::phong}) {
    scene.shading.interpolation = interpolation;
    const Rendering picture = drawn(scene, options);
    const auto at = [&](std::size_t layer) {
      const auto p = picture.layers[layer].image.at(64, 60);
      return Vec3f{p[0], p[1], p[2]};
    };
    EXPECT_EQ(at(0), (Vec3f{0.25F, 0.5F, 0}));
    EXPECT_EQ(at(1), (Vec3f{}));
    EXPECT_EQ(at(2), (Vec3f{}));
    EXPECT_EQ(at(3), (Vec3f{0.25F, 0, 0}));
    EXPECT_EQ(at(4), (Vec3f{0, 0.5F, 0}));
    scene.lights->at(0).shadow = false;
    EXPECT_GT(drawn(scene, options).layers[1].image.at(64, 60)[0], 0.4F);
    scene.lights->at(0).shadow = true;
  }
}

TEST(Shadows, AreExplained) {
  Scene scene = stage(512);
  scene.objects.push_back(placed("cube", {5, 0.1, 5}, {0, 4, 0}));
  scene.lights = {Light{.direction = {0, -1, 0}}, Light{.type = LightType::point, .position = {0, 1, 0}},
                  Light{.direction = {0, -1, 0}, .shadow = false}};
  const auto explanation = explain(scene, 64, 60);
  ASSERT_TRUE(explanation);
  const auto& lights = explanation->fragments.at(0).shadings.at(0).lights;
  ASSERT_EQ(lights.size(), 3U);
  EXPECT_EQ(lights[0].visibility, 0);
  EXPECT_EQ(lights[0].diffuse, (Vec3f{}));
  EXPECT_EQ(lights[1].visibility, 1);
  EXPECT_EQ(lights[2].visibility, 1);
  EXPECT_GT(lights[2].diffuse.x, 0);
  const Rendering picture = drawn(scene);
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_EQ(explanation->color[c], picture.color.at(64, 60)[c]);
  }
}

TEST(Shadows, OfMapsWithoutEndAreAnError) {
  Scene scene = stage(8192);
  scene.lights = std::vector<Light>(17, Light{.direction = {0, -1, 0}});
  const auto picture = render(scene);
  ASSERT_FALSE(picture);
  EXPECT_EQ(picture.error().kind, ErrorKind::limit);
}

}  // namespace
}  // namespace lustro
