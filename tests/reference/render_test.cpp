// The whole reference renderer on scenes with an answer on paper, and the promises that every picture keeps.
#include "lustro/render.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "reference/scenes.hpp"

namespace lustro {
namespace {

std::vector<Aov> aovs(std::string_view list) {
  auto parsed = parse_aovs(list);
  EXPECT_TRUE(parsed) << (parsed ? "" : parsed.error().text());
  return parsed ? *parsed : std::vector<Aov>{};
}

bool same_bits(const Image& a, const Image& b) {
  return a.pixels.size() == b.pixels.size() && std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(float)) == 0;
}

// A quadrilateral that fills the picture at z = 0 and faces the eye.
std::shared_ptr<Mesh> wall() {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}};
  mesh->normals.assign(4, {0, 0, 1});
  mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(Render, AWhiteLambertWallUnderADirectionalLightOfOneIsOne) {
  Scene scene = plain_scene(wall());
  scene.shading.lighting = Lighting::lambert;
  scene.objects[0].material = Material{.diffuse = {{1, 1, 1}}};
  scene.lights->push_back({.direction = {0, 0, -3}});
  const Rendering picture = drawn(scene);
  for (const float v : picture.color.pixels) {
    ASSERT_EQ(v, 1.0F);
  }
  EXPECT_EQ(picture.stats.pixels_covered, 64U * 48U);
}

TEST(Render, FlatLightsAFaceOnceAtItsCentre) {
  Scene scene = plain_scene(triangle_mesh({-3, -2, 0}, {3, -2, 0}, {0, 4, 0}, {1, 0, 0}));
  scene.shading.interpolation = Interpolation::flat;
  scene.objects[0].material = Material{.diffuse = {{1, 1, 1}}};
  Light bulb{.type = LightType::point, .position = {2, 1, 1.5}};
  bulb.attenuation.quadratic = 0.25;
  scene.lights->push_back(bulb);
  const Rendering picture = drawn(scene, {.aovs = aovs("mask,normal")});
  // The centre is (0, 0, 0); the file's normal (1, 0, 0) is not asked.
  const double distance = std::sqrt(4 + 1 + 2.25);
  const double expected = 1.5 / distance / (1 + 0.25 * distance * distance);
  int covered = 0;
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      if (picture.layers[0].image.at(x, y)[0] > 0) {
        EXPECT_NEAR(static_cast<double>(picture.color.at(x, y)[0]), expected, 1e-6);
        EXPECT_EQ(picture.layers[1].image.at(x, y)[2], 1.0F);
        ++covered;
      }
    }
  }
  EXPECT_GT(covered, 500);
}

TEST(Render, GouraudClampsAtTheVertexBeforeItInterpolates) {
  // One vertex is lit with 3, the others with 0. Clamped first, the value falls from 1 to 0 along the edge; clamped last it would stay 1 for two
  // thirds.
  auto mesh = wall();
  mesh->normals = {{0, 0, 1}, {0, 0, 1}, {-1, 0, 0}, {-1, 0, 0}};
  Scene scene = plain_scene(mesh);
  scene.shading.interpolation = Interpolation::gouraud;
  scene.objects[0].material = Material{.diffuse = {{1, 1, 1}}};
  scene.lights->push_back({.direction = {0, 0, -1}, .diffuse = {{3, 3, 3}}});
  const Rendering picture = drawn(scene, {.aovs = aovs("position,diffuse")});
  for (int y = 0; y < 48; ++y) {
    const auto position = picture.layers[0].image.at(10, y);
    const double expected = (9 - static_cast<double>(position[1])) / 18;  // 1 at the bottom, 0 at the top
    EXPECT_NEAR(static_cast<double>(picture.color.at(10, y)[0]), expected, 1e-4);
    EXPECT_EQ(picture.color.at(10, y)[0], picture.layers[1].image.at(10, y)[0]);
  }
}

TEST(Render, GouraudLosesTheHighlightThatPhongShowsInTheMiddleOfAFace) {
  Scene scene = plain_scene(wall());
  scene.objects[0].material = Material{.diffuse = {{0, 0, 0}}, .specular = {{1, 1, 1}}, .shininess = 50};
  scene.lights->push_back({.type = LightType::point, .position = {0, 0, 4}});
  const Rendering phong = drawn(scene);
  scene.shading.interpolation = Interpolation::gouraud;
  const Rendering gouraud = drawn(scene);
  EXPECT_GT(phong.color.at(32, 24)[0], 0.98F);
  EXPECT_LT(gouraud.color.at(32, 24)[0], 0.01F);
}

TEST(Render, TwoSidedLightsTheBackWithItsNormalTurnedRound) {
  auto mesh = wall();
  for (auto& t : mesh->triangles) {
    std::swap(t[1], t[2]);  // now its back is seen
  }
  mesh->normals.assign(4, {0, 0, -1});
  for (const Interpolation interpolation : {Interpolation::flat, Interpolation::gouraud, Interpolation::phong}) {
    Scene scene = plain_scene(mesh);
    scene.shading.interpolation = interpolation;
    scene.objects[0].material = Material{.diffuse = {{1, 1, 1}}};
    scene.lights->push_back({.direction = {0, 0, -1}});
    EXPECT_EQ(drawn(scene).color.at(20, 20)[0], 0.0F);
    scene.shading.two_sided = true;
    EXPECT_EQ(drawn(scene).color.at(20, 20)[0], 1.0F);
  }
}

TEST(Render, AMirroredObjectIsLitFromOutside) {
  for (const Interpolation interpolation : {Interpolation::flat, Interpolation::phong}) {
    Scene scene = plain_scene(wall());
    scene.shading.interpolation = interpolation;
    scene.shading.two_sided = true;
    scene.objects[0].matrix(0, 0) = -1;
    scene.objects[0].material = Material{.diffuse = {{1, 1, 1}}};
    scene.lights->push_back({.direction = {0, 0, -1}});
    EXPECT_EQ(drawn(scene).color.at(20, 20)[0], 1.0F);
  }
}

TEST(Render, NormalsGoByTheInverseTranspose) {
  // A wall tilted by a shear: z' = z + y. Its normal is (0, -1, 1) / sqrt 2; the plain matrix would leave (0, 0, 1).
  for (const Interpolation interpolation : {Interpolation::flat, Interpolation::gouraud, Interpolation::phong}) {
    Scene scene = plain_scene(wall());
    scene.shading.interpolation = interpolation;
    scene.objects[0].matrix(2, 1) = 0.2;
    scene.objects[0].material = Material{.diffuse = {{1, 1, 1}}};
    scene.lights->push_back({.direction = {0, 0, -1}});
    EXPECT_NEAR(static_cast<double>(drawn(scene).color.at(20, 24)[0]), 1 / std::sqrt(1.04), 1e-6);
  }
}

TEST(Render, TermsSumExactlyToThePictureInEveryInterpolationAndSampleCount) {
  for (const Interpolation interpolation : {Interpolation::flat, Interpolation::gouraud, Interpolation::phong}) {
    for (const int samples : {1, 4, 16}) {
      Scene scene = rich_scene();
      scene.shading.interpolation = interpolation;
      scene.image.samples = samples;
      const Rendering picture = drawn(scene, {.aovs = aovs("ambient,diffuse,specular,emission,fog,background")});
      bool fog_is_seen = false;
      for (std::size_t i = 0; i < picture.layers[0].image.pixels.size(); ++i) {
        const auto layer = [&](std::size_t l) { return picture.layers[l].image.pixels[i]; };
        const float sum = ((((layer(0) + layer(1)) + layer(2)) + layer(3)) + layer(4)) + layer(5);
        ASSERT_EQ(sum, picture.color.pixels[i / 3 * 4 + i % 3]);
        fog_is_seen = fog_is_seen || layer(4) > 0;
      }
      EXPECT_TRUE(fog_is_seen);
    }
  }
}

TEST(Render, LightsAndTheSceneSumToTheLitPart) {
  for (const Interpolation interpolation : {Interpolation::flat, Interpolation::gouraud, Interpolation::phong}) {
    Scene scene = rich_scene();
    scene.shading.interpolation = interpolation;
    const Rendering picture = drawn(scene, {.aovs = aovs("light:*,scene,fog,background")});
    ASSERT_EQ(picture.layers.size(), 6U);
    EXPECT_EQ(picture.layers[2].name, "light:2");
    for (std::size_t i = 0; i < picture.layers[0].image.pixels.size(); ++i) {
      float sum = 0;
      for (const Layer& layer : picture.layers) {
        sum += layer.image.pixels[i];
      }
      ASSERT_NEAR(sum, picture.color.pixels[i / 3 * 4 + i % 3], 2e-6F);
    }
  }
}

TEST(Render, ATermThatIsSwitchedOffIsBlackAndTheOthersKeepTheirBits) {
  Scene scene = rich_scene();
  const Rendering all = drawn(scene, {.aovs = aovs("ambient,diffuse,specular,emission")});
  scene.shading.terms.specular = false;
  scene.shading.terms.ambient = false;
  const Rendering some = drawn(scene, {.aovs = aovs("ambient,diffuse,specular,emission")});
  EXPECT_TRUE(same_bits(all.layers[1].image, some.layers[1].image));
  EXPECT_TRUE(same_bits(all.layers[3].image, some.layers[3].image));
  for (const std::size_t off : {0U, 2U}) {
    EXPECT_TRUE(std::all_of(some.layers[off].image.pixels.begin(), some.layers[off].image.pixels.end(), [](float v) { return v == 0; }));
  }
}

TEST(Render, TheNumberOfThreadsChangesNoBit) {
  Scene scene = rich_scene();
  const RenderOptions one{.threads = 1, .aovs = aovs("depth,normal,barycentrics,light:1")};
  const Rendering expected = drawn(scene, one);
  for (const int threads : {2, 3, 7}) {
    RenderOptions options = one;
    options.threads = threads;
    const Rendering picture = drawn(scene, options);
    EXPECT_TRUE(same_bits(expected.color, picture.color));
    for (std::size_t i = 0; i < expected.layers.size(); ++i) {
      EXPECT_TRUE(same_bits(expected.layers[i].image, picture.layers[i].image)) << expected.layers[i].name;
    }
  }
}

TEST(Render, TheOrderOfTrianglesChangesNoBitOfTheColour) {
  Scene scene = rich_scene();
  const Rendering expected = drawn(scene);
  auto mesh = std::make_shared<Mesh>(*scene.objects[0].mesh);
  std::mt19937 random(11);
  std::shuffle(mesh->triangles.begin(), mesh->triangles.end(), random);
  scene.objects[0].mesh = mesh;
  const Rendering shuffled = drawn(scene);
  // Only where fragments of a pixel are summed may their order differ, and the order of samples is fixed: the bits agree.
  EXPECT_TRUE(same_bits(expected.color, shuffled.color));
}

TEST(Render, OfEquallyNearTrianglesTheFirstInTheSceneWins) {
  Scene scene = plain_scene(wall());
  scene.objects.push_back(scene.objects[0]);
  scene.objects[0].material = Material{.emission = {{1, 0, 0}}};
  scene.objects[1].material = Material{.emission = {{0, 1, 0}}};
  EXPECT_EQ(drawn(scene).color.at(5, 5)[0], 1.0F);
}

TEST(Render, NearerSurfacesHideFartherOnesInBothProjections) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Scene scene = plain_scene(wall());
    scene.camera.projection = projection;
    scene.camera.height = 3.0;
    scene.objects.push_back(scene.objects[0]);
    scene.objects[0].material = Material{.emission = {{1, 0, 0}}};
    scene.objects[1].material = Material{.emission = {{0, 1, 0}}};
    scene.objects[1].matrix(2, 3) = 0.001;
    EXPECT_EQ(drawn(scene).color.at(5, 5)[1], 1.0F);
    scene.objects[1].matrix(2, 3) = -0.001;
    EXPECT_EQ(drawn(scene).color.at(5, 5)[1], 0.0F);
  }
}

TEST(Render, NearAndFarPlanesCutInBothProjections) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Scene scene = plain_scene(wall());  // at distance 4
    scene.camera.projection = projection;
    scene.camera.height = 3.0;
    scene.camera.near = 3.9;
    scene.camera.far = 4.1;
    EXPECT_EQ(drawn(scene).stats.pixels_covered, 64U * 48U);
    scene.camera.far = 3.99;
    EXPECT_EQ(drawn(scene).stats.pixels_covered, 0U);
    scene.camera.near = 4.01;
    scene.camera.far = 100;
    EXPECT_EQ(drawn(scene).stats.pixels_covered, 0U);
  }
}

TEST(Render, DepthAndPositionLieOnTheSurface) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Scene scene = plain_scene(primitive("sphere:128"));
    scene.camera.projection = projection;
    scene.camera.eye = Vec3d{103, 51, 24};  // the sphere is moved far from the origin
    scene.camera.target = Vec3d{100, 50, 20};
    scene.camera.near = std::nullopt;
    scene.camera.far = std::nullopt;
    scene.objects[0].matrix = {{1, 0, 0, 100, 0, 1, 0, 50, 0, 0, 1, 20, 0, 0, 0, 1}};
    const Rendering picture = drawn(scene, {.aovs = aovs("position,normal,depth,mask")});
    const Vec3d forward = normalize(Vec3d{-3, -1, -4});
    int covered = 0;
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 64; ++x) {
        if (picture.layers[3].image.at(x, y)[0] == 0) {
          EXPECT_TRUE(std::isinf(picture.layers[2].image.at(x, y)[0]));
          continue;
        }
        const auto p = picture.layers[0].image.at(x, y);
        const auto n = picture.layers[1].image.at(x, y);
        const Vec3d world{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
        EXPECT_NEAR(length(world - Vec3d{100, 50, 20}), 1, 0.02);
        EXPECT_NEAR(static_cast<double>(picture.layers[2].image.at(x, y)[0]), dot(world - *scene.camera.eye, forward), 1e-4);
        EXPECT_NEAR(dot(world - Vec3d{100, 50, 20}, Vec3d{static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])}), 1,
                    0.02);
        ++covered;
      }
    }
    EXPECT_GT(covered, 300);
  }
}

TEST(Render, BackgroundAlphaIsCorrectAtSilhouettes) {
  Scene scene = plain_scene(primitive("sphere:32"));
  scene.image.samples = 16;
  scene.image.transparent = true;
  scene.image.background = {{1, 1, 1}};
  scene.objects[0].material = Material{.ambient = {{0, 0, 0}}, .emission = {{0.5F, 0.25F, 1}}};
  const Rendering picture = drawn(scene, {.aovs = aovs("mask")});
  int edges = 0;
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      const auto c = picture.color.at(x, y);
      const float mask = picture.layers[0].image.at(x, y)[0];
      EXPECT_EQ(c[3], mask);
      EXPECT_NEAR(c[0], 0.5F * mask, 1e-6F) << "premultiplied: no white of the background shines through";
      edges += mask > 0 && mask < 1 ? 1 : 0;
    }
  }
  EXPECT_GT(edges, 50);
}

TEST(Render, IdsNameObjectMaterialAndTriangle) {
  Scene scene = rich_scene();
  const Rendering picture = drawn(scene, {.aovs = aovs("object,material,triangle,mask")});
  EXPECT_EQ(picture.layers[0].labels, (std::vector<std::string>{"test", "floor"}));
  std::array<int, 3> seen{};
  for (std::size_t i = 0; i < picture.layers[0].image.pixels.size(); ++i) {
    const float object = picture.layers[0].image.pixels[i];
    ASSERT_EQ(object < 0, picture.layers[3].image.pixels[i] == 0);
    ASSERT_EQ(picture.layers[1].image.pixels[i], object);  // one material an object here
    ++seen.at(static_cast<std::size_t>(object + 1));
  }
  EXPECT_GT(*std::min_element(seen.begin(), seen.end()), 100);
}

TEST(Render, ConstantIsTheDiffuseColourAlone) {
  Scene scene = plain_scene(wall());
  scene.ambient = {{1, 1, 1}};
  scene.lights->push_back({.direction = {0, 0, -1}});
  scene.objects[0].material =
      Material{.diffuse = {{0.1F, 0.2F, 0.3F}}, .specular = {{1, 1, 1}}, .emission = {{1, 1, 1}}, .lighting = Lighting::constant};
  const Rendering picture = drawn(scene);
  const auto c = picture.color.at(3, 3);
  EXPECT_EQ((std::array{c[0], c[1], c[2]}), (std::array{0.1F, 0.2F, 0.3F}));
}

TEST(Render, VertexColoursMultiplyAmbientAndDiffuse) {
  auto mesh = wall();
  mesh->colors.assign(4, {0.5F, 1, 0});
  Scene scene = plain_scene(mesh);
  scene.ambient = {{1, 1, 1}};
  scene.lights->push_back({.direction = {0, 0, -1}});
  scene.objects[0].material = Material{.ambient = {{0.2F, 0.2F, 0.2F}}, .diffuse = {{0.6F, 0.6F, 0.6F}}};
  const Rendering picture = drawn(scene);
  const auto c = picture.color.at(3, 3);
  EXPECT_NEAR(c[0], 0.4F, 1e-6F);
  EXPECT_NEAR(c[1], 0.8F, 1e-6F);
  EXPECT_EQ(c[2], 0.0F);
}

TEST(Render, FogIsMeasuredAlongTheRayNotAlongTheView) {
  Scene scene = plain_scene(wall());
  scene.objects[0].material = Material{.emission = {{1, 1, 1}}};
  scene.fog = Fog{.mode = FogMode::linear, .start = 4, .end = 5, .color = {{0, 0, 1}}};
  const Rendering picture = drawn(scene);
  EXPECT_NEAR(picture.color.at(32, 24)[0], 1, 1e-3F);
  // At the corner the wall is farther from the eye, though its depth is the same 4.
  const double t = std::tan(21.0 * 3.14159265358979 / 180);
  const double distance = 4 * std::sqrt(1 + t * t * (47.0 / 48 * 47.0 / 48) + (t * 64 / 48) * (t * 64 / 48) * (63.0 / 64 * 63.0 / 64));
  EXPECT_NEAR(static_cast<double>(picture.color.at(0, 0)[0]), 5 - distance, 1e-4);
}

TEST(Render, SaysWhatItCannotDraw) {
  Scene nothing;
  ASSERT_FALSE(render(nothing));
  EXPECT_EQ(render(nothing).error().kind, ErrorKind::empty);
  Scene scene = plain_scene(nullptr);
  EXPECT_EQ(render(scene).error().text(), "objects[0]: its mesh \"test\" is not loaded");
  scene = plain_scene(wall());
  scene.objects[0].matrix(2, 2) = 0;
  EXPECT_EQ(render(scene).error().text(), "objects[0].matrix: is singular: it flattens the object");
  scene = plain_scene(wall());
  scene.camera.eye = scene.camera.target;
  EXPECT_EQ(render(scene).error().kind, ErrorKind::usage);
  scene = plain_scene(wall());
  EXPECT_EQ(render(scene, {.aovs = aovs("light:0")}).error().text(), "light:0 does not exist; the scene has 0 lights, counted from 0");
  auto broken = wall();
  broken->triangles[1][2] = 4;
  EXPECT_EQ(render(plain_scene(broken)).error().text(), "objects[0].mesh: a triangle names vertex 4, but there are 4");
}

TEST(Render, ReportsProgressUpToOne) {
  std::vector<double> seen;
  RenderOptions options;
  options.progress = [&seen](double share) { seen.push_back(share); };
  drawn(rich_scene(), options);
  ASSERT_FALSE(seen.empty());
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1.0);
}

TEST(Aov, NamesAreParsedAndUnknownOnesNamed) {
  EXPECT_EQ(aovs("depth,light:3").at(1).light, 3);
  EXPECT_EQ(parse_aovs("deep").error().kind, ErrorKind::usage);
  EXPECT_FALSE(parse_aovs("depth:1"));
  EXPECT_FALSE(parse_aovs("light:x"));
  EXPECT_FALSE(parse_aovs(""));
  EXPECT_FALSE(parse_aovs("depth,,normal"));
  EXPECT_EQ(aov_names().size(), 18U);
}

TEST(Render, AMaterialMayLeaveOutASideOfItsFaces) {
  auto mesh = std::make_shared<Mesh>(*triangle_mesh({-1, -1, 0}, {1, -1, 0}, {0, 1, 0}));  // seen from the front
  mesh->positions.insert(mesh->positions.end(), {{-1, -1, -1}, {0, 1, -1}, {1, -1, -1}});  // behind it, seen from behind
  mesh->normals.resize(6, {0, 0, 1});
  mesh->triangles.push_back({3, 4, 5});
  mesh->materials.resize(2);
  mesh->triangle_material = {0, 1};
  Scene scene = plain_scene(mesh);
  const auto triangle_seen = [&] { return drawn(scene, {.aovs = {{AovKind::triangle}}}).layers[0].image.at(32, 24)[0]; };
  EXPECT_EQ(triangle_seen(), 0);
  mesh->materials[0].cull = Culling::front;
  EXPECT_EQ(triangle_seen(), 1);
  mesh->materials[1].cull = Culling::back;
  EXPECT_EQ(triangle_seen(), -1);
  mesh->materials[0].cull = Culling::none;  // whatever the scene says
  scene.shading.cull = Culling::front;
  EXPECT_EQ(triangle_seen(), 0);
  mesh->materials[0].cull.reset();
  EXPECT_EQ(triangle_seen(), -1);
}

}  // namespace
}  // namespace lustro
