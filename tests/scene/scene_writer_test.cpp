// Scenes as text, and back, bit by bit.
#include <gtest/gtest.h>

#include <random>

#include "lustro/scene.hpp"
#include "same_scene.hpp"
#include "scene_examples.hpp"

namespace lustro {
namespace {

/// Random scenes that keep every rule of the scene file.
class SceneMaker {
 public:
  explicit SceneMaker(std::uint32_t seed) : random_(seed) {}

  Scene scene() {
    Scene s;
    s.image.width = 1 + below(16384);
    s.image.height = 1 + below(16384);
    s.image.samples = 1 << below(5);
    s.image.transfer = word<Transfer>(2);
    s.image.background = color();
    s.image.background_alpha = coin() ? 1.0F : unit();
    s.image.transparent = coin();
    s.camera = camera();
    s.shading = shading();
    s.ambient = color();
    if (coin()) {
      s.lights.emplace();
      for (int i = below(4); i > 0; --i) {
        s.lights->push_back(light());
      }
    }
    if (coin()) {
      s.fog = Fog{word<FogMode>(3), std::abs(number()), -1 - std::abs(number()), std::abs(number()), color()};
    }
    if (coin()) {
      Environment& sky = s.environment.emplace();
      if (coin()) {
        sky.file = "sky \"1\".hdr";
      } else {
        sky.color = color();
      }
      sky.gain = coin() ? Vec3f{unit(), unit(), 1} : Vec3f{2, 2, 2};
      sky.rotation = 720 * static_cast<double>(unit()) - 360;
      sky.visible = coin();
    }
    std::vector<Material> materials{material("red"),           material("red"),           material("jade"),          material(""),
                                    *library_material("gold"), *library_material("jade"), material("odd \"name\"\n")};
    materials.push_back(*library_material("ruby"));
    materials.back().name = "stone";
    for (int i = below(6); i > 0; --i) {
      Object object;
      object.source = coin() ? "primitive:sphere" : "m\xc3\xb6\xc3\xb6l \"x\".obj";
      object.name = text();
      if (coin()) {
        object.material = materials[static_cast<std::size_t>(below(static_cast<int>(materials.size())))];
      }
      for (std::size_t k = 0; k < 12 && coin(); ++k) {
        object.matrix.m[k] = number();
      }
      s.objects.push_back(object);
    }
    return s;
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint32_t>(n)); }
  bool coin() { return below(2) == 1; }
  float unit() { return static_cast<float>(random_() >> 8U) / 16777216.0F; }
  template <class E>
  E word(int count) {
    return static_cast<E>(below(count));
  }
  std::string text() { return coin() ? "" : "n" + std::to_string(below(100)) + "\t\\"; }
  /// Any finite number that a float holds, of random bits.
  double number() {
    while (true) {
      const auto value = std::bit_cast<double>((std::uint64_t{random_()} << 32U) | random_());
      if (std::abs(value) < 1e38) {
        return value;
      }
    }
  }
  Vec3d vector() { return {number(), number(), number()}; }
  Color color() {
    switch (below(3)) {
      case 0:
        return {{unit(), unit() * 1e30F, unit() * 1e-30F}, ColorSpace::linear};
      case 1:
        return {{unit(), unit() * 9, unit()}, ColorSpace::encoded};
      default:
        return {{static_cast<float>(below(256)) / 255, static_cast<float>(below(256)) / 255, 0}, ColorSpace::encoded};
    }
  }
  Camera camera() {
    Camera c;
    c.projection = word<Projection>(2);
    c.view = word<ViewPreset>(8);
    if (coin()) {
      c.eye = vector();
    } else if (coin()) {
      c.target = vector();
    }
    c.fov = 0.5 + 179 * static_cast<double>(unit());
    if (coin()) {
      c.height = 1 + std::abs(number());
    }
    if (coin()) {
      c.near = 1e-3 + static_cast<double>(unit());
    }
    if (coin()) {
      c.far = 2 + std::abs(number());
    }
    return c;
  }
  Shading shading() {
    Shading s;
    s.lighting = word<Lighting>(4);
    s.interpolation = word<Interpolation>(3);
    s.normals = word<NormalInterpolation>(2);
    s.vertex_normals = word<VertexNormals>(3);
    if (coin()) {
      s.crease = 180 * static_cast<double>(unit());
    }
    s.recompute_normals = coin();
    s.terms = {coin(), coin(), coin(), coin()};
    s.two_sided = coin();
    s.cull = word<Culling>(3);
    s.normalized = coin();
    return s;
  }
  Light light() {
    Light l;
    l.type = word<LightType>(6);
    l.name = text();
    l.position = vector();
    l.direction = {1 + static_cast<double>(unit()), number(), 0};
    l.ambient = color();
    l.diffuse = color();
    l.specular = color();
    if (coin()) {
      l.attenuation.falloff = std::abs(number());
    } else {
      l.attenuation = {1 + std::abs(number()), std::abs(number()), std::abs(number()), std::nullopt, false};
    }
    l.attenuation.unclamped = coin();
    l.cutoff = 10 + 80 * static_cast<double>(unit());
    if (coin()) {
      l.beam = 10 * static_cast<double>(unit());
    }
    l.exponent = 10000 * static_cast<double>(unit());
    l.size = {0.1F + unit(), 0.1F + unit()};
    if (coin()) {
      l.x_axis = Vec3d{0, 0, -1 - static_cast<double>(unit())};
    }
    l.radius = 0.1 + static_cast<double>(unit());
    return l;
  }
  Material material(const std::string& name) {
    Material m;
    m.name = name;
    m.ambient = color();
    m.diffuse = color();
    m.specular = color();
    m.emission = color();
    m.shininess = unit() * 10000;
    m.opacity = unit();
    if (coin()) {
      m.lighting = word<Lighting>(4);
    }
    if (coin()) {
      m.cull = word<Culling>(3);
    }
    if (coin()) {
      m.illumination = below(11);
    }
    m.refraction = 1 + unit();
    m.transmission = color();
    m.alpha_mode = word<AlphaMode>(3);
    m.alpha_cutoff = unit();
    for (const auto slot : {&StatedTextures::diffuse, &StatedTextures::opacity, &StatedTextures::normal, &StatedTextures::displacement}) {
      if (below(4) == 0) {
        (m.stated_textures.*slot) = texture();
      }
    }
    m.stated_textures.object_space = below(8) == 0;
    if (below(4) == 0) {
      StatedReflection& map = m.stated_textures.reflection.emplace();
      map.shape = word<ReflectionShape>(2);
      if (map.shape == ReflectionShape::sphere) {
        map.picture = texture();
      } else {
        for (const auto face : {&StatedReflection::right, &StatedReflection::left, &StatedReflection::top, &StatedReflection::bottom,
                                &StatedReflection::front, &StatedReflection::back}) {
          map.*face = texture();
        }
      }
    }
    return m;
  }

  StatedTexture texture() {
    StatedTexture t;
    t.file = "w\xc3\xb6\xc3\xb6l \"1\".png";
    if (coin()) {
      return t;
    }
    t.wrap = {word<Wrap>(4), word<Wrap>(4)};
    t.magnify = word<TextureFilter>(2);
    t.minify = word<TextureFilter>(2);
    t.mip = word<MipFilter>(3);
    t.anisotropy = 1 + below(16);
    t.lod_bias = 32 * unit() - 16;
    t.border = color();
    t.border_alpha = unit();
    if (coin()) {
      t.offset = {unit() * 2 - 1, unit() * 1e8F};
      t.scale = {unit(), -unit()};
      t.rotation = 720 * unit() - 360;
    } else {
      t.matrix = {unit(), -unit(), unit() * 1e8F, 0, unit(), 1};
    }
    t.v_down = coin();
    t.uv_set = below(2);
    t.gain = coin() ? Vec3f{unit(), unit(), 1} : Vec3f{2, 2, 2};
    t.base = {-unit(), 0, unit()};
    t.channel = word<TextureChannel>(6);
    t.once = coin();
    return t;
  }

  std::mt19937 random_;
};

TEST(SceneWriter, RandomScenesReadBackBitEqual) {
  for (std::uint32_t seed = 0; seed < 3000; ++seed) {
    const Scene scene = SceneMaker(seed).scene();
    const std::string json = scene_json(scene);
    const auto back = parse_scene(json, "s.json");
    ASSERT_TRUE(back) << seed << ": " << back.error().text() << "\n" << json;
    ASSERT_EQ(difference(*back, scene, "scene"), "") << seed << "\n" << json;
    ASSERT_EQ(scene_json(*back), json) << seed;
  }
}

TEST(SceneWriter, TheExampleOfTheContractReadsBack) {
  const Scene scene = parse_scene(kExampleScene).value();
  const Scene back = parse_scene(scene_json(scene)).value();
  EXPECT_EQ(difference(back, scene, "scene"), "");
}

TEST(SceneWriter, ATextureOfDefaultsIsItsFile) {
  Scene scene;
  scene.objects.resize(1);
  scene.objects[0].source = "a.ply";
  scene.objects[0].material.emplace();
  StatedTextures& textures = scene.objects[0].material->stated_textures;
  textures.diffuse = StatedTexture{.file = "a.png"};
  textures.reflection = StatedReflection{.picture = StatedTexture{.file = "sky.hdr"}};
  textures.normal = StatedTexture{.file = "n.png", .wrap = {Wrap::repeat, Wrap::clamp_to_edge}};
  EXPECT_EQ(scene_json(scene),
            "{\n  \"objects\": [\n    {\"mesh\": \"a.ply\", \"material\": {\"diffuse\": [0.8, 0.8, 0.8], \"textures\": {\"diffuse\": \"a.png\", "
            "\"normal\": {\"file\": \"n.png\", \"wrap\": [\"repeat\", \"clamp_to_edge\"]}, \"reflection\": \"sky.hdr\"}}}\n  ]\n}\n");
  scene.objects[0].material = material_with(textures);  // white, as the reader has it
  EXPECT_EQ(scene_json(scene).find("[0.8"), std::string::npos);
  EXPECT_EQ(difference(*parse_scene(scene_json(scene)), scene, "scene"), "");
}

TEST(SceneWriter, LeavesOutWhatIsTheDefault) {
  Scene scene;
  scene.objects.resize(1);
  scene.objects[0].source = "a.ply";
  EXPECT_EQ(scene_json(scene), "{\n  \"objects\": [\n    {\"mesh\": \"a.ply\"}\n  ]\n}\n");
  scene.image.background = {{0.5F, 0.1F, 0}};
  scene.lights.emplace();
  EXPECT_EQ(scene_json(scene),
            "{\n  \"image\": {\"background\": [0.5, 0.1, 0]},\n  \"lights\": [],\n  \"objects\": [\n    {\"mesh\": \"a.ply\"}\n  ]\n}\n");
  EXPECT_EQ(scene_json(Scene{}), "{\n  \"objects\": []\n}\n");
}

TEST(SceneWriter, NamesSharedMaterialsOnceAndLibraryMaterialsByName) {
  Scene scene;
  Material red;
  red.name = "red";
  red.diffuse = {{1, 0, 0}, ColorSpace::encoded};
  for (int i = 0; i < 2; ++i) {
    scene.objects.push_back({.source = "a", .material = red});
  }
  scene.objects.push_back({.source = "a", .material = library_material("jade")});
  EXPECT_EQ(scene_json(scene), R"({
  "materials": {
    "red": {"diffuse": "#ff0000"}
  },
  "objects": [
    {"mesh": "a", "material": "red"},
    {"mesh": "a", "material": "red"},
    {"mesh": "a", "material": "jade"}
  ]
}
)");
}

TEST(SceneWriter, ANumberThatIsNotFiniteCannotBeReadBackUnseen) {
  Scene scene;
  scene.camera.fov = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(parse_scene(scene_json(scene), "s.json").error().text(), "s.json: camera.fov: found null, expected a number");
}

TEST(SceneWriter, TextThatIsNoUnicodeStaysJson) {
  Scene scene;
  scene.objects.push_back({.source = "a\xff"});
  EXPECT_TRUE(parse_scene(scene_json(scene)));
}

TEST(SceneFile, MutationsOfTheExampleNeverBreakTheRules) {
  std::mt19937 random(7);
  int good = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = kExampleScene;
    for (auto n = 1 + random() % 3; n > 0; --n) {
      const std::size_t at = random() % text.size();
      switch (random() % 4) {
        case 0:
          text[at] = static_cast<char>(random());
          break;
        case 1:
          text.erase(at, 1 + random() % 4);
          break;
        case 2:
          text.insert(at, 1, "0123456789-.eE\"[]{},:#"[random() % 23]);
          break;
        default:
          text.replace(at, random() % 20, text.substr(random() % text.size(), random() % 20));
          break;
      }
    }
    const auto scene = parse_scene(text, "s.json");
    if (!scene) {
      ASSERT_TRUE(scene.error().where.starts_with("s.json")) << scene.error().text();
      ASSERT_FALSE(scene.error().message.empty());
      ASSERT_LT(scene.error().text().size(), 1500U);
      continue;
    }
    ++good;
    const auto back = parse_scene(scene_json(*scene), "s.json");
    ASSERT_TRUE(back) << back.error().text() << "\n" << text;
    ASSERT_EQ(difference(*back, *scene, "scene"), "") << text;
  }
  EXPECT_GT(good, 200);
}

TEST(SceneWriter, ShadowsThatStateNothingAreTrue) {
  Scene scene;
  EXPECT_EQ(scene_json(scene).find("shadow"), std::string::npos);
  scene.shadow.emplace();
  EXPECT_NE(scene_json(scene).find("\"shadow\": true"), std::string::npos);
  scene.shadow->softness = 3;
  EXPECT_NE(scene_json(scene).find("\"shadow\": {\"softness\": 3}"), std::string::npos);
  scene.image.tone = {ToneOperator::aces, 0.5F};
  EXPECT_NE(scene_json(scene).find("\"tone\": {\"operator\": \"aces\", \"exposure\": 0.5}"), std::string::npos);
}

}  // namespace
}  // namespace lustro
