// Maps in every row: the same floats as the reference, whatever the sampler, the map and the interpolation.
#include <cmath>
#include <memory>
#include <random>

#include "raster/parity.hpp"
#include "truth/scene_tree.hpp"

namespace lustro {
namespace {

class Random {
 public:
  explicit Random(std::uint32_t seed) : bits_(seed) {}
  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(bits_()) % count; }
  float unit() { return static_cast<float>(bits_() >> 8) / 16777216.0F; }
  float around(float size) { return (unit() * 2 - 1) * size; }

 private:
  std::mt19937 bits_;
};

std::shared_ptr<const Texture> random_texture(Random& random, bool is_hdr) {
  constexpr std::array kSizes{1, 2, 3, 5, 16, 31, 64};
  Image image(kSizes[random.below(kSizes.size())], kSizes[random.below(kSizes.size())], static_cast<int>(1 + random.below(4)));
  const bool is_bytes = random.below(2) == 0;
  for (float& value : image.pixels) {
    const float unit = random.unit();
    value = is_hdr ? unit * 3 : (is_bytes ? std::floor(unit * 255) / 255 : unit);
  }
  return *make_texture(image);
}

TextureUse random_use(Random& random, bool is_hdr = false) {
  TextureUse use;
  use.texture = random_texture(random, is_hdr);
  use.sampler = {static_cast<Wrap>(random.below(4)),
                 static_cast<Wrap>(random.below(4)),
                 static_cast<TextureFilter>(random.below(2)),
                 static_cast<TextureFilter>(random.below(2)),
                 static_cast<MipFilter>(random.below(3)),
                 random.below(3) == 0 ? static_cast<int>(1 + random.below(16)) : 1,
                 {random.unit(), random.unit(), random.unit(), 1}};
  use.uv_set = static_cast<std::uint8_t>(random.below(2));
  if (random.below(2) == 0) {
    use.uv_matrix = {random.around(3), random.around(3), random.around(2), random.around(3), random.around(3), random.around(2)};
  }
  use.channel = static_cast<std::uint8_t>(random.below(5));
  use.leaves_outside = random.below(4) == 0;
  if (random.below(4) == 0) {
    use.gain = {random.around(2), random.around(2), random.around(2)};
    use.base = {random.unit(), random.unit(), random.unit()};
  }
  return use;
}

MaterialTextures random_textures(Random& random) {
  MaterialTextures t;
  const auto maybe = [&](std::optional<TextureUse>& use, bool is_hdr = false) {
    if (random.below(2) == 0) {
      use = random_use(random, is_hdr);
    }
  };
  maybe(t.ambient);
  maybe(t.diffuse);
  maybe(t.specular, random.below(2) == 0);
  maybe(t.emission, true);
  maybe(t.shininess);
  maybe(t.decal);
  maybe(t.bump);
  maybe(t.normal);
  t.normal_is_object_space = random.below(3) == 0;
  if (random.below(3) == 0) {
    t.reflection = ReflectionMap{.shape = static_cast<ReflectionShape>(random.below(2))};
    for (std::optional<TextureUse>& face : t.reflection->faces) {
      maybe(face, random.below(2) == 0);
    }
  }
  return t;
}

// A mesh with both sets of coordinates and tangents, none of them tidy.
std::shared_ptr<const Mesh> mapped_mesh(Random& random, const char* name) {
  Mesh mesh = *truth::tree_mesh(name);
  mesh.uvs.clear();
  for (const Vec3f& p : mesh.positions) {
    mesh.uvs.push_back({p.x * 2 + p.z, p.y - p.x});
    mesh.uvs1.push_back({random.unit(), random.unit()});
    const Vec3f t = normalize(Vec3f{random.around(1), random.around(1), 0.1F});
    mesh.tangents.push_back({t.x, t.y, t.z, random.below(2) == 0 ? 1.0F : -1.0F});
  }
  return std::make_shared<const Mesh>(std::move(mesh));
}

Scene random_scene(Random& random) {
  constexpr std::array kMeshes{"primitive:sphere:40", "primitive:plane:3", "primitive:cube", "primitive:torus:30"};
  Scene scene;
  scene.image = {.width = static_cast<int>(60 + random.below(80)), .height = static_cast<int>(50 + random.below(60))};
  scene.image.samples = random.below(2) == 0 ? 1 : 4;
  scene.camera.projection = random.below(4) == 0 ? Projection::orthographic : Projection::perspective;
  scene.shading.interpolation = static_cast<Interpolation>(random.below(5) < 3 ? 2 : random.below(2));
  scene.shading.lighting = static_cast<Lighting>(random.below(5));
  scene.shading.terms.specular = random.below(6) != 0;
  scene.shading.normals = static_cast<NormalInterpolation>(random.below(3) == 0);
  scene.shading.two_sided = random.below(2) == 0;
  scene.shading.normalized = random.below(3) == 0;
  if (random.below(3) == 0) {
    scene.camera.eye = Vec3d{1.1, 0.7, 1.3};
    scene.camera.near = 0.9;  // opens the objects: clipped triangles have maps, too
    scene.camera.far = 50;
  }
  if (random.below(3) == 0) {
    scene.fog = Fog{.mode = FogMode::exp, .density = 0.3, .color = {{0.5F, 0.6F, 0.7F}}};
  }
  for (std::uint32_t i = 0; i < 2; ++i) {
    Object object;
    object.mesh = mapped_mesh(random, kMeshes[random.below(kMeshes.size())]);
    const double mirror = random.below(3) == 0 ? -1 : 1;
    const double stretch = random.below(2) == 0 ? 1.5 : 1;
    object.matrix.m = {mirror, 0.2 * i, 0, 0.8 * i, 0, stretch, 0, 0, 0, 0, 1, 0.3 * i, 0, 0, 0, 1};
    object.material = Material{.specular = {{0.4F, 0.5F, 0.6F}}, .emission = {{0.1F, 0, 0.2F}}, .shininess = 20};
    if (i == 0 || random.below(2) == 0) {
      object.material->textures = random_textures(random);
    }
    scene.objects.push_back(object);
  }
  return scene;
}

TEST(TextureParity, RandomMapsOnRandomScenes) {
  Random random(23);
  for (int i = 0; i < 60 && !testing::Test::HasFailure(); ++i) {
    expect_parity(random_scene(random), "textures " + std::to_string(i));
  }
}

// Makes what the scene draws see-through, in one of all ways.
void open_up(Random& random, Scene& scene) {
  for (Object& object : scene.objects) {
    Material& material = *object.material;
    if (random.below(5) == 0) {
      continue;  // opaque
    }
    material.alpha_mode = random.below(3) == 0 ? AlphaMode::mask : AlphaMode::blend;
    material.alpha_cutoff = random.unit();
    material.opacity = random.below(3) == 0 ? 1 : random.unit();
    material.halo = random.below(4) == 0;
    if (random.below(2) == 0) {
      material.textures.opacity = random_use(random);
    }
    if (random.below(3) == 0) {
      auto mesh = std::make_shared<Mesh>(*object.mesh);
      for (std::size_t i = 0; i < mesh->positions.size(); ++i) {
        mesh->alphas.push_back(random.unit());
      }
      object.mesh = mesh;
    }
    if (random.below(4) == 0) {  // opaque, masked and blended triangles in one mesh
      auto mesh = std::make_shared<Mesh>(*object.mesh);
      Material opaque = material, mask = material;
      opaque.alpha_mode = AlphaMode::opaque;
      mask.alpha_mode = AlphaMode::mask;
      opaque.cull = static_cast<Culling>(random.below(3));
      mask.cull = static_cast<Culling>(random.below(3));
      mesh->materials = {opaque, mask, material};
      for (std::size_t i = 0; i < mesh->triangles.size(); ++i) {
        mesh->triangle_material.push_back(random.below(3));
      }
      object.mesh = mesh;
      object.material.reset();
    }
  }
}

TEST(TransparencyParity, RandomScenes) {
  Random random(41);
  for (int i = 0; i < 60 && !testing::Test::HasFailure(); ++i) {
    Scene scene = random_scene(random);
    open_up(random, scene);
    scene.image.samples = 1 << random.below(5);
    scene.image.background_alpha = random.unit();
    scene.shading.cull = static_cast<Culling>(random.below(3));
    expect_parity(scene, "transparency " + std::to_string(i));
  }
}

// Squares one behind the other.
Scene stacked_scene(int sheets, int size, int samples, float opacity) {
  Scene scene;
  scene.image = {.width = size, .height = size, .samples = samples};
  scene.camera.eye = Vec3d{0, 0, 3};
  scene.camera.target = Vec3d{0, 0, 0};
  scene.shading.lighting = Lighting::constant;
  Mesh mesh;
  for (int i = 0; i < sheets; ++i) {
    const float z = -static_cast<float>(i) / static_cast<float>(sheets);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}}) {
      mesh.positions.push_back({x, y, z});
      mesh.normals.push_back({0, 0, 1});
      mesh.colors.push_back({static_cast<float>(i % 3) / 2, static_cast<float>(i % 5) / 4, static_cast<float>(i % 7) / 6});
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  scene.objects.push_back({.source = "stack", .mesh = std::make_shared<const Mesh>(std::move(mesh))});
  scene.objects[0].material = Material{.opacity = opacity};
  return scene;
}

TEST(TransparencyParity, MoreLayersThanATileKeepsAtATime) {
  const Scene scene = stacked_scene(150, 70, 1, 0.02F);  // 64 x 64 x 150 layers where 2^17 are kept
  const auto difference_found = difference(drawn(scene, {.engine = Engine::reference}, false), drawn(scene, {.threads = 2}, false));
  EXPECT_FALSE(difference_found) << *difference_found;
}

TEST(TransparencyParity, MoreLayersInAPixelThanAreShadedAtATime) {
  const Scene scene = stacked_scene(2500, 6, 2, 0.001F);
  for (const bool with_layers : {false, true}) {
    const auto difference_found =
        difference(drawn(scene, {.engine = Engine::reference}, with_layers), drawn(scene, {.threads = 2}, with_layers));
    EXPECT_FALSE(difference_found) << *difference_found;
  }
}

TEST(TextureParity, DisplacedMeshes) {
  Random random(29);
  for (int i = 0; i < 3; ++i) {
    Scene scene = random_scene(random);
    for (Object& object : scene.objects) {
      object.material->textures.displacement = random_use(random);
      object.material->textures.displacement->gain = {0.1F, 0.1F, 0.1F};
      object.material->textures.displacement->uv_matrix = {1, 0, 0, 0, 1, 0};
    }
    expect_parity(scene, "displaced " + std::to_string(i));
  }
}

}  // namespace
}  // namespace lustro
