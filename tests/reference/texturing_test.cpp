// Maps in the reference renderer: values on paper, a plane in perspective in double precision, and what must be the same with and without.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "reference/explained_products.hpp"
#include "reference/scenes.hpp"
#include "reference/triangle.hpp"
#include "texture/texture.hpp"

namespace lustro {
namespace {

std::shared_ptr<const Texture> texture_of(const Image& image) {
  auto texture = make_texture(image, 1);
  EXPECT_TRUE(texture) << (texture ? "" : texture.error().text());
  return texture ? *texture : nullptr;
}

Image noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Image image(width, height, 3);
  for (float& x : image.pixels) {
    x = static_cast<float>(random() >> 8) * 0x1p-24F;
  }
  return image;
}

/// A picture of one colour: multiples of 1/65535 or values outside 0..1 are exact.
TextureUse constant(const std::vector<float>& value) {
  Image image(1, 1, static_cast<int>(value.size()));
  image.pixels = value;
  return {.texture = texture_of(image)};
}

/// A quad of -1..1 in x and y, facing +z, that shows a picture upright: v goes down.
std::shared_ptr<Mesh> quad() {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh->normals.assign(4, {0, 0, 1});
  mesh->uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh->tangents.assign(4, {1, 0, 0, 1});
  mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// The quad fills a square picture of `size` pixels exactly, unlit.
Scene straight_on(int size, const MaterialTextures& textures) {
  Scene scene = plain_scene(quad());
  scene.image.width = scene.image.height = size;
  scene.camera.projection = Projection::orthographic;
  scene.camera.height = 2;
  scene.shading.lighting = Lighting::constant;
  scene.objects[0].material = Material{.diffuse = {{1, 1, 1}}, .textures = textures};
  return scene;
}

Light sun(const Vec3d& direction) {
  return {.type = LightType::directional, .direction = direction};
}

const Layer& layer(const Rendering& rendering, std::string_view name) {
  return *std::find_if(rendering.layers.begin(), rendering.layers.end(), [name](const Layer& l) { return l.name == name; });
}

RenderOptions with_layers(std::string_view names) {
  RenderOptions options;
  options.aovs = *parse_aovs(names);
  return options;
}

double largest_difference(const Image& a, const Image& b) {
  EXPECT_EQ(a.pixels.size(), b.pixels.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    largest = std::max(largest, static_cast<double>(std::abs(a.pixels[i] - b.pixels[i])));
  }
  return largest;
}

// --- derivatives -------------------------------------------------------------------------------------------------------------------

TEST(Texturing, SlopesOfWeightsAreTheDerivativesOfTheWeights) {
  Scene scene = plain_scene(triangle_mesh({-1, -1, 1}, {2, -0.5F, -4}, {-0.5F, 1.5F, 0}));
  Mesh more = *scene.objects[0].mesh;
  more.positions.insert(more.positions.end(), {{-3, -1, 6}, {4, -1, -9}, {0, 2, 0}, {0.5F, 0.5F, 0}, {0, 0.5F, 0}, {0.5F, -0.5F, 0.5F}});
  more.normals.resize(9, {0, 0, 1});
  more.triangles = {{0, 1, 2}, {0, 2, 1}, {3, 4, 5}, {6, 7, 8}};  // plain, swapped, cut by the near plane, small
  scene.objects[0].mesh = std::make_shared<const Mesh>(more);
  bool saw_clipped = false, saw_swapped = false;
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    scene.camera.projection = projection;
    scene.camera.height = 5;
    const auto prepared = prepare(scene);
    ASSERT_TRUE(prepared);
    for (const ScreenTriangle& t : setup_triangles(*prepared, 1)) {
      saw_clipped = saw_clipped || t.is_clipped;
      saw_swapped = saw_swapped || t.is_swapped;
      // The weights once more, in double precision and for any point.
      const auto weights = [&](double px, double py) {
        std::array<double, 3> b{};
        double key = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
          b[i] = ((t.x[k] - t.x[j]) * (py - t.y[j]) - (t.y[k] - t.y[j]) * (px - t.x[j])) / static_cast<double>(t.area2);
          key += b[i] * static_cast<double>(t.depth_key[i]);
        }
        std::array<double, 3> w = b;
        for (std::size_t i = 0; i < 3 && projection == Projection::perspective; ++i) {
          w[i] = b[i] * static_cast<double>(t.depth_key[i]) / key;
        }
        if (!t.is_clipped) {
          return t.is_swapped ? Vec3d{w[0], w[2], w[1]} : Vec3d{w[0], w[1], w[2]};
        }
        return vec_cast<double>(t.corner_weights[0]) * w[0] + vec_cast<double>(t.corner_weights[1]) * w[1] +
               vec_cast<double>(t.corner_weights[2]) * w[2];
      };
      const std::int32_t x = (t.x[0] + t.x[1] + t.x[2]) / 3, y = (t.y[0] + t.y[1] + t.y[2]) / 3;
      const WeightSlopes<float> slopes = weight_slopes_at(prepared->view, t, x, y);
      const Vec3d dx = (weights(x + 0.5, y) - weights(x - 0.5, y)) * 256.0;
      const Vec3d dy = (weights(x, y + 0.5) - weights(x, y - 0.5)) * 256.0;
      const double size = std::sqrt(dot(dx, dx) + dot(dy, dy));
      for (std::size_t i = 0; i < 3; ++i) {
        const auto part = [i](const Vec3d& v) { return i == 0 ? v.x : (i == 1 ? v.y : v.z); };
        EXPECT_NEAR(static_cast<double>(slopes.dx[i]), part(dx), 1e-4 * size);
        EXPECT_NEAR(static_cast<double>(slopes.dy[i]), part(dy), 1e-4 * size);
      }
    }
  }
  EXPECT_TRUE(saw_clipped);
  EXPECT_TRUE(saw_swapped);
}

// --- colours -----------------------------------------------------------------------------------------------------------------------

TEST(Texturing, AQuadSeenStraightOnShowsTheTexture) {
  const Image picture = noise(16, 16, 1);
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::linear}) {
    const Rendering r =
        drawn(straight_on(16, {.diffuse = TextureUse{.texture = texture_of(picture), .sampler = {.magnify = filter, .minify = filter}}}));
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 16; ++x) {
        for (std::size_t c = 0; c < 3; ++c) {
          ASSERT_NEAR(r.color.at(x, y)[c], picture.at(x, y)[c], 1e-5F) << x << ", " << y;
        }
      }
    }
  }
}

TEST(Texturing, TheUvMatrixAndTheSecondSetMoveThePicture) {
  const Image picture = noise(8, 8, 2);
  auto mesh = std::make_shared<Mesh>(*quad());
  mesh->uvs1 = mesh->uvs;
  for (Vec2f& uv : mesh->uvs1) {
    uv = {1 - uv.x, uv.y};  // mirrored
  }
  TextureUse use{.texture = texture_of(picture)};
  use.uv_set = 1;
  use.uv_matrix = {1, 0, 0, 0, -1, 1};  // upside down, as OBJ has it
  Scene scene = straight_on(8, {.diffuse = use});
  scene.objects[0].mesh = mesh;
  const Rendering r = drawn(scene);
  EXPECT_TRUE(r.notes.empty());
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      ASSERT_NEAR(r.color.at(x, y)[1], picture.at(7 - x, 7 - y)[1], 1e-5F);
    }
  }
}

TEST(Texturing, GainAndBaseStretchTheValueAndOutsideThePictureMayStayAsItIs) {
  TextureUse use = constant({0.2F, 0.4F, 0.6F});
  use.gain = {2, 0.5F, 1};
  use.base = {0.1F, 0.2F, -0.5F};
  use.uv_matrix = {2, 0, 0, 0, 1, 0};  // the right half lies outside
  use.leaves_outside = true;
  const Rendering r = drawn(straight_on(8, {.diffuse = use}));
  EXPECT_NEAR(r.color.at(1, 4)[0], 0.5F, 1e-6F);
  EXPECT_NEAR(r.color.at(1, 4)[1], 0.4F, 1e-6F);
  EXPECT_NEAR(r.color.at(1, 4)[2], 0.1F, 1e-6F);
  EXPECT_EQ(r.color.at(6, 4)[0], 1);
  use.leaves_outside = false;
  EXPECT_NEAR(drawn(straight_on(8, {.diffuse = use})).color.at(6, 4)[0], 0.5F, 1e-6F);
}

TEST(Texturing, ADecalCoversTheColourByItsAlpha) {
  Scene scene = straight_on(4, {.diffuse = constant({0.5F, 0.5F, 0.5F}), .decal = constant({1, 0, 0.5F, 0.25F})});
  const Rendering r = drawn(scene, with_layers("albedo"));
  const float half = std::floor(0.5F * 65535 + 0.5F) / 65535, quarter = std::floor(0.25F * 65535 + 0.5F) / 65535;
  EXPECT_NEAR(r.color.at(1, 1)[0], half * (1 - quarter) + quarter, 1e-6F);
  EXPECT_NEAR(r.color.at(1, 1)[1], half * (1 - quarter), 1e-6F);
  EXPECT_NEAR(layer(r, "albedo").image.at(1, 1)[0], r.color.at(1, 1)[0], 1e-6F);
}

/// A plane that fills the picture in perspective, and what each of its pixels shows in double precision: the ray's uv, its derivatives in closed
/// form, log2 of the longer one, and trilinear interpolation as OpenGL 4.6, 8.14 has it.
TEST(Texturing, APlaneInPerspectiveEqualsDoublePrecision) {
  const Image picture = noise(64, 64, 3);
  const auto texture = texture_of(picture);
  auto mesh = std::make_shared<Mesh>();  // y = 0, x in -60..60, z in -110..10
  mesh->positions = {{-60, 0, 10}, {60, 0, 10}, {60, 0, -110}, {-60, 0, -110}};
  mesh->normals.assign(4, {0, 1, 0});
  mesh->uvs = {{-30, 5}, {30, 5}, {30, -55}, {-30, -55}};  // u = x / 2, v = z / 2
  mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
  Scene scene = straight_on(8, {.diffuse = TextureUse{.texture = texture}});
  scene.objects[0].mesh = mesh;
  scene.image.width = 160;
  scene.image.height = 120;
  scene.camera = {
      .projection = Projection::perspective, .eye = Vec3d{0.3, 1, 0.2}, .target = Vec3d{0.5, 0.4, -1}, .fov = 50, .near = 0.05, .far = 500};
  const Rendering r = drawn(scene, with_layers("mask"));

  const Vec3d forward = normalize(*scene.camera.target - *scene.camera.eye);
  const Vec3d right = normalize(cross(forward, Vec3d{0, 1, 0}));
  const Vec3d up = cross(right, forward);
  const double per_pixel = 2 * std::tan(25 * 3.14159265358979323846 / 180) / 120;
  const auto trilinear = [&](double u, double v, double lod, std::size_t channel) {
    const auto bilinear = [&](std::size_t level) {
      const int size = texture->levels()[level].width;
      const double x = u * size - 0.5, y = v * size - 0.5;
      const auto texel = [&](double i, double j) {
        const auto wrapped = [size](double k) { return static_cast<int>(k - std::floor(k / size) * size); };
        return static_cast<double>(texture->texel(level, wrapped(i), wrapped(j))[channel]);
      };
      const double i = std::floor(x), j = std::floor(y);
      return (texel(i, j) * (1 - (x - i)) + texel(i + 1, j) * (x - i)) * (1 - (y - j)) +
             (texel(i, j + 1) * (1 - (x - i)) + texel(i + 1, j + 1) * (x - i)) * (y - j);
    };
    const double limited = std::clamp(lod, 0.0, 6.0);
    const auto level = static_cast<std::size_t>(limited);
    const double share = limited - std::floor(limited);
    return bilinear(level) * (1 - share) + (share > 0 ? bilinear(level + 1) * share : 0);
  };
  double sum = 0, largest = 0;
  int compared = 0;
  double lowest_lod = 100, highest_lod = -100;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      if (layer(r, "mask").image.at(x, y)[0] < 1) {
        continue;
      }
      // With d = d0 + x dx + y dy the ray meets y = 0 at t = -eye.y / d.y: u = (eye.x + t d.x) / 2, so u_dx = t (dx.x - d.x dx.y / d.y) / 2.
      const Vec3d dx = right * per_pixel, dy = up * -per_pixel;
      const Vec3d d = forward + dx * (x + 0.5 - 80) + dy * (y + 0.5 - 60);
      const double t = -scene.camera.eye->y / d.y;
      const double u = (scene.camera.eye->x + t * d.x) / 2, v = (scene.camera.eye->z + t * d.z) / 2;
      const auto slope = [&](const Vec3d& step) {
        return std::hypot(t * (step.x - d.x * step.y / d.y) / 2 * 64, t * (step.z - d.z * step.y / d.y) / 2 * 64);
      };
      const double lod = std::log2(std::max(slope(dx), slope(dy)));
      lowest_lod = std::min(lowest_lod, lod);
      highest_lod = std::max(highest_lod, lod);
      for (std::size_t c = 0; c < 3; ++c) {
        const double difference = std::abs(static_cast<double>(r.color.at(x, y)[c]) - trilinear(u, v, lod, c));
        sum += difference;
        largest = std::max(largest, difference);
        ++compared;
      }
    }
  }
  EXPECT_LT(lowest_lod, -1);
  EXPECT_GT(highest_lod, 5);
  EXPECT_GT(compared, 3 * 10000);
  // Corners lie at whole 1/256 pixels: coordinates may be off by half of that.
  EXPECT_LT(largest, 5e-3);
  EXPECT_LT(sum / compared, 2e-4);
}

TEST(Texturing, AConstantMapIsAConstantFactorOfItsTermUnderEveryInterpolation) {
  for (const Interpolation interpolation : {Interpolation::flat, Interpolation::gouraud, Interpolation::phong}) {
    Scene plain = rich_scene();
    plain.shading.interpolation = interpolation;
    plain.fog.reset();
    for (Light& light : *plain.lights) {  // nothing is clamped at a vertex
      light.diffuse = light.specular = {{0.2F, 0.3F, 0.25F}};
    }
    auto mesh = std::make_shared<Mesh>(*plain.objects[0].mesh);
    mesh->uvs.assign(mesh->positions.size(), {0.5F, 0.5F});
    plain.objects[0].mesh = mesh;
    Scene textured = plain;
    textured.objects[0].material->textures = {.ambient = constant({0.2F, 0.4F, 0.6F}),
                                              .diffuse = constant({0.4F, 0.2F, 0.8F}),
                                              .specular = constant({0.6F, 0.6F, 0.2F}),
                                              .emission = constant({1.5F, 0.5F, 1})};
    Material& k = *plain.objects[0].material;
    k.ambient.rgb = k.ambient.rgb * Vec3f{0.2F, 0.4F, 0.6F};
    k.diffuse.rgb = k.diffuse.rgb * Vec3f{0.4F, 0.2F, 0.8F};
    k.specular.rgb = k.specular.rgb * Vec3f{0.6F, 0.6F, 0.2F};
    k.emission.rgb = k.emission.rgb * Vec3f{1.5F, 0.5F, 1};
    const RenderOptions options = with_layers("ambient,diffuse,specular,emission,light:*,scene,albedo");
    const Rendering a = drawn(plain, options), b = drawn(textured, options);
    EXPECT_LT(largest_difference(a.color, b.color), 2e-6);
    for (std::size_t i = 0; i < a.layers.size(); ++i) {
      EXPECT_LT(largest_difference(a.layers[i].image, b.layers[i].image), 2e-6) << a.layers[i].name;
    }
  }
}

TEST(Texturing, GouraudClampsAtTheVertexBeforeTheTexture) {
  Scene scene = straight_on(8, {.diffuse = constant({0.2F, 0.4F, 0.6F})});
  scene.shading = {.lighting = Lighting::lambert, .interpolation = Interpolation::gouraud};
  scene.lights = std::vector<Light>{sun({0, 0, -1})};
  scene.lights->at(0).diffuse = {{5, 5, 5}};
  const Rendering r = drawn(scene);
  EXPECT_NEAR(r.color.at(3, 3)[0], 0.2F, 1e-6F);
  EXPECT_NEAR(r.color.at(3, 3)[2], 0.6F, 1e-6F);
}

TEST(Texturing, AShininessMapMultipliesTheExponentAtThePixel) {
  Scene plain = plain_scene(primitive("sphere:48"));
  auto mesh = std::make_shared<Mesh>(*plain.objects[0].mesh);
  mesh->uvs.assign(mesh->positions.size(), {0.5F, 0.5F});
  plain.objects[0].mesh = mesh;
  plain.lights = std::vector<Light>{sun({-1, -1, -1})};
  for (const Lighting lighting : {Lighting::phong, Lighting::blinn_phong}) {
    for (const bool normalized : {false, true}) {
      plain.shading.lighting = lighting;
      plain.shading.normalized = normalized;
      Scene textured = plain;
      plain.objects[0].material = Material{.specular = {{1, 1, 1}}, .shininess = 12};
      TextureUse use = constant({0, 0.6F, 0});
      use.channel = 1;
      textured.objects[0].material = Material{.specular = {{1, 1, 1}}, .shininess = 20, .textures = {.shininess = use}};
      EXPECT_LT(largest_difference(drawn(plain).color, drawn(textured).color), 2e-5);
      EXPECT_GT(largest_difference(drawn(plain).color, Image(64, 48, 4)), 0.5);
    }
  }
}

// --- normals -----------------------------------------------------------------------------------------------------------------------

/// A normal map of one direction.
TextureUse tilt(const Vec3d& n) {
  Image image(1, 1, 4);  // float, because of the fourth channel: the direction is exact
  image.pixels = {static_cast<float>(n.x / 2 + 0.5), static_cast<float>(n.y / 2 + 0.5), static_cast<float>(n.z / 2 + 0.5), 2};
  return {.texture = texture_of(image)};
}

void expect_normal(const Rendering& r, int x, int y, const Vec3d& expected, double tolerance = 1e-5) {
  const auto n = layer(r, "normal").image.at(x, y);
  const Vec3d unit = normalize(expected);
  EXPECT_NEAR(static_cast<double>(n[0]), unit.x, tolerance);
  EXPECT_NEAR(static_cast<double>(n[1]), unit.y, tolerance);
  EXPECT_NEAR(static_cast<double>(n[2]), unit.z, tolerance);
}

TEST(Texturing, ANormalMapOfAConstantTiltEqualsTiltedGeometry) {
  const Vec3d n = normalize(Vec3d{0.3, 0.4, 0.8});
  Scene mapped = plain_scene(quad());
  mapped.lights = std::vector<Light>{sun({0.3, -0.4, -1})};
  const Material material{.diffuse = {{0.5F, 0.5F, 0.5F}}, .specular = {{1, 1, 1}}, .shininess = 10};
  mapped.objects[0].material = material;
  Scene tilted = mapped;
  auto mesh = std::make_shared<Mesh>(*quad());
  mesh->normals.assign(4, vec_cast<float>(n));
  tilted.objects[0].mesh = mesh;
  mapped.objects[0].material->textures = {.normal = tilt(n)};
  const Rendering a = drawn(mapped, with_layers("normal")), b = drawn(tilted, with_layers("normal"));
  EXPECT_LT(largest_difference(a.color, b.color), 1e-5);
  EXPECT_LT(largest_difference(layer(a, "normal").image, layer(b, "normal").image), 1e-6);
  expect_normal(a, 32, 24, n);
}

TEST(Texturing, ATangentFrameGoesWhereItsObjectGoes) {
  const Vec3d n{0.3, 0.4, 0.8};
  struct Case {
    std::array<double, 9> m;
    Vec3d expected;  // x T + y B + z N with T, B, N unit where the matrix puts them
  };
  const std::vector<Case> cases{{{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0.3, 0.4, 0.8}},
                                {{2, 0, 0, 0, 2, 0, 0, 0, 2}, {0.3, 0.4, 0.8}},
                                {{-1, 0, 0, 0, 1, 0, 0, 0, 1}, {-0.3, 0.4, 0.8}},
                                {{1, 0, 0, 0, -1, 0, 0, 0, 1}, {0.3, -0.4, 0.8}},
                                {{2, 0, 0, 0, 1, 0, 0, 0, 1}, {0.3, 0.4, 0.8}},
                                {{-2, 0, 0, 0, 1, 0, 0, 0, 3}, {-0.3, 0.4, 0.8}},
                                {{0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1}, {0.3 * 0.8 - 0.4 * 0.6, 0.3 * 0.6 + 0.4 * 0.8, 0.8}}};
  for (const Case& c : cases) {
    Scene scene = plain_scene(quad());
    scene.objects[0].matrix = {{c.m[0], c.m[1], c.m[2], 0, c.m[3], c.m[4], c.m[5], 0, c.m[6], c.m[7], c.m[8], 0, 0, 0, 0, 1}};
    scene.objects[0].material = Material{.textures = {.normal = tilt(n)}};
    expect_normal(drawn(scene, with_layers("normal")), 32, 24, c.expected);
    // Seen from behind, lit on both sides: turned round as a whole.
    scene.camera.eye = Vec3d{0, 0, -4};
    scene.shading.two_sided = true;
    expect_normal(drawn(scene, with_layers("normal")), 32, 24, c.expected * -1.0);
  }
}

TEST(Texturing, TangentsAreMadeWhereTheMeshStatesNone) {
  auto mesh = std::make_shared<Mesh>(*quad());
  mesh->tangents.clear();
  Scene scene = plain_scene(mesh);
  TextureUse use = tilt({0.3, 0.4, 0.8});
  scene.objects[0].material = Material{.textures = {.normal = use}};
  expect_normal(drawn(scene, with_layers("normal")), 32, 24, {0.3, 0.4, 0.8});
  // A quarter turn of the picture turns what it states: u' = v is down, up the picture is to the right.
  use.uv_matrix = {0, 1, 0, -1, 0, 0};
  scene.objects[0].material->textures.normal = use;
  expect_normal(drawn(scene, with_layers("normal")), 32, 24, {0.4, -0.3, 0.8});
  // OBJ's way: v up in the file, turned round by the map.
  for (Vec2f& uv : mesh->uvs) {
    uv.y = 1 - uv.y;
  }
  use.uv_matrix = {1, 0, 0, 0, -1, 1};
  scene.objects[0].material->textures.normal = use;
  scene.objects[0].mesh = std::make_shared<const Mesh>(*mesh);
  expect_normal(drawn(scene, with_layers("normal")), 32, 24, {0.3, 0.4, 0.8});
  // Of a material of the mesh, too.
  mesh->materials = {Material{}, *scene.objects[0].material};
  mesh->triangle_material = {1, 1};
  scene.objects[0].material.reset();
  scene.objects[0].mesh = std::make_shared<const Mesh>(*mesh);
  expect_normal(drawn(scene, with_layers("normal")), 32, 24, {0.3, 0.4, 0.8});
}

TEST(Texturing, AFlippedHandednessTurnsGreenRound) {
  auto mesh = std::make_shared<Mesh>(*quad());
  mesh->tangents.assign(4, {1, 0, 0, -1});
  Scene scene = plain_scene(mesh);
  scene.objects[0].material = Material{.textures = {.normal = tilt({0.3, 0.4, 0.8})}};
  expect_normal(drawn(scene, with_layers("normal")), 32, 24, {0.3, -0.4, 0.8});
}

TEST(Texturing, AnObjectSpaceNormalMapStatesNormalsOfTheObject) {
  Scene scene = plain_scene(quad());
  scene.objects[0].matrix = {{0.8, -0.6, 0, 0, 0.6, 0.8, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
  scene.objects[0].material = Material{.textures = {.normal = tilt({1, 0, 1}), .normal_is_object_space = true}};
  expect_normal(drawn(scene, with_layers("normal")), 32, 24, {0.8, 0.6, 1});
  scene.objects[0].matrix = {{2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};  // a normal goes by the inverse transpose
  expect_normal(drawn(scene, with_layers("normal")), 32, 24, {0.5, 0, 1});
}

/// A height that grows with u by `height` from 0 to 1.
TextureUse ramp(float height, int size = 64) {
  Image image(size, size, 1);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      image.at(x, y)[0] = (static_cast<float>(x) + 0.5F) / static_cast<float>(size);
    }
  }
  return {.texture = texture_of(image), .sampler = {.wrap_u = Wrap::clamp_to_edge}, .gain = {height, height, height}};
}

TEST(Texturing, ABumpMapOfALinearRampEqualsTheTiltedPlane) {
  // z = height u with u = (x + 1) / 2: the normal is (-height / 2, 0, 1).
  for (const float height : {0.5F, -1.0F, 3.0F}) {
    const Vec3d expected{-static_cast<double>(height) / 2, 0, 1};
    Scene scene = plain_scene(quad());
    scene.objects[0].material = Material{.textures = {.bump = ramp(height)}};
    for (const int width : {16, 64, 512}) {  // whatever the resolution
      scene.image.width = width;
      scene.image.height = width * 3 / 4;
      expect_normal(drawn(scene, with_layers("normal")), width / 2, width * 3 / 8, expected, 2e-3);
    }
    scene.camera.eye = Vec3d{1.5, 2, 2.5};  // wherever it is seen from
    expect_normal(drawn(scene, with_layers("normal")), 256, 192, expected, 2e-3);
    scene.objects[0].matrix = {{0.8, -0.6, 0, 0, 0.6, 0.8, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};  // turned
    expect_normal(drawn(scene, with_layers("normal")), 256, 192, {expected.x * 0.8, expected.x * 0.6, 1}, 2e-3);
    scene.objects[0].matrix = {{3, 0, 0, 0, 0, 3, 0, 0, 0, 0, 3, 0, 0, 0, 0, 1}};  // three times as large, bumps and all
    expect_normal(drawn(scene, with_layers("normal")), 256, 192, expected, 2e-3);
    scene.objects[0].matrix = {{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};  // mirrored
    expect_normal(drawn(scene, with_layers("normal")), 256, 192, {-expected.x, 0, 1}, 2e-3);
    scene.objects[0].matrix = {};
    scene.camera.eye = Vec3d{0, 0, -4};  // a bump is a dent from behind
    scene.shading.two_sided = true;
    expect_normal(drawn(scene, with_layers("normal")), 256, 192, expected * -1.0, 2e-3);
  }
}

TEST(Texturing, ABumpIsTheSameWhicheverWayThePictureLies) {
  auto mesh = std::make_shared<Mesh>(*quad());
  for (Vec2f& uv : mesh->uvs) {
    uv = {1 - uv.x, uv.y};  // mirrored: heights grow towards -x
  }
  Scene scene = plain_scene(mesh);
  scene.objects[0].material = Material{.textures = {.bump = ramp(1)}};
  expect_normal(drawn(scene, with_layers("normal")), 32, 24, {0.5, 0, 1}, 2e-3);
}

// --- explanations, notes, untrusted numbers ------------------------------------------------------------------------------------------

Scene textured_rich_scene(Interpolation interpolation) {
  Scene scene = rich_scene();
  scene.shading.interpolation = interpolation;
  scene.objects[0].material->textures.specular = constant({0.3F, 0.9F, 0.5F});
  auto mesh = std::make_shared<Mesh>(*scene.objects[0].mesh);
  mesh->uvs.clear();
  for (const Vec3f& p : mesh->positions) {
    mesh->uvs.push_back({p.x * 2, p.y * 3});
  }
  scene.objects[0].mesh = mesh;
  MaterialTextures& textures = scene.objects[0].material->textures;
  textures.diffuse = TextureUse{.texture = texture_of(noise(8, 8, 4)), .name = "noise.png"};
  if (interpolation == Interpolation::phong) {
    textures.bump = TextureUse{.texture = texture_of(noise(4, 4, 5)), .gain = {0.05F, 0.05F, 0.05F}};
    textures.shininess = constant({0.5F});
  }
  return scene;
}

TEST(Texturing, AnExplanationEqualsThePixelAndSaysWhatTheMapsSaid) {
  std::mt19937 random(6);
  for (const Interpolation interpolation : {Interpolation::flat, Interpolation::gouraud, Interpolation::phong}) {
    const Scene scene = textured_rich_scene(interpolation);
    const Rendering picture = drawn(scene);
    int with_maps = 0;
    for (int i = 0; i < 60; ++i) {
      const int x = 20 + static_cast<int>(random() % 57), y = 10 + static_cast<int>(random() % 41);
      const auto e = explain(scene, x, y);
      ASSERT_TRUE(e);
      const auto pixel = picture.color.at(x, y);
      ASSERT_EQ(e->color, (std::array<float, 4>{pixel[0], pixel[1], pixel[2], pixel[3]}));
      const Vec3f sum = ((((e->ambient + e->diffuse) + e->specular) + e->emission) + e->fog) + e->background;
      ASSERT_EQ(sum, (Vec3f{pixel[0], pixel[1], pixel[2]}));
      expect_products(*e);
      for (const FragmentExplanation& f : e->fragments) {
        if (f.maps.empty()) {
          EXPECT_EQ(f.object, 1);
          continue;
        }
        ++with_maps;
        ASSERT_EQ(f.maps.size(), interpolation == Interpolation::phong ? 4U : 2U);
        EXPECT_EQ(f.maps[0].map, "diffuse");
        EXPECT_EQ(f.maps[0].name, "noise.png");
        const Material& stated = *scene.objects[0].material;
        EXPECT_FLOAT_EQ(f.coefficients.diffuse.rgb.x, stated.diffuse.rgb.x * f.maps[0].value[0]);
        EXPECT_FLOAT_EQ(f.coefficients.specular.rgb.y, stated.specular.rgb.y * f.maps[1].value[1]);
        EXPECT_FLOAT_EQ(f.coefficients.shininess, interpolation == Interpolation::phong ? 20 * f.maps[2].value[0] : 20);
      }
    }
    EXPECT_GT(with_maps, 20);
  }
}

// Under flat and Gouraud interpolation, too: a decal that covers all is the material of its colour, one that covers nothing is none, and between
// them the light is mixed as the coefficients are.
TEST(Texturing, ADecalIsLitByTheFaceOrTheVerticesWhereThePixelIsNot) {
  for (const Interpolation interpolation : {Interpolation::flat, Interpolation::gouraud}) {
    Scene scene = plain_scene(primitive("sphere:12"));
    scene.shading.interpolation = interpolation;
    scene.ambient = {{0.1F, 0.2F, 0.1F}};
    scene.lights = std::vector<Light>{sun({-1, -1, -1}), sun({1, -0.5, -1})};
    for (Light& light : *scene.lights) {
      light.diffuse = {{0.3F, 0.25F, 0.2F}};  // nothing is clamped
      light.specular = {{0.2F, 0.2F, 0.2F}};
      light.ambient = {{0.05F, 0, 0.1F}};
    }
    const Material plain{.ambient = {{0.5F, 0.5F, 0.5F}}, .diffuse = {{0.5F, 0.25F, 0.75F}}, .specular = {{0.4F, 0.4F, 0.4F}}, .shininess = 10};
    Material covered = plain;
    covered.ambient = covered.diffuse = {{0.25F, 0.75F, 0.5F}};
    const auto with_share = [&](float share) {
      Material material = plain;
      material.textures.decal = constant({0.25F, 0.75F, 0.5F, share});
      return material;
    };
    const auto seen = [&](const Material& material) {
      scene.objects[0].material = material;
      return drawn(scene, with_layers("ambient,diffuse,light:*,scene"));
    };
    const Rendering none = seen(plain), all = seen(covered);
    for (const float share : {0.0F, 0.25F, 1.0F}) {
      const Rendering mixed = seen(with_share(share));
      EXPECT_TRUE(mixed.notes.empty());
      const auto expect_mixed = [&](const Image& image, const Image& a, const Image& b) {
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
          ASSERT_NEAR(image.pixels[i], a.pixels[i] + (b.pixels[i] - a.pixels[i]) * share, 2e-5F);
        }
      };
      expect_mixed(mixed.color, none.color, all.color);
      for (std::size_t l = 0; l < mixed.layers.size(); ++l) {
        expect_mixed(mixed.layers[l].image, none.layers[l].image, all.layers[l].image);
      }
    }
  }
}

TEST(Texturing, BothEnginesDrawTheSamePicture) {
  const Scene scene = textured_rich_scene(Interpolation::phong);
  const Rendering reference = drawn(scene);
  const auto raster = render(scene, {.store_bytes = true});
  ASSERT_TRUE(raster);
  EXPECT_EQ(raster->color.pixels, reference.color.pixels);
  EXPECT_EQ(raster->bytes.pixels, to_bytes(reference.color, scene.image.transfer).pixels);
}

TEST(Texturing, WhatCannotBeDrawnIsLeftOutWithANote) {
  Scene scene = plain_scene(triangle_mesh({-1, -1, 0}, {1, -1, 0}, {0, 1, 0}));
  const TextureUse use = constant({0.5F, 0.5F, 0.5F});
  scene.objects[0].material = Material{.textures = {.diffuse = use, .specular = TextureUse{}, .opacity = use}};
  const Scene plain = plain_scene(scene.objects[0].mesh);
  const Rendering r = drawn(scene);
  EXPECT_EQ(r.notes, (Notes{{"objects[0]", "its diffuse map is left out: the mesh has no texture coordinates 0"},
                            {"objects[0]", "its specular map is left out: it has no texture"},
                            {"objects[0]", "its opacity map is left out: the mesh has no texture coordinates 0"}}));
  scene.objects[0].mesh = quad();
  scene.objects[0].material->textures = {.bump = use, .normal = use};
  scene.shading.interpolation = Interpolation::gouraud;
  EXPECT_EQ(drawn(scene).notes, (Notes{{"objects[0]", "its bump map is left out: it needs interpolation phong"},
                                       {"objects[0]", "its normal map is left out: it needs interpolation phong"}}));
  auto short_of_uvs = std::make_shared<Mesh>(*quad());
  short_of_uvs->uvs1.resize(3);
  scene.objects[0].mesh = short_of_uvs;
  EXPECT_EQ(render(scene).error().text(),
            "objects[0].mesh: normals, uvs, uvs1, tangents and colors must be empty or have one entry for each of the 4 positions");
}

TEST(Texturing, CoordinatesThatAreNoNumbersAreDrawnAllTheSame) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  auto mesh = std::make_shared<Mesh>(*quad());
  for (const auto& uvs : std::vector<std::vector<Vec2f>>{{{kNan, 0}, {0, kNan}, {1, 1}, {0, 0}},
                                                         {{kInfinity, 0}, {-kInfinity, 0}, {1, 1}, {0, 0}},
                                                         {{3e38F, 0}, {-3e38F, 1e30F}, {1, 1}, {0, -3e38F}}}) {
    mesh->uvs = uvs;
    mesh->tangents.assign(4, {kNan, 0, 0, 0});
    Scene scene = plain_scene(std::make_shared<const Mesh>(*mesh));
    scene.lights = std::vector<Light>{sun({0, 0, -1})};
    const TextureUse use{.texture = texture_of(noise(5, 3, 1)), .sampler = {.anisotropy = 100}};
    scene.objects[0].material =
        Material{.specular = {{1, 1, 1}}, .textures = {.diffuse = use, .shininess = use, .decal = use, .bump = use, .normal = use}};
    const Rendering r = drawn(scene);
    EXPECT_TRUE(std::all_of(r.color.pixels.begin(), r.color.pixels.end(), [](float x) { return std::isfinite(x); }));
  }
}

}  // namespace
}  // namespace lustro
