// What paths bring against closed forms, against the rasterizer where it is exact, and against themselves on other numbers of threads.
#include "path/render.hpp"

#include <gmock/gmock.h>

#include <array>
#include <random>

#include "path_testing.hpp"

namespace lustro {
namespace {

constexpr double kPi_ = 3.14159265358979323846;

// --- the same picture as the rasterizer's under direct light --------------------------------------------------------------------------

Light sun() {
  Light light;
  light.type = LightType::directional;
  light.direction = {0.3, -0.4, -1};
  light.diffuse = {{0.7F, 0.6F, 0.5F}};
  light.specular = {{0.3F, 0.5F, 0.6F}};
  light.ambient = gray(0.05F);
  return light;
}

Light lamp() {
  Light light;
  light.type = LightType::point;
  light.position = {0.6, 0.8, 1.5};
  light.diffuse = {{0.9F, 0.8F, 0.7F}};
  light.specular = {{0.5F, 0.4F, 0.3F}};
  light.attenuation = {.constant = 0.5, .linear = 0.2, .quadratic = 0.3};
  return light;
}

Light spot() {
  Light light = lamp();
  light.type = LightType::spot;
  light.direction = {-0.3, -0.4, -1};
  light.cutoff = 60;
  light.beam = 20;
  light.exponent = 3;
  return light;
}

Material glossy(Lighting lighting) {
  Material material;
  material.ambient = gray(0.3F);
  material.diffuse = {{0.5F, 0.3F, 0.2F}};
  material.specular = {{0.4F, 0.4F, 0.5F}};
  material.emission = {{0.02F, 0, 0.04F}};
  material.shininess = 20;
  material.lighting = lighting;
  return material;
}

/// A shallow bowl's normals over a flat square: they differ from vertex to vertex, and nothing casts a shadow.
std::shared_ptr<const Mesh> bent_square() {
  Mesh mesh = *square(2);
  for (std::size_t i = 0; i < 4; ++i) {
    mesh.normals[i] = normalize(Vec3f{mesh.positions[i].x * 0.2F, mesh.positions[i].y * 0.15F, 1});
  }
  mesh.colors = {{1, 1, 1}, {0.8F, 0.9F, 1}, {1, 0.7F, 0.9F}, {0.9F, 1, 0.8F}};
  return std::make_shared<const Mesh>(std::move(mesh));
}

TextureUse picture() {
  Image image(4, 4, 3);
  std::mt19937 random(7);
  for (float& value : image.pixels) {
    value = static_cast<float>(random() >> 8U) * 0x1p-24F;
  }
  TextureUse use;
  use.texture = make_texture(image).value();
  return use;
}

void expect_same_as_rasterizer(Scene scene, const std::string& what) {
  scene.image.width = 48;
  scene.image.height = 40;
  scene.image.samples = 1;
  const Rendering raster = render(scene).value();
  const Rendering paths = draw_paths(scene, 64, 1);
  double worst = 0;
  for (std::size_t i = 0; i < raster.color.pixels.size(); ++i) {
    const auto shown = [i](const Image& image) { return std::clamp(static_cast<double>(image.pixels[i]), 0.0, 1.0); };
    worst = std::max(worst, std::abs(shown(raster.color) - shown(paths.color)));
  }
  EXPECT_LT(worst, 1.0 / 255) << what;
  EXPECT_GT(estimate(raster.color).mean, 0.03) << what << ": there is nothing to compare";
}

Scene bent_scene(const Light& light, const Material& material) {
  Scene scene = look({0.4, 0.3, 3}, 2.4);
  scene.camera.projection = Projection::perspective;
  scene.camera.height.reset();
  scene.camera.fov = 30;
  scene.ambient = gray(0.2F);
  scene.shading.normalized = false;
  scene.lights->push_back(light);
  scene.objects.push_back(object(bent_square(), material));
  return scene;
}

TEST(Path, DirectLightIsTheRasterizersForEveryModelAndLight) {
  LUSTRO_REQUIRE_PATHS();
  for (const Lighting lighting : {Lighting::constant, Lighting::lambert, Lighting::phong, Lighting::blinn_phong, Lighting::ggx}) {
    for (const Light& light : {sun(), lamp(), spot()}) {
      for (const bool normalized : {false, true}) {
        Scene scene = bent_scene(light, glossy(lighting));
        scene.shading.normalized = normalized;
        expect_same_as_rasterizer(scene, "model " + std::to_string(static_cast<int>(lighting)) + ", light " +
                                             std::to_string(static_cast<int>(light.type)) + (normalized ? ", normalized" : ""));
      }
    }
  }
}

TEST(Path, DirectLightIsTheRasterizersUnderTextures) {
  LUSTRO_REQUIRE_PATHS();
  for (const auto slot : {&MaterialTextures::diffuse, &MaterialTextures::specular, &MaterialTextures::emission, &MaterialTextures::shininess,
                          &MaterialTextures::decal}) {
    Material material = glossy(Lighting::phong);
    material.emission = gray(0.2F);
    material.textures.*slot = picture();
    // Between texels the maps are bent, and a pixel's mean is not its middle: far fewer texels than pixels, and not too different.
    (material.textures.*slot)->gain = {0.4F, 0.4F, 0.4F};
    (material.textures.*slot)->base = {0.3F, 0.3F, 0.3F};
    expect_same_as_rasterizer(bent_scene(sun(), material), "a texture");
  }
}

TEST(Path, DirectLightIsTheRasterizersUnderBumpsAndNormalMaps) {
  LUSTRO_REQUIRE_PATHS();
  Material bumpy = glossy(Lighting::lambert);
  bumpy.textures.bump = picture();
  bumpy.textures.bump->gain = {0.05F, 0.05F, 0.05F};
  expect_same_as_rasterizer(bent_scene(sun(), bumpy), "bumps");
  Material mapped = glossy(Lighting::lambert);
  mapped.textures.normal = picture();
  mapped.textures.normal->gain = {0.2F, 0.2F, 0.2F};
  mapped.textures.normal->base = {0.4F, 0.4F, 0.8F};
  expect_same_as_rasterizer(bent_scene(sun(), mapped), "a normal map");
}

TEST(Path, DirectLightIsTheRasterizersFromBehindAndInFog) {
  LUSTRO_REQUIRE_PATHS();
  for (const bool two_sided : {false, true}) {
    Scene scene = bent_scene(sun(), glossy(Lighting::phong));
    scene.shading.two_sided = two_sided;
    scene.camera.eye = Vec3d{0.4, 0.3, -3};
    if (two_sided) {
      scene.lights->front().direction = {0.3, -0.4, 1};
    }
    expect_same_as_rasterizer(scene, two_sided ? "lit back" : "back that shows the front's light");
  }
  for (const FogMode mode : {FogMode::linear, FogMode::exp, FogMode::exp2}) {
    Scene scene = bent_scene(lamp(), glossy(Lighting::blinn_phong));
    scene.fog = Fog{.mode = mode, .density = 0.3, .start = 1, .end = 5, .color = {{0.3F, 0.4F, 0.5F}}};
    expect_same_as_rasterizer(scene, "fog");
  }
}

TEST(Path, DirectLightIsTheRasterizersOnFacetsUnderTheSun) {
  LUSTRO_REQUIRE_PATHS();
  Scene scene = bent_scene(sun(), glossy(Lighting::lambert));
  scene.shading.interpolation = Interpolation::flat;
  scene.objects.front().mesh = square(2);
  expect_same_as_rasterizer(scene, "flat");
}

TEST(Path, DirectLightIsTheRasterizersThroughPanes) {
  LUSTRO_REQUIRE_PATHS();
  Scene scene = bent_scene(sun(), lambert(0.6F));
  Material pane = lambert(0.8F);
  pane.opacity = 0.25F;
  scene.lights->front().direction = {0, 0, 1};  // from behind the pane, whose shadow falls away from the wall
  scene.shading.two_sided = true;
  scene.image.samples = 1;
  scene.objects.push_back(object(square(3), pane, moved(0, 0, 0.5)));
  scene.objects.front().material->emission = gray(0.5F);
  scene.image.width = scene.image.height = 16;
  const Rendering raster = render(scene).value();
  const Rendering paths = draw_paths(scene, 1024, 1);
  expect_estimate(estimate(paths.color), estimate(raster.color).mean, "a pane");
}

// --- the same bits -----------------------------------------------------------------------------------------------------------------------

TEST(Path, AnyNumberOfThreadsDrawsTheSameBits) {
  LUSTRO_REQUIRE_PATHS();
  Scene scene = bent_scene(lamp(), glossy(Lighting::phong));
  scene.objects.push_back(object(primitive("sphere:12"), glossy(Lighting::blinn_phong), moved(0, 0, 1)));
  scene.environment = white_sky(0.3F);
  scene.image.width = 50;
  scene.image.height = 37;
  const std::uint64_t expected = hash_image(draw_paths(scene, 5, 6, 0, 1).color);
  for (const int threads : {2, 3, 7}) {
    EXPECT_EQ(hash_image(draw_paths(scene, 5, 6, 0, threads).color), expected) << threads;
  }
  EXPECT_NE(hash_image(draw_paths(scene, 5, 6, 1, 1).color), expected) << "the seed changes nothing";
}

// --- closed forms ------------------------------------------------------------------------------------------------------------------------

TEST(Path, AWhiteSurfaceInAWhiteFurnaceCannotBeSeen) {
  LUSTRO_REQUIRE_PATHS();
  Scene scene = look({0, 0, 5}, 1);
  scene.environment = white_sky();
  scene.objects.push_back(object(square(2), lambert(1)));
  expect_estimate(estimate(draw_paths(scene, 256).color), 1, "flat");
  scene.objects = {object(primitive("sphere:48"), lambert(1))};  // from facet to facet light goes on: all of it must come back
  expect_estimate(estimate(draw_paths(scene, 64, 200).color), 1, "a ball");
}

/// The integral of f(direction) over the hemisphere about z, by the middle rule in cosine and angle.
double hemisphere(const std::function<double(const Vec3d&)>& f) {
  constexpr int kRows = 1500;
  constexpr int kColumns = 1500;
  double sum = 0;
  for (int i = 0; i < kRows; ++i) {
    const double c = (i + 0.5) / kRows;
    const double s = std::sqrt(1 - c * c);
    for (int j = 0; j < kColumns; ++j) {
      const double angle = (j + 0.5) / kColumns * kPi_;  // symmetric: half of it
      sum += f({s * std::cos(angle), s * std::sin(angle), c});
    }
  }
  return sum * 2 * kPi_ / (static_cast<double>(kRows) * kColumns);
}

/// What a lobe reflects of a white sky, seen under an angle.
double albedo(Lighting lighting, bool normalized, double n, double k_s, double angle_deg) {
  const double angle = angle_deg * kPi_ / 180;
  const Vec3d eye{std::sin(angle), 0, std::cos(angle)};
  const double norm = !normalized                   ? 1 / kPi_
                      : lighting == Lighting::phong ? (n + 2) / (2 * kPi_)
                                                    : (n + 2) * (n + 4) / (8 * kPi_ * (std::pow(2, -n / 2) + n));
  return hemisphere([&](const Vec3d& l) {
    const Vec3d half = normalize(l + eye);
    const double cosine = lighting == Lighting::phong ? 2 * l.z * eye.z - dot(l, eye) : half.z;
    return k_s * norm * std::pow(std::max(cosine, 0.0), n) * (normalized ? l.z : 1);
  });
}

TEST(Path, LobesReflectTheirAlbedoOfAWhiteSky) {
  LUSTRO_REQUIRE_PATHS();
  for (const Lighting lighting : {Lighting::phong, Lighting::blinn_phong}) {
    for (const bool normalized : {true, false}) {
      for (const float n : {1.0F, 10.0F, 80.0F}) {
        for (const double angle : {0.0, 45.0, 80.0}) {
          const double radians = angle * kPi_ / 180;
          Scene scene = look({5 * std::sin(radians), 0, 5 * std::cos(radians)}, 0.1);
          scene.shading.normalized = normalized;
          scene.environment = white_sky();
          scene.objects.push_back(object(square(2), highlight(lighting, 0.8F, n)));
          expect_estimate(estimate(draw_paths(scene, 512).color),
                          albedo(lighting, normalized, static_cast<double>(n), static_cast<double>(0.8F), angle),
                          "model " + std::to_string(static_cast<int>(lighting)) + (normalized ? " normalized" : "") + " n " + std::to_string(n) +
                              " at " + std::to_string(angle));
        }
      }
    }
  }
}

TEST(Path, TheNormalisedPhongLobeIsWhiteFromAboveAndTheUnnormalisedGainsLight) {
  EXPECT_NEAR(albedo(Lighting::phong, true, 20, 1, 0), 1, 1e-5);  // Lafortune and Willems 1994
  EXPECT_NEAR(albedo(Lighting::phong, false, 0, 1, 0), 2, 1e-5);  // twice what arrives: the classic model is no BRDF
}

TEST(Path, ABallUnderALampIsLambertsCosine) {
  LUSTRO_REQUIRE_PATHS();
  Scene scene = look({0, 0, 5}, 0.2);
  Light light;
  light.type = LightType::point;
  light.position = {0, 0, 3};
  light.attenuation = {.constant = 0, .quadratic = 1, .unclamped = true};
  scene.lights->push_back(light);
  scene.objects.push_back(object(primitive("sphere:1024"), lambert(0.5F)));
  // In the middle of the ball, 2 from the lamp: k_d / 4, to the second order of the pixels' 0.1.
  const Rendering drawn = draw_paths(scene, 4, 16);
  EXPECT_NEAR(static_cast<double>(drawn.color.at(8, 8)[0]), 0.125, 0.001);
}

/// What a white Lambert square at the origin shows under a light, its radiance 1.
Estimate lit_patch(const Light& light) {
  Scene scene = look({0, 3, 0.001}, 1e-3);
  scene.camera.projection = Projection::orthographic;
  Mat4 up;  // z to y
  up.m = {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1};
  scene.objects.push_back(object(square(0.01F), lambert(1), up));
  scene.lights->push_back(light);
  return estimate(draw_paths(scene, 256).color);
}

TEST(Path, ADiskLightHasItsFormFactor) {
  LUSTRO_REQUIRE_PATHS();
  Light light;
  light.type = LightType::disk;
  light.position = {0, 2, 0};
  light.direction = {0, -1, 0};
  light.radius = 1.5;
  expect_estimate(lit_patch(light), 1.5 * 1.5 / (1.5 * 1.5 + 4), "r^2 / (r^2 + h^2)");
  light.direction = {0, 1, 0};
  EXPECT_EQ(lit_patch(light).mean, 0) << "its back shines";
}

TEST(Path, ABallOfLightHasItsFormFactor) {
  LUSTRO_REQUIRE_PATHS();
  Light light;
  light.type = LightType::sphere;
  light.position = {1, 2, 0};
  light.radius = 0.7;
  const double d = std::sqrt(5.0);
  expect_estimate(lit_patch(light), 0.7 * 0.7 / (d * d) * (2 / d), "(r / d)^2 cos: wholly above the horizon (Nusselt)");
}

/// Lambert 1760: the irradiance of a polygon of radiance 1 over pi, from the angles of its edges.
double lambert_formula(const std::vector<Vec3d>& corners, const Vec3d& normal) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d a = normalize(corners[i]);
    const Vec3d b = normalize(corners[(i + 1) % corners.size()]);
    sum += std::acos(dot(a, b)) * dot(normalize(cross(a, b)), normal);
  }
  return std::abs(sum) / (2 * kPi_);
}

TEST(Path, ARectangleOfLightObeysLambertsFormula) {
  LUSTRO_REQUIRE_PATHS();
  Light light;
  light.type = LightType::rectangle;
  light.position = {0.5, 1, 0.2};
  light.direction = {0, -1, 0};
  light.x_axis = Vec3d{1, 0, 0};
  light.size = {2, 1};
  expect_estimate(lit_patch(light), lambert_formula({{-0.5, 1, -0.3}, {1.5, 1, -0.3}, {1.5, 1, 0.7}, {-0.5, 1, 0.7}}, {0, 1, 0}), "rectangle");
}

TEST(Path, AnEmittingMeshLightsAsTheRectangleOfItsShapeDoes) {
  LUSTRO_REQUIRE_PATHS();
  Scene scene = look({0, 3, 0.001}, 1e-3);
  Mat4 up;
  up.m = {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1};
  Material shining = lambert(0);
  shining.emission = gray(1);
  Mat4 above = up;
  above(0, 3) = 2;
  above(1, 3) = 1;
  scene.objects.push_back(object(square(0.01F), lambert(1), up));
  scene.objects.push_back(object(square(1), shining, above));
  const double expected = lambert_formula({{1, 1, -1}, {3, 1, -1}, {3, 1, 1}, {1, 1, 1}}, {0, 1, 0});
  expect_estimate(estimate(draw_paths(scene, 256).color), expected, "emission");
  shining.lighting = Lighting::constant;  // unlit surfaces shine with their colour
  shining.emission = gray(0);
  shining.diffuse = gray(1);
  scene.objects[1] = object(square(1), shining, above);
  expect_estimate(estimate(draw_paths(scene, 256).color), expected, "constant");
  scene.objects.push_back(object(square(3), lambert(0), up));
  scene.objects.back().matrix(1, 3) = 0.5;
  scene.camera.eye = Vec3d{0, 0.25, 0.0001};
  EXPECT_EQ(estimate(draw_paths(scene, 16).color).mean, 0) << "a plate between casts no shadow";
}

TEST(Path, AClosedBallOfLightIsTheSumOfItsReflections) {  // and no triangle stands in its own light
  LUSTRO_REQUIRE_PATHS();
  Scene scene = look({0, 0, 0.5}, 0.1);
  scene.camera.near = 0.01;
  Material wall = lambert(0.6F);
  wall.emission = gray(0.25F);
  scene.shading.two_sided = true;
  scene.shading.interpolation = Interpolation::flat;
  scene.objects.push_back(object(primitive("sphere:24"), wall));
  expect_estimate(estimate(draw_paths(scene, 64, 200).color), 0.25 / (1 - static_cast<double>(0.6F)), "L = L_e / (1 - rho)");
  double series = 0;
  for (int bounces = 0; bounces < 4; ++bounces) {
    series += 0.25 * std::pow(static_cast<double>(0.6F), bounces);
    expect_estimate(estimate(draw_paths(scene, 64, bounces).color), series, "after so many bounces: " + std::to_string(bounces));
  }
}

TEST(Path, FacingPlatesExchangeLightByTheirFormFactor) {
  LUSTRO_REQUIRE_PATHS();
  // Plates so large that each sees nothing but the other: 1-D series L0 = E0 + r0 L1, L1 = E1 + r1 L0.
  Scene scene = look({0, 0, 0.25}, 0.05);
  Material low = lambert(0.5F);
  Material high = lambert(0.7F);
  high.emission = gray(1);
  Mat4 down;  // turned to face -z
  down.m = {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0.5, 0, 0, 0, 1};
  scene.objects = {object(square(2000), low), object(square(2000), high, down)};
  expect_estimate(estimate(draw_paths(scene, 256, 100).color), 0.5 / (1 - 0.5 * static_cast<double>(0.7F)), "two plates");
}

// --- mirrors and glass ---------------------------------------------------------------------------------------------------------------------

/// Reflectance of unpolarised light, written as in the textbooks, by angles.
double textbook_fresnel(double angle, double index) {
  if (angle == 0) {
    return std::pow((index - 1) / (index + 1), 2);
  }
  const double behind = std::asin(std::sin(angle) / index);
  const double across = std::pow(std::sin(angle - behind) / std::sin(angle + behind), 2);
  const double along = std::pow(std::tan(angle - behind) / std::tan(angle + behind), 2);
  return (across + along) / 2;
}

TEST(Path, AGlassMirrorFollowsFresnel) {
  LUSTRO_REQUIRE_PATHS();
  for (const double angle : {0.0, 30.0, 56.3, 75.0, 85.0}) {
    const double radians = angle * kPi_ / 180;
    Scene scene = look({5 * std::sin(radians), 0, 5 * std::cos(radians)}, 0.05);
    Material mirror = highlight(Lighting::phong, 1, 50);
    mirror.illumination = 5;
    mirror.refraction = 1.5F;
    scene.environment = white_sky();
    scene.objects.push_back(object(square(2), mirror));
    const Rendering drawn = draw_paths(scene, 4);
    EXPECT_NEAR(estimate(drawn.color).mean, textbook_fresnel(radians, 1.5), 1e-5) << angle;
  }
}

TEST(Path, AMirrorShowsTheSkyWhereTheViewIsMirroredTo) {
  LUSTRO_REQUIRE_PATHS();
  Scene scene = look({5, 5, 0.001}, 0.05);
  Material mirror = highlight(Lighting::phong, 0.75F, 50);
  mirror.illumination = 3;
  Image picture(64, 32, 3);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      picture.at(x, y)[0] = x < 32 ? 1.0F : 2.0F;  // -x is left of the middle
      picture.at(x, y)[1] = y < 16 ? 1.0F : 3.0F;  // +y is above
    }
  }
  scene.environment = white_sky();
  scene.environment->picture = std::make_shared<const Image>(picture);
  Mat4 up;
  up.m = {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1};
  scene.objects.push_back(object(square(2), mirror, up));
  Rendering drawn = draw_paths(scene, 4);
  EXPECT_NEAR(estimate(drawn.color, 0).mean, 0.75, 1e-5);  // from (1, 1) the view goes on to (-1, 1)
  EXPECT_NEAR(estimate(drawn.color, 1).mean, 0.75, 1e-5);
  scene.environment->rotation = 180;
  drawn = draw_paths(scene, 4);
  EXPECT_NEAR(estimate(drawn.color, 0).mean, 1.5, 1e-5);
}

TEST(Path, AGlassBallInAWhiteFurnaceCannotBeSeen) {
  LUSTRO_REQUIRE_PATHS();
  Scene scene = look({0, 0, 5}, 1.2);
  Material glass = highlight(Lighting::phong, 1, 50);
  glass.illumination = 7;
  glass.refraction = 1.5F;
  scene.environment = white_sky();
  scene.shading.interpolation = Interpolation::flat;
  scene.objects.push_back(object(primitive("sphere:48"), glass));
  expect_estimate(estimate(draw_paths(scene, 64, 1000).color), 1, "what is not mirrored passes");
}

TEST(Path, AGlassPlateLetsThroughWhatStokesSays) {
  LUSTRO_REQUIRE_PATHS();
  // Two parallel boundaries, all inner reflections summed: T = (1 - R) / (1 + R) (Stokes 1862).
  Scene scene = look({0, 0, 5}, 0.01);
  Material glass = highlight(Lighting::phong, 1, 50);
  glass.illumination = 7;
  glass.refraction = 1.5F;
  Material lamp = lambert(0);
  lamp.emission = gray(1);
  Mat4 away;
  away.m = {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, -0.1, 0, 0, 0, 1};
  scene.objects = {object(square(2), glass), object(square(2), glass, away), object(square(3), lamp, moved(0, 0, -1))};
  const double r = 0.04;
  expect_estimate(estimate(draw_paths(scene, 1024, 100).color), (1 - r) / (1 + r), "a plate");
}

// --- the sky --------------------------------------------------------------------------------------------------------------------------------

TEST(Path, ASkyOfOnePictureLightsAsItsIntegralSays) {
  LUSTRO_REQUIRE_PATHS();
  // Radiance a + b y over the upper hemisphere of a horizontal square: a + 2/3 b.
  Scene scene = look({0, 5, 0.001}, 0.05);
  Image picture(256, 128, 3);
  for (int y = 0; y < 128; ++y) {
    const double up = std::cos((y + 0.5) / 128 * kPi_);
    for (int x = 0; x < 256; ++x) {
      picture.at(x, y)[0] = static_cast<float>(up > 0 ? 0.5 + 2 * up : 0);
    }
  }
  scene.environment = white_sky();
  scene.environment->picture = std::make_shared<const Image>(picture);
  Mat4 up;
  up.m = {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1};
  scene.objects.push_back(object(square(2), lambert(1), up));
  const Estimate found = estimate(draw_paths(scene, 256).color);
  EXPECT_NEAR(found.mean, 0.5 + 4.0 / 3, 3 * found.error + 1e-4);  // the pixels of the picture are steps
  EXPECT_LT(found.error, 0.01);
}

TEST(Path, TheSkyIsTheBackgroundUnlessItIsNotToBeSeen) {
  LUSTRO_REQUIRE_PATHS();
  Scene scene = look({0, 0, 5}, 8);
  scene.image.background = gray(0.125F);
  scene.environment = white_sky(0.5F);
  scene.objects.push_back(object(square(1), lambert(0)));
  EXPECT_EQ(draw_paths(scene, 2).color.at(0, 0)[0], 0.5F);
  EXPECT_EQ(draw_paths(scene, 2).color.at(8, 8)[0], 0);
  scene.environment->visible = false;
  EXPECT_EQ(draw_paths(scene, 2).color.at(0, 0)[0], 0.125F);
  scene.image.transparent = true;
  scene.environment->visible = true;
  EXPECT_EQ(draw_paths(scene, 2).color.at(0, 0)[0], 0);
  EXPECT_EQ(draw_paths(scene, 2).color.at(0, 0)[3], 0);
}

// --- when it stops ---------------------------------------------------------------------------------------------------------------------------

/// Two squares before each other under a white sky: some of its light is hidden, so that its pixels have noise.
Scene noisy_scene() {
  Scene scene = look({0, 0, 5}, 0.5);
  scene.environment = white_sky();
  scene.objects.push_back(object(square(2), lambert(0.5F)));
  scene.objects.push_back(object(square(2), lambert(0.5F), moved(1.5, 0, 1)));
  scene.shading.two_sided = true;
  return scene;
}

TEST(Path, TheVarianceIsThatOfTheMeanAndFallsWithTheNumberOfSamples) {
  LUSTRO_REQUIRE_PATHS();
  const Scene scene = noisy_scene();
  RenderOptions options;
  options.engine = Engine::path;
  options.aovs = parse_aovs("variance").value();
  options.path.samples = 256;
  const Rendering drawn = render(scene, options).value();
  ASSERT_EQ(drawn.layers.size(), 1U);
  const double variance = estimate(drawn.layers[0].image).mean;
  const double between = estimate(drawn.color).error * estimate(drawn.color).error * 256;  // how 256 pixels differ
  EXPECT_GT(variance, 0);
  EXPECT_LT(between, 1.5 * variance + 1e-5) << "pixels differ by more than they say";
  EXPECT_GT(drawn.stats.error, 0);
  EXPECT_GT(drawn.stats.rays, 16U * 16 * 256);
  options.path.samples = 1024;
  EXPECT_NEAR(estimate(render(scene, options)->layers[0].image).mean, variance / 4, variance / 20);
}

TEST(Path, StopsWhenTheErrorIsSmallEnough) {
  LUSTRO_REQUIRE_PATHS();
  const Scene scene = noisy_scene();
  RenderOptions options;
  options.engine = Engine::path;
  options.path.samples = 100000;
  options.path.target_error = 0.02;
  const Rendering drawn = render(scene, options).value();
  EXPECT_LE(drawn.stats.error, 0.02);
  EXPECT_GT(drawn.stats.error, 0.005);
  EXPECT_LT(drawn.stats.samples, 100000);
  options.path.target_error = 0;
  options.path.seconds = 0.05;
  EXPECT_LT(render(scene, options)->stats.samples, 100000);
}

TEST(Path, RefusesLayersOfTheLocalModelAndOptionsOutOfRange) {
  LUSTRO_REQUIRE_PATHS();
  Scene scene = look({0, 0, 5}, 0.5);
  scene.objects.push_back(object(square(2), lambert(0.5F)));
  RenderOptions options;
  options.engine = Engine::path;
  options.path.samples = 1;
  options.aovs = parse_aovs("diffuse").value();
  EXPECT_EQ(render(scene, options).error().text(), "the layer diffuse is a part of the local model's sum, which --engine path does not have");
  options.aovs = parse_aovs("depth,variance").value();
  const Rendering drawn = render(scene, options).value();
  EXPECT_FLOAT_EQ(drawn.layers[0].image.at(8, 8)[0], 5);
  options.path.samples = 0;
  EXPECT_EQ(render(scene, options).error().text(), "--spp: 0 is not 1..1048576");
}

}  // namespace
}  // namespace lustro
