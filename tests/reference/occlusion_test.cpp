// Occlusion against form factors from paper, and against rays in the same directions asked of every triangle.
#include "shade/occlusion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "rays.hpp"
#include "reference/depth_maps.hpp"
#include "scene/prepare.hpp"
#include "scenes.hpp"

namespace lustro {
namespace {

Object placed(const char* name, const Vec3d& scale, const Vec3d& at) {
  Object object{.source = name, .mesh = primitive(name), .material = Material{}};
  object.matrix.m = {scale.x, 0, 0, at.x, 0, scale.y, 0, at.y, 0, 0, scale.z, at.z, 0, 0, 0, 1};
  return object;
}

// A floor at y = 0, seen from above, with far looks.
Scene floor_scene(OcclusionSettings settings = {.directions = 512, .size = 256, .radius = 1e6}) {
  Scene scene = plain_scene(primitive("plane"));
  scene.objects[0].matrix.m = {8, 0, 0, 0, 0, 1, 0, 0, 0, 0, 8, 0, 0, 0, 0, 1};
  scene.camera.eye = Vec3d{0.5, 6, 8};
  scene.ambient = {{0.5F, 0.5F, 0.5F}};
  scene.occlusion = settings;
  return scene;
}

// a at places of a scene.
struct Openness {
  PreparedScene prepared;

  explicit Openness(const Scene& scene) {
    auto made = prepare(scene);
    EXPECT_TRUE(made) << (made ? "" : made.error().text());
    prepared = *std::move(made);
    draw_occlusion(prepared, prepared.occlusion, 0);
  }

  double operator()(const Vec3d& place, const Vec3f& normal = {0, 1, 0}) const {
    return static_cast<double>(openness_at(prepared.occlusion.shading, vec_cast<float>(place - prepared.view.eye), normal, normal));
  }
};

TEST(Occlusion, NothingHidesAnOpenFloor) {
  const Openness openness(floor_scene());
  for (const double x : {-7.9, -3.0, 0.0, 0.01, 5.5, 20.0}) {
    EXPECT_GT(openness({x, 0, x * 0.5}), 0.9999) << x;  // a line that all but lies in the floor may meet it
  }
}

// An infinitely long wall of height h at the distance d hides (1 - d / sqrt(d^2 + h^2)) / 2.
TEST(Occlusion, AWallHidesItsFormFactor) {
  Scene scene = floor_scene();
  scene.objects[0].matrix.m[10] = 60;
  scene.objects.push_back(placed("cube", {0.05, 2, 60}, {-0.05, 0, 0}));  // its face at x = 0, 2 high
  scene.occlusion->size = 1024;
  scene.occlusion->directions = 128;
  const Openness openness(scene);
  for (const double d : {0.5, 1.0, 2.0, 4.0}) {
    EXPECT_NEAR(openness({d, 0, 0}), 1 - 0.5 * (1 - d / std::sqrt(d * d + 4)), 0.02) << d;
  }
}

// A ball of radius r whose centre is h above the floor hides (r / h)^2 of it right below. Seen from there its edge lies on the lines in the same
// way in all directions around, so that the mean of some places counts.
TEST(Occlusion, ABallHidesItsFormFactor) {
  for (const double height : {1.5, 2.0, 4.0}) {
    std::mt19937 random(3);
    double sum = 0;
    constexpr int kPlaces = 12;
    for (int i = 0; i < kPlaces; ++i) {
      const auto number = [&random] { return static_cast<double>(random()) / 4294967296.0 * 2 - 1; };
      const Vec3d foot{3 * number(), 0, 3 * number()};
      Scene scene = floor_scene({.directions = 128, .size = 256, .radius = 1e6});
      scene.objects.push_back(placed("sphere:96", {1, 1, 1}, {foot.x, height, foot.z}));
      const double a = Openness(scene)(foot);
      EXPECT_NEAR(a, 1 - 1 / (height * height), 0.04) << height;
      sum += a;
    }
    EXPECT_NEAR(sum / kPlaces, 1 - 1 / (height * height), 0.01) << height;
  }
}

TEST(Occlusion, WhatIsFartherThanTheRadiusHidesNothingAndFadesBeforeThat) {
  Scene scene = floor_scene();
  scene.objects.push_back(placed("plane", {8, -1, 8}, {0, 2, 0}));  // a ceiling
  scene.occlusion->radius = 1.9;
  EXPECT_GT(Openness(scene)({0, 0, 0}), 0.9999);
  double last = 1;
  for (const double radius : {2.2, 2.6, 3.0, 4.0}) {
    scene.occlusion->radius = radius;
    const double now = Openness(scene)({0, 0, 0});
    EXPECT_LT(now, last - 0.02) << radius;
    last = now;
  }
  scene.occlusion->radius = 1e6;  // all but what leaves by the gap between floor and ceiling
  EXPECT_LT(Openness(scene)({0, 0, 0}), 0.08);
  // The radius is in world units, and without one a quarter of the diagonal.
  scene.occlusion->radius.reset();
  const double own = Openness(scene)({0, 0, 0});
  scene.occlusion->radius = 0.25 * std::sqrt(16.0 * 16 + 2 * 2 + 16 * 16);
  EXPECT_EQ(Openness(scene)({0, 0, 0}), own);
}

// Both sides of thin walls, layers above layers: the list of a line holds them.
TEST(Occlusion, ManyLayersAreKeptApart) {
  Scene scene = floor_scene({.directions = 64, .size = 256, .radius = 0.5});
  for (int i = 1; i <= 3; ++i) {
    scene.objects.push_back(placed("plane", {8, 1, 8}, {0, 1.0 * i, 0}));
  }
  const Openness openness(scene);
  for (int i = 0; i <= 3; ++i) {  // each floor has free space above and below it
    EXPECT_EQ(openness({0.1, 1.0 * i, 0.2}), 1) << i;
    EXPECT_EQ(openness({0.1, 1.0 * i, 0.2}, {0, -1, 0}), 1) << i;
  }
  EXPECT_LT(openness({0.1, 0.9, 0.2}), 0.4);              // close below one
  EXPECT_LT(openness({0.1, 1.1, 0.2}, {0, -1, 0}), 0.4);  // close above one, looking down
}

TEST(Occlusion, WhatIsBlendedHidesFromAHalfOn) {
  for (const float opacity : {0.2F, 0.49F, 0.5F, 1.0F}) {
    Scene scene = floor_scene({});
    scene.objects.push_back(placed("plane", {8, -1, 8}, {0, 0.5, 0}));
    scene.objects.back().material->opacity = opacity;
    const double a = Openness(scene)({0, 0, 0});
    if (opacity < 0.5F) {
      EXPECT_EQ(a, 1) << opacity;
    } else {
      EXPECT_LT(a, 0.5) << opacity;
    }
  }
}

// Every direction's own share, from rays: on a mesh whose parts face each other, seen from all its triangles.
TEST(Occlusion, AgreesWithRays) {
  for (const char* name : {"torus:24", "teapot", "cube"}) {
    Scene scene = floor_scene({.directions = 96, .size = 512, .radius = 1e6});
    scene.objects[0].matrix.m = {1.5, 0, 0, 0, 0, 1, 0, -0.5, 0, 0, 1.5, 0, 0, 0, 0, 1};
    scene.objects.push_back(placed(name, {0.6, 0.6, 0.6}, {0, 0.2, 0}));
    const Openness openness(scene);
    const std::vector<Triangle> all = triangles_of(scene);
    std::mt19937 random(7);
    double sum = 0;
    double worst = 0;
    int count = 0;
    for (int i = 0; i < 60; ++i) {
      const std::size_t own = random() % all.size();
      const Triangle& t = all[own];
      const Vec3d across = cross(t.b - t.a, t.c - t.a);
      if (!(length(across) > 1e-9)) {
        continue;
      }
      const Vec3d n = normalize(across);
      const Vec3d p = t.a * 0.3 + t.b * 0.4 + t.c * 0.3;
      double open = 0;
      double weights = 0;
      for (const OcclusionLines& lines : openness.prepared.occlusion.directions) {
        Vec3d way = vec_cast<double>(lines.up);
        double weight = dot(way, n);
        if (weight < 0) {
          way = -way;
          weight = -weight;
        }
        bool is_open = true;
        for (std::size_t other = 0; other < all.size() && is_open; ++other) {
          is_open = other == own || !(hit(all[other], p + n * 1e-6, way) > 0);
        }
        open += is_open ? weight : 0;
        weights += weight;
      }
      const double error = std::abs(openness(p, vec_cast<float>(n)) - open / weights);
      sum += error;
      worst = std::max(worst, error);
      ++count;
    }
    ASSERT_GT(count, 40) << name;
    EXPECT_LT(sum / count, 0.01) << name;
    EXPECT_LT(worst, 0.08) << name;
  }
}

// a multiplies what comes from all around, and nothing else.
TEST(Occlusion, DimsTheAmbientTermAndTheEnvironmentAlone) {
  Scene scene = floor_scene({});
  scene.image.width = 41;
  scene.image.height = 31;
  scene.objects.push_back(placed("sphere:48", {1, 1, 1}, {0, 1, 0}));
  for (Object& object : scene.objects) {
    object.material = Material{.specular = {{0.3F, 0.3F, 0.3F}}, .emission = {{0.1F, 0, 0}}};
  }
  scene.lights = {Light{.type = LightType::point, .position = {1, 5, 3}, .ambient = {{0.2F, 0.1F, 0}}}};
  scene.environment = Environment{.color = {{0.25F, 0.5F, 0.75F}}};
  const RenderOptions options{.aovs = parse_aovs("ambient,diffuse,specular,emission,scene,light:0").value(), .engine = Engine::reference};
  const Rendering with = render(scene, options).value();
  Scene bare = scene;
  bare.occlusion.reset();
  const Rendering without = render(bare, options).value();
  bare.environment.reset();
  const Rendering unsurrounded = render(bare, options).value();
  int dimmed = 0;
  for (int y = 0; y < scene.image.height; ++y) {
    for (int x = 0; x < scene.image.width; ++x) {
      const auto of = [&](const Rendering& r, std::size_t layer, std::size_t c) { return r.layers[layer].image.at(x, y)[c]; };
      if (of(without, 0, 0) == 0) {
        continue;
      }
      const float a = of(with, 0, 0) / of(without, 0, 0);
      ASSERT_LE(a, 1);
      dimmed += a < 0.7F ? 1 : 0;
      EXPECT_NEAR(of(with, 0, 1), a * of(without, 0, 1), 1e-5F);
      const float around = of(without, 1, 2) - of(unsurrounded, 1, 2);  // k_d E
      EXPECT_NEAR(of(with, 1, 2), of(unsurrounded, 1, 2) + a * around, 1e-4F);
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(of(with, 2, c), of(without, 2, c));
        EXPECT_EQ(of(with, 3, c), of(without, 3, c));
        const float sum = ((of(with, 0, c) + of(with, 1, c)) + of(with, 2, c)) + of(with, 3, c);
        EXPECT_NEAR(of(with, 4, c) + of(with, 5, c), sum, 1e-5F);  // the scene's own part and the light's
      }
    }
  }
  EXPECT_GT(dimmed, 20);
  const Explanation explained = explain(scene, 20, 20).value();
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_EQ(explained.color[c], with.color.at(20, 20)[c]);
  }
}

TEST(Occlusion, TooManyLinesAreAnError) {
  const auto made = prepare(floor_scene({.directions = 1024, .size = 1024}));
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().kind, ErrorKind::limit);
  EXPECT_EQ(made.error().text(), "occlusion: 1024 directions of 1024 x 1024 lines are more than 2^27 lines");
}

}  // namespace
}  // namespace lustro
