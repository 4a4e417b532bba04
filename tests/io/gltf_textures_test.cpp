// Pictures of glTF materials as textures of classic ones: the rule texel by texel, where pictures lie, and what is said of those that are not
// there.
#include "io/gltf_textures.hpp"

#include <fstream>
#include <iterator>

#include "gltf_testing.hpp"
#include "image/srgb.hpp"
#include "io/gltf_bake.hpp"
#include "temporary_folder.hpp"

namespace lustro {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Texels of `width` columns, each of `channels` numbers as they are stored.
Image texels(int width, int channels, const std::vector<float>& values) {
  Image image(width, static_cast<int>(values.size()) / width / channels, channels);
  image.pixels = values;
  return image;
}

/// A document with one textured triangle, in a folder of its own.
struct Surface : TemporaryFolder {
  GltfMaker maker;
  Json material = Json::object();

  Surface() {
    Json triangle = maker.triangle();
    triangle["attributes"]["TEXCOORD_0"] = maker.add_accessor<float>("VEC2", {0, 0, 1, 0, 0, 1});
    triangle["attributes"]["TEXCOORD_1"] = maker.add_accessor<float>("VEC2", {0, 0, 2, 0, 0, 2});
    triangle["material"] = 0;
    maker.add_node_with(triangle);
  }

  /// A picture in a file of its own, and the texture that shows it.
  Json texture(const std::string& name, const Image& image) {
    EXPECT_TRUE(write_image(path / name, image, {.transfer = Transfer::none}));
    return Json{{"index", maker.add("textures", {{"source", maker.add("images", {{"uri", name}})}})}};
  }

  Result<LoadedScene> load(const LoadOptions& options = {}) {
    maker.json["materials"] = Json::array({material});
    write("t.gltf", maker.text());
    return load_scene(path / "t.gltf", options);
  }
  Material made(const LoadOptions& options = {}) {
    const LoadedScene loaded = good(load(options));
    EXPECT_THAT(texts(loaded.notes), IsEmpty());
    return loaded.scene.objects[0].mesh->materials[0];
  }
};

/// What a map makes of its coefficient in a texel.
Vec3f value(const std::optional<TextureUse>& use, const Color& coefficient, int x, int y = 0) {
  if (!use) {
    return coefficient.rgb;
  }
  const std::array<float, 4> t = use->texture->texel(0, x, y);
  return (Vec3f{t[0], t[1], t[2]} * use->gain + use->base) * coefficient.rgb;
}
double exponent(const Material& m, int x, int y = 0) {
  const TextureUse& use = *m.textures.shininess;
  return static_cast<double>((use.texture->texel(0, x, y)[use.channel] * use.gain.x + use.base.x) * m.shininess);
}
void expect_near(const Vec3f& actual, const Vec3d& expected, double error = 2e-5) {
  EXPECT_NEAR(actual.x, expected.x, error);
  EXPECT_NEAR(actual.y, expected.y, error);
  EXPECT_NEAR(actual.z, expected.z, error);
}

TEST(GltfTextures, ABaseColourAloneIsThePictureItself) {
  Surface surface;
  surface.material["pbrMetallicRoughness"] = {{"metallicFactor", 0},
                                              {"baseColorFactor", {0.5, 1, 1, 1}},
                                              {"baseColorTexture", surface.texture("a.png", texels(2, 3, {0, 1, 0, 1, 1, 1}))}};
  const Material m = surface.made();
  ASSERT_TRUE(m.textures.diffuse && m.textures.ambient);
  EXPECT_EQ(m.textures.diffuse->texture, m.textures.ambient->texture);
  EXPECT_EQ(m.textures.diffuse->name, "a.png");
  expect_near(value(m.textures.diffuse, m.diffuse, 0), {0, 1, 0});
  expect_near(value(m.textures.diffuse, m.diffuse, 1), {0.5, 1, 1});
  EXPECT_FALSE(m.textures.specular);
  EXPECT_NEAR(m.specular.rgb.x, 0.04, 1e-7);
  EXPECT_FALSE(m.textures.opacity) << "opaque, and without an alpha";
  EXPECT_EQ(m.alpha_mode, AlphaMode::opaque);
}

TEST(GltfTextures, ColoursAreDecodedByTheTransferAndDataNever) {
  Surface surface;
  surface.material["pbrMetallicRoughness"] = {{"metallicFactor", 0},
                                              {"baseColorTexture", surface.texture("a.png", texels(2, 3, {0.6F, 0.6F, 0.6F, 1, 1, 1}))}};
  surface.material["normalTexture"] = surface.texture("n.png", texels(2, 3, {0.6F, 0.6F, 1, 0.4F, 0.6F, 1}));
  const Material m = surface.made();
  EXPECT_NEAR(m.textures.diffuse->texture->texel(0, 0, 0)[0], srgb_decode(0.6F), 1e-4);
  EXPECT_NEAR(m.textures.normal->texture->texel(0, 0, 0)[0], 0.6F, 1e-4);
}

TEST(GltfTextures, MetalIsMappedTexelByTexel) {  // green: roughness, blue: metal
  Surface surface;
  surface.material["pbrMetallicRoughness"] = {{"baseColorTexture", surface.texture("a.png", texels(2, 3, {1, 1, 0, 1, 0, 1}))},
                                              {"metallicRoughnessTexture", surface.texture("m.png", texels(2, 3, {0, 0.6F, 1, 0, 1, 0.2F}))}};
  const Material m = surface.made();
  expect_near(value(m.textures.diffuse, m.diffuse, 0), {0, 0, 0});  // all metal
  expect_near(value(m.textures.specular, m.specular, 0), {1, 1, 0});
  expect_near(value(m.textures.diffuse, m.diffuse, 1), {0.8, 0, 0.8});
  expect_near(value(m.textures.specular, m.specular, 1), {0.04 * 0.8 + 0.2, 0.04 * 0.8, 0.04 * 0.8 + 0.2});
  expect_near(value(m.textures.ambient, m.ambient, 1), {1, 0, 1});
  EXPECT_NEAR(exponent(m, 0), 2 / (0.6 * 0.6 * 0.6 * 0.6) - 2, 2e-3);
  EXPECT_NEAR(exponent(m, 1), 0, 1e-3);
  EXPECT_EQ(m.lighting, Lighting::blinn_phong);
  EXPECT_EQ(surface.made({.gltf_shading = GltfShading::ggx}).lighting, Lighting::ggx);
}

TEST(GltfTextures, WhatIsTheSameEverywhereIsANumber) {
  Surface surface;
  surface.material["pbrMetallicRoughness"] = {{"roughnessFactor", 0.5},
                                              {"baseColorTexture", surface.texture("a.png", texels(2, 3, {1, 1, 0, 1, 0, 1}))},
                                              {"metallicRoughnessTexture", surface.texture("m.png", texels(2, 3, {0, 1, 0, 0.5F, 1, 0}))}};
  const Material m = surface.made();
  EXPECT_FALSE(m.textures.shininess || m.textures.specular);
  EXPECT_NEAR(m.shininess, 30, 1e-4);
  EXPECT_EQ(m.textures.diffuse->texture, m.textures.ambient->texture) << "no metal anywhere: the picture itself";
}

TEST(GltfTextures, AConstantMetalMixesInAStraightLine) {
  Surface surface;
  surface.material["pbrMetallicRoughness"] = {{"metallicFactor", 0.5},
                                              {"baseColorTexture", surface.texture("a.png", texels(2, 3, {1, 1, 0, 1, 0, 1}))}};
  const Material m = surface.made();
  EXPECT_EQ(m.textures.specular->texture, m.textures.diffuse->texture);
  expect_near(value(m.textures.specular, m.specular, 0), {0.52, 0.52, 0.02});
  expect_near(value(m.textures.diffuse, m.diffuse, 0), {0.5, 0.5, 0});
}

TEST(GltfTextures, TheSmallerPictureIsEnlarged) {  // bilinear: 2 columns to 4, at 1/4 and 3/4 between their middles; the picture repeats
  Surface surface;
  surface.material["pbrMetallicRoughness"] = {{"baseColorTexture", surface.texture("a.png", texels(4, 3, {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0}))},
                                              {"metallicRoughnessTexture", surface.texture("m.png", texels(2, 3, {0, 1, 0, 0, 1, 1}))}};
  const Material m = surface.made();
  EXPECT_EQ(m.textures.diffuse->texture->width(), 4);
  for (const auto& [x, metal] : {std::pair(0, 0.25), {1, 0.25}, {2, 0.75}, {3, 0.75}}) {
    EXPECT_NEAR(value(m.textures.diffuse, m.diffuse, x).x, 1 - metal, 2e-5) << x;
  }
}

TEST(GltfTextures, OcclusionDimsTheAmbientLightByItsStrength) {
  Surface surface;
  surface.material["pbrMetallicRoughness"] = {{"metallicFactor", 0}, {"baseColorFactor", {1, 0.5, 0, 1}}};
  surface.material["occlusionTexture"] = surface.texture("o.png", texels(2, 3, {0, 1, 1, 1, 0, 0}));
  surface.material["occlusionTexture"]["strength"] = 0.25;
  const Material m = surface.made();
  expect_near(value(m.textures.ambient, m.ambient, 0), {0.75, 0.375, 0});
  expect_near(value(m.textures.ambient, m.ambient, 1), {1, 0.5, 0});
  EXPECT_EQ(m.diffuse.rgb, (Vec3f{1, 0.5F, 0}));
  EXPECT_FALSE(m.textures.diffuse);
}

TEST(GltfTextures, ScaleTiltsNormals) {  // (2 t - 1) scale in x and y
  Surface surface;
  surface.material["normalTexture"] = surface.texture("n.png", texels(2, 3, {0.6F, 0.2F, 1, 0.4F, 0.6F, 1}));
  surface.material["normalTexture"]["scale"] = 2;
  const TextureUse use = *surface.made().textures.normal;
  const Vec3f n = value(use, Color{{1, 1, 1}}, 0) * Vec3f{2, 2, 2} - Vec3f{1, 1, 1};
  expect_near(n, {0.4, -1.2, 1}, 1e-4);
}

TEST(GltfTextures, GlossinessIsMappedTexelByTexel) {
  Surface surface;
  surface.maker.json["extensionsUsed"] = {"KHR_materials_pbrSpecularGlossiness"};
  surface.material["extensions"]["KHR_materials_pbrSpecularGlossiness"] = {
      {"diffuseFactor", {1, 0.5, 1, 1}}, {"specularGlossinessTexture", surface.texture("s.png", texels(2, 4, {1, 0, 0, 0.4F, 0, 0, 0, 1}))}};
  const Material m = surface.made();
  expect_near(value(m.textures.diffuse, m.diffuse, 0), {0, 0, 0});
  expect_near(value(m.textures.specular, m.specular, 0), {1, 0, 0});
  expect_near(value(m.textures.diffuse, m.diffuse, 1), {1, 0.5, 1});
  EXPECT_NEAR(exponent(m, 0), 2 / std::pow(0.6, 4) - 2, 5e-3);
  EXPECT_NEAR(exponent(m, 1), 10000, 1);
}

TEST(GltfTextures, TheSpecularExtensionHasPicturesToo) {  // strength in alpha, colour in sRGB
  Surface surface;
  surface.maker.json["extensionsUsed"] = {"KHR_materials_specular"};
  surface.material["pbrMetallicRoughness"] = {{"metallicFactor", 0}};
  surface.material["extensions"]["KHR_materials_specular"] = {
      {"specularTexture", surface.texture("s.png", texels(2, 4, {0, 0, 0, 1, 0, 0, 0, 0.2F}))},
      {"specularColorTexture", surface.texture("c.png", texels(2, 3, {1, 0, 0, 1, 1, 0}))}};
  const Material m = surface.made();
  expect_near(value(m.textures.specular, m.specular, 0), {0.04, 0, 0});
  expect_near(value(m.textures.specular, m.specular, 1), {0.008, 0.008, 0});
}

TEST(GltfTextures, AlphaModes) {
  Surface surface;
  surface.material["pbrMetallicRoughness"] = {{"baseColorFactor", {1, 1, 1, 0.5}},
                                              {"baseColorTexture", surface.texture("a.png", texels(2, 4, {1, 1, 1, 1, 1, 1, 1, 0.2F}))}};
  EXPECT_EQ(surface.made().alpha_mode, AlphaMode::opaque);
  EXPECT_FALSE(surface.made().textures.opacity);
  EXPECT_EQ(surface.made().opacity, 1);
  surface.material["alphaMode"] = "MASK";
  surface.material["alphaCutoff"] = 0.25;
  Material m = surface.made();
  EXPECT_EQ(m.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(m.alpha_cutoff, 0.25F);
  EXPECT_EQ(m.opacity, 0.5F);
  ASSERT_TRUE(m.textures.opacity);
  EXPECT_EQ(m.textures.opacity->channel, 3);
  surface.material["alphaMode"] = "BLEND";
  EXPECT_EQ(surface.made().alpha_mode, AlphaMode::blend);
}

TEST(GltfTextures, SamplersTransformsAndSetsOfCoordinatesGoAlong) {
  Surface surface;
  surface.maker.json["extensionsUsed"] = {"KHR_texture_transform"};
  surface.maker.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9985}}};
  Json use = surface.texture("a.png", texels(2, 3, {1, 0, 0, 0, 1, 0}));
  surface.maker.json["textures"][0]["sampler"] = 0;
  use["extensions"]["KHR_texture_transform"] = {{"offset", {0.25, 0.5}}, {"rotation", 1.5707963267948966}, {"scale", {2, 3}}, {"texCoord", 1}};
  surface.material["emissiveTexture"] = use;
  surface.material["emissiveFactor"] = {1, 1, 1};
  const TextureUse made = *surface.made().textures.emission;
  EXPECT_EQ(made.sampler.wrap_u, Wrap::clamp_to_edge);
  EXPECT_EQ(made.sampler.wrap_v, Wrap::mirrored_repeat);
  EXPECT_EQ(made.sampler.magnify, TextureFilter::nearest);
  EXPECT_EQ(made.sampler.minify, TextureFilter::linear);
  EXPECT_EQ(made.sampler.mip, MipFilter::nearest);
  EXPECT_EQ(made.uv_set, 1);
  // A quarter turn, counter-clockwise for who looks at the picture, whose v goes down: u' = 3 v + 1/4, v' = 1/2 - 2 u. (TextureTransformTest)
  constexpr std::array<float, 6> kExpected{0, 3, 0.25F, -2, 0, 0.5F};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(made.uv_matrix[i], kExpected[i], 1e-6) << i;
  }
}

TEST(GltfTextures, APictureElsewhereCountsByItsAverage) {
  Surface surface;
  surface.material["pbrMetallicRoughness"] = {{"baseColorTexture", surface.texture("a.png", texels(2, 3, {1, 1, 1, 0, 0, 0}))},
                                              {"metallicRoughnessTexture", surface.texture("m.png", texels(2, 3, {0, 1, 0, 0, 1, 1}))}};
  surface.material["pbrMetallicRoughness"]["metallicRoughnessTexture"]["texCoord"] = 1;
  const LoadedScene loaded = good(surface.load());
  const Material& m = loaded.scene.objects[0].mesh->materials[0];
  EXPECT_NEAR(m.diffuse.rgb.x, 0.5, 0.51 / 255);  // half of it is metal, to the byte
  EXPECT_THAT(texts(loaded.notes),
              ElementsAre(HasSubstr("materials[0]: its metallicRoughnessTexture lies elsewhere on the surface than its baseColorTexture")));
}

TEST(GltfTextures, EqualCombinationsAreMadeOnce) {
  Surface surface;
  surface.material["pbrMetallicRoughness"] = {{"baseColorTexture", surface.texture("a.png", texels(2, 3, {1, 1, 0, 1, 0, 1}))},
                                              {"metallicRoughnessTexture", surface.texture("m.png", texels(2, 3, {0, 0.6F, 1, 0, 1, 0.2F}))}};
  Json other = surface.maker.json["meshes"][0]["primitives"][0];
  other["material"] = 1;
  surface.maker.add_node_with(other);
  surface.maker.json["materials"] = Json::array({surface.material, surface.material});
  surface.write("t.gltf", surface.maker.text());
  const LoadedScene loaded = good(load_scene(surface.path / "t.gltf"));
  const MaterialTextures& a = loaded.scene.objects[0].mesh->materials[0].textures;
  const MaterialTextures& b = loaded.scene.objects[1].mesh->materials[0].textures;
  EXPECT_EQ(a.diffuse->texture, b.diffuse->texture);
  EXPECT_EQ(a.shininess->texture, b.shininess->texture);
  EXPECT_EQ(a.ambient->texture, b.ambient->texture);
}

TEST(GltfTextures, PicturesLieInFilesDataUrisAndViews) {
  Surface surface;
  const Image image = texels(2, 3, {1, 0, 0, 0, 1, 0});
  surface.texture("a b.png", image);
  std::ifstream stream(surface.path / "a b.png", std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  surface.material["emissiveFactor"] = {1, 1, 1};
  surface.material["emissiveTexture"] = {{"index", 0}};
  const std::size_t view = surface.maker.add_view(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
  for (const Json& stated : {Json{{"uri", "a%20b.png"}}, Json{{"uri", "data:image/png;base64," + base64(bytes)}},
                             Json{{"bufferView", view}, {"mimeType", "image/png"}}}) {
    surface.maker.json["images"][0] = stated;
    expect_near(value(surface.made().textures.emission, Color{{1, 1, 1}}, 1), {0, 1, 0});
  }
}

TEST(GltfTextures, WhatCannotBeHadIsSaidOrAnErrorWithStrict) {
  Surface surface;
  surface.material["pbrMetallicRoughness"] = {
      {"baseColorFactor", {0.5, 0.25, 1, 1}}, {"metallicFactor", 0}, {"baseColorTexture", {{"index", 0}}}};
  surface.material["emissiveTexture"] = {{"index", 0}};
  surface.material["emissiveFactor"] = {1, 1, 1};
  surface.maker.json["textures"] = {{{"source", 0}}};
  surface.write("broken.png", "\x89PNG\r\n\x1a\nno");
  const std::string name = (surface.path / "t.gltf").string();
  const auto check = [&](const Json& image, const std::string& path, const std::string& message) {
    surface.maker.json["images"] = Json::array({image});
    const LoadedScene loaded = good(surface.load());
    const Material& m = loaded.scene.objects[0].mesh->materials[0];
    EXPECT_FALSE(m.textures.diffuse || m.textures.emission);
    EXPECT_EQ(m.diffuse.rgb, (Vec3f{0.5F, 0.25F, 1}));
    EXPECT_EQ(m.emission.rgb, (Vec3f{})) << "a glow without its picture would be everywhere";
    ASSERT_FALSE(loaded.notes.empty()) << message;
    EXPECT_EQ(loaded.notes[0].where, name + ": " + path);
    EXPECT_THAT(loaded.notes[0].message, testing::AllOf(HasSubstr(message), HasSubstr("drawn without it")));
    const Error error = bad(surface.load({.strict = true}));
    EXPECT_EQ(error.where, name + ": " + path);
    EXPECT_THAT(error.message, testing::AllOf(HasSubstr(message), HasSubstr("baseColorTexture of materials[0]")));
  };
  check({{"uri", "none.png"}}, "images[0].uri", "none.png");
  check({{"uri", "../out.png"}}, "images[0].uri", "lies outside the document's folder");
  check({{"uri", "http://a/b.png"}}, "images[0].uri", "only relative paths are read");
  check({{"uri", "data:image/png;base64,AAAA"}}, "images[0]", "");
  check({{"uri", "broken.png"}}, "images[0]", "broken.png");
  surface.maker.json["textures"] = {Json::object()};
  check({{"uri", "broken.png"}}, "textures[0]", "no picture of a kind that is read");
}

TEST(GltfTextures, TheThreadsDoNotMatter) {
  Surface surface;
  surface.material["pbrMetallicRoughness"] = {{"baseColorTexture", surface.texture("a.png", texels(2, 3, {1, 1, 0, 1, 0, 1}))},
                                              {"metallicRoughnessTexture", surface.texture("m.png", texels(2, 3, {0, 0.6F, 1, 0, 1, 0.2F}))}};
  const Material one = surface.made({.threads = 1});
  const Material many = surface.made({.threads = 5});
  for (int x = 0; x < 2; ++x) {
    EXPECT_EQ(value(one.textures.specular, one.specular, x), value(many.textures.specular, many.specular, x));
    EXPECT_EQ(exponent(one, x), exponent(many, x));
  }
}

TEST(GltfTextures, ASceneThatIsLitByGgxLightsItsGltfSo) {
  Surface surface;
  surface.maker.json["materials"] = Json::array({surface.material});
  surface.write("t.gltf", surface.maker.text());
  surface.write("s.json", R"({"shading": {"lighting": "ggx"}, "objects": [{"mesh": "t.gltf#nodes[0]"}, {"mesh": "t.gltf"}]})");
  const LoadedScene loaded = good(load_scene(surface.path / "s.json"));
  EXPECT_EQ(loaded.scene.objects[0].mesh->materials[0].lighting, Lighting::ggx);
  EXPECT_EQ(loaded.scene.objects[1].mesh->materials[0].lighting, Lighting::ggx);
}

}  // namespace
}  // namespace lustro
